// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/device.hpp"

namespace rhexis {
namespace {

DeviceSample between(const Keyframe& a, const Keyframe& b, double time_s) {
    const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
    DeviceSample sample = a.sample;
    sample.pose.position += share * (b.sample.pose.position - a.sample.pose.position);
    sample.pose.orientation = a.sample.pose.orientation.slerp(share, b.sample.pose.orientation);
    sample.jaw += share * (b.sample.jaw - a.sample.jaw);
    sample.pedal += share * (b.sample.pedal - a.sample.pedal);
    return sample;
}

}  // namespace

std::span<const DeviceSample> RecordedDevice::read(std::uint64_t step, double) {
    if (step == 0 || step > steps_.size()) {
        return {};
    }
    return steps_[step - 1];
}

std::span<const DeviceSample> ScriptedDevice::read(std::uint64_t, double time_s) {
    if (keyframes_.empty() || time_s < keyframes_.front().time_s) {
        return {};
    }
    sample_ = keyframes_.back().sample;
    for (std::size_t i = 0; i + 1 < keyframes_.size(); ++i) {
        if (time_s < keyframes_[i + 1].time_s) {
            sample_ = between(keyframes_[i], keyframes_[i + 1], time_s);
            break;
        }
    }
    return {&sample_, 1};
}

}  // namespace rhexis
