// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/spots/outline.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace rhexis::tracking {
namespace {

using Vec5 = Eigen::Matrix<double, 5, 1>;
using Mat5 = Eigen::Matrix<double, 5, 5>;

constexpr double ray_sigma_px = 0.06;  ///< of one ray's rim, at the least
constexpr double begun_px = 0.8;       ///< from the first ellipse to a rim that may be of it
constexpr int inward = 4;              ///< pixels that are searched inside the radius that is expected
constexpr int outward = 5;

/// By ray: 1, cosine, sine, and those of twice the angle.
std::array<Vec5, outline_rays> make_rays() {
    std::array<Vec5, outline_rays> rays;
    for (int i = 0; i < outline_rays; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / outline_rays;
        rays[static_cast<std::size_t>(i)] << 1.0, std::cos(angle), std::sin(angle), std::cos(2.0 * angle),
            std::sin(2.0 * angle);
    }
    return rays;
}
const std::array<Vec5, outline_rays> rays = make_rays();

/// What each ray adds to a normal matrix.
std::array<Mat5, outline_rays> make_products() {
    std::array<Mat5, outline_rays> products;
    for (std::size_t i = 0; i < products.size(); ++i) {
        products[i] = rays[i] * rays[i].transpose();
    }
    return products;
}
const std::array<Mat5, outline_rays> products = make_products();

/// Between four pixels; the place lies within them.
double light_at(const GreyImage& image, double x, double y) {
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const double right = x - left;
    const double down = y - top;
    const std::uint8_t* line = image.pixels + static_cast<std::ptrdiff_t>(top) * image.stride + left;
    const std::uint8_t* next = line + image.stride;
    return (1.0 - down) * ((1.0 - right) * line[0] + right * line[1]) +
           down * ((1.0 - right) * next[0] + right * next[1]);
}

/// Light along a ray, a pixel apart; how many of it lie in the image.
struct Profile {
    static constexpr int most = inward + outward + 1;
    std::array<double, most> light{};
    double first_px = 0.0;  ///< radius of the first
    int count = 0;
};

Profile profile_on(const GreyImage& image, const Vec2& about, const Vec5& ray, double radius) {
    Profile profile;
    profile.first_px = std::max(radius - inward, 0.0);
    for (; profile.count < Profile::most; ++profile.count) {
        const double along = profile.first_px + profile.count;
        const double x = about.x() + along * ray[1];
        const double y = about.y() + along * ray[2];
        if (!(x >= 0.0 && y >= 0.0 && x < image.width - 1 && y < image.height - 1)) {
            break;
        }
        profile.light[static_cast<std::size_t>(profile.count)] = light_at(image, x, y);
    }
    return profile;
}

/// Radius of the outermost fall of light by `step` within two pixels; below 0: there is none.
double rim_of(const Profile& profile, double step) {
    const auto at = [&profile](int i) {
        return profile.light[static_cast<std::size_t>(std::clamp(i, 0, profile.count - 1))];
    };
    int steepest = -1;
    double most = step;
    for (int i = profile.count - 2; i >= 1; --i) {
        const double fall = at(i - 1) - at(i + 1);
        if (fall >= most) {
            most = fall;
            steepest = i;
        } else if (steepest >= 0) {
            break;
        }
    }
    if (steepest < 0) {
        return -1.0;
    }
    const double half = 0.5 * (at(steepest - 2) + 0.5 * (at(steepest + 2) + at(steepest + 3)));
    for (int i = std::max(steepest - 2, 0); i <= steepest + 1 && i + 1 < profile.count; ++i) {
        if (at(i) >= half && at(i + 1) < half) {
            return profile.first_px + i + (at(i) - half) / (at(i) - at(i + 1));
        }
    }
    return -1.0;
}

using Rims = std::array<double, outline_rays>;

/// Tukey's weights about the ellipse; a ray without a rim has none.
class EllipseFit {
public:
    EllipseFit(const Rims& rims, const OutlineSettings& settings) : rims_(rims), settings_(settings) {}

    /// False: too few rays are left.
    bool run() {
        constexpr int steps = 6;
        if (!begin()) {
            return false;
        }
        for (int step = 0; step < steps; ++step) {
            const double limit = weigh(step);
            if (!solve()) {
                return false;
            }
            if (step > 1 && std::abs(limit - limit_) < 0.02) {
                break;
            }
            limit_ = limit;
        }
        return share() >= settings_.least_share;
    }

    [[nodiscard]] const Vec5& shape() const { return shape_; }
    [[nodiscard]] double share() const {
        int on = 0;
        for (const double weight : weights_) {
            on += weight > 0.25 ? 1 : 0;
        }
        return static_cast<double>(on) / outline_rays;
    }
    /// Standard deviation of a ray's rim about the ellipse.
    [[nodiscard]] double ray_sigma() const {
        double squares = 0.0;
        double weights = 0.0;
        for (std::size_t i = 0; i < rims_.size(); ++i) {
            squares += weights_[i] * off(i) * off(i);
            weights += weights_[i];
        }
        return std::max(ray_sigma_px, std::sqrt(squares / std::max(weights - 5.0, 1.0)));
    }
    [[nodiscard]] double centre_spread() const {
        const Mat5 inverse = factor_.solve(Mat5::Identity());
        return 0.5 * (inverse(1, 1) + inverse(2, 2));
    }

private:
    [[nodiscard]] double off(std::size_t ray) const {
        return rims_[ray] < 0.0 ? 0.0 : rims_[ray] - shape_.dot(rays[ray]);
    }

    /// The circle through three rims, of some, that most rims lie near.
    bool begin() {
        constexpr double near_px = 0.6;
        constexpr double nearly_all = 0.9;
        constexpr int starts = 16;
        int most = 0;
        for (int start = 0; start < starts; ++start) {
            Mat3 slopes;
            Vec3 values;
            bool all = true;
            for (int corner = 0; corner < 3; ++corner) {
                // arcs of 75 degrees and more between them, so that a hidden third leaves some triples whole
                const int ray = (start * 4 + corner * (start % 2 == 0 ? 21 : 14)) % outline_rays;
                slopes.row(corner) = rays[static_cast<std::size_t>(ray)].head<3>();
                values[corner] = rims_[static_cast<std::size_t>(ray)];
                all = all && values[corner] >= 0.0;
            }
            if (!all) {
                continue;
            }
            const Vec3 circle = slopes.inverse() * values;
            int on = 0;
            for (std::size_t i = 0; i < rims_.size(); ++i) {
                on += rims_[i] >= 0.0 && std::abs(rims_[i] - circle.dot(rays[i].head<3>())) < near_px ? 1 : 0;
            }
            if (on > most) {
                most = on;
                shape_ << circle, 0.0, 0.0;
            }
            if (most > nearly_all * outline_rays) {
                return true;
            }
        }
        return most >= settings_.least_share * outline_rays;
    }

    double weigh(int step) {
        constexpr double sigmas = 3.5;
        const double limit = step == 0 ? begun_px : std::clamp(sigmas * ray_sigma(), sigmas * ray_sigma_px, begun_px);
        for (std::size_t i = 0; i < rims_.size(); ++i) {
            const double ratio = off(i) / limit;
            const double left = 1.0 - ratio * ratio;
            weights_[i] = rims_[i] >= 0.0 && left > 0.0 ? left * left : 0.0;
        }
        return limit;
    }

    bool solve() {
        Mat5 normal = Mat5::Zero();
        Vec5 slope = Vec5::Zero();
        for (std::size_t i = 0; i < rims_.size(); ++i) {
            if (weights_[i] > 0.0) {
                normal += weights_[i] * products[i];
                slope += weights_[i] * rims_[i] * rays[i];
            }
        }
        const double prior = ray_sigma_px / settings_.stretch_px;
        normal(3, 3) += prior * prior;
        normal(4, 4) += prior * prior;
        factor_.compute(normal);
        if (factor_.info() != Eigen::Success || factor_.vectorD().minCoeff() < 1e-3) {
            return false;
        }
        shape_ = factor_.solve(slope);
        return true;
    }

    const Rims& rims_;
    const OutlineSettings& settings_;
    Rims weights_{};
    Vec5 shape_ = Vec5::Zero();
    double limit_ = 0.0;
    Eigen::LDLT<Mat5> factor_{};
};

Rims rims_about(const GreyImage& image, const Vec2& about, double radius, double step) {
    Rims rims{};
    for (std::size_t i = 0; i < rims.size(); ++i) {
        const Profile profile = profile_on(image, about, rays[i], radius);
        rims[i] = profile.count > inward + 3 ? rim_of(profile, step) : -1.0;
    }
    return rims;
}

}  // namespace

std::optional<FittedOutline> fit_outline(const GreyImage& image, const Vec2& about, double radius, double bright,
                                         const OutlineSettings& settings) {
    constexpr double least_radius = 2.5;
    constexpr double settled_px = 0.2;
    constexpr int passes = 3;
    const double step = std::max(settings.least_step, settings.least_step_share * bright);
    FittedOutline outline{about, radius, 0.0, 0.0, 0.0};
    for (int pass = 0; pass < passes; ++pass) {
        if (outline.radius < least_radius) {
            return std::nullopt;
        }
        const Rims rims = rims_about(image, outline.centre, outline.radius, step);
        EllipseFit fit(rims, settings);
        if (!fit.run()) {
            return std::nullopt;
        }
        const Vec2 moved = fit.shape().segment<2>(1);
        outline.centre += moved;
        outline.radius = fit.shape()[0];
        outline.stretch = fit.shape().tail<2>().norm();
        outline.share = fit.share();
        // On a small rim neighbouring rays read the same pixels.
        const double independent = std::min(1.0, 2.0 * std::numbers::pi * outline.radius / outline_rays);
        outline.sigma_px = fit.ray_sigma() * std::sqrt(fit.centre_spread() / independent);
        if (moved.norm() < settled_px) {
            break;
        }
    }
    return outline;
}

}  // namespace rhexis::tracking
