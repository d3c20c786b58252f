// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/bodies/rigid_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracking/lens_model.hpp"

namespace rhexis::tracking {
namespace {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat26 = Eigen::Matrix<double, 2, 6>;
using Mat23 = Eigen::Matrix<double, 2, 3>;

Quat turn_of(const Vec3& rotation) {
    const double angle = rotation.norm();
    return angle < 1e-12 ? Quat(1.0, 0.5 * rotation.x(), 0.5 * rotation.y(), 0.5 * rotation.z()).normalized()
                         : Quat(Eigen::AngleAxisd(angle, rotation / angle));
}

/// How far a sighting is from where the pose has it, and how that changes with shift and turn.
struct Off {
    Vec2 off;
    Mat26 slope;
};
std::optional<Off> off_of(const Camera& camera, const MarkerBody& body, const Sighting& sighting, const Pose& pose,
                          const Motion& motion) {
    const Pose then = moved(pose, motion, sighting.later_s);
    const Vec3 arm = then.orientation * body.markers[static_cast<std::size_t>(sighting.marker)];
    const Vec3 seen = camera.pose.to_body(arm + then.position);
    if (seen.z() <= 2.0 * body.radius_mm) {
        return std::nullopt;
    }
    const Mat23 by_point = projection_slope(camera.lens, seen) * camera.pose.orientation.conjugate().toRotationMatrix();
    Mat3 cross;
    cross << 0.0, arm.z(), -arm.y(), -arm.z(), 0.0, arm.x(), arm.y(), -arm.x(), 0.0;
    Off result;
    result.off = sighting.at - sphere_image(camera.lens, seen, body.radius_mm);
    result.slope << by_point, by_point * cross;
    return result;
}

/// [Beaton1974]: 1 in the middle, 0 from `limit` on.
double tukey(double ratio) {
    const double left = 1.0 - ratio * ratio;
    return left > 0.0 ? left * left : 0.0;
}

struct Normal {
    Mat6 matrix = Mat6::Zero();
    Vec6 slope = Vec6::Zero();
};

class Fitter {
public:
    Fitter(std::span<const Camera> cameras, const MarkerBody& body, std::span<const Sighting> sightings,
           const Motion& motion, const FitSettings& settings)
        : cameras_(cameras), body_(body), sightings_(sightings), motion_(motion), settings_(settings) {
        fit_.weights.assign(sightings.size(), 1.0);
        fit_.offs.assign(sightings.size(), Vec2::Zero());
        sigmas_off_.assign(sightings.size(), 0.0);
    }

    std::optional<Fit> run(const Pose& begun) {
        fit_.pose = begun;
        for (int step = 0; step < settings_.most_steps; ++step) {
            const std::optional<Normal> normal = linearise();
            if (!normal) {
                return std::nullopt;
            }
            const Eigen::LDLT<Mat6> factor(normal->matrix);
            if (factor.info() != Eigen::Success || factor.vectorD().minCoeff() <= 1e-9 * factor.vectorD().maxCoeff()) {
                return std::nullopt;
            }
            const Vec6 by = factor.solve(normal->slope);
            fit_.pose.position += by.head<3>();
            fit_.pose.orientation = (turn_of(by.tail<3>()) * fit_.pose.orientation).normalized();
            fit_.covariance = factor.solve(Mat6::Identity());
            const bool still = by.head<3>().norm() < 1e-6 && by.tail<3>().norm() < 1e-8;
            weigh(step);
            if (still && step > 2) {
                break;
            }
        }
        return count() ? std::optional<Fit>(std::move(fit_)) : std::nullopt;
    }

private:
    [[nodiscard]] const Camera& camera_of(const Sighting& sighting) const {
        return cameras_[static_cast<std::size_t>(sighting.camera)];
    }

    std::optional<Normal> linearise() {
        Normal normal;
        for (std::size_t i = 0; i < sightings_.size(); ++i) {
            const std::optional<Off> off = off_of(camera_of(sightings_[i]), body_, sightings_[i], fit_.pose, motion_);
            if (!off) {
                return std::nullopt;
            }
            const double sigma = std::hypot(sightings_[i].sigma_px, settings_.floor_px);
            sigmas_off_[i] = off->off.norm() / sigma;
            fit_.offs[i] = off->off;
            const double weight = fit_.weights[i] / (sigma * sigma);
            normal.matrix += weight * off->slope.transpose() * off->slope;
            normal.slope += weight * off->slope.transpose() * off->off;
        }
        return normal;
    }

    /// Wide at first, so that a pose that is begun a little off does not lose what is right.
    void weigh(int step) {
        linearise();
        std::vector<double> sorted = sigmas_off_;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        const double narrow = settings_.outlier_sigmas;
        const double limit = std::max(narrow, *middle * narrow / (step < 2 ? 0.5 : 1.2));
        for (std::size_t i = 0; i < sightings_.size(); ++i) {
            fit_.weights[i] = tukey(sigmas_off_[i] / limit);
        }
    }

    /// What the pose stands on; false: on too little.
    bool count() {
        constexpr double counts = 0.1;
        std::vector<bool> markers(body_.markers.size(), false);
        std::vector<bool> cameras(cameras_.size(), false);
        double squares = 0.0;
        double weights = 0.0;
        for (std::size_t i = 0; i < sightings_.size(); ++i) {
            if (fit_.weights[i] < counts) {
                continue;
            }
            const double sigma = std::hypot(sightings_[i].sigma_px, settings_.floor_px);
            squares += fit_.weights[i] * sigmas_off_[i] * sigmas_off_[i] * sigma * sigma;
            weights += fit_.weights[i];
            ++fit_.counted;
            markers[static_cast<std::size_t>(sightings_[i].marker)] = true;
            cameras[static_cast<std::size_t>(sightings_[i].camera)] = true;
        }
        fit_.markers = static_cast<int>(std::count(markers.begin(), markers.end(), true));
        fit_.cameras = static_cast<int>(std::count(cameras.begin(), cameras.end(), true));
        fit_.residual_px = weights > 0.0 ? std::sqrt(squares / weights) : 0.0;
        return fit_.markers >= 3 && fit_.counted >= 4;
    }

    std::span<const Camera> cameras_;
    const MarkerBody& body_;
    std::span<const Sighting> sightings_;
    const Motion& motion_;
    const FitSettings& settings_;
    std::vector<double> sigmas_off_{};
    Fit fit_{};
};

}  // namespace

Pose moved(const Pose& pose, const Motion& motion, double ahead_s) {
    return {pose.position + ahead_s * motion.velocity,
            (turn_of(ahead_s * motion.turning) * pose.orientation).normalized()};
}

Vec2 sphere_image(const Lens& lens, const Vec3& in_camera, double radius_mm) {
    return distorted(lens, sphere_direction(in_camera, radius_mm));
}

double sphere_area(const Lens& lens, const Vec3& in_camera, double radius_mm) {
    // The disc across the line of sight, small against its distance.
    const Vec3 along = in_camera.normalized();
    const Vec3 right = along.unitOrthogonal();
    const Vec3 down = along.cross(right);
    const Mat23 slope = projection_slope(lens, in_camera);
    Mat2 disc;
    disc << slope * right, slope * down;
    return std::numbers::pi * radius_mm * radius_mm * std::abs(disc.determinant());
}

std::optional<Fit> fit_body(std::span<const Camera> cameras, const MarkerBody& body,
                            std::span<const Sighting> sightings, const Pose& begun, const Motion& motion,
                            const FitSettings& settings) {
    if (sightings.size() < 4) {
        return std::nullopt;
    }
    return Fitter(cameras, body, sightings, motion, settings).run(begun);
}

}  // namespace rhexis::tracking
