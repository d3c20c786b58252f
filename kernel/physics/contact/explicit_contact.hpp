// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: contact as impulses on nodes between the two halves of an explicit substep.
//
// Lumped mass makes the Delassus operator of one vertex against a kinematic partner a number, so a contact is resolved
// in closed form: the impulse that closes the gap exactly at the end of the substep, and the one that brings the vertex
// back to its anchor, cut to the friction disc. Vertices that share nodes or a bag take a few sweeps, warm-started.
//
// A substep is short, and most candidates are far from their partner in most of them. So each sleeps until it and its
// partner have moved by what lay between them, and the wall of a bag stands as a plane until a vertex has moved along
// it by more than the plane is good for. Even to ask whether it may go on sleeping is too much for most: until
// everything has moved so far that the nearest of them could matter, they are passed over by one comparison.
#pragma once

#include "physics/anatomy/bag_motion.hpp"
#include "physics/contact/contact_candidates.hpp"
#include "physics/contact/piece_contact.hpp"
#include "physics/fluid/suction_grip.hpp"
#include "physics/solid/explicit_solid.hpp"

namespace rhexis {

/// Scratch of the explicit resolver for one step.
class ExplicitContact {
public:
    /// Starts a step of a loaded solid. candidates and grips must outlive the step. poses: at its start.
    void begin(const WorldModel& model, const PartnerPoses& poses, ContactCandidates& candidates,
               const std::vector<PiecePair>& pairs, std::vector<SuctionGrip>& grips, ExplicitSolid& solid);

    /// Corrects the velocities of the solid and of the bags so that no contact is violated after dt [s].
    /// before, after: poses at the ends of the substep, of the bags both at its start; bags: already accelerated.
    void resolve(double dt, const PartnerPoses& before, const PartnerPoses& after, std::vector<BagState>& bags);

private:
    /// How far a partner has come since the start of the step: the lengths of its ways.
    struct Drift {
        Pose last;
        double shift = 0.0;  ///< of its centre [mm]
        double turn = 0.0;   ///< [rad]
    };
    /// What is known of a candidate since it was last measured.
    struct Watch {
        int drift = 0;  ///< index into drifts_
        Vec3 start = Vec3::Zero();
        double free = 0.0;  ///< what it and its partner may move before it matters [mm]
        double shift = 0.0;
        double turn = 0.0;
        double arm = 0.0;   ///< from the partner's centre, with some to spare [mm]
        bool flat = false;  ///< the wall is known as a plane near `foot`, all in the bag's frame
        Vec3 foot = Vec3::Zero();
        SurfaceDistance plane = nothing_near();
    };

    /// How a partner answers an impulse within a substep; what does not answer has no responses.
    struct Body {
        Vec3 velocity = Vec3::Zero();
        Vec3 angular_velocity = Vec3::Zero();
        double response = 0.0;          ///< [1/g]
        double turning_response = 0.0;  ///< [1/(g mm^2)]
    };

    struct Active {
        int candidate = 0;
        std::array<int, 4> nodes{0, 0, 0, 0};
        std::array<double, 4> weights{0, 0, 0, 0};
        std::array<double, 4> share{0, 0, 0, 0};  ///< velocity per impulse [1/g]
        double friction = 0.0;
        double pull = 0.0;  ///< impulse that it bears before it parts [uN s]
        double grip = 0.0;  ///< what that adds to the largest friction [uN s]
        int suction = -1;   ///< the grip with which it shares its pull, index into grips_; -1: none
        int body = 0;       ///< index into bodies_
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

    void follow_partners(const PartnerPoses& after);
    void note_motion(double dt);
    [[nodiscard]] Vec3 place(const ContactPoint& at) const;
    [[nodiscard]] Vec3 pace(const ContactPoint& at) const;
    [[nodiscard]] double left_to_sleep(const Watch& watch, const Vec3& point) const;
    [[nodiscard]] double wake_after(const Watch& watch, double left) const;
    SurfaceDistance measure(const ContactCandidate& candidate, const Pose& pose, const Vec3& point, Watch& watch) const;
    void rest(const SurfaceDistance& gap, double near, const Pose& pose, const Vec3& point, Watch& watch) const;
    void collect(double dt, const PartnerPoses& before, const PartnerPoses& after);
    void activate(int index, double dt, const SurfaceDistance& gap, const Pose& old_pose, const Pose& pose,
                  const Vec3& point);
    void set_masses(Active& active) const;
    void take_bodies(double dt, const std::vector<BagState>& bags);
    [[nodiscard]] double pull_left(const Active& active, double dt) const;
    void sweep(double dt);
    [[nodiscard]] double response(const ContactPoint& at) const;
    void push_point(const ContactPoint& at, const Vec3& impulse);
    void collect_pairs(double dt);
    void sweep_pairs();
    void sweep_grips(double dt, const PartnerPoses& before, const PartnerPoses& after);
    void finish(double dt, const PartnerPoses& after);

    const WorldModel* model_ = nullptr;
    ContactCandidates* candidates_ = nullptr;
    ExplicitSolid::Rows rows_;
    std::vector<Body> bodies_;    ///< what stands still or is led, then the bags
    std::vector<Drift> drifts_;   ///< what stands still, the tools, then the bags
    std::vector<Watch> watches_;  ///< per candidate
    std::vector<double> wakes_;   ///< per candidate: it need not be looked at while `motion_` is less [mm]
    double motion_ = 0.0;         ///< since the start of the step: no gap has changed by more [mm]
    double coming_ = 0.0;         ///< what the nodes add to that in the rest of the substep [mm]
    /// A vertex that could meet the triangle of another piece within the substep.
    struct ActivePair {
        int pair = 0;
        double target = 0.0;  ///< smallest relative normal velocity [mm/s]
        double mass = 0.0;    ///< [g]
        double impulse = 0.0;
        Vec3 tangent_impulse = Vec3::Zero();
    };
    const std::vector<PiecePair>* pairs_ = nullptr;
    std::vector<ActivePair> active_pairs_;
    std::vector<SuctionGrip>* grips_ = nullptr;
    std::vector<Active> active_;
    std::vector<int> unsettled_;        ///< indices into active_
    std::vector<int> unsettled_pairs_;  ///< indices into active_pairs_
};

}  // namespace rhexis
