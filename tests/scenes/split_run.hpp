// SPDX-License-Identifier: GPL-3.0-or-later
// A taut round sheet that is split in every step: for what tearing costs.
#pragma once

#include "scenes/tears.hpp"

namespace rhexis::scenes {

class SplitRun {
public:
    static constexpr double step_s = 1e-3;

    /// Of about so many triangles, held at its edge and stretched by 3 %. damping: share of the mass [1/s].
    explicit SplitRun(int triangles, double damping = 50.0);

    /// A tear that winds goes on by an edge; a new puncture where the last one came to an end. False: it could not.
    bool split();
    /// One linearised step of 1 ms.
    ImplicitReport step();

    [[nodiscard]] const MembraneModel& model() const { return held_.model(); }
    [[nodiscard]] const MembraneState& state() { return held_.state(); }

private:
    HeldSheet held_;
    int tries_ = 0;
    double angle_ = 0.0;  ///< of the way that is wanted [rad]
};

}  // namespace rhexis::scenes
