// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/tension_field.hpp"

#include <Eigen/LU>
#include <cmath>

namespace rhexis {
namespace {

constexpr int most_turns = 30;   // Newton steps for the direction of the wrinkles
constexpr double sharp = 1e-24;  // square of the last one [rad^2]

/// n n as a strain.
Vec3 spread(const Vec2& n) { return {n.x() * n.x(), n.y() * n.y(), 2.0 * n.x() * n.y()}; }

/// n t + t n as a strain, t = (-n_y, n_x): the change of n n with the angle of n.
Vec3 turn(const Vec2& n) { return {-2.0 * n.x() * n.y(), 2.0 * n.x() * n.y(), 2.0 * (n.x() * n.x() - n.y() * n.y())}; }

/// Least eigenvalue of a stress and its direction.
double least_stress(const Vec3& stress, Vec2& direction) {
    const double mean = 0.5 * (stress[0] + stress[1]);
    const double half = 0.5 * (stress[0] - stress[1]);
    const double radius = std::sqrt(half * half + stress[2] * stress[2]);
    const double least = mean - radius;
    // of the two ways to write the eigenvector, the longer one
    direction = half > 0.0 ? Vec2(-stress[2], half + radius) : Vec2(half - radius, stress[2]);
    const double length = direction.norm();
    direction = length > 0.0 ? Vec2(direction / length) : Vec2(1.0, 0.0);
    return least;
}

/// Wrinkles of direction n, as deep as takes the stress along n away.
struct Wrinkles {
    double depth = 0.0;  ///< b
    Vec3 stress = Vec3::Zero();
    double stiffness = 0.0;  ///< nn K nn
};

Wrinkles wrinkles_along(const Vec2& n, const Vec3& stress, const Mat3& stiffness) {
    Wrinkles w;
    const Vec3 nn = spread(n);
    const Vec3 answer = stiffness * nn;
    w.stiffness = nn.dot(answer);
    w.depth = -nn.dot(stress) / w.stiffness;
    w.stress = stress + w.depth * answer;
    return w;
}

Vec2 turned(const Vec2& n, double angle) {
    const double square = angle * angle;
    const double c = (1.0 - 0.25 * square) / (1.0 + 0.25 * square);
    const double s = angle / (1.0 + 0.25 * square);
    return {c * n.x() - s * n.y(), s * n.x() + c * n.y()};
}

/// Newton steps on the energy as a function of the angle, uphill steps turned round; starts at the direction of the
/// greatest compression, which is the answer of an isotropic sheet.
Wrinkles deepest_wrinkles(Vec2& n, const Vec3& stress, const Mat3& stiffness) {
    Wrinkles w = wrinkles_along(n, stress, stiffness);
    double energy = -0.5 * w.depth * w.depth * w.stiffness;
    for (int i = 0; i < most_turns; ++i) {
        // of the energy by the angle, with the depth that is best at each
        const Vec3 v = turn(n);
        const double slope = w.depth * v.dot(w.stress);
        const Vec3 answer = stiffness * v;
        const double cross = spread(n).dot(answer);
        const double along = w.stress[0] + w.stress[1];
        const double curvature =
            w.depth * w.depth * (v.dot(answer) - cross * cross / w.stiffness) + 2.0 * w.depth * along;
        double step = -slope / std::max(std::abs(curvature), 1e-300);
        step = std::min(0.5, std::max(-0.5, step));
        if (!(step * step > sharp)) {
            break;
        }
        Vec2 next = turned(n, step);
        Wrinkles there = wrinkles_along(next, stress, stiffness);
        double energy_there = -0.5 * there.depth * there.depth * there.stiffness;
        for (int half = 0; half < 8 && (energy_there > energy || there.depth < 0.0); ++half) {
            step *= 0.5;
            next = turned(n, step);
            there = wrinkles_along(next, stress, stiffness);
            energy_there = -0.5 * there.depth * there.depth * there.stiffness;
        }
        if (energy_there > energy) {
            break;
        }
        n = next;
        w = there;
        energy = energy_there;
    }
    return w;
}

/// The tangent of the least energy: that of the sheet, less what following wrinkles give back.
Mat3 wrinkled_tangent(const Vec2& n, const Wrinkles& w, double along, const Mat3& stiffness) {
    const Vec3 a = stiffness * spread(n);
    const Vec3 b = stiffness * turn(n);
    // second derivative by depth and by depth times angle; the latter is held by the stress along t
    Mat2 inner;
    inner(0, 0) = w.stiffness;
    inner(0, 1) = inner(1, 0) = spread(n).dot(b);
    inner(1, 1) = turn(n).dot(b) + 2.0 * along / w.depth;
    const double det = inner(0, 0) * inner(1, 1) - inner(0, 1) * inner(1, 0);
    const Mat3 given = (inner(1, 1) * a * a.transpose() - inner(0, 1) * (a * b.transpose() + b * a.transpose()) +
                        inner(0, 0) * b * b.transpose()) /
                       det;
    return stiffness - given;
}

}  // namespace

TensionField tension_field(const Vec3& strain, const Mat3& stiffness, double rest) {
    TensionField result;
    const Vec3 stress = stiffness * strain;
    const double whole = 0.5 * strain.dot(stress);
    Vec2 n;
    if (least_stress(stress, n) >= 0.0 || rest >= 1.0) {
        result.energy = whole;
        result.stress = stress;
        result.tangent = stiffness;
        return result;
    }
    const Wrinkles w = deepest_wrinkles(n, stress, stiffness);
    const double along = w.stress[0] + w.stress[1];
    const double kept = 1.0 - rest;
    result.energy = rest * whole;
    result.stress = rest * stress;
    result.tangent = rest * stiffness;
    if (!(along > 0.0)) {
        result.state = SheetState::slack;
        return result;
    }
    result.state = SheetState::wrinkled;
    result.energy += kept * (whole - 0.5 * w.depth * w.depth * w.stiffness);
    result.stress += kept * w.stress;
    result.tangent += kept * wrinkled_tangent(n, w, along, stiffness);
    return result;
}

}  // namespace rhexis
