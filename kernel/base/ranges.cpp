// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ranges.hpp"

#include "base/numbers.hpp"

namespace rhexis {

Status check_ranges(std::initializer_list<RangedNumber> numbers, const std::string& where) {
    for (const RangedNumber& one : numbers) {
        if (Status s = check_range(one.name, one.value, one.least, one.most, where, one.unit); !s) {
            return s;
        }
    }
    return success();
}

}  // namespace rhexis
