// SPDX-License-Identifier: GPL-3.0-or-later
// The microscope's picture in the window: the newest state, with the instruments where the hands are by now.
#pragma once

#include <optional>
#include <vector>

#include "render/image_file.hpp"
#include "render/renderer.hpp"
#include "station/desk.hpp"
#include "station/ghost.hpp"
#include "station/picture_size.hpp"
#include "station/window/fitted_renderer.hpp"
#include "station/window/panels.hpp"
#include "station/window/window.hpp"

namespace rhexis::station {

/// Of a window so wide, what the picture for one eye has. [pixels]
int width_of_eye(int width, Stereo stereo);

class LivePicture {
public:
    struct Wishes {
        Stereo stereo = Stereo::off;
        const Ghost* ghost = nullptr;
        bool keep_rate = false;  ///< pictures are drawn smaller where there would be too few
        double step_s = 0.01;
    };

    LivePicture(Window& window, Panels& panels, FittedRenderer renderer, HoldScript holds, const Wishes& wishes);

    /// after: events that are not yet in the state. taken: receives what the window shows; null: nobody wants it. What
    /// is clicked comes back.
    std::vector<UserEvent> draw(Shown& shown, const std::vector<UserEvent>& after, Image* taken = nullptr);

private:
    /// What a picture of an eye is seen of.
    struct Sight {
        Vec3 camera = Vec3::Zero();  ///< in the eye's frame [mm]
        Vec3 target = Vec3::Zero();
        double focus_mm = 0.0;
        double field_mm = 0.0;
        double pupil_radius = 0.0;
    };
    bool moves(const Frame& frame, const Camera& camera);
    FittedRenderer& renderer_for(const Frame& frame, const Camera& camera, const ScreenArea& all);
    void count(double took_s);
    void run_ahead(Shown& shown, const std::vector<UserEvent>& after);

    Window& window_;
    Panels& panels_;
    Wishes wishes_;
    FittedRenderer sharp_;
    std::optional<FittedRenderer> coarse_;  ///< made when it is first needed
    PictureSize size_;
    Sight sight_;  ///< of the picture before
    HoldScript holds_;
    double begun_s_;
    double rate_ = 0.0;
    int count_ = 0;
};

}  // namespace rhexis::station
