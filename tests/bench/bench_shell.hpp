// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/bench.hpp"

namespace rhexis::bench {

std::vector<BenchCase> shell_cases();
std::vector<BenchCase> shell_speed_cases();
std::vector<BenchCase> shell_element_cases();
std::vector<BenchCase> implant_cases();
std::vector<BenchCase> implant_unfold_cases();
std::vector<BenchCase> shell_contact_cases();
std::vector<BenchCase> shell_contact_solver_cases();
std::vector<BenchCase> implant_inject_cases();
std::vector<BenchCase> implant_bag_cases();
std::vector<BenchCase> verify_cases();

}  // namespace rhexis::bench
