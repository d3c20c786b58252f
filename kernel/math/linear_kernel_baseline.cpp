// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>

#include "math/linear_kernel.hpp"

#define RHEXIS_WIDTH 4
#define RHEXIS_TILE 2
namespace rhexis::linear_kernel {
namespace {
#include "math/linear_kernel.ipp"
constexpr Kernel kernel{"baseline", gather,        extend,        eliminate,    invert, solve,
                        multiply,   multiply_many, products_many, combine_many, dot};
}  // namespace
const Kernel* baseline() { return &kernel; }
}  // namespace rhexis::linear_kernel
