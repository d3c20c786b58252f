// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/wound_way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rhexis::station {
namespace {

constexpr double sill_mm = 0.6;    ///< over or under its wound, from which a tip still goes through it
constexpr double beside_mm = 1.0;  ///< likewise beside it
constexpr double lift_mm_s = 5.0;  ///< of a tip that is drawn out under its wound

/// A wound as a way: how far out along it a place is, how far beside it, and how high it runs there.
struct Way {
    Vec2 outward = Vec2::Zero();
    double out = 0.0;     ///< from the wound [mm]
    double beside = 0.0;  ///< [mm]
    double height = 0.0;  ///< of the tunnel there [mm]

    /// way_out: direction of the tunnel, outwards.
    Way(const Vec3& wound, const Vec3& way_out, const Vec3& place) : outward(way_out.head<2>().normalized()) {
        const Vec2 from = place.head<2>() - wound.head<2>();
        out = outward.dot(from);
        beside = outward.x() * from.y() - outward.y() * from.x();
        height = wound.z() + out * rise(way_out);
    }

    /// Of the tunnel, per mm outwards.
    static double rise(const Vec3& way_out) { return way_out.z() / way_out.head<2>().norm(); }
};

}  // namespace

void keep_to_way(const Vec3& wound, const Vec3& way_out, double dt, HandState& hand) {
    const Way now(wound, way_out, hand.wanted);
    if (hand.inside) {
        if (now.out > 0.0 && hand.wanted.z() < wound.z() - sill_mm) {
            hand.wanted.head<2>() -= now.out * now.outward;
            hand.wanted.z() += lift_mm_s * dt;
        }
        hand.inside = Way(wound, way_out, hand.wanted).out <= 0.0;
    } else if (now.out > 0.0) {
        hand.wanted.z() += hand.out > 0.0 ? Way::rise(way_out) * (now.out - hand.out) : 0.0;
        hand.wanted.z() = std::max(hand.wanted.z(), now.height);
    } else {
        hand.inside = hand.wanted.z() <= now.height + sill_mm && std::abs(now.beside) < beside_mm;
    }
    hand.out = Way(wound, way_out, hand.wanted).out;
}

std::optional<Vec3> landmark(const Surroundings& around, const std::string& name) {
    const auto found = std::find_if(around.percept.landmarks.begin(), around.percept.landmarks.end(),
                                    [&](const Landmark& mark) { return mark.visible && mark.name == name; });
    return found == around.percept.landmarks.end() ? std::nullopt : std::optional<Vec3>(found->position);
}

std::vector<std::string> wounds_like(const std::string& wound) {
    if (wound == "incision" || wound == "side_port") {
        return {"incision", "side_port"};
    }
    if (wound == "incision_site" || wound == "side_port_site") {
        return {"incision_site", "side_port_site"};
    }
    return {wound};
}

std::string wound_on_shaft(const Surroundings& around, const std::string& usual, const Pose& pose) {
    std::string nearest = usual;
    double least = std::numeric_limits<double>::infinity();
    for (const std::string& name : wounds_like(usual)) {
        if (const std::optional<Vec3> place = landmark(around, name)) {
            const double beside = pose.to_body(*place).head<2>().norm();
            nearest = beside < least ? name : nearest;
            least = std::min(least, beside);
        }
    }
    return nearest;
}

bool is_behind(const Vec3& wound, const Vec3& tip) { return Way(wound, wound, tip).out <= 0.0; }

bool leads_inside(const std::string& wound) { return wound == "incision" || wound == "side_port"; }

}  // namespace rhexis::station
