// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "render/image_file.hpp"
#include "render/mp4_boxes.hpp"

using namespace rhexis;

namespace {

/// A folder of its own that goes away again.
struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / ("rhexis-files-" + std::to_string(getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string operator/(const char* name) const { return (path / name).string(); }
    [[nodiscard]] int files() const {
        return static_cast<int>(
            std::distance(std::filesystem::directory_iterator(path), std::filesystem::directory_iterator()));
    }
};

Image ramp(int width, int height, int shift = 0) {
    Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i) {
        for (int c = 0; c < 3; ++c) {
            image.rgb.push_back(static_cast<unsigned char>((i * (c + 1) + shift) % 251));
        }
    }
    return image;
}

/// Files of this process end at `bytes`, as on a full disk.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

}  // namespace

TEST_CASE("A PNG file holds the pixels that were given") {
    const Folder folder;
    const Image image = ramp(37, 23);
    REQUIRE(write_png(image, folder / "ramp.png").ok());
    CHECK(folder.files() == 1);
    const cv::Mat read = cv::imread(folder / "ramp.png", cv::IMREAD_COLOR);
    REQUIRE(read.cols == 37);
    REQUIRE(read.rows == 23);
    int different = 0;
    for (int y = 0; y < 23; ++y) {
        for (int x = 0; x < 37; ++x) {
            for (int c = 0; c < 3; ++c) {
                different += read.at<cv::Vec3b>(y, x)[2 - c] != image.rgb[3 * (y * 37 + x) + c];
            }
        }
    }
    CHECK(different == 0);
}

TEST_CASE("A PNG file that cannot be written is one clear error and leaves nothing behind") {
    const Folder folder;
    const Status no_folder = write_png(ramp(4, 4), folder / "missing/ramp.png");
    REQUIRE_FALSE(no_folder.ok());
    CHECK(no_folder.error().text().find("missing/ramp.png") != std::string::npos);
    CHECK(no_folder.error().text().find('\n') == std::string::npos);
    CHECK_FALSE(write_png(Image{}, folder / "empty.png").ok());
    CHECK(folder.files() == 0);
}

TEST_CASE("A disk that fills up while a PNG file is written keeps the picture that was there") {
    const Folder folder;
    REQUIRE(write_png(ramp(8, 8), folder / "ramp.png").ok());
    Status status = success();
    {
        const SmallDisk disk(4096);
        status = write_png(ramp(301, 203), folder / "ramp.png");
    }
    REQUIRE_FALSE(status.ok());
    CHECK(status.error().text().find("ramp.png") != std::string::npos);
    CHECK(folder.files() == 1);
    CHECK(cv::imread(folder / "ramp.png").cols == 8);
}

TEST_CASE("A video holds the pictures that were added, and appears only when it is finished") {
    const Folder folder;
    Result<VideoFile> video = VideoFile::create(folder / "film.mp4", 64, 48, 25.0);
    REQUIRE(video.ok());
    for (int i = 0; i < 12; ++i) {
        Image grey{64, 48, std::vector<unsigned char>(3 * 64 * 48, static_cast<unsigned char>(20 * i))};
        REQUIRE(video.value().add(grey).ok());
    }
    CHECK_FALSE(std::filesystem::exists(folder / "film.mp4"));
    CHECK_FALSE(video.value().add(ramp(32, 32)).ok());
    REQUIRE(video.value().finish().ok());
    CHECK(folder.files() == 1);
    std::ifstream file(folder / "film.mp4", std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    CHECK(bytes.find("moov") < bytes.find("mdat"));  // a browser plays it while it loads
    cv::VideoCapture read(folder / "film.mp4");
    REQUIRE(read.isOpened());
    CHECK(read.get(cv::CAP_PROP_FPS) == doctest::Approx(25.0));
    cv::Mat frame;
    int frames = 0;
    while (read.read(frame)) {
        CHECK(cv::mean(frame)[1] == doctest::Approx(20.0 * frames).epsilon(0.03).scale(100.0));
        ++frames;
    }
    CHECK(frames == 12);
}

TEST_CASE("A video that was cut off is not taken for a whole one") {
    const Folder folder;
    Result<VideoFile> video = VideoFile::create(folder / "film.mp4", 64, 48, 25.0);
    REQUIRE(video.ok());
    REQUIRE(video.value().add(ramp(64, 48)).ok());
    REQUIRE(video.value().finish().ok());
    CHECK(is_whole_mp4(folder / "film.mp4"));
    REQUIRE(write_index_first(folder / "film.mp4", folder / "again.mp4").ok());
    CHECK(std::filesystem::file_size(folder / "again.mp4") == std::filesystem::file_size(folder / "film.mp4"));
    const std::uintmax_t size = std::filesystem::file_size(folder / "film.mp4");
    for (const std::uintmax_t left : {size - 1, size / 2, std::uintmax_t{5}, std::uintmax_t{0}}) {
        std::filesystem::resize_file(folder / "film.mp4", left);
        CHECK_FALSE(is_whole_mp4(folder / "film.mp4"));
        CHECK_FALSE(write_index_first(folder / "film.mp4", folder / "again.mp4").ok());
    }
}

TEST_CASE("A video that is never finished leaves no file") {
    const Folder folder;
    {
        Result<VideoFile> video = VideoFile::create(folder / "film.mp4", 64, 48, 25.0);
        REQUIRE(video.ok());
        CHECK(video.value().add(ramp(64, 48)).ok());
    }
    CHECK(folder.files() == 0);
}

TEST_CASE("A video that cannot be written is one clear error") {
    const Folder folder;
    for (const auto& video :
         {VideoFile::create(folder / "missing/film.mp4", 64, 48, 25.0),
          VideoFile::create(folder / "film.avi", 64, 48, 25.0), VideoFile::create(folder / "film.mp4", 63, 48, 25.0),
          VideoFile::create(folder / "film.mp4", 64, 48, 0.0)}) {
        REQUIRE_FALSE(video.ok());
        CHECK(video.error().text().find("film.") != std::string::npos);
    }
    CHECK(folder.files() == 0);
}

TEST_CASE("A disk that fills up while a video is written is an error and leaves no file") {
    const Folder folder;
    Status status = success();
    {
        const SmallDisk disk(4096);
        Result<VideoFile> video = VideoFile::create(folder / "film.mp4", 320, 240, 25.0);
        REQUIRE(video.ok());
        for (int i = 0; i < 40; ++i) {
            CHECK(video.value().add(ramp(320, 240, 7 * i)).ok());
        }
        status = video.value().finish();
    }
    REQUIRE_FALSE(status.ok());
    CHECK(status.error().text().find("film.mp4") != std::string::npos);
    CHECK(folder.files() == 0);
}
