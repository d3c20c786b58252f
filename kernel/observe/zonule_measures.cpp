// SPDX-License-Identifier: GPL-3.0-or-later
// Zonules that are lost, what stands in for them, and how the bag sits without them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "observe/bag_edge.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

/// Viscoelastic over the widest gap, share of it; 1: there is no gap, or no vitreous to hold back.
double gap_cover(const ObserveInput& input, const ZonuleGap& gap) {
    if (!input.state.vitreous || !(gap.width_deg > 0.0)) {
        return 1.0;
    }
    const BagShape& shape = input.world.bags[0].shape;
    const double arc = gap.width_deg * std::numbers::pi / 180.0;
    return covered_share(*input.world.vitreous, input.state.vitreous->plug[zonule_gap],
                         arc * (shape.radius + 0.5 * zonule_length) * zonule_length);
}

Vec3 rim_at(const BagModel& model, const Pose& pose, const Vec3& direction) {
    const double share = model.opening_radius / model.shape.radius;
    return pose.to_world(model.opening_radius * direction +
                         model.shape.anterior * std::sqrt(std::max(0.0, 1.0 - share * share)) * Vec3::UnitZ());
}

double broken_since_start(const BagModel& model, const ZonuleState& state) {
    ZonuleState start;
    start.broken = model.breakable->lost;
    return lost_deg(model, state) - lost_deg(model, start);
}

class ZonuleMeasures : public MeasureGroup {
public:
    void describe(ObservationSchema& schema) const override {
        schema.push_back({"zonules.lost_deg", "deg", "All arcs without zonules; 30 degrees are a clock hour."});
        schema.push_back({"zonules.torn_deg", "deg", "Of these, what has been torn since the start."});
        schema.push_back({"zonules.gap_deg", "deg", "The widest arc without zonules."});
        schema.push_back(
            {"zonules.gap_at_deg", "deg", "Where its middle lies, against the clock from the surgeon's right."});
        schema.push_back({"zonules.rim_x_mm", "mm", "Edge of the opening before that middle, to the surgeon's right."});
        schema.push_back({"zonules.rim_y_mm", "mm", "The same, away from the surgeon."});
        schema.push_back({"zonules.rim_z_mm", "mm", "The same, towards the microscope."});
        schema.push_back({"zonules.unsupported_deg", "deg",
                          "The widest arc with neither zonule nor hook, as far as no ring bridges it."});
        schema.push_back({"zonules.hooks", "1", "Hooks that hold the edge of the opening."});
        schema.push_back({"zonules.ring", "bool", "A capsular tension ring lies in the bag."});
        schema.push_back({"zonules.ring_fed", "1", "Share of it that has been fed in."});
        schema.push_back({"bag.offset_mm", "mm", "How far the bag lies beside its place, across the axis of the eye."});
        schema.push_back({"bag.edge_seen_mm", "mm",
                          "How far the edge of the bag stands inside the pupil; negative: behind the iris."});
        schema.push_back({"tamponade.gap_cover", "1", "Share of the widest gap that viscoelastic lies over."});
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const BagModel& model = input.world.bags[0];
        const BagState& bag = input.state.bags[0];
        const ZonuleState& zonules = *bag.zonules;
        const ZonuleGap gap = widest_gap(model, zonules);
        const Vec3 rim = rim_at(model, bag.pose, gap.middle);
        std::size_t next = 0;
        for (const double value :
             {lost_deg(model, zonules), broken_since_start(model, zonules), gap.width_deg,
              std::atan2(gap.middle.y(), gap.middle.x()) * 180.0 / std::numbers::pi, rim.x(), rim.y(), rim.z(),
              unsupported_deg(model, zonules), static_cast<double>(zonules.hooks.size()),
              zonules.ring >= 1.0 ? 1.0 : 0.0, zonules.ring, bag.pose.position.head<2>().norm(), bag_edge(input).inside,
              gap_cover(input, gap)}) {
            values[next++] = value;
        }
    }
};

}  // namespace

BagEdge bag_edge(const ObserveInput& input) {
    const Pose& pose = input.state.bags[0].pose;
    const double radius = input.world.bags[0].shape.radius;
    const double pupil = input.state.iris ? input.state.iris->pupil_radius : input.eye.anatomy.pupil_radius;
    BagEdge edge{-1e9, Vec3::Zero()};
    for (const ZonuleSpring& spring : input.world.bags[0].zonules) {
        const Vec3 outward = Vec3(spring.on_ciliary.x(), spring.on_ciliary.y(), 0.0).normalized();
        const Vec3 place = pose.to_world(radius * outward);
        const double inside = pupil - place.head<2>().norm();
        if (inside > edge.inside) {
            edge = {inside, place};
        }
    }
    return edge;
}

std::unique_ptr<MeasureGroup> zonule_measures() { return std::make_unique<ZonuleMeasures>(); }

}  // namespace rhexis
