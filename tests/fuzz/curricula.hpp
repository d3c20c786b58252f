// SPDX-License-Identifier: GPL-3.0-or-later
// Spoilt curricula: each loads or is refused in one line; what loads watches an eye for a thousand steps and more.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/observation.hpp"
#include "flow/scene.hpp"
#include "fuzz/batches.hpp"

namespace rhexis::fuzz {

/// A curriculum of the repository, with what a short run of it by the random operator showed.
struct Base {
    std::string name;
    std::string text;
    SceneDescription scene;
    ObservationSchema schema;
    std::vector<Observation> seen;
};

/// All exercises in root/curricula, each run for `steps` in a coarse eye.
Result<std::vector<Base>> make_bases(const std::string& root, int steps);

struct CurriculaPlan {
    std::string root;
    std::string work;  ///< a folder of the fuzzer's own
    std::uint64_t seed = 1;
    std::uint64_t steps = 1200;        ///< of time that each exercise watches
    std::uint64_t simulate_each = 50;  ///< every so many-th case is simulated too, for a few steps
    const std::vector<Base>* bases = nullptr;
};

Outcome curriculum_case(const CurriculaPlan& plan, std::uint64_t number);

}  // namespace rhexis::fuzz
