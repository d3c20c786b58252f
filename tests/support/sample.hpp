// SPDX-License-Identifier: GPL-3.0-or-later
// What a device sends in a step, as tests write it.
#pragma once

#include "flow/device_sample.hpp"

namespace rhexis::test {

/// An instrument of that number at a place [mm], upright, its jaws shut, the pedal up; a microscope that is sent there.
inline DeviceSample sample_at(int instrument, const Vec3& place) {
    DeviceSample sample;
    sample.instrument = instrument;
    sample.present = true;
    sample.pose.position = place;
    return sample;
}

}  // namespace rhexis::test
