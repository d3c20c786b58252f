// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/videoio.hpp>

#include "support/folder.hpp"
#include "support/written_pictures.hpp"
#include "video/mp4_boxes.hpp"
#include "video/video_file.hpp"

using namespace rhexis;
using namespace rhexis::test;

TEST_CASE("A video holds the pictures that were added, and appears only when it is finished") {
    const Folder folder;
    Result<std::unique_ptr<Video>> video = create_video_file(folder / "film.mp4", 64, 48, 25.0);
    REQUIRE(video.ok());
    for (int i = 0; i < 12; ++i) {
        Image grey{64, 48, std::vector<unsigned char>(3 * 64 * 48, static_cast<unsigned char>(20 * i))};
        REQUIRE(video.value()->add(grey).ok());
    }
    CHECK_FALSE(std::filesystem::exists(folder / "film.mp4"));
    CHECK_FALSE(video.value()->add(ramp(32, 32)).ok());
    REQUIRE(video.value()->finish().ok());
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
    Result<std::unique_ptr<Video>> video = create_video_file(folder / "film.mp4", 64, 48, 25.0);
    REQUIRE(video.ok());
    REQUIRE(video.value()->add(ramp(64, 48)).ok());
    REQUIRE(video.value()->finish().ok());
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
        Result<std::unique_ptr<Video>> video = create_video_file(folder / "film.mp4", 64, 48, 25.0);
        REQUIRE(video.ok());
        CHECK(video.value()->add(ramp(64, 48)).ok());
    }
    CHECK(folder.files() == 0);
}

TEST_CASE("A video that cannot be written is one clear error") {
    const Folder folder;
    for (const auto& video :
         {create_video_file(folder / "missing/film.mp4", 64, 48, 25.0),
          create_video_file(folder / "film.avi", 64, 48, 25.0), create_video_file(folder / "film.mp4", 63, 48, 25.0),
          create_video_file(folder / "film.mp4", 64, 48, 0.0)}) {
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
        Result<std::unique_ptr<Video>> video = create_video_file(folder / "film.mp4", 320, 240, 25.0);
        REQUIRE(video.ok());
        for (int i = 0; i < 40; ++i) {
            CHECK(video.value()->add(ramp(320, 240, 7 * i)).ok());
        }
        status = video.value()->finish();
    }
    REQUIRE_FALSE(status.ok());
    CHECK(status.error().text().find("film.mp4") != std::string::npos);
    CHECK(folder.files() == 0);
}
