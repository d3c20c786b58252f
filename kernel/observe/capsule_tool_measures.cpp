// SPDX-License-Identifier: GPL-3.0-or-later
// What an instrument does to the anterior capsule.
#include <cmath>
#include <limits>

#include "base/index.hpp"
#include "energy/membrane_triangle.hpp"
#include "energy/metric_strain.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

/// Height of a place over the front of the lens, straight along the axis; undefined beside the lens [mm].
double height_over(const SupportModel& lens, double lift, const Vec3& place) {
    const double share = place.head<2>().norm() / lens.shape.radius;
    return share < 1.0 ? place.z() - lift - lens.shape.anterior * std::sqrt(1.0 - share * share)
                       : std::numeric_limits<double>::quiet_NaN();
}

constexpr double around_needle = 1.5;  ///< where wrinkles are looked for [mm]

TrianglePoints points_of(const std::vector<Vec3>& nodes, const std::array<int, 3>& triangle) {
    return {nodes[at(triangle[0])], nodes[at(triangle[1])], nodes[at(triangle[2])]};
}

/// Whether a sheet of this strain is drawn out one way and wrinkles across it: a taut one would be compressed there.
bool wrinkled(const Vec3& strain, double poisson_ratio) {
    const double mean = 0.5 * (strain[0] + strain[1]);
    const double half = 0.5 * (strain[0] - strain[1]);
    const double radius = std::sqrt(half * half + 0.25 * strain[2] * strain[2]);
    const double most = mean + radius;
    return most > 0.0 && mean - radius + poisson_ratio * most < 0.0;
}

/// Share of the sheet around a place that is wrinkled.
double wrinkled_share(const MembraneModel& model, const MembraneState& state, const Vec3& place) {
    double all = 0.0;
    double creased = 0.0;
    for (const std::array<int, 3>& triangle : state.sheet->mesh.triangles) {
        const TrianglePoints now = points_of(state.position, triangle);
        if (((now[0] + now[1] + now[2]) / 3.0 - place).head<2>().squaredNorm() > around_needle * around_needle) {
            continue;
        }
        const TrianglePoints rest = points_of(state.sheet->mesh.nodes, triangle);
        const double area = (rest[1] - rest[0]).cross(rest[2] - rest[0]).norm();
        MembraneTriangle shape;
        shape.gradient = shape_gradients(rest, plane_frame(rest));
        MetricStrain strain;
        metric_strain(metric_of(shape, now), strain);
        all += area;
        creased += wrinkled(strain.strain, model.material.poisson_ratio) ? area : 0.0;
    }
    return all > 0.0 ? creased / all : 0.0;
}

class CapsuleToolMeasures : public MeasureGroup {
public:
    CapsuleToolMeasures(const ToolModel& model, int tool, int membrane)
        : model_(model), tool_(tool), membrane_(membrane) {}

    void describe(ObservationSchema& schema) const override {
        const std::string group = model_.name + ".";
        schema.push_back({group + "tip_depth_mm", "mm", "Tip below the front of the lens."});
        schema.push_back({group + "in_contact", "bool", "The instrument touches or holds the anterior capsule."});
        schema.push_back({group + "force_mN", "mN", "Force of the instrument on the anterior capsule."});
        if (model_.kind == ToolKind::forceps) {
            schema.push_back({group + "jaw", "1", "Opening of the jaws, 0 closed to 1 open."});
            schema.push_back({group + "holding", "bool", "The jaws hold the capsule."});
        }
        if (model_.kind == ToolKind::cystotome) {
            schema.push_back({group + "wrinkled_share", "1",
                              "Share of the capsule within 1.5 mm of the needle that is in wrinkles. Nothing where it "
                              "does not touch."});
        }
        if (model_.kind == ToolKind::cannula) {
            schema.push_back({group + "press", "1", "How hard the hand presses the syringe, 0 to 1."});
        }
    }

    void measure(const ObserveInput& input, const LensView&, std::span<double>,
                 std::span<double> values) const override {
        const ToolState& tool = input.tools[at(tool_)];
        const MembraneState& state = input.state.membranes[at(membrane_)];
        const std::optional<SupportModel>& lens = input.world.membranes[at(membrane_)].support;
        values[0] = tool.present && lens ? -height_over(*lens, state.support.lift, tool.pose.position)
                                         : std::numeric_limits<double>::quiet_NaN();
        Vec3 force = Vec3::Zero();
        for (const Contact& contact : input.contacts) {
            if (contact.membrane == membrane_ && contact.partner == ContactPartner::tool &&
                contact.partner_index == tool_) {
                force += contact.force;
            }
        }
        values[1] = force.isZero() ? 0.0 : 1.0;
        values[2] = force.norm() * 1e-3;
        if (model_.kind == ToolKind::forceps) {
            values[3] = tool.jaw;
            values[4] = holds(state) ? 1.0 : 0.0;
        }
        if (model_.kind == ToolKind::cystotome) {
            values[3] = force.isZero()
                            ? std::numeric_limits<double>::quiet_NaN()
                            : wrinkled_share(input.world.membranes[at(membrane_)], state, tool.pose.position);
        }
        if (model_.kind == ToolKind::cannula) {
            values[3] = tool.present ? tool.jaw : 0.0;
        }
    }

private:
    [[nodiscard]] bool holds(const MembraneState& state) const {
        for (const SheetGrip& grip : state.grips) {
            if (grip.tool == tool_ && !grip.pushed) {
                return true;
            }
        }
        return false;
    }

    ToolModel model_;
    int tool_;
    int membrane_;
};

}  // namespace

std::unique_ptr<MeasureGroup> capsule_tool_measures(const ToolModel& model, int tool, int membrane) {
    return std::make_unique<CapsuleToolMeasures>(model, tool, membrane);
}

}  // namespace rhexis
