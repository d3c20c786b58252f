// SPDX-License-Identifier: GPL-3.0-or-later
// What forceps feel in each pull of a capsulorhexis, by toughness: the published first pull calibrates it.
#include "bench/bench_capsule_pulls.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "scenes/capsule_scene.hpp"
#include "scenes/flap_hand.hpp"
#include "tools/rhexis_tools.hpp"

namespace rhexis::bench {
namespace {

using scenes::CapsuleScene;

constexpr double age = 68.0;
constexpr double held_behind = 0.8;  ///< the end of the tear, along the flap's edge at rest [mm]
constexpr double circle = 1.7;       ///< on which the hand leads the flap round [mm]
constexpr double height = 0.2;       ///< over the lens [mm]
constexpr double arc = 2.2;          ///< of the hand in a pull [rad]
constexpr double stride = 0.04;      ///< of the hand between two looks [rad]
constexpr double speed = 1.5;        ///< [mm/s]

/// While it tears: from the first tear of a pull to the last.
struct Pull {
    double mean = 0.0;  ///< [uN]
    double peak = 0.0;  ///< [uN]
    double torn = 0.0;  ///< [mm^2]
};

Vec3 where_to_hold(const MembraneState& sheet) {
    const int node = scenes::node_to_hold(sheet, sheet.sheet->mesh.nodes[at(sheet.tips.back().node)], held_behind);
    return node < 0 ? Vec3::Zero() : sheet.position[at(node)];
}

/// The first pull takes the flap where it lies; nothing has moved yet.
Vec3 on_flap(const CapsuleScene& scene, double angle, double radius) {
    return scene.front(radius * std::cos(angle), radius * std::sin(angle));
}

Pull pull(CapsuleScene& scene, const Vec3& place) {
    const Vec3 up = 0.01 * Vec3::UnitZ();
    scene.put(0, place + up, 1.0);
    scene.lead(0, place + 2.0 * up, 1.0, 0.0);
    const double before = scene.sheet().torn_area;
    const double from = std::atan2(place.y(), place.x());
    double last = before;
    double sum = 0.0;
    double peak = 0.0;
    int count = 0;
    Pull result;
    for (double angle = from; angle < from + arc && !scene.sheet().grips.empty(); angle += stride) {
        const Vec3 to = on_flap(scene, angle, circle) + height * Vec3::UnitZ();
        const Vec3 start = scene.tool(0).pose.position;
        const int steps = std::max(1, static_cast<int>(std::ceil((to - start).norm() / (speed * 0.01))));
        for (int i = 1; i <= steps; ++i) {
            scene.lead(0, start + (to - start) * (static_cast<double>(i) / steps), 1e3, 0.0);
            const bool tore = scene.sheet().torn_area > last;
            last = scene.sheet().torn_area;
            if (tore || last > before) {
                sum += scene.force().norm();
                peak = std::max(peak, scene.force().norm());
                ++count;
            }
            if (tore) {
                result = {sum / count, peak, last - before};
            }
        }
    }
    scene.lead(0, scene.tool(0).pose.position + 0.8 * Vec3::UnitZ(), 4.0, 1.0);
    return result;
}

nlohmann::json run(const BenchOptions& options) {
    nlohmann::json rows = nlohmann::json::array();
    const std::vector<double> shares =
        options.quick ? std::vector<double>{1.0} : std::vector<double>{0.6, 0.8, 1.0, 1.2};
    for (const double share : shares) {
        const double start = thread_cpu_seconds();
        CapsuleScene scene(age, {.toughness = share}, {capsulorhexis_forceps()});
        scene.open_flap(1.0, 2.6, 0.9);
        const double toughness = scene.model().toughness.along;
        for (int i = 1; i <= 5 && !scene.sheet().tips.empty(); ++i) {
            const Pull one = pull(scene, i == 1 ? on_flap(scene, 0.2, 2.24) : where_to_hold(scene.sheet()));
            rows.push_back(
                {{"name", "capsule_pulls/" + std::to_string(toughness * 1e-6).substr(0, 4) + "/" + std::to_string(i)},
                 {"elements", scene.model().sheet->mesh.triangles.size()},
                 {"toughness_kj_m2", toughness * 1e-6},
                 {"mean_mn", one.mean * 1e-3},
                 {"peak_mn", one.peak * 1e-3},
                 {"torn_mm", one.torn / anterior_thickness(age, 2.4, 4.8)},
                 {"cpu_s", thread_cpu_seconds() - start}});
        }
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> capsule_pulls_cases() {
    return {{"capsule_pulls", "force of each pull of forceps that tear the capsule round, by its toughness", run}};
}

}  // namespace rhexis::bench
