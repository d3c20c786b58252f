// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/posterior_capsule.hpp"

#include <array>

#include "eye/table.hpp"

namespace rhexis {

namespace {

/// Young's modulus [Pa] and strain at rupture, by age: measured on anterior capsules [Krag1997]; recalled.
constexpr std::array<TableRow, 2> modulus_by_age{{{20.0, 0.9e6}, {38.0, 1.5e6}}};
constexpr std::array<TableRow, 2> strain_by_age{{{0.0, 1.08}, {98.0, 0.40}}};

/// Between the pole, 3.5 um, and the periphery, 9 to 4 um with age [Barraquer2006] [mm].
constexpr double thickness = 0.0045;

}  // namespace

CapsuleModel make_capsule(double age) {
    CapsuleModel capsule;
    capsule.thickness = thickness;
    capsule.membrane_stiffness = linear_between(modulus_by_age, age) * thickness;
    capsule.ultimate_strain = linear_between(strain_by_age, age);
    return capsule;
}

}  // namespace rhexis
