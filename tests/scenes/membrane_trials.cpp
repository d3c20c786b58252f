// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/membrane_trials.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "mesh/shapes.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "scenes/eigenvalues.hpp"
#include "scenes/membranes.hpp"

namespace rhexis::scenes {
namespace {

const Orthotropic fibrous{1.0e6, 2.5e5, 0.45, 0.0};

double off_plane(const MembraneState& state) {
    double most = 0.0;
    for (const Vec3& x : state.position) {
        most = x.allFinite() ? std::max(most, std::abs(x.z())) : NAN;
        if (std::isnan(most)) {
            break;
        }
    }
    return most;
}

/// Least eigenvalue of the stiffness that steps are solved with, over its norm.
double least_eigenvalue(const MembraneTriangle& triangle, const TrianglePoints& x) {
    TrianglePoints force;
    TriangleBlocks blocks;
    membrane_stiffness(triangle, x, MembraneTangent::definite, force, blocks);
    Eigen::Matrix<double, 9, 9> full;
    std::size_t slot = 0;
    for (int a = 0; a < 3; ++a) {
        for (int b = a; b < 3; ++b, ++slot) {
            full.block<3, 3>(3 * a, 3 * b) = blocks[slot];
            full.block<3, 3>(3 * b, 3 * a) = blocks[slot].transpose();
        }
    }
    const double norm = full.norm();
    return norm > 0.0 ? eigenvalues(full)[0] / norm : 0.0;
}

double least_eigenvalue(const MembraneModel& model, const MembraneState& state) {
    double least = HUGE_VAL;
    const std::vector<MembraneTriangle> triangles = membrane_triangles(model, *state.sheet);
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        least = std::min(least, least_eigenvalue(triangles[at(t)], points_now(state, t)));
    }
    return least;
}

double kinetic_energy(const MembraneModel& model, const MembraneState& state) {
    double energy = 0.0;
    for (std::size_t t = 0; t < state.sheet->mesh.triangles.size(); ++t) {
        const std::array<int, 3>& n = state.sheet->mesh.triangles[t];
        const std::vector<Vec3>& x = state.sheet->mesh.nodes;
        const double mass =
            model.density * state.sheet->thickness[t] * triangle_area(x[at(n[0])], x[at(n[1])], x[at(n[2])]);
        for (const int node : n) {
            energy += mass / 6.0 * state.velocity[at(node)].squaredNorm();
        }
    }
    return energy;
}

double change(double now, double before) { return std::abs(now - before) / before; }

}  // namespace

Tautness shake_taut(double dt, int steps) {
    MembraneModel model = membrane("taut", square_sheet(4.0, 400), isotropic(1e6, 0.45));
    const TriMesh& mesh = model.sheet->mesh;
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
        const Vec3& x = mesh.nodes[at(n)];
        if (x.x() == 0.0 || x.x() == 4.0 || x.y() == 0.0 || x.y() == 4.0) {
            model.fixed_nodes.push_back(n);
        }
    }
    HeldSheet sheet(std::move(model));
    Rng rng(3, "taut");
    const std::vector<int>& fixed = sheet.model().fixed_nodes;
    for (int n = 0; n < static_cast<int>(sheet.state().position.size()); ++n) {
        Vec3& x = sheet.state().position[at(n)];
        x *= 1.1;
        if (!std::binary_search(fixed.begin(), fixed.end(), n)) {
            x.z() += 0.01 * (2.0 * rng.uniform() - 1.0);
        }
    }
    const double start = off_plane(sheet.state());
    Tautness found;
    for (int i = 0; i < steps && !std::isnan(found.swing); ++i) {
        const bool finite = std::isfinite(sheet.step(dt).newton_residual);
        const double now = off_plane(sheet.state()) / start;
        found.swing = finite && !std::isnan(now) ? std::max(found.swing, now) : NAN;
    }
    return found;
}

Slackness crumple(int steps) {
    MembraneModel model = membrane("slack", square_sheet(4.0, 400), fibrous, Vec3(1.0, 0.7, 0.0));
    model.fixed_nodes = nodes_at(model.sheet->mesh, 0, 0.0);
    HeldSheet sheet(std::move(model));
    Rng rng(4, "slack");
    for (Vec3& x : sheet.state().position) {
        x = Vec3(0.4 * x.x(), x.y(), 0.05 * (2.0 * rng.uniform() - 1.0));
    }
    const double start = sheet.energy();
    double before = start;
    Slackness found;
    for (int i = 0; i < steps; ++i) {
        found.least = std::min(found.least, least_eigenvalue(sheet.model(), sheet.state()));
        found.residual = std::max(found.residual, sheet.step(0.01, {}, {.max_newton = 6}).residual);
        const double now = sheet.energy() + kinetic_energy(sheet.model(), sheet.state());
        found.rise = std::max(found.rise, (now - before) / start);
        before = now;
    }
    found.left = before / start;  // not a number where a position is none
    return found;
}

FibreSweep sweep_fibres(const Orthotropic& material) {
    Rng rng(6, "fibres");
    const TriMesh one{{Vec3(0.1, 0.0, 0.2), Vec3(0.9, 0.1, 0.25), Vec3(0.2, 0.7, 0.1)}, {{0, 1, 2}}};
    FibreSweep found;
    Vec3 first = Vec3::Zero();
    for (int degree = 0; degree <= 180; ++degree) {
        const double angle = degree * std::numbers::pi / 180.0;
        const Vec2 fibre(std::cos(angle), std::sin(angle));
        // strain with the tensor's shear: then turning the fibre is a rotation, which leaves the eigenvalues alone
        const Vec3 tensor(1.0, 1.0, std::numbers::sqrt2);
        const Mat3 k = tensor.asDiagonal() * plane_stiffness(material, fibre) * tensor.asDiagonal();
        const Vec3 values = eigenvalues(k);
        first = degree == 0 ? values : first;
        found.spread = std::max(found.spread, (values - first).norm() / first.norm());
        if (!(values[0] > 0.0)) {
            found.condition = NAN;
            return found;
        }
        found.condition = std::max(found.condition, values[2] / values[0]);
        const MembraneModel model = membrane("one", one, material, Vec3(fibre.x(), fibre.y(), 0.0));
        const MembraneTriangle triangle = membrane_triangles(model, *model.sheet)[0];
        for (int i = 0; i < 20; ++i) {
            TrianglePoints x;
            for (std::size_t a = 0; a < 3; ++a) {
                x[a] = one.nodes[a] + 0.3 * uniform3(rng);
            }
            found.least = std::min(found.least, least_eigenvalue(triangle, x));
        }
    }
    return found;
}

Renumbering renumber() {
    const Vec3 fibre(1.0, 0.4, 0.0);
    const TriMesh mesh = jittered(square_sheet(2.0, 200), 0.2, 1);
    HeldSheet sheet(membrane("sheet", mesh, fibrous, fibre));
    Rng rng(5, "moved");
    for (Vec3& x : sheet.state().position) {
        x += 0.05 * uniform3(rng);
    }
    TriMesh other = mesh;
    for (std::array<int, 3>& t : other.triangles) {
        std::rotate(t.begin(), t.begin() + 1, t.end());
    }
    std::reverse(other.triangles.begin(), other.triangles.end());
    HeldSheet again(membrane("again", other, fibrous, fibre));
    again.state().position = sheet.state().position;
    const Mat3 turn = Eigen::AngleAxisd(2.1, Vec3(1.0, 0.5, -0.3).normalized()).toRotationMatrix();
    TriMesh turned = mesh;
    for (Vec3& x : turned.nodes) {
        x = turn * x;
    }
    HeldSheet third(membrane("third", turned, fibrous, turn * fibre));
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        third.state().position[n] = turn * sheet.state().position[n];
    }
    return {change(again.energy(), sheet.energy()), change(third.energy(), sheet.energy())};
}

}  // namespace rhexis::scenes
