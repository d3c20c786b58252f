// SPDX-License-Identifier: GPL-3.0-or-later
#include <immintrin.h>

#include "physics/membrane/membrane_kernel.hpp"

#define RHEXIS_WIDTH 8
namespace rhexis::membrane_kernel {
namespace {
#include "physics/membrane/membrane_kernel.ipp"
constexpr Kernel kernel{"avx512", assemble};
}  // namespace
const Kernel* avx512() { return &kernel; }
}  // namespace rhexis::membrane_kernel
