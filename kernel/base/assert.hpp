// SPDX-License-Identifier: GPL-3.0-or-later
// Assertions for our own bugs. Bad input is never asserted: it is reported through Result.
#pragma once

namespace rhexis {

/// Prints the expression and its place on stderr and aborts.
[[noreturn]] void assertion_failed(const char* expression, const char* file, int line);

}  // namespace rhexis

#if defined(NDEBUG) && !defined(RHEXIS_CHECKS)
#define RHEXIS_ASSERT(condition) static_cast<void>(0)
#else
#define RHEXIS_ASSERT(condition) \
    ((condition) ? static_cast<void>(0) : ::rhexis::assertion_failed(#condition, __FILE__, __LINE__))
#endif
