// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/contact/rigid_partner.hpp"

#include <algorithm>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {
namespace {

SurfaceDistance plane_distance(const PlaneModel& plane, const Vec3& place) {
    return {plane.normal.dot(place - plane.point), plane.normal};
}

/// From within.
SurfaceDistance dome_distance(const DomeModel& dome, const Vec3& place) {
    const Vec3 out = place - dome.centre;
    const double distance = out.norm();
    return {dome.radius - distance, Vec3(-out / std::max(distance, 1e-9))};
}

}  // namespace

bool within_opening(const BagModel& bag, const Vec3& local) {
    return local.z() > 0.0 && local.head<2>().squaredNorm() < bag.opening_radius * bag.opening_radius;
}

SurfaceDistance wall_distance(const BagModel& bag, const Vec3& local, const Approach& approach) {
    if (within_opening(bag, local)) {
        return nothing_near();
    }
    SurfaceDistance found = bag_distance(bag.shape, local);
    if (approach.outside) {
        // Past the equator zonules and ciliary body close the way back.
        return local.z() < found.distance ? SurfaceDistance{local.z(), Vec3::UnitZ()} : found;
    }
    return found.distance > approach.wall ? nothing_near() : SurfaceDistance{-found.distance, -found.normal};
}

SurfaceDistance distance_to(const RigidPartners& all, ContactPartner partner, int index, const Pose& pose,
                            const Vec3& place, const Approach& approach) {
    if (partner == ContactPartner::plane) {
        return plane_distance(all.planes[at(index)], place);
    }
    if (partner == ContactPartner::dome) {
        return dome_distance(all.domes[at(index)], place);
    }
    const Vec3 local = pose.to_body(place);
    SurfaceDistance found = nothing_near();
    switch (partner) {
        case ContactPartner::tool:
            found = tool_distance(all.tools[at(index)], local, approach.least_radius);
            break;
        case ContactPartner::tube:
            found = tube_distance(all.tubes[at(index)], local);
            break;
        case ContactPartner::bag:
            found = wall_distance(all.bags[at(index)], local, approach);
            break;
        default:
            RHEXIS_ASSERT(false);
    }
    return {found.distance, pose.orientation * found.normal};
}

double friction_of(const RigidPartners& all, ContactPartner partner, int index) {
    switch (partner) {
        case ContactPartner::plane:
            return all.planes[at(index)].friction;
        case ContactPartner::dome:
            return all.domes[at(index)].friction;
        case ContactPartner::tube:
            return all.tubes[at(index)].friction;
        case ContactPartner::bag:
            return all.bags[at(index)].friction;
        default:
            RHEXIS_ASSERT(partner == ContactPartner::tool);
            return all.tools[at(index)].friction;
    }
}

}  // namespace rhexis
