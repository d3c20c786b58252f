// SPDX-License-Identifier: GPL-3.0-or-later
// What standards ask of optical tracking, as far as a rig without cameras can answer: docs/tracking.md says how far.
#pragma once

#include "tracking/measure/measured_parts.hpp"

namespace rhexis::tracking {

/// After [ASTME3064]: two bodies on one bar, 120 mm apart, carried to and fro along two paths at up to 100 mm/s, the
/// bar along each axis; what their distance and the turn between them seem to change by. Rows "artifact.distance_mm",
/// signed, and "artifact.turn_deg".
Result<Numbers> measure_artifact(const Setting& setting);

/// After [ASTMF2554]: an instrument's tip set on 20 points of a phantom that is fixed to the head, and on its middle
/// one with the instrument turned about each axis. Rows, of images, in mm: "phantom.point", from each point after the
/// best rigid fit; "phantom.distance", signed, between all pairs of points; "phantom.bias", of the middle point's mean;
/// "phantom.spread", of each reading about that mean; "phantom.pitch", "phantom.yaw" and "phantom.roll", of each
/// turned placement's mean from the straight one's.
Result<Numbers> measure_phantom(const Setting& setting);

}  // namespace rhexis::tracking
