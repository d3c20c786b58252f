// SPDX-License-Identifier: GPL-3.0-or-later
// What the posterior capsule of a patient bears.
#pragma once

#include "flow/capsule.hpp"

namespace rhexis {

/// Young's modulus of the capsule [Pa], by age: measured on anterior capsules [Krag1997]; recalled.
double capsule_modulus(double age);

/// age: [years], 20 to 95.
CapsuleModel make_capsule(double age);

}  // namespace rhexis
