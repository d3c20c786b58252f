// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/blas.hpp"

extern "C" void openblas_set_num_threads(int threads);

namespace rhexis {

void use_one_blas_thread() { openblas_set_num_threads(1); }

}  // namespace rhexis
