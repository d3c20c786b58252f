// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/sources/board_source.hpp"

#include "base/index.hpp"
#include "base/rng.hpp"
#include "math/poses.hpp"
#include "math/random_vectors.hpp"
#include "tracking/bodies/rigid_fit.hpp"
#include "tracking/synthetic/renderer.hpp"

namespace rhexis::tracking::synthetic {
namespace {

constexpr double moves_hz = 1.0;  ///< at which a hand moves a board from place to place

std::uint64_t seed_of(std::uint64_t seed, int camera) { return seed * 100U + static_cast<std::uint64_t>(camera); }

Vec2 image_of(const TrueCamera& camera, const Vec3& seen) { return distorted(camera.lens, seen.head<2>() / seen.z()); }

/// Whether each point, and a dot around it, is in the image.
bool wholly_seen(const TrueCamera& camera, const GridPlan& plan, const Pose& pose) {
    constexpr double spare_px = 4.0;
    for (int i = 0; i < plan.points(); ++i) {
        const Vec2 on_board = point_of(plan, i);
        const Vec3 seen = pose.to_world({on_board.x(), on_board.y(), 0.0});
        const double reach = spare_px + 0.3 * plan.spacing_mm * camera.lens.fx / seen.z();
        const Vec2 at = image_of(camera, seen);
        if (!(at.x() > reach && at.y() > reach && at.x() < camera.width - 1 - reach &&
              at.y() < camera.height - 1 - reach)) {
            return false;
        }
    }
    return true;
}

class BoardImages final : public FrameSource {
public:
    BoardImages(const SyntheticRig& rig, const GridPlan& plan, std::vector<std::vector<Pose>> poses, std::uint64_t seed)
        : rig_(rig), poses_(std::move(poses)), seed_(seed) {
        for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
            patterns_.emplace_back(rig.cameras[i], seed + i);
        }
        scene_.boards.emplace_back();
        scene_.boards[0].plan = plan;
        if (plan.kind == GridKind::chess) {
            scene_.boards[0].ground = 12.0;  // black paint, which is not as dark as what is behind dots
        }
    }

    Result<bool> next(FrameSet& set) override {
        set.frames.clear();
        if (view_ == poses_[0].size()) {
            return false;
        }
        set.time_s = static_cast<double>(view_) / moves_hz;
        for (int i = 0; i < static_cast<int>(rig_.cameras.size()); ++i) {
            const TrueCamera& camera = rig_.cameras[at(i)];
            scene_.boards[0].pose = times(camera.pose, poses_[at(i)][view_]);
            render(camera, patterns_[at(i)], {&scene_, 1}, seed_of(seed_, i) * 1000003U + view_, scratch_, image_);
            set.frames.push_back({i, set.time_s, image_.width, image_.height, image_.pixels});
        }
        ++view_;
        return true;
    }
    [[nodiscard]] double rate_hz() const override { return moves_hz; }

private:
    SyntheticRig rig_;
    std::vector<std::vector<Pose>> poses_;  ///< by camera, view by view
    std::vector<SensorPattern> patterns_{};
    std::uint64_t seed_;
    std::size_t view_ = 0;
    Scene scene_{};
    RenderScratch scratch_{};
    Image image_{};
};

}  // namespace

std::vector<Pose> held_poses(const TrueCamera& camera, const GridPlan& plan, int views, std::uint64_t seed) {
    constexpr int most_tries = 4000;
    Rng rng(seed, "board");
    const auto within = [&rng](double most) { return most * (2.0 * rng.uniform() - 1.0); };
    std::vector<Pose> poses;
    for (int tried = 0; tried < most_tries && static_cast<int>(poses.size()) < views; ++tried) {
        const Vec3 place{within(150.0), within(120.0), 420.0 + within(80.0)};
        const Pose pose =
            moved({place, Quat::Identity()}, {Vec3::Zero(), {within(0.6), within(0.6), within(0.8)}}, 1.0);
        if (wholly_seen(camera, plan, pose)) {
            poses.push_back(pose);
        }
    }
    return poses;
}

std::vector<BoardView> held_board(const TrueCamera& camera, const GridPlan& plan, int views, double noise_px,
                                  std::uint64_t seed) {
    Rng rng(seed, "noise of a board");
    std::vector<BoardView> all;
    for (const Pose& pose : held_poses(camera, plan, views, seed)) {
        BoardView view{"board " + std::to_string(all.size() + 1), camera.width, camera.height};
        for (int i = 0; i < plan.points(); ++i) {
            const Vec2 on_board = point_of(plan, i);
            view.points.push_back(image_of(camera, pose.to_world({on_board.x(), on_board.y(), 0.0})) +
                                  noise_px * normal2(rng));
        }
        all.push_back(std::move(view));
    }
    return all;
}

Result<std::unique_ptr<FrameSource>> film_boards(const SyntheticRig& rig, const GridPlan& plan, int views,
                                                 std::uint64_t seed) {
    std::vector<std::vector<Pose>> poses;
    for (int i = 0; i < static_cast<int>(rig.cameras.size()); ++i) {
        poses.push_back(held_poses(rig.cameras[at(i)], plan, views, seed_of(seed, i)));
        if (static_cast<int>(poses.back().size()) < views) {
            return Error{"the board does not fit into the image of \"" + rig.cameras[at(i)].name + "\"", "board",
                         "a smaller one"};
        }
    }
    return std::unique_ptr<FrameSource>(std::make_unique<BoardImages>(rig, plan, std::move(poses), seed));
}

}  // namespace rhexis::tracking::synthetic
