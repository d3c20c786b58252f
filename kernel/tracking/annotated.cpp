// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/annotated.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/output_file.hpp"
#include "tracking/bodies/rigid_fit.hpp"

namespace rhexis::tracking {
namespace {

constexpr int tile_width = 640;  ///< [pixels]
constexpr int columns = 3;
// Told apart by light as well as by colour (B, G, R).
const std::array<cv::Scalar, 4> colours{cv::Scalar(0, 165, 255), cv::Scalar(255, 200, 80), cv::Scalar(160, 255, 160),
                                        cv::Scalar(255, 140, 255)};

cv::Point at(const Vec2& pixel, double scale) {
    return {static_cast<int>(std::lround((pixel.x() + 0.5) * scale)),
            static_cast<int>(std::lround((pixel.y() + 0.5) * scale))};
}

cv::Mat tile_of(const Camera& camera, int index, double scale, const FrameSet* images) {
    const cv::Size size(tile_width, static_cast<int>(std::lround(camera.height * scale)));
    cv::Mat tile(size, CV_8UC3, cv::Scalar(24, 24, 24));
    if (images != nullptr) {
        for (const CameraFrame& frame : images->frames) {
            if (frame.camera == index) {
                const cv::Mat grey(frame.height, frame.width, CV_8UC1, const_cast<std::uint8_t*>(frame.pixels.data()));
                cv::Mat small;
                cv::resize(grey, small, size, 0, 0, cv::INTER_AREA);
                cv::cvtColor(small, tile, cv::COLOR_GRAY2BGR);
            }
        }
    }
    cv::putText(tile, camera.name, {10, 24}, cv::FONT_HERSHEY_SIMPLEX, 0.6, cv::Scalar(220, 220, 220), 1, cv::LINE_AA);
    return tile;
}

void draw_body(cv::Mat& tile, const Camera& camera, const MarkerBody& body, const Pose& pose, const cv::Scalar& colour,
               double scale) {
    std::optional<Vec2> first;
    for (const Vec3& marker : body.markers) {
        if (const std::optional<Vec2> image = project(camera, pose.to_world(marker))) {
            cv::drawMarker(tile, at(*image, scale), colour, cv::MARKER_CROSS, 12, 1, cv::LINE_AA);
            first = first ? first : image;
        }
    }
    const std::optional<Vec2> tip = project(camera, pose.to_world(body.tip.position));
    const std::optional<Vec2> shaft = project(camera, pose.to_world(body.tip.to_world({0.0, 0.0, 60.0})));
    if (tip && shaft) {
        cv::line(tile, at(*tip, scale), at(*shaft, scale), colour, 1, cv::LINE_AA);
        cv::circle(tile, at(*tip, scale), 3, colour, cv::FILLED, cv::LINE_AA);
    }
    if (first) {
        cv::putText(tile, body.name, at(*first, scale) + cv::Point(10, -6), cv::FONT_HERSHEY_SIMPLEX, 0.45, colour, 1,
                    cv::LINE_AA);
    }
}

}  // namespace

Status write_annotated(const std::string& path, const Setup& setup, const std::vector<CameraSpots>& exposures,
                       const FrameSet* images, const std::vector<Pose>& bodies_in_rig, const std::vector<bool>& seen) {
    std::vector<cv::Mat> tiles;
    int height = 0;
    for (std::size_t i = 0; i < setup.rig.cameras.size(); ++i) {
        const Camera& camera = setup.rig.cameras[i];
        const double scale = static_cast<double>(tile_width) / camera.width;
        cv::Mat tile = tile_of(camera, static_cast<int>(i), scale, images);
        for (const CameraSpots& exposure : exposures) {
            for (std::size_t s = 0; exposure.camera == static_cast<int>(i) && s < exposure.spots.size(); ++s) {
                const Spot& spot = exposure.spots[s];
                const int radius = static_cast<int>(std::lround(std::sqrt(spot.area / 3.14) * scale)) + 4;
                cv::circle(tile, at(spot.at, scale), radius, cv::Scalar(200, 200, 200), 1, cv::LINE_AA);
            }
        }
        for (std::size_t b = 0; b < setup.bodies.size(); ++b) {
            if (seen[b]) {
                draw_body(tile, camera, setup.bodies[b], bodies_in_rig[b], colours[b % colours.size()], scale);
            }
        }
        height = std::max(height, tile.rows);
        tiles.push_back(std::move(tile));
    }
    const int rows = (static_cast<int>(tiles.size()) + columns - 1) / columns;
    cv::Mat all(rows * height, std::min(columns, static_cast<int>(tiles.size())) * tile_width, CV_8UC3,
                cv::Scalar(0, 0, 0));
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int x = static_cast<int>(i) % columns * tile_width;
        const int y = static_cast<int>(i) / columns * height;
        tiles[i].copyTo(all(cv::Rect(x, y, tiles[i].cols, tiles[i].rows)));
    }
    std::vector<std::uint8_t> png;
    if (!cv::imencode(".png", all, png)) {
        return Error{"the picture cannot be packed", path, "PNG"};
    }
    return write_file(path, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace rhexis::tracking
