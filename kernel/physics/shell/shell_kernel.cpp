// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_kernel.hpp"

#include "math/same_instruction_set.hpp"

namespace rhexis::shell_kernel {

const Kernel* choose(std::string_view instruction_set) {
    return same_instruction_set(instruction_set, {baseline(), avx2(), avx512()});
}

}  // namespace rhexis::shell_kernel
