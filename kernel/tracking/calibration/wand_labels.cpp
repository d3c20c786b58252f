// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/wand_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rhexis::tracking {
namespace {

/// Sum of the rays' projections onto the planes across them, of which a point is solved.
struct RayCrossing {
    Mat3 across = Mat3::Zero();
    Vec3 moment = Vec3::Zero();

    void add(const Camera& camera, const Vec2& direction) {
        const Vec3 along = (camera.pose.orientation * Vec3(direction.x(), direction.y(), 1.0)).normalized();
        const Mat3 plane = Mat3::Identity() - along * along.transpose();
        across += plane;
        moment += plane * camera.pose.position;
    }
    [[nodiscard]] Vec3 point() const {
        const Eigen::LDLT<Mat3> factor(across);
        return factor.solve(moment);
    }
};

const Camera& camera_of_view(std::span<const Camera> cameras, int camera) {
    return cameras[static_cast<std::size_t>(camera)];
}

std::vector<Vec2> directions_of(const Camera& camera, const std::vector<Vec2>& pixels) {
    std::vector<Vec2> directions;
    for (const Vec2& pixel : pixels) {
        directions.push_back(undistorted(camera.lens, pixel));
    }
    return directions;
}

LabelledView reordered(const LabelledView& view, std::span<const std::size_t> order) {
    LabelledView result{view.camera, {}, {}};
    for (const std::size_t i : order) {
        result.pixels.push_back(view.pixels[i]);
        result.directions.push_back(view.directions[i]);
    }
    return result;
}

/// Ends first and last, the one between them in the middle.
std::array<std::size_t, 3> order_on_line(const std::vector<Vec2>& at) {
    std::array<std::size_t, 3> order{0, 1, 2};
    double longest = -1.0;
    for (std::size_t middle = 0; middle < 3; ++middle) {
        const std::size_t first = (middle + 1) % 3;
        const std::size_t last = (middle + 2) % 3;
        if ((at[first] - at[last]).norm() > longest) {
            longest = (at[first] - at[last]).norm();
            order = {first, middle, last};
        }
    }
    return order;
}

/// A view whose first and last spots are the wand's ends, whichever is which; none: its spots are no wand's.
std::optional<LabelledView> ordered_on_line(const LabelledView& view) {
    constexpr double straight = 0.02;  // of the image's length: how far the middle one may be off the line
    if (view.directions.size() < 3) {
        return view;
    }
    const std::array<std::size_t, 3> order = order_on_line(view.directions);
    const Vec2 line = view.directions[order[2]] - view.directions[order[0]];
    const Vec2 to_middle = view.directions[order[1]] - view.directions[order[0]];
    const double off = line.x() * to_middle.y() - line.y() * to_middle.x();
    return std::abs(off) > straight * line.squaredNorm() ? std::nullopt : std::optional(reordered(view, order));
}

LabelledView reversed_view(const LabelledView& view) {
    return {
        view.camera, {view.pixels.rbegin(), view.pixels.rend()}, {view.directions.rbegin(), view.directions.rend()}};
}

const Vec2& end_of(const LabelledView& view, std::size_t end) {
    return end == 0 ? view.directions.front() : view.directions.back();
}

std::optional<LabelledView> ordered_by_gaps(const LabelledView& given, const Wand& wand) {
    constexpr double clear = 0.1;  // by how much the better way's logarithm of depths is nearer to 0
    const std::optional<LabelledView> view = ordered_on_line(given);
    if (!view) {
        return std::nullopt;
    }
    const Vec2 line = view->directions[2] - view->directions[0];
    const Vec2 to_middle = view->directions[1] - view->directions[0];
    const double seen = std::log(to_middle.norm() / (line - to_middle).norm());
    const double built = std::log((wand.at_mm[1] - wand.at_mm[0]) / (wand.at_mm[2] - wand.at_mm[1]));
    const double as_it_is = std::abs(seen - built);
    const double reversed = std::abs(-seen - built);
    if (!(std::abs(as_it_is - reversed) > clear)) {
        return std::nullopt;
    }
    return reversed < as_it_is ? reversed_view(*view) : *view;
}

/// Two places that the wand's ends may have, and how well the views agree.
struct EndsGuess {
    std::array<Vec3, 2> ends{Vec3::Zero(), Vec3::Zero()};
    double cost = std::numeric_limits<double>::infinity();
};

/// How far a point's image is from a direction [pixels]; a lot where it is behind the camera.
double distance_px(const Camera& camera, const Vec3& point, const Vec2& direction) {
    constexpr double most = 600.0;  // so that one wrong view does not outweigh the others
    const Vec3 seen = camera.pose.to_body(point);
    if (seen.z() <= 0.0) {
        return most;
    }
    const Vec2 off = seen.head<2>() / seen.z() - direction;
    return std::min(most, camera.lens.fx * off.norm());
}

/// Of the order as it is, and of the other.
std::array<double, 2> costs_of_view(const Camera& camera, const LabelledView& view, const std::array<Vec3, 2>& ends) {
    std::array<double, 2> costs{};
    for (std::size_t swapped = 0; swapped < 2; ++swapped) {
        costs[swapped] = distance_px(camera, ends[0], end_of(view, swapped)) +
                         distance_px(camera, ends[1], end_of(view, 1 - swapped));
    }
    return costs;
}

EndsGuess guess_of_pair(std::span<const Camera> cameras, double length_mm, const LabelledFrame& frame,
                        std::array<std::size_t, 2> pair, std::size_t swapped) {
    constexpr double pixels_per_share = 500.0;  // what the length's error costs against a pixel
    EndsGuess guess;
    for (std::size_t end = 0; end < 2; ++end) {
        const LabelledView& one = frame.views[pair[0]];
        const LabelledView& other = frame.views[pair[1]];
        RayCrossing crossing;
        crossing.add(camera_of_view(cameras, one.camera), end_of(one, end));
        crossing.add(camera_of_view(cameras, other.camera), end_of(other, swapped == 0 ? end : 1 - end));
        guess.ends[end] = crossing.point();
    }
    const double share = std::abs((guess.ends[1] - guess.ends[0]).norm() - length_mm) / length_mm;
    guess.cost = pixels_per_share * std::min(1.0, share);
    for (const LabelledView& view : frame.views) {
        const std::array<double, 2> costs = costs_of_view(camera_of_view(cameras, view.camera), view, guess.ends);
        guess.cost += std::min(costs[0], costs[1]);
    }
    return guess;
}

EndsGuess best_guess(std::span<const Camera> cameras, double length_mm, const LabelledFrame& frame) {
    EndsGuess best;
    for (std::size_t first = 0; first < std::min<std::size_t>(2, frame.views.size()); ++first) {
        for (std::size_t other = first + 1; other < frame.views.size(); ++other) {
            for (std::size_t swapped = 0; swapped < 2; ++swapped) {
                EndsGuess guess = guess_of_pair(cameras, length_mm, frame, {first, other}, swapped);
                if (guess.cost < best.cost) {
                    best = guess;
                }
            }
        }
    }
    return best;
}

/// Whether the sphere between the ends lies where it would if the ends were exchanged.
bool is_reversed(std::span<const Camera> cameras, const Wand& wand, const LabelledFrame& frame,
                 const std::array<Vec3, 2>& ends) {
    const double share = (wand.at_mm[1] - wand.at_mm[0]) / wand.length_mm();
    double as_it_is = 0.0;
    double reversed = 0.0;
    for (const LabelledView& view : frame.views) {
        const Camera& camera = camera_of_view(cameras, view.camera);
        as_it_is += distance_px(camera, ends[0] + share * (ends[1] - ends[0]), view.directions[1]);
        reversed += distance_px(camera, ends[1] + share * (ends[0] - ends[1]), view.directions[1]);
    }
    return reversed < as_it_is;
}

LabelledFrame as_seen(std::span<const Camera> cameras, const Wand& wand, const WandFrame& frame) {
    LabelledFrame result;
    for (const WandView& view : frame.views) {
        if (view.spots.size() == wand.at_mm.size()) {
            result.views.push_back(
                {view.camera, view.spots, directions_of(camera_of_view(cameras, view.camera), view.spots)});
        }
    }
    return result;
}

}  // namespace

LabelledFrame label_by_gaps(std::span<const Camera> cameras, const Wand& wand, const WandFrame& frame) {
    LabelledFrame result;
    for (const LabelledView& view : as_seen(cameras, wand, frame).views) {
        if (std::optional<LabelledView> labelled = ordered_by_gaps(view, wand)) {
            result.views.push_back(std::move(*labelled));
        }
    }
    return result;
}

LabelledFrame label_by_poses(std::span<const Camera> cameras, const Wand& wand, const WandFrame& frame) {
    constexpr double clear = 0.7;  // of the worse way's cost, at most
    LabelledFrame seen;
    for (const LabelledView& view : as_seen(cameras, wand, frame).views) {
        if (std::optional<LabelledView> on_line = ordered_on_line(view)) {
            seen.views.push_back(std::move(*on_line));
        }
    }
    if (seen.views.size() < 2) {
        return {};
    }
    const EndsGuess guess = best_guess(cameras, wand.length_mm(), seen);
    LabelledFrame result;
    for (const LabelledView& view : seen.views) {
        const std::array<double, 2> costs = costs_of_view(camera_of_view(cameras, view.camera), view, guess.ends);
        if (std::min(costs[0], costs[1]) < clear * std::max(costs[0], costs[1])) {
            result.views.push_back(costs[0] < costs[1] ? view : reversed_view(view));
        }
    }
    if (wand.at_mm.size() == 3 && is_reversed(cameras, wand, result, guess.ends)) {
        std::transform(result.views.begin(), result.views.end(), result.views.begin(), reversed_view);
    }
    return result;
}

Vec3 meeting_point(std::span<const Camera> cameras, const LabelledFrame& frame, std::size_t label) {
    RayCrossing crossing;
    for (const LabelledView& view : frame.views) {
        crossing.add(camera_of_view(cameras, view.camera), view.directions[label]);
    }
    return crossing.point();
}

}  // namespace rhexis::tracking
