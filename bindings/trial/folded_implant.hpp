// SPDX-License-Identifier: GPL-3.0-or-later
// The implant folded into its injector, for exercises that begin with it: folded when it is asked for first, and kept.
#pragma once

#include <string>

#include "base/result.hpp"
#include "flow/scene.hpp"

namespace rhexis {

/// Hash over the bytes of the program that runs: what another one makes may differ in its last bits.
Result<std::string> hash_of_program();

/// Path of the state in which the scene's implant lies folded in its injector. All scenes with the same lens and
/// cartridge share it, and processes that need it at once wait for the one that folds. quiet: no progress.
Result<std::string> find_folded_implant(const SceneDescription& scene, bool quiet);

}  // namespace rhexis
