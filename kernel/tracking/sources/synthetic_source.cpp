// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/sources/synthetic_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "tracking/bodies/rigid_fit.hpp"

namespace rhexis::tracking::synthetic {
namespace {

constexpr std::int64_t at_once = 600;  ///< frames whose shots are drawn together

/// Shots of some frames, exposure by exposure: one that comes later than half an exposure's time after it could have is
/// not waited for.
Result<std::vector<std::vector<Shot>>> shots_from(const SyntheticRig& rig, const Film& film, std::int64_t first) {
    const std::int64_t count = std::min(at_once, film.frames - first);
    const Result<std::vector<Shot>> all =
        shots(rig, film.delivery, static_cast<int>(count), film.seed + static_cast<std::uint64_t>(first));
    if (!all) {
        return all.error();
    }
    std::vector<std::vector<Shot>> sorted(static_cast<std::size_t>(count));
    const double patience_s = film.delivery.delay_s + 0.5 / film.delivery.rate_hz;
    const double begun_s = static_cast<double>(first) / film.delivery.rate_hz;
    for (Shot shot : all.value()) {
        if (shot.arrives_s - shot.exposed_s > patience_s) {
            continue;
        }
        std::vector<Shot>& frame = sorted[static_cast<std::size_t>(shot.frame)];
        shot.frame += first;
        shot.exposed_s += begun_s;
        shot.time_s += begun_s;
        shot.arrives_s += begun_s;
        frame.push_back(shot);
    }
    for (std::vector<Shot>& frame : sorted) {
        std::stable_sort(frame.begin(), frame.end(), [](const Shot& a, const Shot& b) { return a.camera < b.camera; });
    }
    return sorted;
}

/// What both kinds of film share: the stage as a shot sees it.
class Cameras {
public:
    Cameras(const SyntheticRig& rig, Stage stage, const Film& film, std::vector<std::vector<Shot>> shots)
        : rig_(rig), stage_(std::move(stage)), film_(film), shots_(std::move(shots)) {}

    [[nodiscard]] bool over() const { return next_ == film_.frames; }
    Result<std::vector<Shot>> take() {
        if (next_ - first_ == static_cast<std::int64_t>(shots_.size())) {
            Result<std::vector<std::vector<Shot>>> more = shots_from(rig_, film_, next_);
            if (!more) {
                return more.error();
            }
            shots_ = std::move(more).value();
            first_ = next_;
        }
        std::vector<Shot> shots = shots_[static_cast<std::size_t>(next_ - first_)];
        ++next_;
        lost_ += rig_.cameras.size() - shots.size();
        return shots;
    }
    TrueCamera camera_of(const Shot& shot) const {
        return stage_.camera ? stage_.camera(shot.camera, shot.exposed_s)
                             : rig_.cameras[static_cast<std::size_t>(shot.camera)];
    }
    const std::vector<Scene>& instants_of(const Shot& shot) {
        const int count = std::max(stage_.instants, 1);
        instants_.resize(static_cast<std::size_t>(count));
        for (int i = 0; i < count; ++i) {
            const double part = (i + 0.5) / count - 0.5;
            stage_.scene(shot.exposed_s + part * film_.delivery.exposure_s, instants_[static_cast<std::size_t>(i)]);
        }
        return instants_;
    }
    [[nodiscard]] const Film& film() const { return film_; }
    [[nodiscard]] std::uint64_t lost() const { return lost_; }
    /// Drawn anew for each image.
    [[nodiscard]] std::uint64_t seed_of(const Shot& shot) const {
        return film_.seed * 1000003U + static_cast<std::uint64_t>(shot.frame) * 64U +
               static_cast<std::uint64_t>(shot.camera);
    }

private:
    SyntheticRig rig_;
    Stage stage_;
    Film film_;
    std::vector<std::vector<Shot>> shots_;
    std::vector<Scene> instants_{};
    std::int64_t first_ = 0;  ///< frame of the first of `shots_`
    std::int64_t next_ = 0;
    std::uint64_t lost_ = 0;
};

class Images final : public FrameSource {
public:
    Images(const SyntheticRig& rig, Cameras cameras) : cameras_(std::move(cameras)) {
        for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
            patterns_.emplace_back(rig.cameras[i], cameras_.film().seed + i);
        }
    }
    Result<bool> next(FrameSet& set) override {
        set.frames.clear();
        if (cameras_.over()) {
            return false;
        }
        const Result<std::vector<Shot>> shots = cameras_.take();
        if (!shots) {
            return shots.error();
        }
        for (const Shot& shot : shots.value()) {
            render(cameras_.camera_of(shot), patterns_[static_cast<std::size_t>(shot.camera)],
                   cameras_.instants_of(shot), cameras_.seed_of(shot), scratch_, image_);
            set.frames.push_back({shot.camera, shot.time_s, image_.width, image_.height, image_.pixels});
            set.time_s = shot.time_s;
        }
        return true;
    }
    [[nodiscard]] double rate_hz() const override { return cameras_.film().delivery.rate_hz; }
    [[nodiscard]] std::uint64_t lost() const override { return cameras_.lost(); }

private:
    Cameras cameras_;
    std::vector<SensorPattern> patterns_{};
    RenderScratch scratch_{};
    Image image_{};
};

class Markers final : public SpotSource {
public:
    explicit Markers(Cameras cameras) : cameras_(std::move(cameras)) {}
    Result<bool> next(std::vector<CameraSpots>& exposures) override {
        exposures.clear();
        if (cameras_.over()) {
            return false;
        }
        const Result<std::vector<Shot>> shots = cameras_.take();
        if (!shots) {
            return shots.error();
        }
        for (const Shot& shot : shots.value()) {
            Rng rng(cameras_.seed_of(shot), "spots");
            CameraSpots exposure{shot.camera, shot.time_s, {}};
            SpotOptions options;
            options.centre = cameras_.film().centre;
            spots_without_images(cameras_.camera_of(shot), cameras_.instants_of(shot), options, rng, scratch_,
                                 exposure.spots);
            exposures.push_back(std::move(exposure));
        }
        return true;
    }
    [[nodiscard]] double rate_hz() const override { return cameras_.film().delivery.rate_hz; }
    [[nodiscard]] std::uint64_t lost() const override { return cameras_.lost(); }

private:
    Cameras cameras_;
    SpotScratch scratch_{};
};

Result<Cameras> cameras_of(const SyntheticRig& rig, Stage stage, const Film& film) {
    Result<std::vector<std::vector<Shot>>> first = shots_from(rig, film, 0);
    if (!first) {
        return first.error();
    }
    return Cameras(rig, std::move(stage), film, std::move(first).value());
}

}  // namespace

Result<std::unique_ptr<FrameSource>> film_images(const SyntheticRig& rig, Stage stage, const Film& film) {
    Result<Cameras> cameras = cameras_of(rig, std::move(stage), film);
    if (!cameras) {
        return cameras.error();
    }
    return std::unique_ptr<FrameSource>(std::make_unique<Images>(rig, std::move(cameras).value()));
}

Result<std::unique_ptr<SpotSource>> film_markers(const SyntheticRig& rig, Stage stage, const Film& film) {
    Result<Cameras> cameras = cameras_of(rig, std::move(stage), film);
    if (!cameras) {
        return cameras.error();
    }
    return std::unique_ptr<SpotSource>(std::make_unique<Markers>(std::move(cameras).value()));
}

Stage waved_wand(std::uint64_t seed) {
    struct Wave {
        Vec3 phase;
        Vec3 frequency_hz;
        [[nodiscard]] Vec3 at(double time_s) const {
            return (2.0 * std::numbers::pi * (frequency_hz * time_s + phase)).array().sin();
        }
    };
    Rng rng(seed, "wand");
    const auto draw = [&rng](double low, double high) {
        return Vec3(Vec3::Constant(low) + (high - low) * uniform3(rng));
    };
    const Wave moves{draw(0.0, 1.0), draw(0.2, 0.5)};
    const Wave turns{draw(0.0, 1.0), draw(0.15, 0.4)};
    Stage stage;
    stage.scene = [moves, turns](double time_s, Scene& scene) {
        const Vec3 middle = moves.at(time_s).cwiseProduct(Vec3(90.0, 90.0, 60.0));
        const Pose pose = moved({middle, Quat::Identity()}, {Vec3::Zero(), 1.5 * turns.at(time_s)}, 1.0);
        scene = Scene{};
        for (const double at : wand_mm) {
            Sphere sphere;
            sphere.centre = pose.to_world({at - 0.5 * wand_mm.back(), 0.0, 0.0});
            scene.spheres.push_back(sphere);
        }
    };
    return stage;
}

}  // namespace rhexis::tracking::synthetic
