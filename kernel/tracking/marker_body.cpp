// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/marker_body.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"

namespace rhexis::tracking {
namespace {

struct MarkerDistance {
    std::size_t body;
    std::size_t one;
    std::size_t other;
    double mm;
};

std::vector<MarkerDistance> distances_of(std::span<const MarkerBody> bodies) {
    std::vector<MarkerDistance> all;
    for (std::size_t body = 0; body < bodies.size(); ++body) {
        const std::vector<Vec3>& markers = bodies[body].markers;
        for (std::size_t one = 0; one < markers.size(); ++one) {
            for (std::size_t other = one + 1; other < markers.size(); ++other) {
                all.push_back({body, one, other, (markers[one] - markers[other]).norm()});
            }
        }
    }
    return all;
}

std::string hundredths(double mm) { return short_number(0.01 * std::round(100.0 * mm)); }

/// Markers are numbered from 1, as a person counts them.
std::string text_of(std::span<const MarkerBody> bodies, const MarkerDistance& distance) {
    return "\"" + bodies[distance.body].name + "\" " + std::to_string(distance.one + 1) + "-" +
           std::to_string(distance.other + 1) + " (" + hundredths(distance.mm) + " mm)";
}

/// How far the marker farthest from the plane that lies best in them is from it [mm].
double out_of_plane(const std::vector<Vec3>& markers) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& marker : markers) {
        middle += marker / static_cast<double>(markers.size());
    }
    Mat3 spread = Mat3::Zero();
    for (const Vec3& marker : markers) {
        spread += (marker - middle) * (marker - middle).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
    const Vec3 normal = axes.eigenvectors().col(0);
    double farthest = 0.0;
    for (const Vec3& marker : markers) {
        farthest = std::max(farthest, std::abs(normal.dot(marker - middle)));
    }
    return farthest;
}

/// All that is wrong: the first as the error, others as more of it.
class Complaints {
public:
    void add(Error error) {
        if (first_.what.empty()) {
            first_ = std::move(error);
        } else {
            first_.more.push_back(error.text());
        }
    }
    [[nodiscard]] Status status() const { return first_.what.empty() ? success() : Status(first_); }

private:
    Error first_{};
};

void check_shape(const MarkerBody& body, double apart_mm, Complaints& complaints) {
    const std::string where = "body \"" + body.name + "\"";
    if (body.markers.size() < 3 || body.markers.size() > 8) {
        complaints.add({std::to_string(body.markers.size()) + " markers", where, "3 to 8"});
        return;
    }
    for (std::size_t i = 0; i < body.markers.size(); ++i) {
        if (!body.markers[i].allFinite()) {
            complaints.add({"marker " + std::to_string(i + 1) + " is not at a finite place", where, "millimetres"});
            return;
        }
    }
    const double off = out_of_plane(body.markers);
    if (body.markers.size() == 4 && off < apart_mm) {
        complaints.add({"its 4 markers lie within " + hundredths(off) + " mm of a plane", where,
                        "one is at least " + short_number(apart_mm) + " mm off the plane of best fit"});
    }
}

}  // namespace

Status check_signatures(std::span<const MarkerBody> bodies, double apart_mm) {
    Complaints complaints;
    for (const MarkerBody& body : bodies) {
        check_shape(body, apart_mm, complaints);
    }
    const std::vector<MarkerDistance> all = distances_of(bodies);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            const double apart = std::abs(all[i].mm - all[j].mm);
            if (apart < apart_mm) {
                complaints.add({"distances of markers " + text_of(bodies, all[i]) + " and " + text_of(bodies, all[j]) +
                                    " differ by " + hundredths(apart) + " mm",
                                "marker bodies", "at least " + short_number(apart_mm) + " mm"});
            }
        }
    }
    return complaints.status();
}

}  // namespace rhexis::tracking
