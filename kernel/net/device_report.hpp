// SPDX-License-Identifier: GPL-3.0-or-later
// What devices of a tracking computer do, whichever protocol tells it.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "math/types.hpp"

namespace rhexis {

struct PoseReport {
    int sensor = 0;                  ///< 0 or more
    Vec3 position = Vec3::Zero();    ///< [mm]
    Quat turned = Quat::Identity();  ///< unit
};

struct VelocityReport {
    int sensor = 0;
    Vec3 velocity = Vec3::Zero();   ///< [mm/s]
    Quat turns = Quat::Identity();  ///< within `interval_s`, unit
    double interval_s = 0.0;
};

struct ButtonReport {
    int button = 0;  ///< 0 or more
    bool down = false;
};

enum class Severity : std::uint32_t { normal = 0, warning = 1, error = 2 };
struct TextReport {
    Severity severity = Severity::normal;
    std::uint32_t level = 0;
    std::string text{};  ///< at most 1023 bytes, without a 0
};

/// What a device did at one time.
struct DeviceReport {
    std::string device{};
    std::int64_t time_us = 0;  ///< by the server's clock, since 1970
    std::variant<PoseReport, VelocityReport, ButtonReport, std::vector<bool>, std::vector<double>, TextReport> what{};
    bool by_datagram = false;  ///< else by TCP
};

}  // namespace rhexis
