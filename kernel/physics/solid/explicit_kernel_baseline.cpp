// SPDX-License-Identifier: GPL-3.0-or-later
#include <immintrin.h>

#include "physics/solid/explicit_kernel.hpp"

#define RHEXIS_WIDTH 4
#define RHEXIS_BATCH 8
namespace rhexis::explicit_kernel {
namespace {
#include "physics/solid/explicit_kernel.ipp"
constexpr Kernel kernel{"baseline", add_forces, add_nodal_forces, accelerate, move};
}  // namespace
const Kernel* baseline() { return &kernel; }
}  // namespace rhexis::explicit_kernel
