// SPDX-License-Identifier: GPL-3.0-or-later
// A standard linear (Zener) solid over a step: beside a spring K another one, share K, in series with a dashpot. With d
// the deformation and h that of the second spring,
//
//   stress = K d + share K h,   h' = d' - h / time
//
// Where d goes evenly over a step of dt, h ends exactly at  left h + mean (d - d_start)  with left and mean of
// dt / time ([TaylorPisterGoudreau1970], [SimoHughes1998] chapter 10): no error grows with dt but that of d. The stress
// is then that of one spring of (1 + share mean) K whose natural deformation is  share (mean d_start - left h) / (1 +
// share mean), so that a step is a minimum of an energy as an elastic one is. It gives back no energy: work of the
// second spring in a step is its gain and what the dashpot takes, share K time (d - d_start)(d - d_start - (h_end - h))
// / dt less the gain.
#pragma once

#include "math/decay.hpp"

namespace rhexis {

struct ZenerStep {
    double left = 0.0;   ///< of the second spring's deformation
    double mean = 0.0;   ///< of the step's deformation that it takes on
    double share = 0.0;  ///< modulus of the second spring over that of the first

    /// Stiffness of a step over that of the first spring.
    [[nodiscard]] double stiffness() const { return 1.0 + share * mean; }
    /// One number of the natural deformation, from those at the start of the step.
    [[nodiscard]] double natural(double start, double second) const {
        return share * (mean * start - left * second) / stiffness();
    }
    /// One number of the second spring's deformation at the end.
    [[nodiscard]] double second_at_end(double second, double start, double end) const {
        return left * second + mean * (end - start);
    }
};

/// share >= 0; dt and time [s], above 0.
inline ZenerStep zener_step(double share, double time, double dt) {
    const Decay over = decay(dt / time);
    return {over.left, over.mean, share};
}

}  // namespace rhexis
