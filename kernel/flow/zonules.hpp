// SPDX-License-Identifier: GPL-3.0-or-later
// Zonules that break, and what stands in for them: hooks on the edge of the capsule's opening, a capsular tension ring.
// Formulas, sources and limits: docs/zonules.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

struct BagModel;
struct BagState;

/// Constant while a scene runs.
struct ZonuleModel {
    double breaks_at = 3.82;         ///< stretch beyond rest at which one breaks [mm] [Assia1991]
    double rest_stretch = 1.2;       ///< of the anterior ones at rest [mm], as eye/anterior_capsule.cpp has it
    std::vector<std::uint8_t> lost;  ///< per zonule: 1 where it is lost at the start
    double hook_pull = 4000.0;       ///< of a hook when it is set [uN]. Proposal
    double hook_stiffness = 6000.0;  ///< [uN/mm]. Proposal
    double hook_reach = 0.6;         ///< from the edge of the opening, at which a hook takes hold [mm]. Proposal
    std::size_t most_hooks = 5;      ///< that an eye has room for
    double ring_s = 2.0;             ///< the shortest time in which a hand feeds a ring in [s]. Proposal
    double ring_holds_deg = 120.0;   ///< widest gap that a ring bridges wholly
    double ring_fails_deg = 180.0;   ///< and from which on it bridges nothing. Proposal
    double limbus_radius = 5.82;     ///< ring of places from which hooks pull [mm]
    double limbus_z = 0.0;           ///< [mm]
};

/// A hook that was set: a spring from the edge of the opening to the limbus, which only pulls.
struct CapsuleHook {
    Vec3 on_bag = Vec3::Zero();     ///< in the bag's frame [mm]
    Vec3 at_limbus = Vec3::Zero();  ///< in the eye's frame [mm]
    double length = 0.0;            ///< when it was set [mm]
};

/// Changes from step to step.
struct ZonuleState {
    std::vector<std::uint8_t> broken;  ///< per zonule: 1 where it holds nothing any more
    std::vector<CapsuleHook> hooks;
    double ring = 0.0;  ///< share of a ring that has been fed into the bag; 1: it lies in it
};

ZonuleState rest_state(const ZonuleModel& model);

/// Widest arc of meridians without a whole zonule [degrees], and the direction of its middle. Zonules come in pairs,
/// an anterior and a posterior one for each meridian; with only one of the two left a meridian counts as held.
struct ZonuleGap {
    double width_deg = 0.0;
    Vec3 middle = Vec3::UnitX();  ///< in the bag's frame, unit; where there is a gap
};
ZonuleGap widest_gap(const BagModel& model, const ZonuleState& state);

/// The same where hooks count as zonules, and a ring lets a gap count only by the share that it does not bridge.
double unsupported_deg(const BagModel& model, const ZonuleState& state);

/// All arcs without zonules [degrees]: each zonule counts for half its meridian.
double lost_deg(const BagModel& model, const ZonuleState& state);

/// How far a ring shares out what whole zonules bear: 1 up to gaps of ring_holds_deg, 0 from ring_fails_deg on or
/// without a ring.
double bridged_share(const BagModel& model, const ZonuleState& state);

/// Share of its stiffness with which zonule i holds: 1 whole, 0 broken; where a ring bridges, the mean of all.
class ZonuleShares {
public:
    /// A bag without ZonuleModel has whole zonules only.
    ZonuleShares(const BagModel& model, const BagState& state);
    [[nodiscard]] bool all_whole() const { return broken_ == nullptr; }
    [[nodiscard]] double of(std::size_t zonule) const;

private:
    const std::vector<std::uint8_t>* broken_ = nullptr;  ///< null: all are whole
    double bridged_ = 0.0;
    double mean_ = 1.0;
};

/// Pull on the bag that is missing where a zonule no longer holds what it held at rest [uN]: the others draw the bag
/// away from there.
Vec3 missing_pull(const BagModel& model, std::size_t zonule, double share);

/// Force of a hook on the bag [uN], and its change with its place, positive semidefinite [uN/mm].
Vec3 hook_force(const ZonuleModel& model, const CapsuleHook& hook, const Pose& bag);
Mat3 hook_stiffness(const ZonuleModel& model, const CapsuleHook& hook, const Pose& bag);

}  // namespace rhexis
