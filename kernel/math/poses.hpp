// SPDX-License-Identifier: GPL-3.0-or-later
// Poses of poses: of a part on a body, and of a body seen from another.
#pragma once

#include "math/types.hpp"

namespace rhexis {

/// Of a part in the frame that `whole` is given in; part: in the frame of the whole.
inline Pose times(const Pose& whole, const Pose& part) {
    return {whole.to_world(part.position), (whole.orientation * part.orientation).normalized()};
}

/// `pose` as seen from `frame`, both given in the same third one: times(frame, relative(frame, pose)) is pose.
inline Pose relative(const Pose& frame, const Pose& pose) {
    return {frame.to_body(pose.position), (frame.orientation.conjugate() * pose.orientation).normalized()};
}

/// The whole's frame as seen from the part: times(pose, inverse(pose)) changes nothing.
inline Pose inverse(const Pose& pose) { return relative(pose, Pose{}); }

}  // namespace rhexis
