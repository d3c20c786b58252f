// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/window_screen.hpp"

#include <SDL.h>
#include <doctest/doctest.h>
#include <epoxy/gl.h>

#include <array>
#include <cstring>
#include <string>

using namespace rhexis;
using namespace rhexis::station;

namespace {

constexpr int screen_width = 640;
constexpr int screen_height = 480;
constexpr int tile_width = 100;
constexpr int tile_height = 80;

Image plain(unsigned char red, unsigned char green, unsigned char blue) {
    Image image{tile_width, tile_height, {}};
    for (int i = 0; i < tile_width * tile_height; ++i) {
        image.rgb.insert(image.rgb.end(), {red, green, blue});
    }
    return image;
}

/// A red, a green and a blue one, and two bodies.
ScreenMoment three_pictures() {
    ScreenMoment moment;
    moment.state = "all is well";
    moment.pictures = {
        {"red", plain(255, 0, 0), false}, {"green", plain(0, 255, 0), false}, {"blue", plain(0, 0, 255), false}};
    moment.titles = {"body", "cameras"};
    moment.rows = {{{255, 165, 0}, {"phaco", "6"}}, {{80, 200, 255}, {"chopper"}}};
    return moment;
}

std::unique_ptr<PictureScreen> a_screen() {
    Result<std::unique_ptr<PictureScreen>> screen = WindowScreen::open({"test", screen_width, screen_height, ""});
    REQUIRE_MESSAGE(screen.ok(), (screen ? "" : screen.error().text()));
    return std::move(screen).value();
}

void press_key(SDL_Keycode key) {
    for (const Uint32 type : {SDL_KEYDOWN, SDL_KEYUP}) {
        SDL_Event event{};
        event.type = type;
        event.key.keysym.sym = key;
        SDL_PushEvent(&event);
    }
}

void type_text(const char* text) {
    SDL_Event event{};
    event.type = SDL_TEXTINPUT;
    std::strncpy(event.text.text, text, sizeof(event.text.text) - 1);
    SDL_PushEvent(&event);
}

/// Moved there, pressed and released, a picture each.
ScreenWish click(PictureScreen& screen, const ScreenMoment& moment, int x, int y) {
    SDL_Event moved{};
    moved.type = SDL_MOUSEMOTION;
    moved.motion.x = x;
    moved.motion.y = y;
    SDL_PushEvent(&moved);
    screen.show(moment);
    ScreenWish wish;
    for (const Uint32 type : {SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP}) {
        SDL_Event event{};
        event.type = type;
        event.button.button = SDL_BUTTON_LEFT;
        event.button.x = x;
        event.button.y = y;
        SDL_PushEvent(&event);
        wish = screen.show(moment);
    }
    return wish;
}

using Colour = std::array<unsigned char, 3>;

/// Of what was shown last: that driver has one buffer.
Colour colour_at(int x, int y) {
    Colour colour{};
    glReadPixels(x, screen_height - 1 - y, 1, 1, GL_RGB, GL_UNSIGNED_BYTE, colour.data());
    return colour;
}

}  // namespace

TEST_SUITE("window screen") {
    TEST_CASE("pictures get as large as their place lets them") {
        const PictureGrid six = grid_of(6, 0.8F, 1280.0F, 660.0F);
        CHECK(six.columns == 3);
        CHECK(six.height == doctest::Approx(328.0F).epsilon(0.01));
        CHECK(grid_of(1, 0.8F, 1280.0F, 660.0F).width == doctest::Approx(825.0F));
        CHECK(grid_of(6, 0.8F, 300.0F, 2000.0F).columns == 1);
        CHECK(grid_of(0, 0.8F, 300.0F, 200.0F).width == 0.0F);
    }

    TEST_CASE("keys choose a picture, all of them, and the end") {
        const std::unique_ptr<PictureScreen> screen = a_screen();
        const ScreenMoment moment = three_pictures();
        ScreenWish wish = screen->show(moment);
        CHECK(wish.one == -1);
        CHECK_FALSE(wish.end);
        const int among_all = wish.picture_width;
        press_key(SDLK_2);
        wish = screen->show(moment);
        CHECK(wish.one == 1);
        CHECK(wish.picture_width > among_all);
        CHECK(colour_at(screen_width / 2, screen_height / 2) == Colour{0, 255, 0});
        press_key(SDLK_7);  // there are three
        CHECK(screen->show(moment).one == 1);
        press_key(SDLK_0);
        CHECK(screen->show(moment).one == -1);
        press_key(SDLK_ESCAPE);
        CHECK(screen->show(moment).end);
    }

    TEST_CASE("F1 and ? show the keys over the pictures, and take them away again") {
        const std::unique_ptr<PictureScreen> screen = a_screen();
        const ScreenMoment moment = three_pictures();
        press_key(SDLK_2);
        screen->show(moment);
        const auto middle = [&] {
            screen->show(moment);  // what fits its content is as large as it is from its second picture on
            screen->show(moment);
            return colour_at(screen_width / 2, screen_height / 2);
        };
        const Colour green{0, 255, 0};
        CHECK(middle() == green);
        press_key(SDLK_F1);
        CHECK(middle() != green);
        press_key(SDLK_F1);
        CHECK(middle() == green);
        type_text("?");
        CHECK(middle() != green);
        type_text("?");
        CHECK(middle() == green);
    }

    TEST_CASE("closing the window ends it") {
        const std::unique_ptr<PictureScreen> screen = a_screen();
        CHECK_FALSE(screen->show(three_pictures()).end);
        SDL_Event event{};
        event.type = SDL_QUIT;
        SDL_PushEvent(&event);
        CHECK(screen->show(three_pictures()).end);
    }

    TEST_CASE("a click on a picture shows it alone, another one all of them") {
        const std::unique_ptr<PictureScreen> screen = a_screen();
        const ScreenMoment moment = three_pictures();
        screen->show(moment);
        ScreenWish wish = click(*screen, moment, screen_width / 4, screen_height / 4);
        CHECK(wish.one == 0);
        wish = click(*screen, moment, screen_width / 2, screen_height / 3);
        CHECK(wish.one == -1);
    }
}
