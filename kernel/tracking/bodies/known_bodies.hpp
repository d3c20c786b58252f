// SPDX-License-Identifier: GPL-3.0-or-later
// The marker bodies that come with the program: one for each instrument of the exercises, and the head's.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "tracking/marker_body.hpp"

namespace rhexis::tracking {

inline constexpr const char* head_name = "head";

/// By the instrument's name, or "head": a file of assets/tracking/bodies. None: there is no such file.
std::optional<MarkerBody> known_body(const std::string& name);

/// The head's and those of these instruments, in their order. The error: an instrument that none comes with.
Result<std::vector<MarkerBody>> known_bodies(std::span<const std::string> instruments);

}  // namespace rhexis::tracking
