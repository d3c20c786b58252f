// SPDX-License-Identifier: GPL-3.0-or-later
// How large pictures are drawn, so that there are enough of them: smaller where they take too long, larger again where
// there is time.
#pragma once

#include <cstddef>
#include <vector>

namespace rhexis::station {

class PictureSize {
public:
    /// Of the window's size each way, 0.35 to 1.
    [[nodiscard]] double share() const;
    /// A picture of that share took so long [s]; from now on it may be another one.
    void count(double took_s);
    /// What is drawn with is new, so that the next pictures say little: textures are painted meanwhile.
    void begin_anew();

private:
    void decide(double usual_s);

    int size_ = 0;                ///< in the list of shares
    std::vector<double> took_s_;  ///< of the pictures that are looked at now
    double sum_s_ = 0.0;
    bool first_look_ = true;
    int easy_looks_ = 0;  ///< in a row, after which the next larger size would do
    int patience_ = 2;    ///< of those, before it is tried; more after each that was too large
    bool has_grown_ = false;
};

}  // namespace rhexis::station
