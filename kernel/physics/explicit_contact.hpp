// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: contact as impulses on nodes between the two halves of an explicit substep.
//
// Lumped mass makes the Delassus operator of one vertex against a kinematic partner a number, so a contact is resolved
// in closed form: the impulse that closes the gap exactly at the end of the substep, and the one that brings the vertex
// back to its anchor, cut to the friction disc. Vertices that share nodes or a bag take a few sweeps, warm-started.
#pragma once

#include "physics/bag_motion.hpp"
#include "physics/contact_candidates.hpp"
#include "physics/explicit_solid.hpp"

namespace rhexis {

/// Scratch of the explicit resolver for one step.
class ExplicitContact {
public:
    /// Starts a step. candidates must outlive the step.
    void begin(const WorldModel& model, const ContactSurface& surface, ContactCandidates& candidates,
               const ExplicitSolid& solid);

    /// Corrects the velocities of the solid and of the bags so that no contact is violated after dt [s].
    /// before, after: poses of the tools at the ends of the substep; bags: their state, already accelerated.
    void resolve(double dt, const PartnerPoses& before, const PartnerPoses& after, ExplicitSolid& solid,
                 std::vector<BagState>& bags);

private:
    struct Active {
        int candidate = 0;
        std::array<int, 2> nodes{0, -1};    ///< index into velocity_
        std::array<double, 2> share{0, 0};  ///< velocity per impulse: weight / mass [1/g]
        double weight = 1.0;
        int bag = -1;
        Vec3 arm = Vec3::Zero();
        Vec3 normal = Vec3::UnitZ();
        double normal_target = 0.0;          ///< smallest relative normal velocity [mm/s]
        Vec3 tangent_target = Vec3::Zero();  ///< relative tangential velocity that sticks [mm/s]
        double normal_mass = 0.0;            ///< [g]
        double tangent_mass = 0.0;           ///< [g]
        double normal_impulse = 0.0;         ///< [uN s]
        Vec3 tangent_impulse = Vec3::Zero();
        bool sliding = false;
    };

    void collect(double dt, const PartnerPoses& before, const PartnerPoses& after, const ExplicitSolid& solid);
    void set_masses(Active& active) const;
    int local_node(int node, const ExplicitSolid& solid);
    [[nodiscard]] Vec3 relative_velocity(const Active& active, const std::vector<BagState>& bags) const;
    void apply(const Active& active, const Vec3& impulse, std::vector<BagState>& bags);
    void sweep(std::vector<BagState>& bags);
    void finish(double dt, const PartnerPoses& after, ExplicitSolid& solid, const std::vector<BagState>& bags);

    const WorldModel* model_ = nullptr;
    const ContactSurface* surface_ = nullptr;
    ContactCandidates* candidates_ = nullptr;
    std::vector<double> mass_;  ///< per candidate and node, two each
    std::vector<BagInertia> bag_response_;
    std::vector<Active> active_;
    std::vector<int> local_of_;  ///< per coarse node: index into nodes_, or -1
    std::vector<int> nodes_;
    std::vector<Vec3> velocity_;
};

}  // namespace rhexis
