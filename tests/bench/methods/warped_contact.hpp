// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of a shell by compliance warping, as [Dequidt2013] has it after [Saupin2008]. A step goes without contact
// first; then impulses l >= 0 along the normals undo what sank in. What they do to the velocities is taken from the
// matrix A0 of the shell at rest, factored once, turned with the nodes:
//   dv = C H' l,  C = R A0^-1 R',  0 <= gap / dt + H dv, complementary to l (projected Gauss-Seidel)
// exact where all nodes turn alike, wrong where turns or strains differ. The error
//   e = |A dv - H' l| / |H' l|,  A of the step without contact,
// says so; with a gate, above 0.3, the step is corrected again with A itself instead of C. One plane without friction.
#pragma once

#include <memory>

#include "flow/world.hpp"
#include "physics/solve/implicit_step.hpp"

namespace rhexis::bench {

class WarpedContact {
public:
    /// gate: error above which A itself is factored; none: HUGE_VAL, always: 0. The model must outlive this.
    WarpedContact(const ShellModel& model, double dt, double gate);
    ~WarpedContact();

    /// One step of dt [s] against the plane, without gravity.
    void step(const PlaneModel& plane, const ImplicitSettings& settings, ShellState& state);

    // Of the last step.
    [[nodiscard]] double force() const;    ///< of the plane, along its normal [uN]
    [[nodiscard]] double error() const;    ///< e of the correction that was kept
    [[nodiscard]] double deepest() const;  ///< penetration after it, over thickness
    [[nodiscard]] int contacts() const;    ///< samples that had sunk in
    [[nodiscard]] int touching() const;    ///< those with an impulse
    [[nodiscard]] int factors() const;     ///< of A, in all steps

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis::bench
