// SPDX-License-Identifier: GPL-3.0-or-later
// Whether this program is instrumented, and takes ten times as long.
#pragma once

namespace rhexis::testing {

/// TEST_CASE("..." * doctest::skip(sanitized)): for tests of numbers whose ways through the code others run as well.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace rhexis::testing
