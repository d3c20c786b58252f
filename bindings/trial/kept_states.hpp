// SPDX-License-Identifier: GPL-3.0-or-later
// Where states that take long to make are kept for the next time: a cache, that may be deleted at any time.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis {

/// A folder that can be written, made if need be: states/ in what --cache or RHEXIS_CACHE names, else in
/// $XDG_CACHE_HOME/rhexis, else in ~/.cache/rhexis, else in a folder of this user alone among the temporary ones. Fails
/// where one is named that cannot be written, and where there is none at all.
Result<std::string> folder_of_states();

/// The turn to make the file of a path. Held by one process at a time, until it goes; the system frees it of one that
/// dies. Where there are no locks each process makes its own.
class Turn {
public:
    explicit Turn(const std::string& path);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

private:
    int file_;
};

}  // namespace rhexis
