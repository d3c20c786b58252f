// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: what is rigid, as solids, membranes and shells touch it: how far a place is from it, which way it
// pushes, and how it rubs. What a body does not meet is left empty.
#pragma once

#include <cmath>
#include <span>

#include "flow/bag.hpp"
#include "flow/contact.hpp"
#include "flow/tool.hpp"
#include "flow/tube.hpp"
#include "flow/world.hpp"

namespace rhexis {

struct RigidPartners {
    std::span<const PlaneModel> planes;
    std::span<const DomeModel> domes;
    std::span<const TubeModel> tubes;
    std::span<const BagModel> bags;
    std::span<const ToolModel> tools;
};

inline RigidPartners rigid_partners(const WorldModel& world) {
    return {world.planes, world.domes, {}, world.bags, world.tools};
}

/// Farther outside than this a point has left a bag that has a hole, or by its opening [mm].
inline constexpr double bag_wall = 0.5;

/// How a place meets a partner.
struct Approach {
    double least_radius = 0.0;  ///< thinner parts of a tool are taken to have this radius [mm]
    bool outside = false;       ///< of a bag: it has left through the opening, and meets the wall from there
    double wall = bag_wall;     ///< of a bag, from within: as far beyond its wall it is still pushed back [mm]
};

/// Distance of a place, positive apart, and the unit normal that it is pushed along. pose: of the frame of a tool, a
/// tube or a bag; planes and domes stand still. Infinite where there is nothing to touch. partner: one of those above.
SurfaceDistance distance_to(const RigidPartners& all, ContactPartner partner, int index, const Pose& pose,
                            const Vec3& place, const Approach& approach = {});

/// Coulomb coefficient. partner: likewise.
double friction_of(const RigidPartners& all, ContactPartner partner, int index);

/// Of the wall of a bag, for a place in its frame, from within or from outside; there the wall goes on in the plane of
/// its equator, where zonules and ciliary body are.
SurfaceDistance wall_distance(const BagModel& bag, const Vec3& local, const Approach& approach);

/// Whether a point in a bag's frame is in front of the equator and seen through the opening: there is no wall.
bool within_opening(const BagModel& bag, const Vec3& local);

/// Nothing to touch.
inline SurfaceDistance nothing_near() { return {HUGE_VAL, Vec3::UnitZ()}; }

}  // namespace rhexis
