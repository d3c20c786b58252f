// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/bodies/mount.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/numbers.hpp"
#include "tracking/synthetic/scene.hpp"

namespace rhexis::tracking {
namespace {

constexpr double off_bore = 0.2;  ///< of a strut's round end
constexpr double step_mm = 0.5;   ///< between places that are tried
constexpr double gathered = 0.5;  ///< what a strut may be longer for each millimetre that it begins nearer the others

/// A marker as seen from the handle.
struct Stand {
    double behind = 0.0;
    double off = 0.0;          ///< from the axis
    Vec3 out = Vec3::UnitX();  ///< unit, from the axis to it
};

Stand stand_of(const Vec3& marker, const Handle& handle) {
    Stand stand;
    const Vec3 way = marker - handle.foot;
    stand.behind = way.dot(handle.along);
    const Vec3 out = way - stand.behind * handle.along;
    stand.off = out.norm();
    stand.out = stand.off > 1e-9 ? Vec3(out / stand.off) : Vec3(handle.along.unitOrthogonal());
    return stand;
}

double distance(const Vec3& point, const Vec3& from, const Vec3& to) {
    return synthetic::nearest(point, point, from, to).distance;
}

class Planner {
public:
    Planner(const MarkerBody& body, const Handle& handle, const MountSizes& sizes)
        : body_(body), handle_(handle), sizes_(sizes) {
        double sum = 0.0;
        for (const Vec3& marker : body.markers) {
            stands_.push_back(stand_of(marker, handle));
            sum += stands_.back().behind;
        }
        low_ = std::max(handle.from_mm, sizes.hand_mm);
        high_ = std::max({handle.to_mm, sizes.least_end_mm, low_ + sizes.least_width});
        const double half = 0.5 * sizes.least_width;
        middle_ = std::clamp(sum / static_cast<double>(stands_.size()), low_ + half, high_ - half);
    }

    Result<Mount> plan() {
        Mount mount;
        mount.from_mm = middle_ - 0.5 * sizes_.least_width;
        mount.to_mm = middle_ + 0.5 * sizes_.least_width;
        // a longer sleeve is about a thicker handle, from which other places are clear
        for (int round = 0; round < 4; ++round) {
            mount.bore = greatest_radius(handle_, mount.from_mm, mount.to_mm);
            mount.bore = mount.bore > 0.0 ? mount.bore : sizes_.rod_radius;
            mount.begins.clear();
            Mount longer = mount;
            for (std::size_t i = 0; i < stands_.size(); ++i) {
                const std::optional<double> place = place_for(i, mount.bore);
                if (!place) {
                    return Error{"there is no room for a strut to marker " + std::to_string(i + 1),
                                 "body \"" + body_.name + "\"",
                                 "clear of the handle, the instrument and other spheres by " +
                                     short_number(sizes_.apart) + " mm"};
                }
                mount.begins.push_back(begin_at(i, *place, mount.bore));
                const double reach = sizes_.strut_radius + off_bore;
                longer.from_mm = std::min(longer.from_mm, *place - reach);
                longer.to_mm = std::max(longer.to_mm, *place + reach);
            }
            if (longer.from_mm == mount.from_mm && longer.to_mm == mount.to_mm) {
                break;
            }
            mount.from_mm = longer.from_mm;
            mount.to_mm = longer.to_mm;
        }
        return mount;
    }

private:
    [[nodiscard]] Vec3 begin_at(std::size_t marker, double place, double bore) const {
        return handle_.at(place) + (bore + sizes_.clearance + off_bore + sizes_.strut_radius) * stands_[marker].out;
    }

    /// Nearest to the marker and to the others' places. None is clear: none.
    [[nodiscard]] std::optional<double> place_for(std::size_t marker, double bore) const {
        const double reach = sizes_.strut_radius + off_bore;
        std::optional<double> best;
        double least = 0.0;
        for (double place = low_ + reach; place <= high_ - reach; place += step_mm) {
            const Vec3 begin = begin_at(marker, place, bore);
            const double cost = (body_.markers[marker] - begin).norm() + gathered * std::abs(place - middle_);
            if ((!best || cost < least) && clear(marker, begin, bore)) {
                best = place;
                least = cost;
            }
        }
        return best;
    }

    [[nodiscard]] bool clear(std::size_t marker, const Vec3& begin, double bore) const {
        const double around = sizes_.strut_radius + sizes_.apart;
        const double sphere = body_.radius_mm + sizes_.clearance;
        const Vec3& end = body_.markers[marker];
        const double outer = bore + sizes_.clearance + sizes_.wall;
        if (stands_[marker].off < outer + sphere + sizes_.apart) {
            return false;
        }
        for (std::size_t i = 0; i < body_.markers.size(); ++i) {
            if (i != marker && distance(body_.markers[i], begin, end) < sphere + around) {
                return false;
            }
        }
        return std::none_of(handle_.off.begin(), handle_.off.end(), [&](const RoundedCone& cone) {
            const double thick = std::max(cone.radius_a, cone.radius_b);
            return synthetic::nearest(begin, end, cone.a, cone.b).distance < thick + around;
        });
    }

    const MarkerBody& body_;
    const Handle& handle_;
    const MountSizes& sizes_;
    std::vector<Stand> stands_;
    double low_ = 0.0;
    double high_ = 0.0;
    double middle_ = 0.0;
};

Status check_sizes(const MarkerBody& body, const MountSizes& sizes) {
    const std::string where = "body \"" + body.name + "\"";
    for (const Status& status :
         {check_range("radius_mm", body.radius_mm, 0.5, 20.0, where, " mm"),
          check_range("clearance", sizes.clearance, 0.0, 1.0, where, " mm"),
          check_range("wall", sizes.wall, 1.0, 10.0, where, " mm"),
          check_range("least_width", sizes.least_width, 2.0, 50.0, where, " mm"),
          check_range("strut_radius", sizes.strut_radius, 1.2, std::min(7.0, 0.9 * body.radius_mm), where, " mm"),
          check_range("apart", sizes.apart, 0.0, 5.0, where, " mm"),
          check_range("hand_mm", sizes.hand_mm, 0.0, 200.0, where, " mm"),
          check_range("least_end_mm", sizes.least_end_mm, 0.0, 300.0, where, " mm"),
          check_range("rod_radius", sizes.rod_radius, 1.0, 10.0, where, " mm")}) {
        if (!status) {
            return status;
        }
    }
    for (const Vec3& marker : body.markers) {
        if (!marker.allFinite()) {
            return Error{"a marker is not at a finite place", where, "millimetres"};
        }
    }
    return body.markers.empty() ? Status(Error{"no markers", where, "3 to 8"}) : success();
}

}  // namespace

Result<Mount> mount_of(const MarkerBody& body, const Handle& handle, const MountSizes& sizes) {
    if (const Status status = check_sizes(body, sizes); !status) {
        return status.error();
    }
    return Planner(body, handle, sizes).plan();
}

}  // namespace rhexis::tracking
