// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: a membrane against instruments, fixed half-spaces and the body that it lies on. Nodes meet what is
// smooth and large; triangles meet instruments, at the point of each that is nearest, so that a thin tool does not slip
// between nodes. Both sides of a sheet touch. For the length of a substep each contact is one with a plane that goes
// with the partner, its tangent where it is nearest: nothing goes far in one, and the system stays one of straight
// springs.
#pragma once

#include <span>
#include <vector>

#include "flow/world.hpp"
#include "physics/contact/contact_candidates.hpp"
#include "physics/solve/contact_term.hpp"

namespace rhexis {

struct SheetContact {
    SheetTouch touch;
    std::array<int, 3> nodes{0, -1, -1};
    std::array<double, 3> weights{1.0, 0.0, 0.0};
    Vec3 foot = Vec3::Zero();     ///< of the partner's plane of contact, in its frame [mm]
    Vec3 out = Vec3::UnitZ();     ///< that plane's normal, in the partner's frame
    Vec3 anchor = Vec3::Zero();   ///< where friction holds it, in the partner's frame [mm]
    Vec3 impulse = Vec3::Zero();  ///< on the sheet, summed over the step [uN s]
    Vec3 point = Vec3::Zero();    ///< at the end [mm]
    Vec3 normal = Vec3::UnitZ();  ///< from the partner into the sheet
    double gap = 0.0;             ///< [mm]
    bool sliding = false;
    // where the partner is at the end of the substep
    ContactSpring spring;
    double level = 0.0;           ///< of the plane of contact along its normal [mm]
    Vec3 held_at = Vec3::Zero();  ///< the anchor [mm]
};

class SheetContacts {
public:
    /// What can touch in a step of dt [s]. The world must outlive the calls that follow.
    void look(const WorldModel& world, int membrane, const MembraneState& state, std::span<const ToolState> tools,
              double dt);
    [[nodiscard]] bool empty() const { return list_.empty(); }
    [[nodiscard]] double stiffness() const { return stiffness_; }  ///< of a contact [uN/mm]
    /// Impulse on the body under the sheet, along z [uN s].
    [[nodiscard]] double impulse_on_support() const;

    /// Before the calls that follow. poses: of the instruments at the end of the substep.
    void place(const PartnerPoses& poses);
    /// Forces and stiffness at an iterate.
    void terms(const std::vector<Vec3>& position, std::vector<ContactTerm>& terms) const;
    /// Ends a substep: sums impulses and lets go of what slid or is apart.
    void settle(const std::vector<Vec3>& position, const PartnerPoses& poses, double dt);

    /// Of the whole step of dt [s].
    void report(double dt, ContactSet& contacts) const;
    [[nodiscard]] std::vector<SheetTouch> touches() const;

private:
    [[nodiscard]] Pose pose_of(const SheetContact& contact, const PartnerPoses& poses) const;
    void meet_support(const MembraneState& state, double dt);
    void meet_planes(const MembraneState& state, double dt);
    void meet_tool(const MembraneState& state, const ToolState& tool, int index);
    void add(SheetContact contact, const MembraneState& state, const Pose& start);

    const WorldModel* world_ = nullptr;
    int membrane_ = 0;
    double stiffness_ = 0.0;
    Pose support_;  ///< where the body under the sheet is
    std::vector<SheetContact> list_;
    std::size_t next_known_ = 0;  ///< of the state's touches, which come in the order in which contacts are found
};

}  // namespace rhexis
