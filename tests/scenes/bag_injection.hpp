// SPDX-License-Identifier: GPL-3.0-or-later
// A folded implant that a hand which holds still pushes into the bag, for tests and benchmarks.
#pragma once

#include <memory>

#include "flow/scene.hpp"
#include "physics/physics.hpp"

namespace rhexis::scenes {

struct BagInjectionCase {
    double bag = 800.0;      ///< triangles
    double implant = 400.0;  ///< likewise
    double dt = 0.02;        ///< [s]
    double unfolding = 6.0;  ///< that it is looked at after the hand has come to the end of the stroke [s]
    ShellContactSettings contact{};
};

class BagInjection {
public:
    /// Folds the implant first, which takes seconds.
    explicit BagInjection(const BagInjectionCase& own);

    [[nodiscard]] int steps() const { return steps_; }  ///< of the whole run
    /// One step of the run; `before` is the state at its start.
    StepOutcome step();

    std::shared_ptr<const WorldModel> model;
    WorldState before;
    WorldState state;
    ToolState hand;

private:
    BagInjectionCase own_;
    int pushing_ = 1;  ///< steps
    int steps_ = 0;
    Physics physics_;
};

}  // namespace rhexis::scenes
