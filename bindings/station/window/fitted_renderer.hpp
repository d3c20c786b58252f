// SPDX-License-Identifier: GPL-3.0-or-later
// Draws pictures in the size of a part of a window, and in another one when that part has another.
#pragma once

#include <memory>

#include "render/renderer.hpp"

namespace rhexis::station {

class FittedRenderer {
public:
    /// For pictures in `share` of an area of so many pixels each way. In the context that is current on this thread.
    static Result<FittedRenderer> create(int width, int height, double share = 1.0);

    /// The area or the share may have changed since. The share counts at once; the area when it has stayed the same for
    /// a while, for somebody may be drawing its corner. What cannot be had leaves all as it is. True: it is made anew.
    bool fit(int width, int height, double share, double now_s);

    /// Of a part of the window, the largest in its middle that has the picture's shape.
    void show(const Frame& frame, const Camera& camera, const ScreenArea& area, Stereo stereo);

private:
    struct Size {
        int width = 0;
        int height = 0;
        bool operator==(const Size&) const = default;
    };
    FittedRenderer(Renderer renderer, Size area, double share);

    std::unique_ptr<Renderer> renderer_;
    Size area_;  ///< that it was made for
    double share_;
    Size tried_;  ///< that it was to be made for, which may have failed
    Size asked_;  ///< the last time
    double since_s_ = 0.0;
};

}  // namespace rhexis::station
