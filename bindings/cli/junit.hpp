// SPDX-License-Identifier: GPL-3.0-or-later
// Results of scenario tests as JUnit XML, as continuous integration reads it.
#pragma once

#include <string>
#include <vector>

#include "trial/scenario_run.hpp"

namespace rhexis::cli {

struct FinishedScenario {
    const ScenarioFile* file = nullptr;
    std::size_t number = 0;
    ScenarioResult result;
};

/// One test suite per file, one test case per scenario; times are CPU seconds. Ordered by file.
std::string junit_xml(const std::vector<FinishedScenario>& scenarios);

}  // namespace rhexis::cli
