// SPDX-License-Identifier: GPL-3.0-or-later
// The structs of a recording as bytes. Each pair put/get lists the fields in one order.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "session/recording.hpp"

namespace rhexis {

std::string encode(const RecordingHeader& header);
std::string encode(const RecordedStart& start);
std::string encode(const RecordedStep& step);
std::string encode(const Snapshot& snapshot);

// Nothing when the bytes are too few, too many, or hold values that the fields cannot have.
std::optional<RecordingHeader> decode_header(std::string_view bytes);
std::optional<RecordedStart> decode_start(std::string_view bytes);
std::optional<RecordedStep> decode_step(std::string_view bytes);
std::optional<Snapshot> decode_snapshot(std::string_view bytes);

}  // namespace rhexis
