// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/retraction.hpp"

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "observe/rim.hpp"
#include "scenes/capsule_scene.hpp"
#include "topology/tear.hpp"

namespace rhexis::scenes {
namespace {

constexpr int steps_to_rest = 100;  ///< until lens and capsule are at rest
constexpr double ahead = 0.4;       ///< how far along the circle the knife aims [mm]

/// Mean ratio of distances from the axis, now over at rest, near a radius.
double drawn_wide(const MembraneState& sheet, double radius) {
    double now = 0.0;
    double rest = 0.0;
    for (std::size_t n = 0; n < sheet.position.size(); ++n) {
        const double own = sheet.sheet->mesh.nodes[n].head<2>().norm();
        if (std::abs(own - radius) < 0.3) {
            rest += own;
            now += sheet.position[n].head<2>().norm();
        }
    }
    return now / rest;
}

/// Cuts edge by edge along a circle of the sheet at rest until the cut meets its beginning.
void cut_round(CapsuleScene& scene, double radius) {
    MembraneState& sheet = scene.sheet();
    const auto place = [&](double angle) { return scene.front(radius * std::cos(angle), radius * std::sin(angle)); };
    const auto angle_of = [](const Vec3& x) { return std::atan2(x.y(), x.x()); };
    Result<MembraneEdit> edit =
        puncture(scene.model(), sheet, nearest_triangle(sheet.sheet->mesh, place(0.0)), place(0.0), -Vec3::UnitY());
    double gone = 0.0;
    const std::size_t both = 2;
    while (edit.ok()) {
        sheet = applied(sheet, edit.value());
        if (sheet.tips.size() != both) {
            return;
        }
        const std::vector<Vec3>& nodes = sheet.sheet->mesh.nodes;
        const Vec3 here = nodes[at(sheet.tips.back().node)] + sheet.tips.back().owed;
        const Vec3& beginning = nodes[at(sheet.tips.front().node)];
        const double angle = angle_of(here);
        gone = angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
        const bool home = gone > std::numbers::pi && (beginning - here).norm() < ahead;
        edit = tear(scene.model(), sheet, static_cast<int>(sheet.tips.size()) - 1,
                    (home ? beginning : place(angle + ahead / radius)) - here);
    }
}

}  // namespace

Retraction retraction(double age, double diameter, const AnteriorCapsuleSettings& settings) {
    CapsuleScene scene(age, settings, {});
    scene.settle(steps_to_rest);
    const double wide = drawn_wide(scene.sheet(), 0.5 * diameter);
    cut_round(scene, 0.5 * diameter / wide);
    Retraction result;
    RhexisShape shape = rhexis_shape(*scene.model().sheet, scene.sheet());
    result.closed = shape.closed;
    result.cut = shape.mean_diameter;
    scene.settle(steps_to_rest);
    if (shape.closed) {
        measure_rim_now(scene.sheet(), shape);
        result.open = shape.mean_diameter;
        result.rest = shape.rest_diameter;
    }
    return result;
}

}  // namespace rhexis::scenes
