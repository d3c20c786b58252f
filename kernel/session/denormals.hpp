// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers too small for full precision slow a step down many times: inside it they count as zero.
#pragma once

#include <xmmintrin.h>

namespace rhexis {

/// Flushes denormals on the calling thread, and on threads that it starts, until destroyed; then restores what was set.
class FlushDenormals {
public:
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_to_zero | denormals_are_zero); }
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    static constexpr unsigned flush_to_zero = 0x8000U;
    static constexpr unsigned denormals_are_zero = 0x0040U;
    unsigned before_;
};

}  // namespace rhexis
