// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/posterior_capsule.hpp"

#include <array>

#include "eye/table.hpp"

namespace rhexis {

namespace {

constexpr std::array<TableRow, 2> capsule_modulus_by_age{{{20.0, 0.9e6}, {38.0, 1.5e6}}};
/// Strain at rupture, likewise.
constexpr std::array<TableRow, 2> strain_by_age{{{0.0, 1.08}, {98.0, 0.40}}};

/// Between the pole, 3.5 um, and the periphery, 9 to 4 um with age [Barraquer2006] [mm].
constexpr double thickness = 0.0045;

}  // namespace

double capsule_modulus(double age) { return linear_between(capsule_modulus_by_age, age); }

CapsuleModel make_capsule(double age) {
    CapsuleModel capsule;
    capsule.thickness = thickness;
    capsule.membrane_stiffness = capsule_modulus(age) * thickness;
    capsule.ultimate_strain = linear_between(strain_by_age, age);
    return capsule;
}

}  // namespace rhexis
