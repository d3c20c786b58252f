// SPDX-License-Identifier: GPL-3.0-or-later
// Where an instrument's tip is, what it does and what it touches.
#include <cmath>

#include "observe/distances.hpp"
#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

/// Memory of a tool.
enum Memory : std::size_t {
    path_mm,
    ultrasound_s,
    idle_ultrasound_s,
    dissipated,
    wall_touches,
    wall_touched,
    memory_count
};

bool has_mouth(ToolKind kind) {
    return kind == ToolKind::phaco || kind == ToolKind::cutter || kind == ToolKind::aspirator;
}

class ToolMeasures : public MeasureGroup {
public:
    ToolMeasures(const ToolModel& model, int tool, const ToolSurroundings& around)
        : model_(model), tool_(tool), around_(around) {}

    void describe(ObservationSchema& schema) const override;
    [[nodiscard]] std::size_t memory_size() const override { return memory_count; }
    void measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                 std::span<double> values) const override;

private:
    void describe_phaco(ObservationSchema& schema) const;
    void describe_cutter(ObservationSchema& schema) const;
    void describe_aspirator(ObservationSchema& schema) const;
    void describe_mouth(ObservationSchema& schema) const;
    void describe_lens(ObservationSchema& schema) const;
    void describe_bag(ObservationSchema& schema) const;

    ToolModel model_;
    int tool_;
    ToolSurroundings around_;
};

void ToolMeasures::describe(ObservationSchema& schema) const {
    const std::string group = model_.name + ".";
    schema.push_back({group + "present", "bool", "The instrument is in the eye."});
    schema.push_back({group + "tip_x_mm", "mm", "Tip, to the surgeon's right of the eye's axis."});
    schema.push_back({group + "tip_y_mm", "mm", "Tip, away from the surgeon."});
    schema.push_back({group + "tip_z_mm", "mm", "Tip, towards the microscope from the lens equator."});
    schema.push_back({group + "speed_mm_s", "mm/s", "Speed of the tip."});
    schema.push_back({group + "path_mm", "mm", "Length of the way of the tip inside the eye so far."});
    if (model_.kind == ToolKind::phaco) {
        describe_phaco(schema);
    }
    if (model_.kind == ToolKind::cutter) {
        describe_cutter(schema);
    }
    if (model_.kind == ToolKind::aspirator) {
        describe_aspirator(schema);
    }
    if (around_.chamber && has_mouth(model_.kind)) {
        describe_mouth(schema);
    }
    if (around_.lens) {
        describe_lens(schema);
    }
    if (around_.bag) {
        describe_bag(schema);
    }
    if (around_.cornea) {
        schema.push_back({group + "endothelium_mm", "mm", "Distance of the tip from the back of the cornea."});
    }
}

void ToolMeasures::describe_phaco(ObservationSchema& schema) const {
    const std::string group = model_.name + ".";
    schema.push_back({group + "pedal", "1", "Foot pedal: 0 up, 1 irrigation, 2 aspiration, 3 ultrasound."});
    schema.push_back({group + "irrigating", "bool", "Irrigation flows."});
    schema.push_back({group + "aspirating", "bool", "Aspiration draws."});
    schema.push_back({group + "ultrasound", "bool", "Ultrasound is on."});
    schema.push_back({group + "power", "1", "Ultrasound power, share of full."});
    schema.push_back({group + "ultrasound_s", "s", "Time with ultrasound on so far."});
    schema.push_back({group + "idle_ultrasound_s", "s", "Part of it in which the tip touched no lens."});
    schema.push_back(
        {group + "cde", "% s", "Cumulative dissipated energy: ultrasound power in percent times seconds."});
}

void ToolMeasures::describe_cutter(ObservationSchema& schema) const {
    const std::string group = model_.name + ".";
    schema.push_back({group + "pedal", "1", "Foot pedal: 0 up, 1 irrigation, 2 and 3 as cutter.cut_first says."});
    schema.push_back({group + "irrigating", "bool", "Irrigation flows."});
    schema.push_back({group + "aspirating", "bool", "Aspiration draws."});
    schema.push_back({group + "cutting", "bool", "Its blade cuts."});
    schema.push_back({group + "cuts_per_min", "1/min", "Cuts per minute now."});
}

void ToolMeasures::describe_aspirator(ObservationSchema& schema) const {
    const std::string group = model_.name + ".";
    schema.push_back({group + "pedal", "1", "Foot pedal: 0 up, 1 irrigation, 2 aspiration too."});
    schema.push_back({group + "irrigating", "bool", "Irrigation flows."});
    schema.push_back({group + "aspirating", "bool", "Aspiration draws."});
}

void ToolMeasures::describe_mouth(ObservationSchema& schema) const {
    const std::string group = model_.name + ".";
    schema.push_back({group + "occlusion", "1", "Share of its mouth that is shut."});
    schema.push_back({group + "occluded_by_lens", "1", "Share of its mouth that lens covers."});
    schema.push_back({group + "suction_mmhg", "mmHg", "Vacuum that acts at its mouth."});
    schema.push_back({group + "hold_mN", "mN", "Force with which it holds tissue."});
}

void ToolMeasures::describe_lens(ObservationSchema& schema) const {
    const std::string group = model_.name + ".";
    schema.push_back({group + "tip_depth_mm", "mm", "Tip below the front surface that the lens had at this place."});
    schema.push_back({group + "inside_lens", "bool", "Tip within the outline that the lens had at the start."});
    schema.push_back({group + "in_contact", "bool", "The instrument touches the lens."});
    schema.push_back({group + "force_mN", "mN", "Force of the instrument on the lens."});
}

void ToolMeasures::describe_bag(ObservationSchema& schema) const {
    const std::string group = model_.name + ".";
    schema.push_back(
        {group + "tip_posterior_mm", "mm", "Distance of the tip from the posterior capsule; negative: through it."});
    schema.push_back({group + "capsule_gap_mm", "mm", "Gap between instrument and capsule; negative: through it."});
    schema.push_back({group + "capsule_touch", "bool", "The instrument touches the capsule."});
    schema.push_back({group + "capsule_touches", "1", "Touches of the capsule so far."});
}

struct LensContact {
    bool touching = false;
    Vec3 force = Vec3::Zero();
};

LensContact contact_with_lens(const ContactSet& contacts, int tool) {
    LensContact sum;
    for (const Contact& contact : contacts) {
        if (contact.partner == ContactPartner::tool && contact.partner_index == tool && contact.solid == 0) {
            sum.force += contact.force;
            sum.touching = sum.touching || contact.gap <= 0.0 || contact.force != Vec3::Zero();
        }
    }
    return sum;
}

/// Writes values one after the other, in the order of describe().
class Writer {
public:
    explicit Writer(std::span<double> values) : values_(values) {}
    void put(double value) { values_[next_++] = value; }
    void put_if(bool defined, double value) { put(defined ? value : not_defined); }

private:
    std::span<double> values_;
    std::size_t next_ = 0;
};

double truth(bool value) { return value ? 1.0 : 0.0; }

void measure_phaco(const ToolState& tool, bool idle, double dt, std::span<double> memory, Writer& out) {
    const bool on = tool.present && tool.power > 0.0;
    memory[ultrasound_s] += on ? dt : 0.0;
    memory[idle_ultrasound_s] += on && idle ? dt : 0.0;
    memory[dissipated] += on ? 100.0 * tool.power * dt : 0.0;
    out.put(tool.pedal);
    out.put(truth(tool.irrigation));
    out.put(truth(tool.aspiration > 0.0));
    out.put(truth(on));
    out.put(tool.power);
    out.put(memory[ultrasound_s]);
    out.put(memory[idle_ultrasound_s]);
    out.put(memory[dissipated]);
}

void measure_cutter(const ToolState& tool, Writer& out) {
    out.put(tool.pedal);
    out.put(truth(tool.irrigation));
    out.put(truth(tool.aspiration > 0.0));
    out.put(truth(tool.present && tool.power > 0.0));
    out.put(fastest_cutter * tool.power);
}

void measure_aspirator(const ToolState& tool, Writer& out) {
    out.put(tool.pedal);
    out.put(truth(tool.irrigation));
    out.put(truth(tool.aspiration > 0.0));
}

void measure_mouth(const TipState& tip, Writer& out) {
    out.put(1.0 - tip.open);
    out.put(tip.lens);
    out.put(tip.suction / pascal_per_mmhg);
    out.put(1e-3 * tip.hold);
}

void measure_lens(const ToolState& tool, const LensView& lens, const LensContact& contact, Writer& out) {
    const Vec3 place = lens.motion->to_rest(tool.pose.position);
    const Vec2 across(place.x(), place.y());
    const double front = front_surface(*lens.grid, across);
    const double back = back_surface(*lens.grid, across);
    out.put_if(tool.present, front - place.z());
    out.put(truth(tool.present && place.z() < front && place.z() > back));
    out.put(truth(contact.touching));
    out.put(contact.force.norm() * 1e-3);
}

void measure_bag(const ToolModel& model, const ToolState& tool, const BagModel& bag, const BagState& state,
                 std::span<double> memory, Writer& out) {
    double gap = not_defined;
    double posterior = not_defined;
    if (tool.present) {
        const Vec3 tip = state.pose.to_body(tool.pose.position);
        const bool through = tip.z() < 0.0 && bag_distance(bag.shape, tip).distance > 0.0;
        posterior = (through ? -1.0 : 1.0) * posterior_distance(bag.shape, tip);
        gap = tool_gap(model, tool.pose,
                       [&](const Vec3& point) { return bag_wall_distance(bag, state.pose.to_body(point)); });
    }
    const bool touch = gap <= 0.0;
    // A touch ends only when the gap has opened clearly: a trembling tip is not many touches.
    if (touch && memory[wall_touched] == 0.0) {
        memory[wall_touches] += 1.0;
        memory[wall_touched] = 1.0;
    } else if (!(gap <= 0.05)) {
        memory[wall_touched] = 0.0;
    }
    out.put(posterior);
    out.put(gap);
    out.put(truth(touch));
    out.put(memory[wall_touches]);
}

void ToolMeasures::measure(const ObserveInput& input, const LensView& lens, std::span<double> memory,
                           std::span<double> values) const {
    const ToolState& tool = input.tools[tool_];
    const LensContact contact = contact_with_lens(input.contacts, tool_);
    Writer out(values);
    if (tool.present) {
        memory[path_mm] += (tool.pose.position - tool.previous_pose.position).norm();
    }
    out.put(truth(tool.present));
    for (int axis = 0; axis < 3; ++axis) {
        out.put_if(tool.present, tool.pose.position[axis]);
    }
    out.put_if(tool.present, tool.velocity.norm());
    out.put(memory[path_mm]);
    if (model_.kind == ToolKind::phaco) {
        measure_phaco(tool, !contact.touching, input.dt, memory, out);
    }
    if (model_.kind == ToolKind::cutter) {
        measure_cutter(tool, out);
    }
    if (model_.kind == ToolKind::aspirator) {
        measure_aspirator(tool, out);
    }
    if (around_.chamber && has_mouth(model_.kind)) {
        measure_mouth(input.state.tips[tool_], out);
    }
    if (around_.lens) {
        measure_lens(tool, lens, contact, out);
    }
    if (around_.bag) {
        measure_bag(model_, tool, input.world.bags[0], input.state.bags[0], memory, out);
    }
    if (around_.cornea) {
        out.put_if(tool.present, endothelium_distance(input.eye.anatomy, tool.pose.position));
    }
}

}  // namespace

std::unique_ptr<MeasureGroup> tool_measures(const ToolModel& model, int tool, const ToolSurroundings& around) {
    return std::make_unique<ToolMeasures>(model, tool, around);
}

}  // namespace rhexis
