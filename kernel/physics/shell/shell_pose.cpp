// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_pose.hpp"

#include "base/index.hpp"
#include "math/rotation.hpp"

namespace rhexis {
namespace {

/// Without the columns of freedoms that are held.
Mat3 of_free(const Mat3& share, std::span<const std::uint8_t> free) {
    Mat3 result = share;
    for (int i = 0; i < 3; ++i) {
        if (free[rhexis::at(i)] == 0) {
            result.col(i).setZero();
        }
    }
    return result;
}

}  // namespace

void ShellPose::set(std::span<const Quat> reference, const std::vector<Vec3>& points) {
    const std::size_t nodes = reference.size();
    position_.resize(nodes);
    rotation_.resize(nodes);
    turn_.resize(nodes);
    rate_.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
        position_[n] = points[2 * n];
        turn_[n] = cayley(points[2 * n + 1]);
        rotation_[n] = turn_[n] * reference[n].toRotationMatrix();
        rate_[n] = spin_of_turn(points[2 * n + 1]);
    }
}

Vec3 ShellPose::at(const ShellPlace& place) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        if (place.nodes[k] >= 0) {
            const std::size_t n = rhexis::at(place.nodes[k]);
            sum += place.weights[k] * position_[n] + rotation_[n] * place.arms[k];
        }
    }
    return sum;
}

Vec3 ShellPose::turned(const ShellPlace& place, const Vec3& arm) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        if (place.nodes[k] >= 0) {
            sum += place.blend[k] * (turn_[rhexis::at(place.nodes[k])] * arm);
        }
    }
    return sum;
}

void ShellPose::add_shares(const ShellPlace& place, const Vec3& arm, bool turned, double scale,
                           std::span<const std::uint8_t> free, std::vector<ContactShare>& shares) const {
    for (std::size_t k = 0; k < 3; ++k) {
        if (place.nodes[k] < 0) {
            continue;
        }
        const std::size_t n = rhexis::at(place.nodes[k]);
        shares.push_back(
            {2 * place.nodes[k], of_free(scale * place.weights[k] * Mat3::Identity(), free.subspan(6 * n, 3))});
        const Vec3 now = turned ? Vec3(turn_[n] * arm) : arm;
        const Vec3 lever = rotation_[n] * place.arms[k] + place.blend[k] * now;
        shares.push_back(
            {2 * place.nodes[k] + 1, of_free(-scale * cross_matrix(lever) * rate_[n], free.subspan(6 * n + 3, 3))});
    }
}

}  // namespace rhexis
