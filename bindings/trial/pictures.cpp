// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/pictures.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "lua/video_library.hpp"
#include "render/image_file.hpp"
#include "render/renderer.hpp"
#include "trial/places.hpp"

namespace rhexis {
namespace {

constexpr int width = 640;
constexpr int height = 480;

/// Letters, digits and dashes of a name, for a file.
std::string file_word(const std::string& name) {
    std::string word;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        word += plain ? c : '-';
    }
    return word.substr(0, 40);
}

/// Pictures of an earlier run in the same folder do not belong to this one.
void remove_old_pictures(const std::string& folder) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
        if (entry.path().extension() == ".png") {
            std::filesystem::remove(entry.path(), ignored);
        }
    }
}

}  // namespace

bool FilmClock::wants(double time_s) const {
    return time_s * pictures_per_second_ + 1e-6 >= static_cast<double>(frames_);
}

void FilmClock::advance_beyond(double time_s) {
    while (wants(time_s)) {
        advance();
    }
}

struct PictureBook::Parts {
    std::string folder;
    Renderer renderer;
    std::unique_ptr<Video> video;
    std::optional<Renderer> filming;  ///< its pictures follow one another: what does not change is kept
    FilmClock clock;
    std::vector<Picture> pictures;
    bool later = false;
    std::vector<std::pair<std::string, Frame>> undrawn{};  ///< files, relative to the folder

    Status draw(const Frame& frame, const std::string& file) {
        return write_png(renderer.draw(frame, microscope_camera(frame)), folder + "/" + file);
    }
};

PictureBook::PictureBook(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
PictureBook::~PictureBook() = default;
PictureBook::PictureBook(PictureBook&&) noexcept = default;

Result<PictureBook> PictureBook::create(const std::string& folder, bool video, double pictures_per_second) {
    Result<Renderer> renderer = Renderer::create(width, height);
    if (!renderer) {
        return renderer.error();
    }
    const Status made = prepare_folder(folder + "/frames");
    if (!made) {
        return made.error();
    }
    remove_old_pictures(folder + "/frames");
    std::unique_ptr<Parts> parts(
        new Parts{folder, std::move(renderer).value(), nullptr, std::nullopt, FilmClock(pictures_per_second), {}});
    if (video) {
        Result<std::unique_ptr<Video>> file = open_video(folder + "/video.mp4", width, height, pictures_per_second);
        if (!file) {
            return file.error();
        }
        Result<Renderer> filming = Renderer::create(width, height, Light::kept);
        if (!filming) {
            return filming.error();
        }
        parts->video = std::move(file).value();
        parts->filming.emplace(std::move(filming).value());
    }
    return PictureBook(std::move(parts));
}

Status PictureBook::keep(const Frame& frame, const std::string& name, const std::string& caption) {
    char number[16];
    std::snprintf(number, sizeof number, "%02zu", parts_->pictures.size() + 1);
    const std::string file = std::string("frames/") + number + "-" + file_word(name) + ".png";
    if (parts_->later) {
        parts_->undrawn.emplace_back(file, frame);
    }
    Status status = parts_->later ? success() : parts_->draw(frame, file);
    if (status) {
        parts_->pictures.push_back({file, name, caption, frame.time_s});
    }
    return status;
}

void PictureBook::draw_later() { parts_->later = true; }

bool PictureBook::wants_film(double time_s) const { return parts_->video && parts_->clock.wants(time_s); }

Status PictureBook::film(const Frame& frame) {
    if (!wants_film(frame.time_s)) {
        return success();
    }
    const Image image = parts_->filming->draw(frame, microscope_camera(frame));
    while (wants_film(frame.time_s)) {
        Status status = parts_->video->add(image);
        if (!status) {
            return status;
        }
        parts_->clock.advance();
    }
    return success();
}

Status PictureBook::finish() {
    for (const auto& [file, frame] : std::exchange(parts_->undrawn, {})) {
        if (Status status = parts_->draw(frame, file); !status) {
            return status;
        }
    }
    return parts_->video ? parts_->video->finish() : success();
}

const std::vector<Picture>& PictureBook::pictures() const { return parts_->pictures; }
bool PictureBook::has_video() const { return parts_->video != nullptr; }
FilmClock PictureBook::clock() const { return parts_->clock; }

}  // namespace rhexis
