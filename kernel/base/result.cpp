// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/result.hpp"

#include <cstdio>
#include <cstdlib>

namespace rhexis {

std::string Error::text() const {
    std::string line;
    if (!where.empty()) {
        line += where + ": ";
    }
    line += what;
    if (!allowed.empty()) {
        line += " (" + allowed + ")";
    }
    return line;
}

void assertion_failed(const char* expression, const char* file, int line) {
    std::fprintf(stderr, "rhexis: internal error: %s does not hold at %s:%d\n", expression, file, line);
    std::abort();
}

}  // namespace rhexis
