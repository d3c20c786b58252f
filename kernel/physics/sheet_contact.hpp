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
#include "physics/contact_candidates.hpp"
#include "physics/contact_term.hpp"

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
};

/// The point of a triangle that is nearest to a segment, as weights of its corners.
std::array<double, 3> nearest_to_segment(const std::array<Vec3, 3>& triangle, const Vec3& a, const Vec3& b);

class SheetContacts {
public:
    /// What can touch in a step of dt [s]. The world must outlive the calls that follow.
    void look(const WorldModel& world, int membrane, const MembraneState& state, std::span<const ToolState> tools,
              double dt);
    [[nodiscard]] bool empty() const { return list_.empty(); }
    [[nodiscard]] double stiffness() const { return stiffness_; }  ///< of a contact [uN/mm]
    /// Impulse on the body under the sheet, along z [uN s].
    [[nodiscard]] double impulse_on_support() const;

    /// Forces and stiffness at an iterate; poses: of the instruments at the end of the substep.
    void terms(const std::vector<Vec3>& position, const PartnerPoses& poses, std::vector<ContactTerm>& terms) const;
    /// Ends a substep: sums impulses and lets go of what slid or is apart.
    void settle(const std::vector<Vec3>& position, const PartnerPoses& poses, double dt);

    /// Of the whole step of dt [s].
    void report(double dt, ContactSet& contacts) const;
    [[nodiscard]] std::vector<SheetTouch> touches() const;

private:
    struct Meeting {
        double gap;
        Vec3 normal;
        Vec3 point;
    };
    [[nodiscard]] Meeting meeting(const SheetContact& contact, const std::vector<Vec3>& position,
                                  const PartnerPoses& poses) const;
    [[nodiscard]] SpringResponse spring(const SheetContact& contact, const Meeting& meeting,
                                        const PartnerPoses& poses) const;
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
