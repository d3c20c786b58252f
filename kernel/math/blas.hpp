// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace rhexis {

/// From now on BLAS sums in one order, on one core: with more of them the last digits depend on how many there are.
void use_one_blas_thread();

}  // namespace rhexis
