// SPDX-License-Identifier: GPL-3.0-or-later
#include <immintrin.h>

#include "physics/solid/elastic_kernel.hpp"

#define RHEXIS_WIDTH 4
namespace rhexis::elastic_kernel {
namespace {
#include "physics/solid/elastic_kernel.ipp"
constexpr Kernel kernel{"avx2", assemble};
}  // namespace
const Kernel* avx2() { return &kernel; }
}  // namespace rhexis::elastic_kernel
