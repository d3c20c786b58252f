// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/annotated.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/output_file.hpp"
#include "tracking/bodies/rigid_fit.hpp"

namespace rhexis::tracking {
namespace {

constexpr int tile_width = 640;  ///< of a camera among all [pixels]
constexpr int columns = 3;
// Told apart by light as well as by colour.
constexpr std::array<std::array<unsigned char, 3>, 4> colours{
    {{255, 165, 0}, {80, 200, 255}, {160, 255, 160}, {255, 140, 255}}};
constexpr std::array<unsigned char, 3> colour_of_coverage{60, 160, 90};
const cv::Scalar ground(24, 24, 24);
const cv::Scalar of_letters(220, 220, 220);
const cv::Scalar of_rings(200, 200, 200);

constexpr int cross_size = 12;  ///< of a marker [pixels]
constexpr double name_size = 0.45;
constexpr double camera_name_size = 0.6;

/// A camera's picture while it is drawn.
struct Tile {
    const Camera& camera;
    double scale;  ///< from pixels of the camera to those of the picture
    cv::Mat& picture;
    std::vector<cv::Rect> taken{};  ///< by names and by what names may not hide

    [[nodiscard]] cv::Point at(const Vec2& pixel) const {
        return {static_cast<int>(std::lround((pixel.x() + 0.5) * scale)),
                static_cast<int>(std::lround((pixel.y() + 0.5) * scale))};
    }
    [[nodiscard]] bool is_free(const cv::Rect& place) const {
        return (place & cv::Rect({0, 0}, picture.size())) == place &&
               std::none_of(taken.begin(), taken.end(), [&](const cv::Rect& one) { return (one & place).area() > 0; });
    }
    /// On a shadow, so that it is read before bright things as well.
    void write(const std::string& text, const cv::Rect& place, double size, const cv::Scalar& colour) {
        for (const int thick : {3, 1}) {
            cv::putText(picture, text, {place.x, place.y + place.height}, cv::FONT_HERSHEY_SIMPLEX, size,
                        thick > 1 ? cv::Scalar(0, 0, 0) : colour, thick, cv::LINE_AA);
        }
        taken.push_back(place);
    }
};

cv::Size size_of(const std::string& text, double size) {
    return cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, size, 1, nullptr);
}

cv::Scalar scalar_of(const std::array<unsigned char, 3>& colour) {
    return {static_cast<double>(colour[0]), static_cast<double>(colour[1]), static_cast<double>(colour[2])};
}

/// Whether there was an exposure.
bool draw_ground(const Tile& tile, int index, const SeenByCameras& seen) {
    tile.picture.setTo(ground);
    if (seen.images != nullptr) {
        for (const CameraFrame& frame : seen.images->frames) {
            if (frame.camera == index) {
                const cv::Mat grey(frame.height, frame.width, CV_8UC1, const_cast<std::uint8_t*>(frame.pixels.data()));
                cv::Mat small;
                cv::resize(grey, small, tile.picture.size(), 0, 0, cv::INTER_AREA);
                cv::cvtColor(small, tile.picture, cv::COLOR_GRAY2RGB);
            }
        }
    }
    return std::any_of(seen.exposures.begin(), seen.exposures.end(),
                       [index](const CameraSpots& one) { return one.camera == index; });
}

void draw_spots(Tile& tile, const std::vector<Spot>& spots) {
    constexpr double pi = 3.14;
    for (const Spot& spot : spots) {
        const int radius = static_cast<int>(std::lround(std::sqrt(spot.area / pi) * tile.scale)) + 4;
        const cv::Point middle = tile.at(spot.at);
        cv::circle(tile.picture, middle, radius, of_rings, 1, cv::LINE_AA);
        tile.taken.emplace_back(middle - cv::Point(radius, radius), middle + cv::Point(radius, radius));
    }
}

/// Where its markers are in the picture comes back.
std::vector<cv::Point> draw_body(Tile& tile, const MarkerBody& body, const Pose& pose, const cv::Scalar& colour) {
    std::vector<cv::Point> markers;
    for (const Vec3& marker : body.markers) {
        if (const std::optional<Vec2> image = project(tile.camera, pose.to_world(marker))) {
            markers.push_back(tile.at(*image));
            cv::drawMarker(tile.picture, markers.back(), colour, cv::MARKER_CROSS, cross_size, 1, cv::LINE_AA);
            const cv::Point half(cross_size / 2, cross_size / 2);
            tile.taken.emplace_back(markers.back() - half, markers.back() + half);
        }
    }
    const std::optional<Vec2> tip = project(tile.camera, pose.to_world(body.tip.position));
    const std::optional<Vec2> shaft = project(tile.camera, pose.to_world(body.tip.to_world({0.0, 0.0, 60.0})));
    if (tip && shaft) {
        cv::line(tile.picture, tile.at(*tip), tile.at(*shaft), colour, 1, cv::LINE_AA);
        cv::circle(tile.picture, tile.at(*tip), 3, colour, cv::FILLED, cv::LINE_AA);
    }
    return markers;
}

/// Beside one of its markers where nothing else is; where there is no such place, nowhere: its colour says whose it is.
void write_name(Tile& tile, const std::string& name, const std::vector<cv::Point>& markers, const cv::Scalar& colour) {
    const cv::Size size = size_of(name, name_size);
    for (const int apart : {9, 14, 20}) {  // the rings of large spots are in the way of near ones
        for (const cv::Point& marker : markers) {
            for (const cv::Point& corner :
                 {cv::Point(apart, -apart - size.height), cv::Point(apart, apart),
                  cv::Point(-apart - size.width, -apart - size.height), cv::Point(-apart - size.width, apart)}) {
                if (const cv::Rect place(marker + corner, size); tile.is_free(place)) {
                    tile.write(name, place, name_size, colour);
                    return;
                }
            }
        }
    }
}

}  // namespace

std::array<unsigned char, 3> body_colour(std::size_t body) { return colours[body % colours.size()]; }

Image annotated_camera(const Rig& rig, std::span<const MarkerBody> bodies, const SeenByCameras& seen, int camera,
                       int width) {
    const Camera& of = rig.cameras[static_cast<std::size_t>(camera)];
    const double scale = static_cast<double>(width) / of.width;
    Image image{width, std::max(1, static_cast<int>(std::lround(of.height * scale))), {}};
    image.rgb.resize(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    cv::Mat picture(image.height, image.width, CV_8UC3, image.rgb.data());
    Tile tile{of, scale, picture};
    const bool came = draw_ground(tile, camera, seen);
    const std::string title = came ? of.name : of.name + ": this exposure did not come";
    tile.write(title, {{10, 10}, size_of(title, camera_name_size)}, camera_name_size, of_letters);
    for (const CameraSpots& exposure : seen.exposures) {
        if (exposure.camera == camera) {
            draw_spots(tile, exposure.spots);
        }
    }
    std::vector<std::vector<cv::Point>> markers(bodies.size());
    for (std::size_t b = 0; b < bodies.size() && b < seen.bodies.size(); ++b) {
        if (seen.bodies[b]) {
            markers[b] = draw_body(tile, bodies[b], *seen.bodies[b], scalar_of(body_colour(b)));
        }
    }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        write_name(tile, bodies[b].name, markers[b], scalar_of(body_colour(b)));
    }
    return image;
}

void draw_coverage(const Coverage& coverage, Image& picture) {
    constexpr double share_of_light = 0.3;
    cv::Mat drawn(picture.height, picture.width, CV_8UC3, picture.rgb.data());
    for (int i = 0; i < static_cast<int>(coverage.points.size()); ++i) {
        const int column = i % coverage.columns;
        const int row = i / coverage.columns;
        const cv::Rect cell(cv::Point(column * picture.width / coverage.columns, row * picture.height / coverage.rows),
                            cv::Point((column + 1) * picture.width / coverage.columns - 1,
                                      (row + 1) * picture.height / coverage.rows - 1));
        if (coverage.points[static_cast<std::size_t>(i)] > 0) {
            cv::Mat part = drawn(cell);
            const cv::Mat light(part.size(), part.type(), scalar_of(colour_of_coverage));
            cv::addWeighted(part, 1.0 - share_of_light, light, share_of_light, 0.0, part);
        }
    }
}

Status write_annotated(const std::string& path, const Rig& rig, std::span<const MarkerBody> bodies,
                       const SeenByCameras& seen) {
    std::vector<Image> tiles;
    int height = 0;
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        tiles.push_back(annotated_camera(rig, bodies, seen, static_cast<int>(i), tile_width));
        height = std::max(height, tiles.back().height);
    }
    const int count = static_cast<int>(tiles.size());
    const int rows = (count + columns - 1) / columns;
    cv::Mat all(rows * height, std::min(columns, count) * tile_width, CV_8UC3, cv::Scalar(0, 0, 0));
    for (int i = 0; i < count; ++i) {
        Image& tile = tiles[static_cast<std::size_t>(i)];
        const cv::Mat drawn(tile.height, tile.width, CV_8UC3, tile.rgb.data());
        cv::cvtColor(drawn, all(cv::Rect(i % columns * tile_width, i / columns * height, tile.width, tile.height)),
                     cv::COLOR_RGB2BGR);
    }
    std::vector<std::uint8_t> png;
    if (!cv::imencode(".png", all, png)) {
        return Error{"the picture cannot be packed", path, "PNG"};
    }
    return write_file(path, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace rhexis::tracking
