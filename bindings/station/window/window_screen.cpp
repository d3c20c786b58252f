// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/window_screen.hpp"

#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "render/image_file.hpp"
#include "station/window/read_window.hpp"

namespace rhexis::station {
namespace {

constexpr ImGuiWindowFlags whole_screen = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
const ImVec4 warned_colour{1.0F, 0.8F, 0.2F, 1.0F};
constexpr float edge = 6.0F;           ///< about everything [pixels]
constexpr float between = 4.0F;        ///< pictures
constexpr float most_of_table = 0.4F;  ///< of the window's height
constexpr float usual_shape = 0.8F;    ///< of pictures that have not come yet
constexpr const char* keys_hint = "F1: keys";

void to_the_right(const std::string& text) {
    const float free = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, free));
    ImGui::TextUnformatted(text.c_str());
}

}  // namespace

/// Height by width of the tallest picture that has come.
float WindowScreen::shape() const {
    float tallest = 0.0F;
    for (const Texture& one : textures_) {
        tallest =
            one.width > 0 ? std::max(tallest, static_cast<float>(one.height) / static_cast<float>(one.width)) : tallest;
    }
    return tallest > 0.0F ? tallest : usual_shape;
}

PictureGrid grid_of(int count, float shape, float width, float height) {
    PictureGrid best;
    for (int columns = 1; columns <= count; ++columns) {
        const int rows = (count + columns - 1) / columns;
        const float wide = (width - between * static_cast<float>(columns - 1)) / static_cast<float>(columns);
        const float high = (height - between * static_cast<float>(rows - 1)) / static_cast<float>(rows);
        const float fits = std::floor(std::min(wide, high / shape));
        if (fits > best.width) {
            best = {columns, fits, std::floor(fits * shape)};
        }
    }
    return best;
}

Result<std::unique_ptr<PictureScreen>> WindowScreen::open(const ScreenOptions& options) {
    Result<Window> window = Window::open(options.title, options.width, options.height, false);
    if (!window) {
        return window.error();
    }
    std::unique_ptr<WindowScreen> screen(new WindowScreen(std::move(window).value()));
    if (const Status drawable = screen->window_.draw_here(); !drawable) {
        return drawable.error();
    }
    screen->overlay_.emplace(screen->window_);
    return std::unique_ptr<PictureScreen>(std::move(screen));
}

WindowScreen::~WindowScreen() {
    for (const Texture& one : textures_) {
        glDeleteTextures(1, &one.name);
    }
}

ScreenWish WindowScreen::show(const ScreenMoment& moment) {
    for (const UserEvent& event : window_.poll()) {
        take(event, static_cast<int>(moment.pictures.size()));
    }
    draw(moment);
    window_.present();
    return wish_;
}

Status WindowScreen::keep(const ScreenMoment& moment, const std::string& png) {
    draw(moment);
    const Image image = read_window(window_);
    window_.present();
    return write_png(image, png);
}

void WindowScreen::take(const UserEvent& event, int pictures) {
    const bool down = event.value != 0.0;
    if (event.kind == EventKind::quit) {
        wish_.end = true;
    } else if (event.kind == EventKind::key && down) {
        take_key(event.name, pictures);
    } else if (event.kind == EventKind::pointer) {
        cursor_x_ = static_cast<float>(event.x * window_.height() + 0.5 * window_.width());
        cursor_y_ = static_cast<float>((0.5 - event.y) * window_.height());
    } else if (const int hit = picture_at_cursor(); event.kind == EventKind::button && down && hit >= 0) {
        wish_.one = wish_.one < 0 ? hit : -1;
    }
}

void WindowScreen::take_key(const std::string& name, int pictures) {
    const char last = name.empty() ? '\0' : name.back();
    if (name == "Escape") {
        wish_.end = true;
    } else if (name == "F1") {
        help_ = !help_;
    } else if ((name.size() == 1 || name.starts_with("Keypad ")) && last >= '0' && last <= '9') {
        const int number = last - '0';
        wish_.one = number <= pictures ? number - 1 : wish_.one;
    }
}

/// -1: none is there.
int WindowScreen::picture_at_cursor() const {
    for (const Place& one : places_) {
        if (cursor_x_ >= one.x && cursor_x_ < one.x + one.width && cursor_y_ >= one.y &&
            cursor_y_ < one.y + one.height) {
            return one.number;
        }
    }
    return -1;
}

void WindowScreen::draw(const ScreenMoment& moment) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, window_.width(), window_.height());
    glClearColor(0.02F, 0.03F, 0.04F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    overlay_->begin();
    const ImGuiIO& io = ImGui::GetIO();
    for (const ImWchar typed : io.InputQueueCharacters) {
        help_ = typed == '?' ? !help_ : help_;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {edge, edge});
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::Begin("screen", nullptr, whole_screen);
    draw_head(moment);
    const float line = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    const float table = moment.titles.empty()
                            ? 0.0F
                            : std::min(most_of_table * io.DisplaySize.y,
                                       line * static_cast<float>(moment.rows.size() + 1) + 2.0F * between);
    draw_pictures(moment, ImGui::GetContentRegionAvail().y - table);
    draw_table(moment);
    ImGui::End();
    ImGui::PopStyleVar();
    if (help_) {
        draw_help(moment);
    }
    overlay_->end();
}

/// Two lines, of which the second is for warnings: what is under them stays where it is.
void WindowScreen::draw_head(const ScreenMoment& moment) {
    ImGui::TextUnformatted(moment.state.c_str());
    ImGui::SameLine();
    to_the_right(keys_hint);
    ImGui::TextColored(warned_colour, "%s", moment.warning.c_str());
}

void WindowScreen::draw_pictures(const ScreenMoment& moment, float height) {
    const int count = static_cast<int>(moment.pictures.size());
    textures_.resize(std::max(textures_.size(), moment.pictures.size()));
    for (std::size_t i = 0; i < moment.pictures.size(); ++i) {
        if (moment.pictures[i].image.width > 0) {
            upload(moment.pictures[i].image, textures_[i]);
        }
    }
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    wish_.one = std::min(wish_.one, count - 1);
    const int shown = wish_.one < 0 ? count : 1;
    const PictureGrid grid = grid_of(shown, shape(), width, height);
    wish_.picture_width = std::max(64, static_cast<int>(grid.width));
    const float left = 0.5F * (width - static_cast<float>(grid.columns) * (grid.width + between) + between);
    places_.clear();
    for (int i = 0; i < shown; ++i) {
        places_.push_back({wish_.one < 0 ? i : wish_.one,
                           from.x + left + static_cast<float>(i % grid.columns) * (grid.width + between),
                           from.y + static_cast<float>(i / grid.columns) * (grid.height + between), grid.width,
                           grid.height});
    }
    const int hovered = picture_at_cursor();
    for (const Place& place : places_) {
        draw_picture(moment.pictures[static_cast<std::size_t>(place.number)], place, place.number == hovered);
    }
    ImGui::SetCursorScreenPos({from.x, from.y + height + between});
}

void WindowScreen::draw_picture(const ScreenPicture& picture, const Place& place, bool hovered) const {
    const ImVec2 from{place.x, place.y};
    const ImVec2 to{place.x + place.width, place.y + place.height};
    const Texture& texture = textures_[static_cast<std::size_t>(place.number)];
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (texture.name != 0) {
        list.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.name)), from, to);
    } else {
        list.AddText({from.x + edge, from.y + edge}, ImGui::GetColorU32(ImGuiCol_Text), picture.name.c_str());
    }
    if (picture.warned || hovered) {
        list.AddRect(
            from, to,
            picture.warned ? ImGui::ColorConvertFloat4ToU32(warned_colour) : ImGui::GetColorU32(ImGuiCol_ButtonHovered),
            0.0F, ImDrawFlags_None, picture.warned ? 3.0F : 1.0F);
    }
}

void WindowScreen::draw_table(const ScreenMoment& moment) const {
    if (moment.titles.empty() ||
        !ImGui::BeginTable("rows", static_cast<int>(moment.titles.size()),
                           ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY)) {
        return;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow();
    for (std::size_t i = 0; i < moment.titles.size(); ++i) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
        if (i == 0) {
            ImGui::TextUnformatted(moment.titles[i].c_str());
        } else {
            to_the_right(moment.titles[i]);
        }
        ImGui::PopStyleColor();
    }
    for (const ScreenRow& row : moment.rows) {
        ImGui::TableNextRow();
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            ImGui::TableNextColumn();
            if (i == 0) {
                const ImU32 colour = IM_COL32(row.colour[0], row.colour[1], row.colour[2], 255);
                ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour), "%s", row.cells[i].c_str());
            } else {
                to_the_right(row.cells[i]);
            }
        }
    }
    ImGui::EndTable();
}

void WindowScreen::draw_help(const ScreenMoment& moment) const {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.92F);
    ImGui::Begin("help", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs);
    const auto key = [](const std::string& keys, const std::string& what) {
        ImGui::TextUnformatted(keys.c_str());
        ImGui::SameLine(130.0F);
        ImGui::TextUnformatted(what.c_str());
    };
    key("1 to " + std::to_string(std::min<std::size_t>(9, moment.pictures.size())),
        "one of them, large; so does a click on it");
    key("0", "all of them; so does a click on a large one");
    key("F1 or ?", "this");
    key("Escape", "ends it, as closing the window does");
    ImGui::Separator();
    for (const std::string& line : moment.legend) {
        ImGui::TextUnformatted(line.c_str());
    }
    ImGui::End();
}

void WindowScreen::upload(const Image& image, Texture& texture) const {
    if (texture.name == 0) {
        glGenTextures(1, &texture.name);
    }
    glBindTexture(GL_TEXTURE_2D, texture.name);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (texture.width != image.width || texture.height != image.height) {
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                     image.rgb.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        texture.width = image.width;
        texture.height = image.height;
    } else {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace rhexis::station

extern "C" __attribute__((visibility("default"))) void rhexis_station_picture_screen(
    const rhexis::ScreenOptions& options, rhexis::Result<std::unique_ptr<rhexis::PictureScreen>>& screen) {
    screen = rhexis::station::WindowScreen::open(options);
}
