// SPDX-License-Identifier: GPL-3.0-or-later
#include <immintrin.h>

#include "physics/solid/explicit_kernel.hpp"

#define RHEXIS_WIDTH 16
#define RHEXIS_BATCH 8
namespace rhexis::explicit_kernel {
namespace {
#include "physics/solid/explicit_kernel.ipp"
constexpr Kernel kernel{"avx512", add_forces, add_nodal_forces, accelerate, move};
}  // namespace
const Kernel* avx512() { return &kernel; }
}  // namespace rhexis::explicit_kernel
