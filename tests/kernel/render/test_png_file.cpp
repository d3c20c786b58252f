// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <opencv2/imgcodecs.hpp>

#include "render/image_file.hpp"
#include "support/folder.hpp"
#include "support/written_pictures.hpp"

using namespace rhexis;
using namespace rhexis::test;

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
