// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/vrpn_report.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::vrpn {
namespace {

constexpr double mm_per_m = 1000.0;
constexpr std::size_t text_bytes = 1024;
constexpr double off_unit = 0.01;  ///< a length of a quaternion that is taken as rounding

Error spoilt(const std::string& what, const std::string& allowed) { return Error{what, "VRPN", allowed}; }

Status check_size(WireSpan payload, std::size_t bytes, const char* of) {
    if (payload.size() != bytes) {
        return spoilt(std::string(of) + " of " + std::to_string(payload.size()) + " bytes", std::to_string(bytes));
    }
    return success();
}

/// What poses and velocities begin with: a sensor, a vector in mm, a quaternion.
struct Placed {
    int sensor = 0;
    Vec3 vector;
    Quat quaternion;
};

WireBytes bytes_of(const Placed& placed) {
    WireBytes out;
    append_i32(placed.sensor, out);
    append_i32(placed.sensor, out);  // a filler, which others expect to be this
    for (const double x : placed.vector) {
        append_f64(x / mm_per_m, out);
    }
    for (const double x : placed.quaternion.coeffs()) {  // x, y, z, w
        append_f64(x, out);
    }
    return out;
}

Result<Placed> read_placed(WireReader& reader, const char* of) {
    Placed placed;
    placed.sensor = reader.i32();
    static_cast<void>(reader.i32());
    for (double& x : placed.vector) {
        x = mm_per_m * reader.f64();
    }
    for (double& x : placed.quaternion.coeffs()) {
        x = reader.f64();
    }
    if (placed.sensor < 0) {
        return spoilt(std::string(of) + " of sensor " + std::to_string(placed.sensor), "0 or more");
    }
    const double length = placed.quaternion.norm();
    if (!placed.vector.allFinite() || !(std::abs(length - 1.0) <= off_unit)) {
        return spoilt(
            std::string(of) + " with a number that is not finite, or a quaternion of length " + std::to_string(length),
            "finite, and 1");
    }
    placed.quaternion.normalize();
    return placed;
}

}  // namespace

WireBytes payload_of(const PoseReport& report) { return bytes_of({report.sensor, report.position, report.turned}); }

WireBytes payload_of(const VelocityReport& report) {
    WireBytes out = bytes_of({report.sensor, report.velocity, report.turns});
    append_f64(report.interval_s, out);
    return out;
}

WireBytes payload_of(const ButtonReport& report) {
    WireBytes out;
    append_i32(report.button, out);
    append_i32(report.down ? 1 : 0, out);
    return out;
}

WireBytes payload_of(const TextReport& report) {
    RHEXIS_ASSERT(report.text.size() < text_bytes);
    WireBytes out;
    append_u32(static_cast<std::uint32_t>(report.severity), out);
    append_u32(report.level, out);
    append_text(report.text, out);
    out.resize(8 + text_bytes, 0);
    return out;
}

WireBytes buttons_payload(const std::vector<bool>& down) {
    RHEXIS_ASSERT(down.size() <= static_cast<std::size_t>(most_buttons));
    WireBytes out;
    append_i32(static_cast<std::int32_t>(down.size()), out);
    for (const bool one : down) {
        append_i32(one ? 1 : 0, out);
    }
    return out;
}

WireBytes analog_payload(const std::vector<double>& channels) {
    RHEXIS_ASSERT(channels.size() <= static_cast<std::size_t>(most_channels));
    WireBytes out;
    append_f64(static_cast<double>(channels.size()), out);
    for (const double value : channels) {
        append_f64(value, out);
    }
    return out;
}

Result<PoseReport> read_pose(WireSpan payload) {
    if (const Status size = check_size(payload, 64, "a pose"); !size) {
        return size.error();
    }
    WireReader reader(payload);
    Result<Placed> placed = read_placed(reader, "a pose");
    if (!placed) {
        return placed.error();
    }
    return PoseReport{placed.value().sensor, placed.value().vector, placed.value().quaternion};
}

Result<VelocityReport> read_velocity(WireSpan payload) {
    if (const Status size = check_size(payload, 72, "a velocity"); !size) {
        return size.error();
    }
    WireReader reader(payload);
    Result<Placed> placed = read_placed(reader, "a velocity");
    if (!placed) {
        return placed.error();
    }
    const double interval_s = reader.f64();
    if (!(interval_s >= 0.0) || !std::isfinite(interval_s)) {
        return spoilt("a velocity over " + std::to_string(interval_s) + " s", "0 or more");
    }
    return VelocityReport{placed.value().sensor, placed.value().vector, placed.value().quaternion, interval_s};
}

Result<ButtonReport> read_button(WireSpan payload) {
    if (const Status size = check_size(payload, 8, "a button's change"); !size) {
        return size.error();
    }
    WireReader reader(payload);
    const int button = reader.i32();
    const int state = reader.i32();
    if (button < 0 || button >= most_buttons) {
        return spoilt("button " + std::to_string(button), "0 to " + std::to_string(most_buttons - 1));
    }
    return ButtonReport{button, state != 0};
}

Result<TextReport> read_text(WireSpan payload) {
    if (const Status size = check_size(payload, 8 + text_bytes, "a text"); !size) {
        return size.error();
    }
    WireReader reader(payload);
    const std::uint32_t severity = reader.u32();
    const std::uint32_t level = reader.u32();
    if (severity > static_cast<std::uint32_t>(Severity::error)) {
        return spoilt("a text of severity " + std::to_string(severity), "0 to 2");
    }
    const WireSpan text = reader.rest();
    const auto end = std::find(text.begin(), text.end(), std::uint8_t{0});
    return TextReport{static_cast<Severity>(severity), level, std::string(text.begin(), end)};
}

Result<std::vector<bool>> read_buttons(WireSpan payload) {
    WireReader reader(payload);
    const std::int64_t count = reader.i32();
    if (reader.failed() || count < 0 || count > most_buttons ||
        reader.rest().size() != 4 * static_cast<std::size_t>(count)) {
        return spoilt(std::to_string(count) + " buttons in " + std::to_string(payload.size()) + " bytes",
                      "at most " + std::to_string(most_buttons) + ", 4 bytes each");
    }
    std::vector<bool> down;
    while (!reader.rest().empty()) {
        down.push_back(reader.i32() != 0);
    }
    return down;
}

Result<std::vector<double>> read_analog(WireSpan payload) {
    WireReader reader(payload);
    const double count = reader.f64();
    // a count that is not whole differs from the bytes that are there
    if (reader.failed() || !(count >= 0.0 && count <= most_channels) ||
        static_cast<double>(reader.rest().size()) != 8.0 * count) {
        return spoilt(std::to_string(count) + " channels in " + std::to_string(payload.size()) + " bytes",
                      "at most " + std::to_string(most_channels) + ", 8 bytes each");
    }
    std::vector<double> channels;
    while (!reader.rest().empty()) {
        channels.push_back(reader.f64());
        if (!std::isfinite(channels.back())) {
            return spoilt("channel " + std::to_string(channels.size() - 1) + " is not finite", "");
        }
    }
    return channels;
}

}  // namespace rhexis::vrpn
