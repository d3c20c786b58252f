// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/orthotropic.hpp"

#include <cmath>

#include "base/numbers.hpp"

namespace rhexis {
namespace {

double shear_of(const Orthotropic& material) {
    return material.shear_modulus > 0.0 ? material.shear_modulus : harmonic_shear_modulus(material);
}

double ratio_across(const Orthotropic& material) { return material.poisson_ratio * material.across / material.along; }

Status check_positive(const std::string& field, double value, const std::string& where) {
    return check_range(field, value, 1e-3, 1e12, where, " Pa");
}

}  // namespace

Orthotropic isotropic(double young_modulus, double poisson_ratio) {
    return {young_modulus, young_modulus, poisson_ratio, young_modulus / (2.0 * (1.0 + poisson_ratio))};
}

double harmonic_shear_modulus(const Orthotropic& material) {
    return 1.0 / ((1.0 + material.poisson_ratio) / material.along + (1.0 + ratio_across(material)) / material.across);
}

Status check_orthotropic(const Orthotropic& material, const std::string& where) {
    if (Status status = check_positive("along", material.along, where); !status) {
        return status;
    }
    if (Status status = check_positive("across", material.across, where); !status) {
        return status;
    }
    if (material.shear_modulus != 0.0) {
        if (Status status = check_positive("shear_modulus", material.shear_modulus, where); !status) {
            return status;
        }
    }
    const double most = std::sqrt(material.along / material.across);
    if (!(std::abs(material.poisson_ratio) < most)) {
        return Error{"poisson_ratio is " + short_number(material.poisson_ratio), where,
                     "between -" + short_number(most) + " and " + short_number(most) +
                         ", the root of along / across: else some strain would give energy back"};
    }
    if (!(shear_of(material) > 0.0)) {
        return Error{"no shear modulus follows from poisson_ratio " + short_number(material.poisson_ratio), where,
                     "give shear_modulus"};
    }
    return success();
}

Mat3 plane_stiffness(const Orthotropic& material, const Vec2& fibre) {
    const double share = 1.0 - material.poisson_ratio * ratio_across(material);
    const double q11 = material.along / share;
    const double q22 = material.across / share;
    const double q12 = ratio_across(material) * material.along / share;
    const double g = shear_of(material);
    const double a = q22 - 2.0 * g;
    const double b = q12 - q22 + 2.0 * g;
    const double d = q11 + q22 - 2.0 * q12 - 4.0 * g;
    const Vec3 trace(1.0, 1.0, 0.0);
    const Vec3 along(fibre.x() * fibre.x(), fibre.y() * fibre.y(), fibre.x() * fibre.y());
    Mat3 result = a * trace * trace.transpose() + b * (trace * along.transpose() + along * trace.transpose()) +
                  d * along * along.transpose();
    result.diagonal() += g * Vec3(2.0, 2.0, 1.0);
    return result;
}

double off_axis_modulus(const Orthotropic& material, double angle) {
    const double c2 = std::cos(angle) * std::cos(angle);
    const double s2 = 1.0 - c2;
    return 1.0 / (c2 * c2 / material.along + s2 * s2 / material.across +
                  c2 * s2 * (1.0 / shear_of(material) - 2.0 * material.poisson_ratio / material.along));
}

}  // namespace rhexis
