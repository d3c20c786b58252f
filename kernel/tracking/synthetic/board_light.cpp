// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/board_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/index.hpp"
#include "tracking/synthetic/blur.hpp"
#include "tracking/synthetic/window_rays.hpp"

namespace rhexis::tracking::synthetic {
namespace {

constexpr int part_px = 48;                ///< side of a part that is drawn at once
constexpr int blur_px = 4;                 ///< that light of a part's neighbours reaches into it
constexpr int edge_samples = 8;            ///< across a pixel
constexpr double nearest_board_mm = 20.0;  ///< that a board is to a camera

/// Half its width and height [mm]: a spacing beyond the outer dots; of chess the outer fields, and a margin as wide.
Vec2 half_size(const GridPlan& plan) {
    const double beyond = plan.kind == GridKind::chess ? 2.0 : 1.0;
    return plan.spacing_mm * Vec2(0.5 * (plan.columns - 1) + beyond, 0.5 * (plan.rows - 1) + beyond);
}

/// What is at a place of the board, and how far the next edge of the pattern is [mm].
struct Print {
    double light = 0.0;
    double edge_mm = 0.0;
};

Print dot_at(const Board& board, const Vec2& in_spacings) {
    const GridPlan& plan = board.plan;
    const Vec2 node(std::clamp(std::round(in_spacings.x()), 0.0, plan.columns - 1.0),
                    std::clamp(std::round(in_spacings.y()), 0.0, plan.rows - 1.0));
    const double beyond = (in_spacings - node).norm() - board.dot;
    return {beyond < 0.0 ? board.light : board.ground, std::abs(beyond) * plan.spacing_mm};
}

Print field_at(const Board& board, const Vec2& in_spacings) {
    const Vec2 field(std::floor(in_spacings.x()), std::floor(in_spacings.y()));
    const bool inside =
        field.x() >= -1.0 && field.y() >= -1.0 && field.x() < board.plan.columns && field.y() < board.plan.rows;
    const Vec2 away = (in_spacings - Vec2(in_spacings.array().round())).cwiseAbs();
    const bool dark = inside && std::lround(field.x() + field.y()) % 2 == 0;
    return {dark ? board.ground : board.light, away.minCoeff() * board.plan.spacing_mm};
}

/// A board as one camera has it before it.
class SeenBoard {
public:
    SeenBoard(const TrueCamera& camera, const Board& board)
        : camera_(camera),
          board_(board),
          turn_(board.pose.orientation.toRotationMatrix()),
          half_(half_size(board.plan)) {
        const GridPlan& plan = board.plan;
        first_ = Vec2(0.5 * (plan.columns - 1), 0.5 * (plan.rows - 1));
    }

    /// The part of the image that it may be in; empty: it is not seen from before, or not wholly before the camera.
    [[nodiscard]] Window window() const {
        Eigen::AlignedBox2d box;
        for (int i = 0; i <= 8; ++i) {  // a rim is bent by the lens: its ends and what is between them
            for (int j = 0; j <= 8; ++j) {
                const Vec2 on_board = half_.cwiseProduct(Vec2(0.25 * i - 1.0, 0.25 * j - 1.0));
                const Vec3 at = board_.pose.to_world({on_board.x(), on_board.y(), 0.0});
                if (at.z() < nearest_board_mm || turn_.col(2).dot(at) <= 0.0) {
                    return {};
                }
                box.extend(distorted(camera_.lens, at.head<2>() / at.z()));
            }
        }
        constexpr double spare = 12.0;  // for the bend between, and the blur
        const Vec2 low = (box.min().array() - spare).max(-spare).min(1e5);
        const Vec2 high = (box.max().array() + spare).max(-spare).min(1e5);
        return within({static_cast<int>(low.x()), static_cast<int>(low.y()), static_cast<int>(high.x()) + 1,
                       static_cast<int>(high.y()) + 1},
                      camera_.width, camera_.height);
    }

    /// Depth of its middle [mm].
    [[nodiscard]] double depth() const { return board_.pose.position.z(); }

    /// Mean light of a pixel; none: it is not the board's.
    [[nodiscard]] double pixel(const WindowRays& rays, int x, int y) const {
        const Vec3 ray = rays.at(x, y);
        const Vec3 point = met(ray);
        const double wide_mm = 1.5 * point.norm() * point.norm() / (camera_.lens.fx * turn_.col(2).dot(point));
        const Print print = printed(point);
        if (print.edge_mm > wide_mm) {
            return print.light * lit(point, ray);
        }
        double sum = 0.0;
        for (int i = 0; i < edge_samples; ++i) {
            const WindowRays::Line line = rays.line(y + (i + 0.5) / edge_samples - 0.5);
            for (int j = 0; j < edge_samples; ++j) {
                sum += printed(met(line.at(x + (j + 0.5) / edge_samples - 0.5))).light;
            }
        }
        return sum / (edge_samples * edge_samples) * lit(point, ray);
    }

private:
    /// Where a ray meets its plane. Far aside it meets it behind the camera: that is outside the board, too.
    [[nodiscard]] Vec3 met(const Vec3& ray) const {
        return turn_.col(2).dot(board_.pose.position) / turn_.col(2).dot(ray) * ray;
    }

    [[nodiscard]] Print printed(const Vec3& point) const {
        const Vec3 from_middle = point - board_.pose.position;
        const Vec2 on_board(turn_.col(0).dot(from_middle), turn_.col(1).dot(from_middle));
        const double to_rim = (half_ - on_board.cwiseAbs()).minCoeff();
        if (to_rim < 0.0) {
            return {0.0, -to_rim};
        }
        const Vec2 in_spacings = on_board / board_.plan.spacing_mm + first_;
        Print print = board_.plan.kind == GridKind::dots ? dot_at(board_, in_spacings) : field_at(board_, in_spacings);
        print.edge_mm = std::min(print.edge_mm, to_rim);
        return print;
    }

    /// Share of the light that comes back to the camera.
    [[nodiscard]] double lit(const Vec3& point, const Vec3& ray) const {
        const double cosine = turn_.col(2).dot(point) / point.norm();
        return cosine * light_at_mm * light_at_mm / point.squaredNorm() * sensitivity(camera_.optics, ray.head<2>());
    }

    const TrueCamera& camera_;
    const Board& board_;
    Mat3 turn_;
    Vec2 half_;
    Vec2 first_;
};

Window grown(const Window& window, int by) {
    return {window.left - by, window.top - by, window.right + by, window.bottom + by};
}

void add_part(const TrueCamera& camera, const SeenBoard& board, const Window& part, BoardScratch& scratch,
              LightField& field) {
    const Window all = grown(part, blur_px);
    const WindowRays rays(camera.lens, all);
    scratch.light.clear();
    for (int y = all.top; y < all.bottom; ++y) {
        for (int x = all.left; x < all.right; ++x) {
            scratch.light.push_back(static_cast<float>(board.pixel(rays, x, y)));
        }
    }
    const Vec2 middle{0.5 * (part.left + part.right - 1), 0.5 * (part.top + part.bottom - 1)};
    blur(scratch.light, all.width(), all.height(), psf_sigma(camera, middle, board.depth()), scratch.line);
    for (int y = part.top; y < part.bottom; ++y) {
        const float* from = scratch.light.data() + at((y - all.top) * all.width() + blur_px);
        std::transform(from, from + part.width(), field.light.begin() + at(y * field.width + part.left),
                       field.light.begin() + at(y * field.width + part.left), std::plus<>());
    }
    field.windows.push_back(part);
}

}  // namespace

void add_boards(const TrueCamera& camera, const Scene& seen, BoardScratch& scratch, LightField& field) {
    for (const Board& one : seen.boards) {
        const SeenBoard board(camera, one);
        const Window window = board.window();
        for (int top = window.top; top < window.bottom; top += part_px) {
            for (int left = window.left; left < window.right; left += part_px) {
                add_part(camera, board,
                         {left, top, std::min(left + part_px, window.right), std::min(top + part_px, window.bottom)},
                         scratch, field);
            }
        }
    }
}

}  // namespace rhexis::tracking::synthetic
