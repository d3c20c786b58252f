// SPDX-License-Identifier: GPL-3.0-or-later
// Speed against accuracy of what a capsulorhexis consists of: a needle goes through the capsule and cuts, forceps take
// a flap, fold it over and tear it round. By mesh, step and solver; against the finest mesh and step.
#include "bench/bench_capsule_chart.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "scenes/capsule_scene.hpp"
#include "tools/rhexis_tools.hpp"

namespace rhexis::bench {
namespace {

using scenes::CapsuleScene;

constexpr double age = 68.0;
constexpr double circle = 1.7;   ///< on which the hand leads the flap round [mm]
constexpr double height = 0.2;   ///< over the lens [mm]
constexpr double arc = 2.2;      ///< of the hand in the pull [rad]
constexpr double stride = 0.08;  ///< of the hand between two places [rad]
constexpr double speed = 1.5;    ///< of forceps and, through the capsule, of the needle [mm/s]

struct Point {
    std::string name;
    int triangles = 1500;
    double step_s = 0.01;
    MembraneSolve solve;
};

/// What came of one point.
struct Run {
    std::size_t triangles = 0;
    double edge = 0.0;       ///< mean, at rest [mm]
    double needle = 0.0;     ///< mean force while it cuts [uN]
    double pull = 0.0;       ///< mean force on the forceps from the first tear to the last [uN]
    std::vector<Vec3> path;  ///< of the end of the tear that the forceps lead, at rest [mm]
    double simulated = 0.0;  ///< [s]
    double cpu = 0.0;        ///< [s]
    double slowest = 0.0;    ///< CPU s per simulated s of the part that costs most
    bool good = true;
};

double mean_edge(const MembraneSheet& sheet) {
    double area = 0.0;
    for (int t = 0; t < static_cast<int>(sheet.mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = sheet.mesh.triangles[at(t)];
        area += triangle_area(sheet.mesh.nodes[at(n[0])], sheet.mesh.nodes[at(n[1])], sheet.mesh.nodes[at(n[2])]);
    }
    // of triangles with three equal sides
    return std::sqrt(area / static_cast<double>(sheet.mesh.triangles.size()) * 4.0 / std::sqrt(3.0));
}

class Timed {
public:
    Timed(const CapsuleScene& scene, Run& run)
        : scene_(&scene), run_(&run), cpu_(thread_cpu_seconds()), time_(scene.time_s()) {}
    void finish() const {
        const double cpu = thread_cpu_seconds() - cpu_;
        const double time = scene_->time_s() - time_;
        run_->cpu += cpu;
        run_->simulated += time;
        run_->slowest = std::max(run_->slowest, cpu / time);
    }

private:
    const CapsuleScene* scene_;
    Run* run_;
    double cpu_;
    double time_;
};

PhysicsSettings settings_of(const Point& point) {
    PhysicsSettings settings;
    settings.membranes = point.solve;
    return settings;
}

void cut(const Point& point, Run& run) {
    CapsuleScene scene(age, {.triangles = point.triangles}, {cystotome()}, true, point.step_s, settings_of(point));
    const auto above = [&](double x, double z) { return Vec3(scene.front(x, -0.2) + z * Vec3::UnitZ()); };
    const Timed timed(scene, run);
    scene.put(0, above(0.3, 0.3));
    run.good = scene.lead(0, above(0.3, -0.5), speed) && run.good;
    const double torn = scene.sheet().torn_area;
    double sum = 0.0;
    int count = 0;
    for (double x = 0.4; x < 2.05; x += 0.02) {
        run.good = scene.lead(0, above(x, -0.5), speed) && run.good;
        if (scene.sheet().torn_area > torn) {
            sum += scene.force().norm();
            ++count;
        }
    }
    timed.finish();
    run.needle = count > 0 ? sum / count : 0.0;
}

/// One step after the other, so that the force is looked at in each.
void tear_round(const Point& point, Run& run) {
    CapsuleScene scene(age, {.triangles = point.triangles}, {capsulorhexis_forceps()}, true, point.step_s,
                       settings_of(point));
    scene.open_flap(1.0, 2.6, 0.9);
    const auto above = [&](double angle, double radius, double z) {
        return Vec3(scene.front(radius * std::cos(angle), radius * std::sin(angle)) + z * Vec3::UnitZ());
    };
    const auto end = [&] { return scene.sheet().sheet->mesh.nodes[at(scene.sheet().tips.back().node)]; };
    const Timed timed(scene, run);
    run.path = {end()};
    scene.put(0, above(0.2, 2.24, 0.01), 1.0);
    run.good = scene.lead(0, above(0.2, 2.24, 0.02), 1.0, 0.0) && run.good;
    double sum = 0.0;
    double until = scene.sheet().torn_area;
    double spent = 0.0;
    for (double angle = 0.2; angle < 0.2 + arc; angle += stride) {
        const Vec3 start = scene.tool(0).pose.position;
        const Vec3 to = above(angle, circle, height);
        const int steps = std::max(1, static_cast<int>(std::ceil((to - start).norm() / (speed * point.step_s))));
        for (int i = 1; i <= steps; ++i) {
            run.good = scene.lead(0, start + (to - start) * (static_cast<double>(i) / steps), 1e6, 0.0) && run.good;
            sum += run.path.size() > 1 ? scene.force().norm() * point.step_s : 0.0;
            spent += run.path.size() > 1 ? point.step_s : 0.0;
            if (scene.sheet().torn_area > until) {
                until = scene.sheet().torn_area;
                run.path.push_back(end());
                run.pull = spent > 0.0 ? sum / spent : scene.force().norm();
            }
        }
    }
    timed.finish();
    run.triangles = scene.model().sheet->mesh.triangles.size();
    run.edge = mean_edge(*scene.model().sheet);
}

Run measure(const Point& point) {
    Run run;
    cut(point, run);
    tear_round(point, run);
    return run;
}

double length_of(const std::vector<Vec3>& path) {
    double sum = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        sum += (path[i] - path[i - 1]).norm();
    }
    return sum;
}

double distance_to(const std::vector<Vec3>& path, const Vec3& point) {
    double least = (path[0] - point).norm();
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vec3 along = path[i] - path[i - 1];
        const double square = along.squaredNorm();
        const double share = square > 0.0 ? std::clamp(along.dot(point - path[i - 1]) / square, 0.0, 1.0) : 0.0;
        least = std::min(least, (path[i - 1] + share * along - point).norm());
    }
    return least;
}

/// Farthest that a path is from another, as far as both go [mm].
double apart(const std::vector<Vec3>& path, const std::vector<Vec3>& other) {
    const double common = length_of(other);
    double gone = 0.0;
    double most = distance_to(other, path[0]);
    for (std::size_t i = 1; i < path.size(); ++i) {
        gone += (path[i] - path[i - 1]).norm();
        if (gone <= common) {
            most = std::max(most, distance_to(other, path[i]));
        }
    }
    return most;
}

Point by(const std::string& name, int triangles, double step_s) { return {name, triangles, step_s, {}}; }

std::vector<Point> points(bool quick) {
    if (quick) {
        return {by("mesh", 400, 0.01)};
    }
    std::vector<Point> list;
    for (const int triangles : {400, 750, 1000, 1500, 3000, 6000}) {
        list.push_back(by("mesh", triangles, 0.01));
    }
    for (const double step_s : {0.0025, 0.005, 0.02, 0.04}) {
        list.push_back(by("step", 1500, step_s));
    }
    for (const int triangles : {400, 750, 1000}) {
        list.push_back(by("mesh, 20 ms", triangles, 0.02));
    }
    for (const double force : {2.0, 100.0, 500.0}) {
        list.push_back(by("tolerance", 1500, 0.01));
        list.back().solve.force_tolerance = force;
        list.back().solve.max_newton = force < 20.0 ? 40 : 8;
    }
    for (const int most : {2, 4, 40}) {
        list.push_back(by("most iterations", 1500, 0.01));
        list.back().solve.max_newton = most;
    }
    list.push_back(by("kept factor", 1500, 0.01));
    list.back().solve.new_factors = false;
    return list;
}

nlohmann::json row(const Point& point, const Run& run, const Run& finest) {
    return {{"name", point.name},
            {"elements", run.triangles},
            {"edge_mm", run.edge},
            {"step_ms", 1e3 * point.step_s},
            {"tolerance_un", point.solve.force_tolerance},
            {"most_newton", point.solve.max_newton},
            {"cpu_s_per_s", run.cpu / run.simulated},
            {"slowest_cpu_s_per_s", run.slowest},
            {"path_mm", apart(run.path, finest.path)},
            {"torn_mm", length_of(run.path)},
            {"needle_mn", 1e-3 * run.needle},
            {"pull_mn", 1e-3 * run.pull},
            {"error", std::abs(run.pull / finest.pull - 1.0)},
            {"error_kind", "force of the pull against the finest mesh and step"},
            {"failure", run.good ? "" : "a step was given up"}};
}

nlohmann::json chart(const BenchOptions& options) {
    Point best = by("finest", options.quick ? 750 : 6000, options.quick ? 0.01 : 0.0025);
    best.solve = {2.0, 40, true};
    const Run finest = measure(best);
    nlohmann::json rows = nlohmann::json::array();
    rows.push_back(row(best, finest, finest));
    for (const Point& point : points(options.quick)) {
        rows.push_back(row(point, measure(point), finest));
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> capsule_chart_cases() {
    return {{"capsule_chart", "tearing the capsule: path, force and cost by mesh, step and solver", chart}};
}

}  // namespace rhexis::bench
