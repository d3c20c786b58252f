// SPDX-License-Identifier: GPL-3.0-or-later
// A patient's eye as models: the lens as a solid of three tissues, free in its bag on zonules.
#pragma once

#include "base/result.hpp"
#include "flow/eye_model.hpp"

namespace rhexis {

/// Fails if a field of the patient is out of its range. The same patient gives the same bits on every machine.
/// solid_lens: false: the lens gets no tetrahedra and the model's stays empty, where no tissue of a scene needs it.
Result<EyeModel> make_eye(const Patient& patient, bool solid_lens = true);

}  // namespace rhexis
