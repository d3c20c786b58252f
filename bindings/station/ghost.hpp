// SPDX-License-Identifier: GPL-3.0-or-later
// The way that an expert's instruments took, from a recording: shown on request, as an aid that the attempt tells of.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis::station {

class Ghost {
public:
    /// Of a run's folder or a recording. Fails where it is of other instruments than these.
    static Result<Ghost> read(const std::string& path, const std::vector<std::string>& instruments);

    /// The way of an instrument's tip in the room from where it came nearest to a place, for so long [mm]. Empty: it
    /// was not used.
    [[nodiscard]] std::vector<Vec3> ahead(int instrument, const Vec3& tip, double seconds) const;

private:
    double step_s_ = 0.01;
    std::vector<std::vector<Vec3>> ways_;  ///< by instrument, tips step by step
};

}  // namespace rhexis::station
