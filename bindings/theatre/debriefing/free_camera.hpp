// SPDX-License-Identifier: GPL-3.0-or-later
// A camera that leaves the microscope: it goes round what the microscope looks at.
#pragma once

#include "flow/frame.hpp"

namespace rhexis::station {

class FreeCamera {
public:
    /// By so many degrees round the eye, to the right and up.
    void turn(double right_deg, double up_deg);
    /// So many times as large.
    void zoom(double times);
    void reset() { *this = FreeCamera(); }
    [[nodiscard]] bool is_free() const { return right_deg_ != 0.0 || up_deg_ != 0.0 || zoom_ != 1.0; }

    /// From the microscope's own.
    [[nodiscard]] Camera of(const Camera& microscope) const;

private:
    double right_deg_ = 0.0;
    double up_deg_ = 0.0;
    double zoom_ = 1.0;
};

}  // namespace rhexis::station
