// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/print/marker_body_stl.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"

namespace rhexis::tracking {
namespace {

constexpr int arc_points = 9;      ///< of a quarter of a circle, and of a seat
constexpr double clasp_mm = 10.0;  ///< that a rod overlaps the handle which it goes on from

/// Round in the sleeve's wall, hollow under the sphere, and the pin.
Solid strut_of(const Vec3& from, const Vec3& marker, double seat_radius, const MarkerBodyPrint& print) {
    const double length = (marker - from).norm();
    const double radius = print.mount.strut_radius;
    std::vector<ProfilePoint> profile{{0.0, -radius}};
    for (int i = 1; i <= arc_points; ++i) {
        const double angle = 0.5 * std::numbers::pi * i / arc_points;
        profile.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
    }
    for (int i = 0; i <= arc_points; ++i) {
        const double across = radius + (print.pin_radius - radius) * i / arc_points;
        profile.push_back({across, length - std::sqrt(seat_radius * seat_radius - across * across)});
    }
    profile.push_back({print.pin_radius, length - seat_radius + print.pin_length});
    profile.push_back({0.0, length - seat_radius + print.pin_length});
    return revolved({from, (marker - from) / length}, profile);
}

/// A ring, or a cap with a rod where the handle ends before the sleeve does.
Solid sleeve_of(const Handle& handle, const Mount& mount, bool solid, const MountSizes& sizes) {
    const double bore = mount.bore + sizes.clearance;
    const double outer = bore + sizes.wall;
    const bool rod = handle.to_mm < mount.to_mm;
    const double clasp = std::min(mount.from_mm, handle.to_mm - clasp_mm);
    std::vector<ProfilePoint> profile;
    double inner = 0.0;
    if (!solid) {
        inner = (rod ? greatest_radius(handle, clasp, handle.to_mm) : mount.bore) + sizes.clearance;
    }
    const auto end_mm = handle.to_mm + sizes.clearance;
    if (rod && !solid) {
        profile.push_back({0.0, end_mm});
        profile.push_back({inner, end_mm});
    }
    if (rod && clasp < mount.from_mm) {
        const double thick = std::max(sizes.rod_radius, inner + 1.0);
        profile.push_back({inner, clasp});
        profile.push_back({thick, clasp});
        profile.push_back({thick, mount.from_mm});
    } else {
        profile.push_back({inner, mount.from_mm});
    }
    profile.push_back({outer, mount.from_mm});
    profile.push_back({outer, mount.to_mm});
    profile.push_back({rod ? 0.0 : inner, mount.to_mm});
    if (!rod && !solid) {
        profile.push_back({inner, mount.from_mm});
    }
    return revolved({handle.foot, handle.along}, profile);
}

/// Below the markers, across the body's z axis: all struts begin in its middle.
struct Plate {
    double height = 0.0;  ///< of its middle
    Mount mount{};
};

double plate_thick(const MountSizes& sizes) { return 2.0 * sizes.strut_radius + 1.0; }

Plate plate_of(const MarkerBody& body, const MountSizes& sizes) {
    Plate plate;
    double lowest = body.markers.front().z();
    for (const Vec3& marker : body.markers) {
        lowest = std::min(lowest, marker.z());
    }
    plate.height = lowest - body.radius_mm - sizes.apart - plate_thick(sizes);
    plate.mount.begins.assign(body.markers.size(), {0.0, 0.0, plate.height});
    return plate;
}

Solid disc_of(const Plate& plate, const MountSizes& sizes) {
    constexpr double radius = 12.0;
    const double half = 0.5 * plate_thick(sizes);
    const std::array<ProfilePoint, 4> profile{{{0.0, -half}, {radius, -half}, {radius, half}, {0.0, half}}};
    return revolved({{0.0, 0.0, plate.height}, Vec3::UnitZ()}, profile);
}

Status check_print_sizes(const MarkerBody& body, const MarkerBodyPrint& print) {
    const std::string where = "body \"" + body.name + "\"";
    const double most_pin = std::min(5.0, 0.95 * print.mount.strut_radius);
    if (const Status status = check_range("pin_radius", print.pin_radius, 0.2, most_pin, where, " mm"); !status) {
        return status;
    }
    return check_range("pin_length", print.pin_length, 0.5, std::min(10.0, body.radius_mm), where, " mm");
}

void append(const Solid& solid, Solid& all) { all.insert(all.end(), solid.begin(), solid.end()); }

void append_shape(const Replica& replica, const Pose& tip, Solid& all) {
    for (const Solid& shell : replica.shape) {
        for (const Triangle& triangle : shell) {
            all.push_back({tip.to_world(triangle[0]), tip.to_world(triangle[1]), tip.to_world(triangle[2])});
        }
    }
}

}  // namespace

Result<std::string> marker_body_stl(const MarkerBody& body, const Replica& replica, const MarkerBodyPrint& print) {
    Solid all;
    Mount mount;
    append_shape(replica, body.tip, all);
    if (const Status sizes = check_print_sizes(body, print); !sizes) {
        return sizes.error();
    }
    if (replica.handle) {
        const Handle handle = moved_to(body.tip, *replica.handle);
        Result<Mount> planned = mount_of(body, handle, print.mount);
        if (!planned) {
            return planned.error();
        }
        mount = std::move(planned).value();
        append(sleeve_of(handle, mount, !replica.shape.empty(), print.mount), all);
    } else {
        const Plate plate = plate_of(body, print.mount);
        mount = plate.mount;
        append(disc_of(plate, print.mount), all);
    }
    for (std::size_t i = 0; i < body.markers.size(); ++i) {
        append(strut_of(mount.begins[i], body.markers[i], body.radius_mm + print.mount.clearance, print), all);
    }
    return binary_stl(all);
}

}  // namespace rhexis::tracking
