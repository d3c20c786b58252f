// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/tear_tip.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/index.hpp"
#include "energy/metric_strain.hpp"
#include "physics/membrane/membrane_body.hpp"

namespace rhexis {
namespace {

constexpr double least_radius = 2.0;  // of the domain of the integral, in edges at the tip

double mean_edge_at(const MembraneSheet& sheet, int node) {
    const TriNeighbours& around = sheet.neighbours;
    double sum = 0.0;
    int count = 0;
    for (int i = around.offset[at(node)]; i < around.offset[at(node) + 1]; ++i) {
        for (const int other : sheet.mesh.triangles[at(around.triangles[at(i)])]) {
            if (other != node) {
                sum += (sheet.mesh.nodes[at(other)] - sheet.mesh.nodes[at(node)]).norm();
                ++count;
            }
        }
    }
    return count > 0 ? sum / count : 0.0;
}

Mat2 matrix_of(const Vec3& stress) {
    Mat2 result;
    result << stress[0], stress[2], stress[2], stress[1];
    return result;
}

/// C S - w I of a triangle in its frame at rest [Pa].
Mat2 energy_momentum(const MembraneTriangle& triangle, const TrianglePoints& x) {
    const Vec3 c = metric_of(triangle, x);
    MetricStrain strain;
    metric_strain(c, strain);
    const TensionField field = tension_field(strain.strain, triangle.stiffness, triangle.rest);
    const Vec3 s = strain.first.transpose() * field.stress;  // by the metric
    Mat2 metric;
    metric << c[0], c[2], c[2], c[1];
    Mat2 stress;
    stress << 2.0 * s[0], s[2], s[2], 2.0 * s[1];
    return metric * stress - field.energy * Mat2::Identity();
}

PlaneFrame frame_at(const MembraneSheet& sheet, int node) {
    const TriNeighbours& around = sheet.neighbours;
    Vec3 front = Vec3::Zero();
    for (int i = around.offset[at(node)]; i < around.offset[at(node) + 1]; ++i) {
        front += front_of(sheet.mesh, around.triangles[at(i)]);
    }
    front.normalize();
    const Vec3 axis = std::abs(front.x()) < 0.7 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    PlaneFrame frame;
    frame.e1 = (axis - axis.dot(front) * front).normalized();
    frame.e2 = front.cross(frame.e1);
    return frame;
}

double quotient(const Mat2& stress, const Mat2& strength, const Vec2& u) {
    return u.dot(stress * u) / u.dot(strength * u);
}

/// u with the largest u.S u / u.A u: A positive definite.
Vec2 largest_opening(const Mat2& stress, const Mat2& strength) {
    // with A = L L^T: the eigenvector w of L^-1 S L^-T, u = L^-T w
    const double l11 = std::sqrt(strength(0, 0));
    const double l21 = strength(1, 0) / l11;
    const double l22 = std::sqrt(strength(1, 1) - l21 * l21);
    Mat2 inverse;
    inverse << 1.0 / l11, 0.0, -l21 / (l11 * l22), 1.0 / l22;
    const Mat2 m = inverse * stress * inverse.transpose();
    const double half = 0.5 * (m(0, 0) - m(1, 1));
    const double radius = std::sqrt(half * half + m(0, 1) * m(0, 1));
    const Vec2 w = half > 0.0 ? Vec2(half + radius, m(0, 1)) : Vec2(m(0, 1), radius - half);
    const Vec2 u = inverse.transpose() * (w.norm() > 0.0 ? w : Vec2(1.0, 0.0));
    return u.normalized();
}

Vec2 across(const Vec2& v) { return {-v.y(), v.x()}; }

/// A force at the tip itself is not what the integral is about: what a needle pushes it cuts, at a force of its own.
bool pushed(const MembraneState& state, int node) {
    return std::any_of(state.grips.begin(), state.grips.end(),
                       [node](const SheetGrip& grip) { return grip.node == node && grip.pushed; });
}

/// Jaws within the domain of a tip's integral: their forces are in it.
bool held_near(const MembraneState& state, int node, double radius) {
    const std::vector<Vec3>& rest = state.sheet->mesh.nodes;
    const double reach = std::max(radius, least_radius * mean_edge_at(*state.sheet, node));
    return std::any_of(state.grips.begin(), state.grips.end(), [&](const SheetGrip& grip) {
        return (rest[at(grip.node)] - rest[at(node)]).norm() < 1.5 * reach;
    });
}

/// The way that a tear came, in the plane. A needle that went back leaves a hook, whose end points backwards: energy
/// comes free against it, which no straight tear has, and the tear may go on that way.
Vec3 way_on(const MembraneModel& model, const MembraneState& state, const TearTip& tip, const Vec3& release) {
    const double least = std::min(model.toughness.along, model.toughness.across);
    const bool hooked = release.dot(tip.direction) < -least && !held_near(state, tip.node, model.tear_radius);
    return hooked ? Vec3(release.normalized()) : tip.direction;
}

bool is_tip(const MembraneState& state, int node) {
    return std::any_of(state.tips.begin(), state.tips.end(), [node](const TearTip& tip) { return tip.node == node; });
}

}  // namespace

std::vector<NearTriangle> near_tip(const MembraneSheet& sheet, int node, double radius) {
    const TriNeighbours& around = sheet.neighbours;
    const Vec3& origin = sheet.mesh.nodes[at(node)];
    std::vector<NearTriangle> result;
    std::vector<int> seen;
    const auto take = [&](int t) {
        if (std::find(seen.begin(), seen.end(), t) == seen.end()) {
            seen.push_back(t);
            result.push_back({t, (triangle_middle(sheet.mesh, t) - origin).norm()});
        }
    };
    for (int i = around.offset[at(node)]; i < around.offset[at(node) + 1]; ++i) {
        take(around.triangles[at(i)]);
    }
    for (std::size_t next = 0; next < result.size(); ++next) {
        for (const int other : around.across[at(result[next].triangle)]) {
            if (other >= 0 && (triangle_middle(sheet.mesh, other) - origin).norm() < radius) {
                take(other);
            }
        }
    }
    return result;
}

Vec3 release_at(const MembraneModel& model, const MembraneState& state, int node, double radius) {
    const MembraneSheet& sheet = *state.sheet;
    const double reach = std::max(radius, least_radius * mean_edge_at(sheet, node));
    const Vec3& origin = sheet.mesh.nodes[at(node)];
    Vec3 sum = Vec3::Zero();
    double thickness = 0.0;
    double weight = 0.0;
    for (const NearTriangle& near : near_tip(sheet, node, 1.5 * reach)) {
        const PlaneFrame frame = frame_of(sheet.mesh, near.triangle);
        const MembraneTriangle triangle = membrane_triangle(model, sheet, near.triangle, frame);
        Vec2 slope = Vec2::Zero();
        for (std::size_t a = 0; a < 3; ++a) {
            const int corner = sheet.mesh.triangles[at(near.triangle)][a];
            const double distance = (sheet.mesh.nodes[at(corner)] - origin).norm();
            const bool counts = distance < reach && (corner == node || !is_tip(state, corner));
            slope += (counts ? 1.0 - distance / reach : 0.0) * triangle.gradient[a];
        }
        if (slope.isZero()) {
            continue;
        }
        const Vec2 own = triangle.volume * (energy_momentum(triangle, points_now(state, near.triangle)) * slope);
        sum += frame.to_space(own);
        thickness += triangle.volume;
        weight += triangle.volume / sheet.thickness[at(near.triangle)];
    }
    return weight > 0.0 ? Vec3(sum * (weight / thickness)) : Vec3(Vec3::Zero());
}

TipStress stress_at(const MembraneModel& model, const MembraneState& state, int node, const Vec3& direction) {
    const MembraneSheet& sheet = *state.sheet;
    TipStress result;
    result.frame = frame_at(sheet, node);
    const Vec3& origin = sheet.mesh.nodes[at(node)];
    const double reach = std::max(model.tear_radius, mean_edge_at(sheet, node));
    Mat2 fibres = Mat2::Zero();
    double whole = 0.0;
    for (const NearTriangle& near : near_tip(sheet, node, reach)) {
        const Vec3 way = triangle_middle(sheet.mesh, near.triangle) - origin;
        const double weight = std::max(0.0, 1.0 - near.distance / reach);
        if (weight == 0.0 || way.dot(direction) < 0.0) {
            continue;
        }
        const PlaneFrame frame = frame_of(sheet.mesh, near.triangle);
        const MembraneTriangle triangle = membrane_triangle(model, sheet, near.triangle, frame);
        const TensionField field = membrane_state(triangle, points_now(state, near.triangle));
        // from the triangle's frame to that of the tip
        Mat2 turn;
        turn << result.frame.e1.dot(frame.e1), result.frame.e1.dot(frame.e2), result.frame.e2.dot(frame.e1),
            result.frame.e2.dot(frame.e2);
        const double share = weight * triangle.volume;
        const Vec2 fibre = result.frame.to_plane(sheet.fibre[at(near.triangle)]);
        result.stress += share * (turn * matrix_of(field.stress) * turn.transpose());
        fibres += share * (fibre * fibre.transpose());
        whole += share;
    }
    if (whole > 0.0) {
        result.stress /= whole;
    }
    result.fibre = largest_opening(fibres, Mat2::Identity());
    return result;
}

std::optional<Vec2> tear_direction(const Mat2& stress, const Vec2& fibre, double ratio, const Vec2& within,
                                   double cosine) {
    const Mat2 strength = Mat2::Identity() + (ratio - 1.0) * fibre * fibre.transpose();
    const auto in_cone = [&](const Vec2& d) { return within.isZero() || d.dot(within) >= cosine - 1e-12; };
    std::array<Vec2, 4> candidates;
    std::size_t count = 0;
    const Vec2 best = across(largest_opening(stress, strength));
    candidates[count++] = best;
    candidates[count++] = -best;
    if (!within.isZero()) {
        const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
        candidates[count++] = cosine * within + sine * across(within);
        candidates[count++] = cosine * within - sine * across(within);
    }
    std::optional<Vec2> found;
    double most = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double value = quotient(stress, strength, across(candidates[i]));
        if (in_cone(candidates[i]) && value > most * (1.0 + 1e-12)) {
            most = value;
            found = candidates[i];
        }
    }
    return found;
}

std::vector<TearProposal> propose_tears(const MembraneModel& model, const MembraneState& state) {
    std::vector<TearProposal> proposals;
    const double ratio = std::sqrt(model.toughness.across / model.toughness.along);
    for (int i = 0; i < static_cast<int>(state.tips.size()); ++i) {
        const TearTip& tip = state.tips[at(i)];
        if (pushed(state, tip.node)) {
            continue;
        }
        const Vec3 release = release_at(model, state, tip.node, model.tear_radius);
        const Vec3 on = way_on(model, state, tip, release);
        const double free = release.dot(on);
        if (free < std::min(model.toughness.along, model.toughness.across)) {
            continue;
        }
        const TipStress about = stress_at(model, state, tip.node, on);
        Vec2 came = about.frame.to_plane(on);
        came.normalize();
        const std::optional<Vec2> way = tear_direction(about.stress, about.fibre, ratio, came, model.turn_cosine);
        if (!way) {
            continue;
        }
        const Vec3 direction = about.frame.to_space(*way);
        const double toughness = toughness_along(model.toughness, about.frame.to_space(about.fibre), direction);
        if (free >= toughness) {
            proposals.push_back({i, direction, free, toughness});
        }
    }
    return proposals;
}

}  // namespace rhexis
