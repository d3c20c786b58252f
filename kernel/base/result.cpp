// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/result.hpp"

#include <cstdio>
#include <cstdlib>

namespace rhexis {

std::string Error::text() const {
    std::string line = lines().front();
    if (!more.empty()) {
        line += " (and " + std::to_string(more.size()) + " more)";
    }
    return line;
}

std::vector<std::string> Error::lines() const {
    std::string line;
    if (!where.empty()) {
        line += where + ": ";
    }
    line += what;
    if (!allowed.empty()) {
        line += " (" + allowed + ")";
    }
    std::vector<std::string> all{line};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

void assertion_failed(const char* expression, const char* file, int line) {
    std::fprintf(stderr, "rhexis: internal error: %s does not hold at %s:%d\n", expression, file, line);
    std::abort();
}

}  // namespace rhexis
