// SPDX-License-Identifier: GPL-3.0-or-later
// Whether this program is instrumented, and takes ten times as long.
#pragma once

namespace rhexis::testing {

/// TEST_CASE("..." * doctest::skip(sanitized)): for tests of numbers whose ways through the code others run as well.
#if defined(__SANITIZE_ADDRESS__)  // g++
inline constexpr bool sanitized = true;
#elif defined(__has_feature)  // clang++
inline constexpr bool sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace rhexis::testing
