// SPDX-License-Identifier: GPL-3.0-or-later
#include <immintrin.h>

#include "physics/shell/shell_kernel.hpp"

#define RHEXIS_WIDTH 2
namespace rhexis::shell_kernel {
namespace {
#include "physics/shell/shell_kernel.ipp"
constexpr Kernel kernel{"baseline", assemble};
}  // namespace
const Kernel* baseline() { return &kernel; }
}  // namespace rhexis::shell_kernel
