// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a membrane in the jaws of forceps. Jaws that close take hold of the nodes of what lies between them;
// each is led by a spring, slips when that pulls harder than its share of what the jaws bear, and is lost when it has
// slipped out. Jaws that open let go.
#pragma once

#include <span>
#include <vector>

#include "flow/world.hpp"
#include "physics/contact/contact_candidates.hpp"
#include "physics/solve/contact_term.hpp"

namespace rhexis {

/// Takes hold and lets go. Jaws: by how they moved in the step, of what lies between them at its start; where some of
/// that is folded over, only of that: it lies on top. A needle that is through the sheet pushes the end or the lip of
/// the tear that it has gone past, as long as it has. Returns the nodes that jaws held which have left the eye.
std::vector<int> take_hold(const WorldModel& world, std::span<const ToolState> tools, MembraneState& state);

class SheetGrips {
public:
    /// stiffness: of what leads a node [uN/mm]. The world must outlive the calls that follow.
    void look(const WorldModel& world, int membrane, const MembraneState& state, double stiffness);
    [[nodiscard]] bool empty() const { return grips_.empty(); }

    /// Forces and stiffness at an iterate; poses: of the instruments at the end of the substep.
    void terms(const std::vector<Vec3>& position, const PartnerPoses& poses, std::vector<ContactTerm>& terms) const;
    /// Ends a substep: what pulled too hard has slipped.
    void settle(const std::vector<Vec3>& position, const PartnerPoses& poses, double dt);

    /// Mean over a step of dt [s], as contacts with the instruments.
    void report(double dt, ContactSet& contacts) const;
    /// Those that have not slipped out.
    [[nodiscard]] std::vector<SheetGrip> kept() const;

private:
    struct Pull {
        Vec3 force = Vec3::Zero();      ///< on the sheet [uN]
        Mat3 stiffness = Mat3::Zero();  ///< positive semidefinite [uN/mm]
    };
    [[nodiscard]] Pull pull(const SheetGrip& grip, const std::vector<Vec3>& position, const PartnerPoses& poses) const;
    [[nodiscard]] double most(const SheetGrip& grip) const;

    const WorldModel* world_ = nullptr;
    int membrane_ = 0;
    double stiffness_ = 0.0;
    std::vector<SheetGrip> grips_;
    std::vector<Vec3> impulse_;  ///< per grip [uN s]
    std::vector<Vec3> point_;    ///< per grip, at the end [mm]
    std::vector<int> nodes_of_;  ///< per tool: how many it holds
};

}  // namespace rhexis
