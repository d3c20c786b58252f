// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/bodies/identity.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace rhexis::tracking {
namespace {

constexpr int fewest_found = 3;

/// Gives markers to points one after the other, and keeps the best of all ways to do so.
class Search {
public:
    Search(const MarkerBody& body, std::span<const Vec3> points, const std::vector<bool>& taken, double tolerance_mm)
        : body_(body), points_(points), used_(taken), given_(body.markers.size(), -1), tolerance_mm_(tolerance_mm) {}

    std::optional<Identified> run() {
        give(0, 0);
        return best_;
    }

private:
    void give(std::size_t marker, int found) {
        const std::size_t all = body_.markers.size();
        const int at_most = found + static_cast<int>(all - marker);
        if (at_most < fewest_found || (best_ && at_most < best_->markers)) {
            return;
        }
        if (marker == all) {
            keep(found);
            return;
        }
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!used_[i] && fits(marker, i)) {
                used_[i] = true;
                given_[marker] = static_cast<int>(i);
                give(marker + 1, found + 1);
                given_[marker] = -1;
                used_[i] = false;
            }
        }
        give(marker + 1, found);
    }

    [[nodiscard]] bool fits(std::size_t marker, std::size_t point) const {
        for (std::size_t other = 0; other < marker; ++other) {
            if (given_[other] < 0) {
                continue;
            }
            const double wanted = (body_.markers[marker] - body_.markers[other]).norm();
            const double is = (points_[point] - points_[static_cast<std::size_t>(given_[other])]).norm();
            if (std::abs(wanted - is) > tolerance_mm_) {
                return false;
            }
        }
        return true;
    }

    void keep(int found) {
        std::vector<Vec3> markers;
        std::vector<Vec3> points;
        for (std::size_t i = 0; i < given_.size(); ++i) {
            if (given_[i] >= 0) {
                markers.push_back(body_.markers[i]);
                points.push_back(points_[static_cast<std::size_t>(given_[i])]);
            }
        }
        Identified now{given_, fitted(markers, points), found, 0.0};
        for (std::size_t i = 0; i < markers.size(); ++i) {
            now.worst_mm = std::max(now.worst_mm, (now.pose.to_world(markers[i]) - points[i]).norm());
        }
        if (now.worst_mm <= tolerance_mm_ &&
            (!best_ || now.markers > best_->markers || now.worst_mm < best_->worst_mm)) {
            best_ = std::move(now);
        }
    }

    const MarkerBody& body_;
    std::span<const Vec3> points_;
    std::vector<bool> used_;
    std::vector<int> given_;
    double tolerance_mm_;
    std::optional<Identified> best_{};
};

}  // namespace

Pose fitted(std::span<const Vec3> markers, std::span<const Vec3> points) {
    Vec3 markers_mean = Vec3::Zero();
    Vec3 points_mean = Vec3::Zero();
    for (std::size_t i = 0; i < markers.size(); ++i) {
        markers_mean += markers[i];
        points_mean += points[i];
    }
    markers_mean /= static_cast<double>(markers.size());
    points_mean /= static_cast<double>(markers.size());
    Mat3 both = Mat3::Zero();
    for (std::size_t i = 0; i < markers.size(); ++i) {
        both += (points[i] - points_mean) * (markers[i] - markers_mean).transpose();
    }
    const Eigen::JacobiSVD<Mat3> svd(both, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Vec3 signs = Vec3::Ones();
    signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    const Mat3 turned = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    return {points_mean - turned * markers_mean, Quat(turned).normalized()};
}

std::optional<Identified> identify(const MarkerBody& body, std::span<const Vec3> points, const std::vector<bool>& taken,
                                   double tolerance_mm) {
    return Search(body, points, taken, tolerance_mm).run();
}

}  // namespace rhexis::tracking
