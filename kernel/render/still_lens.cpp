// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/still_lens.hpp"

#include <cmath>
#include <numbers>

#include "render/vertex_floats.hpp"

namespace rhexis {

namespace {

constexpr int turns = 48;  ///< triangles' edges around the axis
constexpr int rings = 24;  ///< and from pole to pole: the surface is nowhere off by more than 15 um

/// On the contour: number of the ring from the front, and of the meridian.
Vec3 contour_point(const BagShape& shape, int ring, int turn) {
    const double from_pole = std::numbers::pi * ring / rings;
    const double around = 2.0 * std::numbers::pi * (turn % turns) / turns;
    const double rho = ring == 0 || ring == rings ? 0.0 : shape.radius * std::sin(from_pole);
    const double depth = 2 * ring <= rings ? shape.anterior : shape.posterior;
    return {rho * std::cos(around), rho * std::sin(around), depth * std::cos(from_pole)};
}

/// Calls with the corners of each triangle, counter-clockwise from outside.
template <typename Use>
void for_each_triangle(const BagShape& shape, const Use& use) {
    for (int ring = 0; ring < rings; ++ring) {
        for (int turn = 0; turn < turns; ++turn) {
            const Vec3 a = contour_point(shape, ring, turn);
            const Vec3 b = contour_point(shape, ring + 1, turn);
            const Vec3 c = contour_point(shape, ring + 1, turn + 1);
            const Vec3 d = contour_point(shape, ring, turn + 1);
            if (ring + 1 < rings) {
                use(std::array<Vec3, 3>{a, b, c});
            }
            if (ring > 0) {
                use(std::array<Vec3, 3>{a, c, d});
            }
        }
    }
}

/// An eye of which only the front takes part, before anything was cut: its lens is still there.
bool is_untouched(const Frame& frame) {
    const WorldModel& model = *frame.model;
    const bool cut_before = model.wounds && model.wounds->start[main_wound].cut;
    const bool front_only =
        model.solids.empty() && model.bags.empty() && model.membranes.empty() && model.shells.empty();
    return frame.eye->has_iris && front_only && !cut_before;
}

}  // namespace

std::optional<StillLens> still_lens(const Frame& frame) {
    if (!frame.eye || !frame.solids.empty()) {
        return std::nullopt;
    }
    if (is_untouched(frame)) {
        const double front = frame.eye->cornea_apex_z - frame.eye->anterior_chamber_depth;
        BagShape shape;
        shape.posterior *= front / shape.anterior;
        shape.anterior = front;
        return StillLens{shape, 0.0, frame.eye->lens_zones};
    }
    for (std::size_t i = 0; i < frame.membranes.size(); ++i) {
        const std::optional<SupportModel>& support = frame.model->membranes[i].support;
        if (support) {
            return StillLens{support->shape, frame.membranes[i].support.lift, frame.eye->lens_zones};
        }
    }
    return std::nullopt;
}

void append_signed_faces(const StillLens& lens, FaceStream& stream) {
    const Vec3 lift = lens.lift * Vec3::UnitZ();
    Vec3 outside = Vec3::Zero();
    for (const LensZone& zone : lens.zones) {
        const Eigen::Vector3f change = (zone.extinction - outside).cast<float>();
        outside = zone.extinction;
        for_each_triangle(lens.shape, [&](std::array<Vec3, 3> corners) {
            for (Vec3& corner : corners) {
                corner = zone.scale * corner + lift;
            }
            stream.push_back({corners, change});
        });
    }
}

void append_front(const StillLens& lens, std::vector<float>& stream) {
    const Vec3 lift = lens.lift * Vec3::UnitZ();
    for_each_triangle(lens.shape, [&](const std::array<Vec3, 3>& corners) {
        for (const Vec3& corner : corners) {
            append_floats(corner + lift, stream);
            append_floats(corner, stream);
        }
    });
}

Vec3 contour_of(const std::optional<StillLens>& lens) {
    return lens ? Vec3(lens->shape.radius, lens->shape.anterior, lens->shape.posterior) : Vec3(Vec3::Zero());
}

}  // namespace rhexis
