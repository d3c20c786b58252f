// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures beside each other, or one of them, with a table under them.
#pragma once

#include <optional>

#include "station/window/overlay.hpp"
#include "station/window/window.hpp"
#include "trial/picture_screen.hpp"

namespace rhexis::station {

/// So many pictures of a shape in a place, as large as they get.
struct PictureGrid {
    int columns = 1;
    float width = 0.0F;  ///< of a picture [pixels]
    float height = 0.0F;
};
/// shape: height of a picture by its width.
PictureGrid grid_of(int count, float shape, float width, float height);

class WindowScreen final : public PictureScreen {
public:
    static Result<std::unique_ptr<PictureScreen>> open(const ScreenOptions& options);
    ~WindowScreen() override;

    ScreenWish show(const ScreenMoment& moment) override;
    Status keep(const ScreenMoment& moment, const std::string& png) override;

private:
    /// Where a picture was drawn the last time [pixels].
    struct Place {
        int number = 0;
        float x = 0.0F;
        float y = 0.0F;
        float width = 0.0F;
        float height = 0.0F;
    };
    explicit WindowScreen(Window window) : window_(std::move(window)) {}

    void take(const UserEvent& event, int pictures);
    void take_key(const std::string& name, int pictures);
    [[nodiscard]] int picture_at_cursor() const;
    void draw(const ScreenMoment& moment);
    void draw_head(const ScreenMoment& moment);
    void draw_pictures(const ScreenMoment& moment, float height);
    void draw_picture(const ScreenPicture& picture, const Place& place, bool hovered) const;
    void draw_table(const ScreenMoment& moment) const;
    void draw_help(const ScreenMoment& moment) const;

    /// What was uploaded of a picture.
    struct Texture {
        unsigned int name = 0;
        int width = 0;
        int height = 0;
    };
    void upload(const Image& image, Texture& texture) const;
    [[nodiscard]] float shape() const;

    Window window_;
    std::optional<Overlay> overlay_;
    std::vector<Texture> textures_;
    std::vector<Place> places_;
    float cursor_x_ = -1.0F;  ///< [pixels]
    float cursor_y_ = -1.0F;
    ScreenWish wish_{};
    bool help_ = false;
};

}  // namespace rhexis::station
