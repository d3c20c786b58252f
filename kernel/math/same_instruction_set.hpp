// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of one instruction set among several. Not for sources that are compiled for one.
#pragma once

#include <initializer_list>
#include <string_view>

#include "math/linear_kernel.hpp"

namespace rhexis {

/// That for which linear algebra would take the instruction set of this name (empty: the machine's best); null if there
/// is none.
template <typename Kernel>
const Kernel* same_instruction_set(std::string_view name, std::initializer_list<const Kernel*> kernels) {
    const linear_kernel::Kernel* const same = linear_kernel::choose(name);
    for (const Kernel* kernel : kernels) {
        if (same != nullptr && std::string_view(same->name) == kernel->name) {
            return kernel;
        }
    }
    return nullptr;
}

}  // namespace rhexis
