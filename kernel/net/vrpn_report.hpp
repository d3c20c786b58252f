// SPDX-License-Identifier: GPL-3.0-or-later
// What VRPN's devices tell: poses and speeds of trackers, buttons, analogs. Here lengths are millimetres; on the wire
// they are metres.
#pragma once

#include <string_view>
#include <vector>

#include "net/device_report.hpp"
#include "net/vrpn_message.hpp"

namespace rhexis::vrpn {

/// Names of types, as both sides describe them.
inline constexpr std::string_view ping_type = "vrpn_Base ping_message";
inline constexpr std::string_view pong_type = "vrpn_Base pong_message";
inline constexpr std::string_view text_type = "vrpn_Base text_message";
inline constexpr std::string_view pose_type = "vrpn_Tracker Pos_Quat";
inline constexpr std::string_view velocity_type = "vrpn_Tracker Velocity";
inline constexpr std::string_view button_type = "vrpn_Button Change";
inline constexpr std::string_view buttons_type = "vrpn_Button States";
inline constexpr std::string_view analog_type = "vrpn_Analog Channel";

inline constexpr int most_buttons = 256;
inline constexpr int most_channels = 128;

/// Payloads.
WireBytes payload_of(const PoseReport& report);
WireBytes payload_of(const VelocityReport& report);
WireBytes payload_of(const ButtonReport& report);
WireBytes payload_of(const TextReport& report);
WireBytes buttons_payload(const std::vector<bool>& down);       ///< at most most_buttons
WireBytes analog_payload(const std::vector<double>& channels);  ///< at most most_channels

/// Of a payload with another size, numbers out of range or not finite: an error that names them.
Result<PoseReport> read_pose(WireSpan payload);
Result<VelocityReport> read_velocity(WireSpan payload);
Result<ButtonReport> read_button(WireSpan payload);
Result<TextReport> read_text(WireSpan payload);
Result<std::vector<bool>> read_buttons(WireSpan payload);
Result<std::vector<double>> read_analog(WireSpan payload);

}  // namespace rhexis::vrpn
