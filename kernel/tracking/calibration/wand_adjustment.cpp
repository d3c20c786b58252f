// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/wand_adjustment.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

#include "tracking/lens_model.hpp"

namespace rhexis::tracking {
namespace {

constexpr double huber_sigmas = 3.0;

/// What Ceres changes; addresses stay while a problem lives.
struct WandBlocks {
    std::vector<Quat> orientations{};
    std::vector<Vec3> positions{};
    std::vector<LensNumbers> lenses{};
    std::vector<std::array<double, 6>> ends{};
    double length_mm = 0.0;

    explicit WandBlocks(const WandEstimate& estimate) : ends(estimate.ends), length_mm(estimate.length_mm) {
        for (const Camera& camera : estimate.cameras) {
            orientations.push_back(camera.pose.orientation);
            positions.push_back(camera.pose.position);
            lenses.push_back(numbers_of(camera.lens));
        }
    }
    void write_to(WandEstimate& estimate) const {
        for (std::size_t i = 0; i < estimate.cameras.size(); ++i) {
            estimate.cameras[i].pose = {positions[i], orientations[i].normalized()};
            estimate.cameras[i].lens = lens_of(lenses[i]);
        }
        estimate.ends = ends;
        estimate.length_mm = length_mm;
    }
};

/// Whether a sphere at this depth is before the camera.
template <typename T>
bool is_before(const T& depth_mm, double radius_mm) {
    return depth_mm > T(2.0 * radius_mm);
}

/// A spot against the image of a sphere at `share` of the way between the wand's ends.
struct SpotResidual {
    Vec2 pixel;
    double share;
    double radius_mm;
    double sigma_px;

    template <typename T>
    bool operator()(const T* orientation, const T* position, const T* lens, const T* ends, T* residual) const {
        const Eigen::Map<const Eigen::Quaternion<T>> turned(orientation);
        const Eigen::Map<const Eigen::Matrix<T, 3, 1>> at(position);
        const Eigen::Map<const Eigen::Matrix<T, 3, 1>> first(ends);
        const Eigen::Map<const Eigen::Matrix<T, 3, 1>> last(ends + 3);
        const Eigen::Matrix<T, 3, 1> point = first + (last - first) * T(share);
        const Eigen::Matrix<T, 3, 1> seen = turned.conjugate() * Eigen::Matrix<T, 3, 1>(point - at);
        if (!is_before(seen.z(), radius_mm)) {
            return false;  // no spot is of what is behind the camera: a step that is not taken
        }
        const Eigen::Matrix<T, 2, 1> image = lens_image<T>(lens, sphere_direction<T>(seen, radius_mm));
        residual[0] = (image.x() - T(pixel.x())) / T(sigma_px);
        residual[1] = (image.y() - T(pixel.y())) / T(sigma_px);
        return true;
    }
};

/// The wand is as long in this frame as in all others.
struct RigidResidual {
    double sigma_mm;

    template <typename T>
    bool operator()(const T* ends, const T* length, T* residual) const {
        const Eigen::Map<const Eigen::Matrix<T, 3, 1>> first(ends);
        const Eigen::Map<const Eigen::Matrix<T, 3, 1>> last(ends + 3);
        residual[0] = (Eigen::Matrix<T, 3, 1>(last - first).norm() - length[0]) / T(sigma_mm);
        return true;
    }
};

/// The wand is as long as it was measured.
struct LengthResidual {
    double measured_mm;
    double sigma_mm;

    template <typename T>
    bool operator()(const T* length, T* residual) const {
        residual[0] = (length[0] - T(measured_mm)) / T(sigma_mm);
        return true;
    }
};

double share_of(const Wand& wand, std::size_t label) {
    return (wand.at_mm[label] - wand.at_mm.front()) / wand.length_mm();
}

void add_cameras(ceres::Problem& problem, WandBlocks& blocks, bool refine_lenses) {
    for (std::size_t i = 0; i < blocks.positions.size(); ++i) {
        problem.AddParameterBlock(blocks.orientations[i].coeffs().data(), 4, new ceres::EigenQuaternionManifold);
        problem.AddParameterBlock(blocks.positions[i].data(), 3);
        problem.AddParameterBlock(blocks.lenses[i].data(), 9);
        if (refine_lenses) {
            problem.SetManifold(blocks.lenses[i].data(), new ceres::SubsetManifold(9, {8}));
        } else {
            problem.SetParameterBlockConstant(blocks.lenses[i].data());
        }
    }
    problem.SetParameterBlockConstant(blocks.orientations[0].coeffs().data());
    problem.SetParameterBlockConstant(blocks.positions[0].data());
}

void add_frame(ceres::Problem& problem, WandBlocks& blocks, const LabelledFrame& frame, std::array<double, 6>& ends,
               const Wand& wand, const WandSettings& settings) {
    for (const LabelledView& view : frame.views) {
        const auto camera = static_cast<std::size_t>(view.camera);
        for (std::size_t label = 0; label < view.pixels.size(); ++label) {
            problem.AddResidualBlock(
                new ceres::AutoDiffCostFunction<SpotResidual, 2, 4, 3, 9, 6>(new SpotResidual{
                    view.pixels[label], share_of(wand, label), wand.radius_mm, settings.spot_sigma_px}),
                new ceres::HuberLoss(huber_sigmas), blocks.orientations[camera].coeffs().data(),
                blocks.positions[camera].data(), blocks.lenses[camera].data(), ends.data());
        }
    }
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<RigidResidual, 1, 6, 1>(new RigidResidual{settings.bending_mm}), nullptr,
        ends.data(), &blocks.length_mm);
}

void build(ceres::Problem& problem, WandBlocks& blocks, const WandEstimate& estimate, const Wand& wand,
           const WandSettings& settings) {
    add_cameras(problem, blocks, settings.refine_lenses);
    for (std::size_t i = 0; i < estimate.frames.size(); ++i) {
        add_frame(problem, blocks, estimate.frames[i], blocks.ends[i], wand, settings);
    }
    problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<LengthResidual, 1, 1>(new LengthResidual{wand.length_mm(), wand.sigma_mm}),
        nullptr, &blocks.length_mm);
}

/// Ends are eliminated first, so that what is left is as large as the rig.
ceres::Solver::Options solver_options(const ceres::Problem& problem, WandBlocks& blocks, int most_iterations) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.num_threads = 1;
    options.max_num_iterations = most_iterations;
    options.logging_type = ceres::SILENT;
    auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    std::vector<double*> all;
    problem.GetParameterBlocks(&all);
    for (double* block : all) {
        ordering->AddElementToGroup(block, 1);
    }
    for (std::array<double, 6>& ends : blocks.ends) {
        ordering->AddElementToGroup(ends.data(), 0);
    }
    options.linear_solver_ordering = ordering;
    return options;
}

struct Solved {
    int iterations = 0;
    bool converged = false;
};

/// Until a step takes off less than this share of the cost.
Solved solve(WandEstimate& estimate, const Wand& wand, const WandSettings& settings, double least_share) {
    WandBlocks blocks(estimate);
    ceres::Problem problem;
    build(problem, blocks, estimate, wand, settings);
    ceres::Solver::Options options = solver_options(problem, blocks, settings.most_iterations);
    options.function_tolerance = least_share;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    blocks.write_to(estimate);
    return {static_cast<int>(summary.iterations.size()) - 1, summary.termination_type == ceres::CONVERGENCE};
}

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

WandEstimate wand_estimate(std::vector<Camera> cameras, std::vector<LabelledFrame> frames, double length_mm) {
    WandEstimate estimate{std::move(cameras), std::move(frames), {}, length_mm};
    for (const LabelledFrame& frame : estimate.frames) {
        const std::size_t last_label = frame.views.front().directions.size() - 1;
        const Vec3 first = meeting_point(estimate.cameras, frame, 0);
        const Vec3 last = meeting_point(estimate.cameras, frame, last_label);
        estimate.ends.push_back({first.x(), first.y(), first.z(), last.x(), last.y(), last.z()});
    }
    return estimate;
}

std::vector<SpotOff> spot_offs(const WandEstimate& estimate, const Wand& wand) {
    std::vector<SpotOff> offs;
    for (std::size_t i = 0; i < estimate.frames.size(); ++i) {
        const Eigen::Map<const Vec3> first(estimate.ends[i].data());
        const Eigen::Map<const Vec3> last(estimate.ends[i].data() + 3);
        for (const LabelledView& view : estimate.frames[i].views) {
            const Camera& camera = estimate.cameras[static_cast<std::size_t>(view.camera)];
            for (std::size_t label = 0; label < view.pixels.size(); ++label) {
                const Vec3 seen = camera.pose.to_body(first + (last - first) * share_of(wand, label));
                Vec2 off = Vec2::Constant(std::numeric_limits<double>::infinity());
                if (is_before(seen.z(), wand.radius_mm)) {
                    off = distorted(camera.lens, sphere_direction(seen, wand.radius_mm)) - view.pixels[label];
                }
                offs.push_back({i, view.camera, off});
            }
        }
    }
    return offs;
}

std::vector<double> worst_residuals(const WandEstimate& estimate, const Wand& wand) {
    std::vector<double> worst(estimate.frames.size(), 0.0);
    for (const SpotOff& spot : spot_offs(estimate, wand)) {
        worst[spot.frame] = std::max(worst[spot.frame], spot.off.norm());
    }
    return worst;
}

int drop_outliers(WandEstimate& estimate, const Wand& wand, double factor) {
    const std::vector<double> worst = worst_residuals(estimate, wand);
    const double limit = factor * median_of(worst);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < worst.size(); ++i) {
        if (worst[i] <= limit) {
            std::swap(estimate.frames[kept], estimate.frames[i]);
            std::swap(estimate.ends[kept], estimate.ends[i]);
            ++kept;
        }
    }
    estimate.frames.resize(kept);
    estimate.ends.resize(kept);
    return static_cast<int>(worst.size() - kept);
}

int approach(WandEstimate& estimate, const Wand& wand, const WandSettings& settings) {
    constexpr double near_enough = 1e-2;
    return solve(estimate, wand, settings, near_enough).iterations;
}

Result<int> adjust(WandEstimate& estimate, const Wand& wand, const WandSettings& settings) {
    constexpr double still = 1e-6;
    WandEstimate adjusted = estimate;
    const Solved solved = solve(adjusted, wand, settings, still);
    if (!solved.converged) {
        return Error{"the adjustment did not converge in " + std::to_string(settings.most_iterations) + " iterations",
                     "wand", "spots of the wand only, and lenses that are calibrated"};
    }
    estimate = std::move(adjusted);
    return solved.iterations;
}

Result<WandCertainty> certainty_of(const WandEstimate& estimate, const Wand& wand, const WandSettings& settings) {
    WandBlocks blocks(estimate);
    ceres::Problem problem;
    build(problem, blocks, estimate, wand, settings);
    std::vector<std::pair<const double*, const double*>> wanted{{&blocks.length_mm, &blocks.length_mm}};
    for (std::size_t i = 1; i < blocks.positions.size(); ++i) {
        wanted.emplace_back(blocks.positions[i].data(), blocks.positions[i].data());
    }
    ceres::Covariance::Options options;
    options.num_threads = 1;
    ceres::Covariance covariance(options);
    if (!covariance.Compute(wanted, &problem)) {
        return Error{"the wand's frames do not determine where the cameras are", "wand",
                     "a wand moved through the whole space and turned every way"};
    }
    WandCertainty certainty{{0.0}, 0.0};
    for (std::size_t i = 1; i < blocks.positions.size(); ++i) {
        Eigen::Matrix<double, 3, 3, Eigen::RowMajor> block;
        covariance.GetCovarianceBlock(blocks.positions[i].data(), blocks.positions[i].data(), block.data());
        certainty.position_sigma_mm.push_back(std::sqrt(block.trace()));
    }
    double variance = 0.0;
    covariance.GetCovarianceBlock(&blocks.length_mm, &blocks.length_mm, &variance);
    certainty.length_sigma_mm = std::sqrt(variance);
    return certainty;
}

}  // namespace rhexis::tracking
