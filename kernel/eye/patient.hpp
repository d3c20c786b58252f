// SPDX-License-Identifier: GPL-3.0-or-later
// What may be said of a patient, and patients read from files.
#pragma once

#include <string>

#include "base/result.hpp"
#include "flow/eye_model.hpp"

namespace rhexis {

/// Every field in its range; else the field, its value and the range.
Status check(const Patient& patient);

/// A JSON object with any of the fields of Patient ("age", "nuclear_grade", "pupil_mm", "side", "tetrahedra") and an
/// optional "note"; fields left out keep their defaults. Names an unknown field with the nearest known one.
Result<Patient> read_patient(const std::string& path);

}  // namespace rhexis
