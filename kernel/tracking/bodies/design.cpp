// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/bodies/design.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/numbers.hpp"
#include "base/rng.hpp"
#include "tracking/bodies/triangles.hpp"

namespace rhexis::tracking {
namespace {

constexpr std::size_t spheres = 4;
constexpr double between_spheres = 14.0;  ///< centres: cameras see them apart
constexpr double rounding_mm = 0.05;      ///< of distances between places to a hundredth of a millimetre
constexpr double out_of_plane_mm = 5.0;   ///< a body is not to be taken for its mirror image

/// The instrument's frame in that of the body.
Pose frame_of(const DesignPlan& plan, double behind_mm) {
    const Vec3& along = plan.handle.along;
    const Vec3 aside = std::abs(along.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    Mat3 turned;
    turned.row(2) = along;
    turned.row(0) = (aside - aside.dot(along) * along).normalized();
    turned.row(1) = turned.row(2).cross(turned.row(0));
    return {-turned * plan.handle.at(behind_mm), Quat(turned)};
}

double shortfall(double value, double least) { return std::max(0.0, least - value); }

/// The least distance of a corner of the four from the plane of the others.
double height_of(const std::vector<Vec3>& markers) {
    double least = 1e9;
    for (std::size_t i = 0; i < spheres; ++i) {
        const Vec3& a = markers[(i + 1) % spheres];
        const Vec3 normal = (markers[(i + 2) % spheres] - a).cross(markers[(i + 3) % spheres] - a).normalized();
        least = std::min(least, std::abs(normal.dot(markers[i] - a)));
    }
    return least;
}

void append_distances(const std::vector<Vec3>& markers, std::vector<double>& distances) {
    for (std::size_t i = 0; i < markers.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            distances.push_back((markers[i] - markers[j]).norm());
        }
    }
}

/// By how much distances are too near to others, all told.
double too_near(const std::vector<double>& distances, const std::vector<double>& others, double apart_mm) {
    double sum = 0.0;
    for (const double one : distances) {
        for (const double other : others) {
            sum += shortfall(std::abs(one - other), apart_mm);
        }
    }
    return sum;
}

/// How far four places are from what is asked for, and how good they are.
class Costs {
public:
    Costs(const DesignPlan& plan, double behind_mm, const OtherBodies& others) : plan_(plan), behind_mm_(behind_mm) {
        for (const std::vector<MarkerBody>* bodies : {&others.unlike, &others.beside}) {
            for (const MarkerBody& other : *bodies) {
                const std::vector<MarkerTriangle> of_it = triangles_of(other.markers);
                triangles_.insert(triangles_.end(), of_it.begin(), of_it.end());
            }
        }
        for (const MarkerBody& other : others.beside) {
            append_distances(other.markers, distances_);
        }
    }

    [[nodiscard]] double of(const MarkerBody& body) const {
        constexpr double weight = 20.0;  // a millimetre short is worse than any error of the tip
        return tip_error_share(body) + weight * (places(body) + signature(body.markers));
    }

private:
    [[nodiscard]] double places(const MarkerBody& body) const {
        double sum = 0.0;
        for (const Vec3& marker : body.markers) {
            const double off = marker.head<2>().norm();
            const double behind = behind_mm_ + marker.z();
            const double thick = greatest_radius(plan_.handle, behind - body.radius_mm, behind + body.radius_mm);
            const double least = std::max(thick + plan_.off_mm, sleeve_radius() + 2.0 * plan_.mount.apart);
            sum += shortfall(off, least + body.radius_mm) + shortfall(plan_.reach_mm, off) +
                   shortfall(plan_.reach_mm, std::abs(marker.z()));
        }
        for (std::size_t i = 0; i < spheres; ++i) {
            for (std::size_t j = 0; j < spheres; ++j) {
                if (i != j) {
                    sum += shortfall((body.markers[i] - body.markers[j]).norm(), between_spheres) +
                           shortfall(off_strut(body.markers[i], body.markers[j]), strut_room(body));
                }
            }
        }
        return sum;
    }

    [[nodiscard]] double sleeve_radius() const {
        return greatest_radius(plan_.handle, behind_mm_ - 5.0, behind_mm_ + 5.0) + plan_.mount.clearance +
               plan_.mount.wall;
    }
    [[nodiscard]] double strut_room(const MarkerBody& body) const {
        return body.radius_mm + plan_.mount.clearance + plan_.mount.strut_radius + plan_.mount.apart;
    }
    /// From a strut that goes out straight from the axis.
    [[nodiscard]] static double off_strut(const Vec3& marker, const Vec3& other) {
        const Vec3 out(other.x(), other.y(), 0.0);
        const double share = std::clamp(marker.dot(out) / std::max(out.squaredNorm(), 1e-9), 0.0, 1.0);
        return (marker - Vec3(0.0, 0.0, other.z()) - share * out).norm();
    }

    [[nodiscard]] double signature(const std::vector<Vec3>& markers) const {
        double sum = shortfall(height_of(markers), out_of_plane_mm);
        std::vector<double> distances;
        append_distances(markers, distances);
        sum += too_near(distances, distances_, plan_.apart_mm);
        std::sort(distances.begin(), distances.end());
        for (std::size_t i = 1; i < distances.size(); ++i) {
            sum += shortfall(distances[i] - distances[i - 1], plan_.apart_mm);
        }
        for (const MarkerTriangle& triangle : triangles_of(markers)) {
            for (const MarkerTriangle& other : triangles_) {
                sum += shortfall(apart_mm(triangle, other), plan_.apart_mm);
            }
        }
        return sum;
    }

    const DesignPlan& plan_;
    double behind_mm_;
    std::vector<MarkerTriangle> triangles_;
    std::vector<double> distances_;
};

void draw_places(const DesignPlan& plan, Rng& rng, MarkerBody& body) {
    body.markers.clear();
    for (std::size_t i = 0; i < spheres; ++i) {
        const double around = 2.0 * std::numbers::pi * rng.uniform();
        const double off = plan.reach_mm * (0.6 + 0.4 * rng.uniform());
        body.markers.emplace_back(off * std::cos(around), off * std::sin(around),
                                  plan.reach_mm * (2.0 * rng.uniform() - 1.0));
    }
}

/// From 8 mm and a cost of 3 down to a thousandth of both.
void anneal(const DesignPlan& plan, const Costs& costs, Rng& rng, MarkerBody& body) {
    double cost = costs.of(body);
    MarkerBody best = body;
    double least = cost;
    for (int move = 0; move < plan.moves; ++move) {
        const double cool = std::pow(1e-3, static_cast<double>(move) / plan.moves);
        const auto which = static_cast<std::size_t>(rng.integer(0, spheres - 1));
        const Vec3 before = body.markers[which];
        for (int i = 0; i < 3; ++i) {
            body.markers[which][i] += 8.0 * cool * rng.normal();
        }
        const double now = costs.of(body);
        if (now <= cost || rng.uniform() < std::exp((cost - now) / (3.0 * cool))) {
            cost = now;
        } else {
            body.markers[which] = before;
        }
        if (cost < least) {
            least = cost;
            best = body;
        }
    }
    body = best;
    for (Vec3& marker : body.markers) {
        marker = (100.0 * marker).array().round() / 100.0;  // as a person reads and writes them
    }
}

/// What is in the way of a body, if anything is.
Status check_design(const MarkerBody& body, const Handle& handle, const DesignPlan& plan, const OtherBodies& others) {
    std::vector<MarkerBody> all = others.unlike;
    all.insert(all.end(), others.beside.begin(), others.beside.end());
    all.push_back(body);
    if (Status alike = check_signatures(all); !alike) {
        return alike;
    }
    std::vector<double> distances;
    std::vector<double> beside;
    append_distances(body.markers, distances);
    for (const MarkerBody& other : others.beside) {
        append_distances(other.markers, beside);
    }
    if (too_near(distances, beside, plan.apart_mm - rounding_mm) > 0.0) {
        return Error{"no distances were found that none beside it has", "design of \"" + plan.name + "\"",
                     "fewer bodies beside it, a greater reach, or a smaller difference"};
    }
    const Result<Mount> mount = mount_of(body, handle, plan.mount);
    return mount ? success() : Status(mount.error());
}

Status check_plan(const DesignPlan& plan) {
    const std::string where = "design of \"" + plan.name + "\"";
    for (const Status& status : {check_range("behind_mm", plan.behind_mm, 30.0, 200.0, where, " mm"),
                                 check_range("reach_mm", plan.reach_mm, 18.0, 60.0, where, " mm"),
                                 check_range("off_mm", plan.off_mm, 2.0, 15.0, where, " mm"),
                                 check_range("apart_mm", plan.apart_mm, 0.5, 5.0, where, " mm"),
                                 check_range("moves", static_cast<double>(plan.moves), 1e3, 1e7, where)}) {
        if (!status) {
            return status;
        }
    }
    return success();
}

}  // namespace

double tip_error_share(const MarkerBody& body) {
    const auto count = static_cast<double>(body.markers.size());
    Vec3 middle = Vec3::Zero();
    for (const Vec3& marker : body.markers) {
        middle += marker / count;
    }
    Mat3 spread = Mat3::Zero();
    for (const Vec3& marker : body.markers) {
        spread += (marker - middle) * (marker - middle).transpose() / count;
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
    const Vec3 tip = axes.eigenvectors().transpose() * (body.tip.position - middle);
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double tip_off = tip.squaredNorm() - tip[i] * tip[i];
        const double markers_off = axes.eigenvalues().sum() - axes.eigenvalues()[i];
        sum += tip_off / std::max(markers_off, 1e-9);
    }
    return std::sqrt((1.0 + sum / 3.0) / count);
}

Result<MarkerBody> design_body(const DesignPlan& plan, const OtherBodies& others) {
    constexpr int attempts = 12;
    if (const Status status = check_plan(plan); !status) {
        return status.error();
    }
    const double end_mm = std::max(plan.handle.to_mm, plan.mount.least_end_mm);
    const double behind_mm = std::min(plan.behind_mm, end_mm - 0.5 * plan.mount.least_width);
    MarkerBody body;
    body.name = plan.name;
    body.tip = frame_of(plan, behind_mm);
    const Handle handle = moved_to(body.tip, plan.handle);
    const Costs costs(plan, behind_mm, others);
    Status wrong = success();
    std::optional<MarkerBody> best;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        Rng rng(plan.seed, "spheres of " + plan.name + " " + std::to_string(attempt));
        draw_places(plan, rng, body);
        anneal(plan, costs, rng, body);
        const Status found = check_design(body, handle, plan, others);
        if (!found) {
            wrong = found;
        } else if (!best || tip_error_share(body) < tip_error_share(*best)) {
            best = body;
        }
    }
    return best ? Result<MarkerBody>(*best) : Result<MarkerBody>(wrong.error());
}

}  // namespace rhexis::tracking
