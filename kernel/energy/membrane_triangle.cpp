// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/membrane_triangle.hpp"

#include <cmath>

#include "energy/metric_strain.hpp"

namespace rhexis {
namespace {

struct Gradient {
    Vec3 f1 = Vec3::Zero();  ///< columns of F
    Vec3 f2 = Vec3::Zero();
};

Gradient gradient_of(const MembraneTriangle& triangle, const TrianglePoints& x) {
    Gradient f;
    for (std::size_t a = 0; a < 3; ++a) {
        f.f1 += triangle.gradient[a].x() * x[a];
        f.f2 += triangle.gradient[a].y() * x[a];
    }
    return f;
}

Vec3 metric_of(const Gradient& f) { return {f.f1.squaredNorm(), f.f2.squaredNorm(), f.f1.dot(f.f2)}; }

/// d metric / d x_a: columns (c11, c22, c12).
Mat3 metric_change(const Gradient& f, const Vec2& g) {
    Mat3 result;
    result.col(0) = 2.0 * g.x() * f.f1;
    result.col(1) = 2.0 * g.y() * f.f2;
    result.col(2) = g.x() * f.f2 + g.y() * f.f1;
    return result;
}

Mat2 stress_on_metric(const Vec3& s) {
    Mat2 result;
    result << 2.0 * s[0], s[2], s[2], 2.0 * s[1];
    return result;
}

/// Without its negative part.
Mat2 tensile(const Mat2& stress) {
    const double mean = 0.5 * (stress(0, 0) + stress(1, 1));
    const double half = 0.5 * (stress(0, 0) - stress(1, 1));
    const double radius = std::sqrt(half * half + stress(0, 1) * stress(0, 1));
    if (mean - radius >= 0.0) {
        return stress;
    }
    if (mean + radius <= 0.0) {
        return Mat2::Zero();
    }
    // the projector on the greater eigenvalue's direction
    const Mat2 projector = 0.5 * Mat2::Identity() + (stress - mean * Mat2::Identity()) / (2.0 * radius);
    return (mean + radius) * projector;
}

}  // namespace

PlaneFrame plane_frame(const TrianglePoints& rest) {
    const Vec3 edge = rest[1] - rest[0];
    const Vec3 other = rest[2] - rest[0];
    PlaneFrame frame;
    frame.e1 = edge.normalized();
    frame.e2 = (other - frame.e1.dot(other) * frame.e1).normalized();
    return frame;
}

std::array<Vec2, 3> shape_gradients(const TrianglePoints& rest, const PlaneFrame& frame) {
    std::array<Vec2, 3> p;
    for (std::size_t a = 0; a < 3; ++a) {
        p[a] = frame.to_plane(rest[a] - rest[0]);
    }
    const double twice_area = (p[1] - p[0]).x() * (p[2] - p[0]).y() - (p[1] - p[0]).y() * (p[2] - p[0]).x();
    std::array<Vec2, 3> gradient;
    for (std::size_t a = 0; a < 3; ++a) {
        const Vec2 opposite = p[(a + 2) % 3] - p[(a + 1) % 3];
        gradient[a] = Vec2(-opposite.y(), opposite.x()) / twice_area;
    }
    return gradient;
}

Vec3 metric_of(const MembraneTriangle& triangle, const TrianglePoints& x) {
    return metric_of(gradient_of(triangle, x));
}

TensionField membrane_state(const MembraneTriangle& triangle, const TrianglePoints& x) {
    MetricStrain strain;
    metric_strain(metric_of(triangle, x), strain);
    return tension_field(strain.strain, triangle.stiffness, triangle.rest);
}

double membrane_forces(const MembraneTriangle& triangle, const TrianglePoints& x, TrianglePoints& force) {
    const Gradient f = gradient_of(triangle, x);
    MetricStrain strain;
    metric_strain(metric_of(f), strain);
    const TensionField field = tension_field(strain.strain, triangle.stiffness, triangle.rest);
    const Mat2 stress = stress_on_metric(strain.first.transpose() * field.stress);
    for (std::size_t a = 0; a < 3; ++a) {
        const Vec2 pull = -triangle.volume * (stress * triangle.gradient[a]);
        force[a] = pull.x() * f.f1 + pull.y() * f.f2;
    }
    return triangle.volume * field.energy;
}

double membrane_stiffness(const MembraneTriangle& triangle, const TrianglePoints& x, MembraneTangent kind,
                          TrianglePoints& force, TriangleBlocks& blocks) {
    const Gradient f = gradient_of(triangle, x);
    MetricStrain strain;
    if (kind == MembraneTangent::consistent) {
        metric_strain_twice(metric_of(f), strain);
    } else {
        metric_strain(metric_of(f), strain);
    }
    const TensionField field = tension_field(strain.strain, triangle.stiffness, triangle.rest);
    Mat2 stress = stress_on_metric(strain.first.transpose() * field.stress);
    Mat3 tangent = strain.first.transpose() * field.tangent * strain.first;
    if (kind == MembraneTangent::consistent) {
        for (std::size_t k = 0; k < 3; ++k) {
            tangent += field.stress[static_cast<Eigen::Index>(k)] * strain.second[k];
        }
    }
    std::array<Mat3, 3> change;
    for (std::size_t a = 0; a < 3; ++a) {
        const Vec2 pull = -triangle.volume * (stress * triangle.gradient[a]);
        force[a] = pull.x() * f.f1 + pull.y() * f.f2;
        change[a] = metric_change(f, triangle.gradient[a]);
    }
    if (kind == MembraneTangent::definite) {
        stress = tensile(stress);
    }
    std::size_t slot = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const Mat3 left = triangle.volume * change[a] * tangent;
        for (std::size_t b = a; b < 3; ++b, ++slot) {
            blocks[slot] = left * change[b].transpose();
            blocks[slot].diagonal().array() +=
                triangle.volume * triangle.gradient[a].dot(stress * triangle.gradient[b]);
        }
    }
    return triangle.volume * field.energy;
}

}  // namespace rhexis
