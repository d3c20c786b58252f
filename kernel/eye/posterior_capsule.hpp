// SPDX-License-Identifier: GPL-3.0-or-later
// What the posterior capsule of a patient bears.
#pragma once

#include "flow/capsule.hpp"

namespace rhexis {

/// age: [years], 20 to 95.
CapsuleModel make_capsule(double age);

}  // namespace rhexis
