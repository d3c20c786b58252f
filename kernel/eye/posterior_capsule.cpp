// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/posterior_capsule.hpp"

#include "eye/table.hpp"
#include "eye/tissue_numbers.hpp"

namespace rhexis {

double capsule_modulus(double age) { return linear_between(capsule_modulus_by_age, age); }

CapsuleModel make_capsule(double age) {
    CapsuleModel capsule;
    capsule.thickness = posterior_thickness;
    capsule.membrane_stiffness = capsule_modulus(age) * posterior_thickness;
    capsule.ultimate_strain = linear_between(posterior_rupture_strain, age);
    return capsule;
}

}  // namespace rhexis
