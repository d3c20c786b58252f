// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/step_input.hpp"

#include <cmath>

#include "base/numbers.hpp"

namespace rhexis {
namespace {

Status in_range(const char* field, double value, double low, double high) {
    return check_range(field, value, low, high, "device sample");
}

}  // namespace

Result<DeviceSample> checked_sample(const DeviceSample& sample, int instruments) {
    if (sample.instrument < 0 || sample.instrument >= instruments) {
        return Error{"instrument is " + std::to_string(sample.instrument), "device sample",
                     "0 to " + std::to_string(instruments - 1)};
    }
    const char* const axes[] = {"pose.position.x", "pose.position.y", "pose.position.z"};
    for (int axis = 0; axis < 3; ++axis) {
        const Status status = in_range(axes[axis], sample.pose.position[axis], -sample_reach_mm, sample_reach_mm);
        if (!status) {
            return status.error();
        }
    }
    for (const Status& status : {in_range("pose.orientation length", sample.pose.orientation.norm(), 0.99, 1.01),
                                 in_range("jaw", sample.jaw, 0.0, 1.0), in_range("pedal", sample.pedal, 0.0, 3.0)}) {
        if (!status) {
            return status.error();
        }
    }
    DeviceSample checked = sample;
    checked.pose.orientation.normalize();
    return checked;
}

StepInput read_samples(std::span<const DeviceSample> given, int instruments) {
    StepInput input;
    input.samples.resize(static_cast<std::size_t>(instruments));
    for (const DeviceSample& sample : given) {
        const Result<DeviceSample> checked = checked_sample(sample, instruments);
        if (checked) {
            input.samples[static_cast<std::size_t>(sample.instrument)] = checked.value();
        } else {
            input.refused.push_back({sample.instrument, checked.error().text()});
        }
    }
    return input;
}

}  // namespace rhexis
