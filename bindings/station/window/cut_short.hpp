// SPDX-License-Identifier: GPL-3.0-or-later
// A display that goes away: Xlib ends the process then, whatever else it does.
#pragma once

#include <string>

namespace rhexis::station {

/// As long as it lives: where the process ends, one line says how the attempt in this folder is gone on with, and
/// nothing is taken down under the threads that still run.
class CutShort {
public:
    explicit CutShort(const std::string& folder);
    ~CutShort();
    CutShort(const CutShort&) = delete;
    CutShort& operator=(const CutShort&) = delete;
};

}  // namespace rhexis::station
