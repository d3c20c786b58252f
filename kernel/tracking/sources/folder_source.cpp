// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/sources/folder_source.hpp"

#include <array>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "base/output_file.hpp"
#include "tracking/sources/grey.hpp"

namespace rhexis::tracking {
namespace {

namespace fs = std::filesystem;

/// The number that a name ends with, before its extension.
std::optional<std::uint64_t> number_of(const fs::path& path) {
    const std::string stem = path.stem().string();
    const std::size_t begin = stem.find_last_not_of("0123456789") + 1;
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(stem.data() + begin, stem.data() + stem.size(), number);
    return begin < stem.size() && error == std::errc() ? std::optional(number) : std::nullopt;
}

bool is_image(const fs::path& path) {
    const std::string extension = path.extension().string();
    for (const char* known : {".png", ".pgm", ".tif", ".tiff", ".bmp", ".jpg", ".jpeg"}) {
        if (extension == known) {
            return true;
        }
    }
    return false;
}

using Images = std::map<std::uint64_t, std::vector<std::string>>;  // by exposure, then by camera; empty: lost

Status list_images(const fs::path& folder, std::size_t camera, std::size_t cameras, Images& images) {
    std::error_code wrong;
    bool any = false;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, wrong)) {
        if (!is_image(entry.path())) {
            continue;
        }
        const std::optional<std::uint64_t> number = number_of(entry.path());
        if (!number) {
            return Error{"an image's name does not end with a number", entry.path().string(), "as in 000017.png"};
        }
        std::vector<std::string>& of_all = images[*number];
        of_all.resize(cameras);
        of_all[camera] = entry.path().string();
        any = true;
    }
    if (wrong) {
        return Error{"no such folder", folder.string(), "a folder for each camera, named as it is"};
    }
    if (!any) {
        return Error{"no images", folder.string(), "png, pgm, tif, bmp or jpg"};
    }
    return success();
}

class FolderSource final : public FrameSource {
public:
    FolderSource(const Rig& rig, Images images, double rate_hz)
        : rig_(rig), images_(std::move(images)), next_(images_.begin()), rate_hz_(rate_hz) {}

    Result<bool> next(FrameSet& set) override {
        if (next_ == images_.end()) {
            return false;
        }
        set.time_s = static_cast<double>(next_->first) / rate_hz_;
        set.frames.clear();
        for (std::size_t i = 0; i < rig_.cameras.size(); ++i) {
            const std::string& path = next_->second[i];
            if (path.empty()) {
                ++lost_;
                continue;
            }
            CameraFrame frame{static_cast<int>(i), set.time_s, 0, 0, {}};
            if (const Status read = grey_frame(cv::imread(path, cv::IMREAD_GRAYSCALE), rig_.cameras[i], path, frame);
                !read) {
                return read.error();
            }
            frame.from = path;
            set.frames.push_back(std::move(frame));
        }
        ++next_;
        return true;
    }
    [[nodiscard]] double rate_hz() const override { return rate_hz_; }
    [[nodiscard]] std::uint64_t lost() const override { return lost_; }

private:
    Rig rig_;
    Images images_;
    Images::const_iterator next_;
    double rate_hz_;
    std::uint64_t lost_ = 0;
};

}  // namespace

Result<std::unique_ptr<FrameSource>> open_folder(const FolderPlan& plan, const Rig& rig) {
    Images images;
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        const fs::path folder = fs::path(plan.path) / rig.cameras[i].name;
        if (const Status listed = list_images(folder, i, rig.cameras.size(), images); !listed) {
            return listed.error();
        }
    }
    return std::unique_ptr<FrameSource>(std::make_unique<FolderSource>(rig, std::move(images), plan.rate_hz));
}

Status keep_frames(const std::string& folder, const Rig& rig, const FrameSet& set, std::uint64_t number) {
    std::array<char, 24> name{};
    std::snprintf(name.data(), name.size(), "%06llu.png", static_cast<unsigned long long>(number));
    for (const CameraFrame& frame : set.frames) {
        const fs::path place = fs::path(folder) / rig.cameras[static_cast<std::size_t>(frame.camera)].name;
        std::error_code ignored;  // what cannot be made cannot be written into, which is told
        fs::create_directories(place, ignored);
        const cv::Mat grey(frame.height, frame.width, CV_8UC1, const_cast<std::uint8_t*>(frame.pixels.data()));
        std::vector<std::uint8_t> png;
        cv::imencode(".png", grey, png);
        if (const Status written =
                write_file((place / name.data()).string(), {reinterpret_cast<const char*>(png.data()), png.size()});
            !written) {
            return written;
        }
    }
    return success();
}

}  // namespace rhexis::tracking
