// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/marker_body.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "tracking/bodies/triangles.hpp"

namespace rhexis::tracking {
namespace {

std::string hundredths(double mm) { return short_number(0.01 * std::round(100.0 * mm)); }

/// Markers are numbered from 1, as a person counts them.
struct MarkerDistance {
    std::size_t one;
    std::size_t other;
    double mm;
    [[nodiscard]] std::string text() const {
        return std::to_string(one + 1) + "-" + std::to_string(other + 1) + " (" + hundredths(mm) + " mm)";
    }
};

std::vector<MarkerDistance> distances_of(const std::vector<Vec3>& markers) {
    std::vector<MarkerDistance> all;
    for (std::size_t one = 0; one < markers.size(); ++one) {
        for (std::size_t other = one + 1; other < markers.size(); ++other) {
            all.push_back({one, other, (markers[one] - markers[other]).norm()});
        }
    }
    return all;
}

/// "phaco" 1-3-2 (20.1, 33 and 40.5 mm)
std::string text_of(const MarkerBody& body, const MarkerTriangle& triangle) {
    const auto& [first, second, third] = triangle.markers;
    const auto& [shortest, middle, longest] = triangle.sides_mm;
    return "\"" + body.name + "\" " + std::to_string(first + 1) + "-" + std::to_string(second + 1) + "-" +
           std::to_string(third + 1) + " (" + hundredths(shortest) + ", " + hundredths(middle) + " and " +
           hundredths(longest) + " mm)";
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

void check_distances(const MarkerBody& body, double apart_mm, Complaints& complaints) {
    const std::vector<MarkerDistance> all = distances_of(body.markers);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            const double apart = std::abs(all[i].mm - all[j].mm);
            if (apart < apart_mm) {
                complaints.add({"distances of markers " + all[i].text() + " and " + all[j].text() + " differ by " +
                                    hundredths(apart) + " mm",
                                "body \"" + body.name + "\"", "at least " + short_number(apart_mm) + " mm"});
            }
        }
    }
}

void check_pair(const MarkerBody& one, const MarkerBody& other, double least_mm, Complaints& complaints) {
    for (const MarkerTriangle& triangle : triangles_of(one.markers)) {
        for (const MarkerTriangle& of_other : triangles_of(other.markers)) {
            const double apart = apart_mm(triangle, of_other);
            if (apart < least_mm) {
                complaints.add({"markers " + text_of(one, triangle) + " and " + text_of(other, of_other) +
                                    " fit within " + hundredths(apart) + " mm",
                                "marker bodies", "some side differs by at least " + short_number(least_mm) + " mm"});
            }
        }
    }
}

}  // namespace

Status check_signatures(std::span<const MarkerBody> bodies, double apart_mm) {
    Complaints complaints;
    for (const MarkerBody& body : bodies) {
        check_shape(body, apart_mm, complaints);
        check_distances(body, apart_mm, complaints);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            check_pair(bodies[i], bodies[j], apart_mm, complaints);
        }
    }
    return complaints.status();
}

}  // namespace rhexis::tracking
