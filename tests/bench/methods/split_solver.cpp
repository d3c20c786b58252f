// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/split_solver.hpp"

#include "bench/methods/anew_solver.hpp"
#include "bench/methods/kept_split_solver.hpp"

namespace rhexis::bench {

const char* name_of(SplitMethod method) {
    switch (method) {
        case SplitMethod::anew:
            return "anew";
        case SplitMethod::anew_double:
            return "anew_double";
        case SplitMethod::stale:
            return "stale";
        case SplitMethod::updown:
            return "updown";
        case SplitMethod::woodbury:
            return "woodbury";
    }
    return "";
}

std::unique_ptr<SplitSolver> split_solver(SplitMethod method, int splits) {
    switch (method) {
        case SplitMethod::anew:
            return anew_in_single();
        case SplitMethod::anew_double:
            return anew_in_double();
        case SplitMethod::stale:
            return with_stale_factor(splits);
        case SplitMethod::updown:
            return with_updown(splits);
        case SplitMethod::woodbury:
            return with_woodbury(splits);
    }
    return nullptr;
}

}  // namespace rhexis::bench
