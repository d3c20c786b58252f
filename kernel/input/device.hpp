// SPDX-License-Identifier: GPL-3.0-or-later
// Where samples come from. A device is asked once per step; the session checks whatever it says.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "flow/device_sample.hpp"

namespace rhexis {

class Device {
public:
    virtual ~Device() = default;
    /// Samples for the step that ends at time_s [s]; valid until the next call. Empty: nothing new.
    virtual std::span<const DeviceSample> read(std::uint64_t step, double time_s) = 0;
};

/// Plays samples back as they were recorded, one list per step, the first for step 1.
class RecordedDevice : public Device {
public:
    explicit RecordedDevice(std::vector<std::vector<DeviceSample>> steps) : steps_(std::move(steps)) {}
    std::span<const DeviceSample> read(std::uint64_t step, double time_s) override;

private:
    std::vector<std::vector<DeviceSample>> steps_;
};

/// A moment of one instrument's way.
struct Keyframe {
    double time_s = 0.0;
    DeviceSample sample;
};

/// Moves one instrument through keyframes (ascending in time): positions, pedal and jaw linear in between, orientation
/// by spherical interpolation; before the first it is absent, after the last it stays.
class ScriptedDevice : public Device {
public:
    explicit ScriptedDevice(std::vector<Keyframe> keyframes) : keyframes_(std::move(keyframes)) {}
    std::span<const DeviceSample> read(std::uint64_t step, double time_s) override;

private:
    std::vector<Keyframe> keyframes_;
    DeviceSample sample_;
};

}  // namespace rhexis
