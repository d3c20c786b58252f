// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/tear_paths.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "scenes/tears.hpp"

namespace rhexis::scenes {
double slope(const std::vector<double>& x, const std::vector<double>& y) {
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += std::log(x[i]) / static_cast<double>(x.size());
        mean_y += std::log(y[i]) / static_cast<double>(x.size());
    }
    double up = 0.0;
    double down = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        up += (std::log(x[i]) - mean_x) * (std::log(y[i]) - mean_y);
        down += (std::log(x[i]) - mean_x) * (std::log(x[i]) - mean_x);
    }
    return up / down;
}

TearPath tear_path(TriMesh mesh, const Vec3& fibre, double across) {
    const double side = 8.0;
    MembraneModel model = membrane("sheet", std::move(mesh), Orthotropic{1e6, 1e6, 0.45, 0.0}, fibre);
    model.toughness = {2e3, 2e3 * across * across};
    model.tear_radius = 0.8;
    model.damping_mass = 200.0;
    std::vector<int> low;
    std::vector<int> high;
    const TriMesh& rest = model.sheet->mesh;
    for (int n = 0; n < static_cast<int>(rest.nodes.size()); ++n) {
        const Vec3& x = rest.nodes[at(n)];
        // a round sheet, gripped over two arcs
        if (x.norm() > 0.5 * side - 1e-6 && std::abs(x.x()) < std::abs(x.y())) {
            (x.y() < 0.0 ? low : high).push_back(n);
        }
    }
    hold(model, low, high);
    HeldSheet held(model);
    int middle = 0;
    for (int n = 0; n < static_cast<int>(rest.nodes.size()); ++n) {
        middle = rest.nodes[at(n)].norm() < rest.nodes[at(middle)].norm() ? n : middle;
    }
    const int triangle = model.sheet->neighbours.triangles[at(model.sheet->neighbours.offset[at(middle)])];
    const Result<MembraneEdit> slit = puncture(model, held.state(), triangle, rest.nodes[at(middle)], Vec3::UnitX());
    TearPath path;
    if (!slit.ok()) {
        return path;
    }
    held.state() = applied(held.state(), slit.value());
    const double start = thread_cpu_seconds();
    for (int i = 0; i < 2000; ++i) {
        for (const int node : low) {
            held.state().position[at(node)].y() -= 0.002;
        }
        for (const int node : high) {
            held.state().position[at(node)].y() += 0.002;
        }
        for (int k = 0; k < 3; ++k) {
            held.step(0.01, {}, {.tolerance = 1e-4, .max_newton = 6, .newton_tolerance = 1e-3});
            path.simulated_s += 0.01;
        }
        tear_once(held.model(), held.state());
        const auto right = std::max_element(
            held.state().tips.begin(), held.state().tips.end(), [&](const TearTip& a, const TearTip& b) {
                return held.state().sheet->mesh.nodes[at(a.node)].x() < held.state().sheet->mesh.nodes[at(b.node)].x();
            });
        if (right == held.state().tips.end()) {
            break;
        }
        const Vec3& place = held.state().sheet->mesh.nodes[at(right->node)];
        if (path.places.empty() || (path.places.back() - place).norm() > 1e-9) {
            path.places.push_back(place);
        }
        if (place.norm() > 0.5 * side - 1.2) {
            break;
        }
    }
    path.cpu_s = thread_cpu_seconds() - start;
    return path;
}

double off_line(const TearPath& path, double angle) {
    double most = 0.0;
    const Vec3 normal(-std::sin(angle), std::cos(angle), 0.0);
    for (const Vec3& place : path.places) {
        most = std::max(most, std::abs(normal.dot(place)));
    }
    return most;
}

double angle_of(const TearPath& path) {
    return path.places.empty() ? 0.0 : std::atan2(path.places.back().y(), path.places.back().x());
}

TriMesh turned(TriMesh mesh, double angle) {
    const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    for (Vec3& x : mesh.nodes) {
        x = turn * x;
    }
    return mesh;
}

}  // namespace rhexis::scenes
