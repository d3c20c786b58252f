// SPDX-License-Identifier: GPL-3.0-or-later
// What is written and clicked over the picture.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "station/desk.hpp"
#include "station/ghost.hpp"
#include "station/guide.hpp"
#include "station/mapping.hpp"
#include "station/window/window.hpp"

namespace rhexis::station {

/// How pictures are drawn.
struct DrawingRate {
    double pictures_per_s = 0.0;
    double size = 1.0;  ///< of the window's, that they are drawn in
};

class Panels {
public:
    explicit Panels(const Window& window);
    ~Panels();
    Panels(const Panels&) = delete;
    Panels& operator=(const Panels&) = delete;

    /// Over the picture that is drawn; what is clicked comes back as events. ghost: null, there is none.
    std::vector<UserEvent> draw(const Shown& shown, const Mapping& mapping, const Ghost* ghost,
                                const DrawingRate& rate);

private:
    Guide guide_;
};

}  // namespace rhexis::station
