// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane_kernel.hpp"

#include "math/linear_kernel.hpp"

namespace rhexis::membrane_kernel {

const Kernel* choose(std::string_view instruction_set) {
    const linear_kernel::Kernel* const same = linear_kernel::choose(instruction_set);
    for (const Kernel* kernel : {baseline(), avx2(), avx512()}) {
        if (same != nullptr && std::string_view(same->name) == kernel->name) {
            return kernel;
        }
    }
    return nullptr;
}

}  // namespace rhexis::membrane_kernel
