// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lids_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

using Part = ToolMesh::Part;
using Vertex = ToolMesh::Vertex;

constexpr int fine = 4;          ///< strips per place of lashes
constexpr double beyond = 26.0;  ///< how far skin and drape go on outwards [mm]
constexpr double thick = 1.0;    ///< of a lid's margin [mm]
constexpr double rise = 2.5;     ///< of the skin outwards [mm]
constexpr double lash_length = 5.0;
constexpr double lash_width = 0.10;
constexpr int lashes_per_place = 5;

/// A point of a margin: the place of lashes is a number with fractions here.
struct Margin {
    Vec3 place;
    Vec3 out;  ///< away from the eye, across the view
};

Margin margin_at(const LidsModel& model, double opening, int lid, double along) {
    const double x = model.half_width * (2.0 * along / model.per_lid - 1.0);
    const double half = model.shut + opening * (model.opened - model.shut);
    const double share = x / model.half_width;
    const double side = lid == 0 ? -1.0 : 1.0;
    const Vec2 out = Vec2(0.6 * share, side).normalized();
    return {Vec3(x, side * half * (1.0 - share * share), model.height - model.fall * x * x),
            Vec3(out.x(), out.y(), 0.0)};
}

void add_triangle(const Vertex& a, const Vertex& b, const Vertex& c, Part& part) {
    const Vec3 face = (b.place - a.place).cross(c.place - a.place);
    if (face.dot(a.normal + b.normal + c.normal) >= 0.0) {
        part.corners.insert(part.corners.end(), {a, b, c});
    } else {
        part.corners.insert(part.corners.end(), {a, c, b});
    }
}

/// From the margin over its rounded edge outwards; inset and lift [mm] are where a layer over the skin begins.
void add_strip(const Margin& from, const Margin& to, double inset, double lift, Part& part) {
    constexpr int rings = 7;
    const auto vertex = [&](const Margin& margin, int ring) {
        const double share = static_cast<double>(ring) / (rings - 1);
        const double out = ring < 4 ? -inset + thick * share * 2.0 : -inset + beyond * share;
        const double up = ring < 4 ? thick * std::sqrt(std::min(1.0, 2.0 * share)) : thick + rise * share;
        const Vec3 normal =
            ring < 3 ? Vec3((1.0 - 2.0 * share) * -margin.out + Vec3(0.0, 0.0, 0.5 + share)) : Vec3::UnitZ();
        return Vertex{margin.place + out * margin.out + Vec3(0.0, 0.0, up + lift), normal.normalized()};
    };
    for (int ring = 0; ring + 1 < rings; ++ring) {
        const Vertex a = vertex(from, ring);
        const Vertex b = vertex(to, ring);
        const Vertex c = vertex(to, ring + 1);
        const Vertex d = vertex(from, ring + 1);
        add_triangle(a, b, c, part);
        add_triangle(a, c, d, part);
    }
}

/// Two crossed slivers that curve up and outwards.
void add_lash(const Margin& root, double lean, Part& part) {
    const Vec3 along = Vec3::UnitZ().cross(root.out);
    const Vec3 start = root.place + 0.5 * root.out + Vec3(0.0, 0.0, thick);
    const auto point = [&](double share) {
        return Vec3(start + lash_length * share * root.out + lean * share * share * along +
                    Vec3(0.0, 0.0, 2.6 * share * share));
    };
    for (int piece = 0; piece < 4; ++piece) {
        const double near = 0.25 * piece;
        const double far = near + 0.25;
        const Vec3 side = lash_width * along;
        const Vertex a{point(near) - (1.0 - near) * side, Vec3::UnitZ()};
        const Vertex b{point(near) + (1.0 - near) * side, Vec3::UnitZ()};
        const Vertex c{point(far) + (1.0 - far) * side, Vec3::UnitZ()};
        const Vertex d{point(far) - (1.0 - far) * side, Vec3::UnitZ()};
        add_triangle(a, b, c, part);
        add_triangle(a, c, d, part);
    }
}

}  // namespace

ToolMesh lids_mesh(const LidsModel& model, const LidsState& lids) {
    ToolMesh mesh;
    mesh.parts.resize(3);
    Part& skin = mesh.parts[0];
    Part& lashes = mesh.parts[1];
    Part& drape = mesh.parts[2];
    skin.finish = ToolFinish::skin;
    lashes.finish = ToolFinish::lash;
    drape.finish = ToolFinish::drape;
    for (int lid = 0; lid < 2; ++lid) {
        for (int strip = 0; strip < fine * model.per_lid; ++strip) {
            const double from = static_cast<double>(strip) / fine;
            const Margin left = margin_at(model, lids.opening, lid, from);
            const Margin right = margin_at(model, lids.opening, lid, from + 1.0 / fine);
            add_strip(left, right, 0.0, 0.0, skin);
            if (lids.covered[static_cast<std::size_t>(lid * model.per_lid + strip / fine)] != 0) {
                add_strip(left, right, 0.6, 0.35, drape);
            }
        }
        for (int lash = 0; lash < lashes_per_place * model.per_lid; ++lash) {
            const int place = lash / lashes_per_place;
            if (lids.covered[static_cast<std::size_t>(lid * model.per_lid + place)] == 0) {
                const double along = (lash + 0.5) / lashes_per_place;
                add_lash(margin_at(model, lids.opening, lid, along), 0.8 * ((lash * 7) % 5 - 2) / 2.0, lashes);
            }
        }
    }
    return mesh;
}

}  // namespace rhexis
