// SPDX-License-Identifier: GPL-3.0-or-later
#include "math/linear_kernel.hpp"

namespace rhexis::linear_kernel {

const Kernel* choose(std::string_view instruction_set) {
    const bool has_avx512 = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
                            __builtin_cpu_supports("avx512vl") != 0;
    const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    const bool any = instruction_set.empty();
    if (has_avx512 && (any || instruction_set == "avx512")) {
        return avx512();
    }
    if (has_avx2 && (any || instruction_set == "avx2")) {
        return avx2();
    }
    return any || instruction_set == "baseline" ? baseline() : nullptr;
}

}  // namespace rhexis::linear_kernel
