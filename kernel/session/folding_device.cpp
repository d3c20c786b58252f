// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/folding_device.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "base/numbers.hpp"

namespace rhexis {
namespace {

enum Stage { grip, tuck_upper, tuck_lower, roll, release, close, rest, stages };

constexpr std::array<FoldingStage, stages> stage_table{{{"haptics gripped", 1.0},
                                                        {"upper haptic tucked", 5.0},
                                                        {"lower haptic tucked", 5.0},
                                                        {"rolled", 8.0},
                                                        {"forceps withdrawn", 4.0},
                                                        {"in the bore", 4.0},
                                                        {"at rest", 3.0}}};

constexpr double jaw_radius = 0.2;       // of its two rods [mm]
constexpr double jaw_half_length = 0.4;  // across the haptic [mm]
constexpr double jaw_half_width = 0.2;   // between its rods, along the haptic [mm]
constexpr double jaw_friction = 0.6;
constexpr double squeeze = 0.025;  // of the haptic's thickness, from either side
constexpr double opened = 0.3;     // [mm]
constexpr double flat = 40.0;  // radius of the open wings: a flat lens lies in them without touching their sides [mm]
constexpr double around_jaws = 2.0;  // to which they close before the forceps go [mm]
constexpr double suction = 5e4;      // [uN]
constexpr double way_out = 8.0;      // [mm]

double mixed(double a, double b, double share) { return a + share * (b - a); }

/// How much of the way from one share to another is done.
double part(double share, double from, double to) { return std::clamp((share - from) / (to - from), 0.0, 1.0); }

ToolModel jaw(const char* name) {
    ToolModel tool;
    tool.name = name;
    tool.friction = jaw_friction;
    for (const double x : {-jaw_half_width, jaw_half_width}) {
        tool.parts.push_back({Vec3(x, -jaw_half_length, 0.0), Vec3(x, jaw_half_length, 0.0), jaw_radius, jaw_radius});
    }
    return tool;
}

/// Half a turn about x, evenly enough: without trigonometry, so the same bits with every C library.
Quat half_turn(double share) { return Quat(1.0 - share, share, 0.0, 0.0).normalized(); }

/// Where the haptics are turned over, from the lens's middle.
double hinge_of(const ImplantShape& shape) { return 0.5 * shape.optic_diameter - 0.5; }

constexpr double section_width = 0.5;  // along the bore [mm]
constexpr double most_filled = 0.9;    // share of the bore's section. Proposal

}  // namespace

double smallest_bore(const ImplantShape& shape, const ShellModel& model, bool tucked) {
    const double hinge = hinge_of(shape);
    std::vector<double> volume(static_cast<std::size_t>(shape.overall_diameter / section_width) + 1, 0.0);
    for (int t = 0; t < static_cast<int>(model.mesh.triangles.size()); ++t) {
        const std::array<int, 3>& n = model.mesh.triangles[at(t)];
        const Vec3 middle = triangle_middle(model.mesh, t);
        const bool haptic = tucked && middle.norm() > 0.5 * shape.optic_diameter;
        const double side = middle.y() < 0.0 ? -1.0 : 1.0;
        const double y = haptic && side * middle.y() > hinge ? side * 2.0 * hinge - middle.y() : middle.y();
        const double share = (y + 0.5 * shape.overall_diameter) / section_width;
        volume[at(std::clamp(static_cast<int>(share), 0, static_cast<int>(volume.size()) - 1))] +=
            model.thickness[at(t)] *
            triangle_area(model.mesh.nodes[at(n[0])], model.mesh.nodes[at(n[1])], model.mesh.nodes[at(n[2])]);
    }
    const double section = *std::max_element(volume.begin(), volume.end()) / section_width;
    return 0.01 * std::ceil(200.0 * std::sqrt(section / (std::numbers::pi * most_filled)));
}

Status check_laid_in(const Cartridge& cartridge, const ShellModel& model, const ShellState& laid) {
    double out = 0.0;
    for (const Vec3& place : laid.position) {
        const double along = cartridge.bore.pose.to_body(place).z();
        out = std::max(out, std::abs(along - cartridge.loaded_at) - 0.5 * cartridge.room);
    }
    if (out > 0.0) {
        return Error{std::string("the folded lens sticks out of the cartridge's chamber by ")
                         .append(short_number(0.01 * std::ceil(100.0 * out)))
                         .append(" mm"),
                     model.name, std::string("a length of ").append(short_number(cartridge.room)).append(" mm")};
    }
    return success();
}

std::span<const FoldingStage> folding_stages() { return stage_table; }

FoldingDevice::FoldingDevice(const ImplantShape& shape, const InjectorShape& cartridge)
    : shape_(shape),
      bore_(cartridge.chamber),
      friction_(cartridge.friction),
      tucked_(cartridge.tucked),
      inverted_(cartridge.inverted),
      tools_{jaw("upper front jaw"), jaw("upper back jaw"), jaw("lower front jaw"), jaw("lower back jaw")} {}

bool FoldingDevice::has(int stage) const { return tucked_ || stage == roll || stage >= close; }

/// The middle of the haptic's arm between the jaws: from where it lies over the edge of the optic onto its front.
Pose FoldingDevice::grip_at(int haptic, double share) const {
    const double arm = 0.5 * (shape_.overall_diameter - shape_.haptic_width);
    const double hinge = hinge_of(shape_);
    const double landing =
        0.5 * shape_.centre_thickness + 0.5 * shape_.haptic_thickness + 2.0 * jaw_radius + opened + 0.05;
    Pose pose;
    pose.orientation = half_turn(share);
    const Vec3 out = pose.orientation * Vec3::UnitY();
    pose.position = Vec3(0.0, hinge, landing * share) + (arm - hinge) * Vec3(0.0, out.y(), 0.85 * out.z());
    if (haptic == 1) {
        const Quat about(0.0, 0.0, 0.0, 1.0);  // half a turn about z
        pose.position = about * pose.position;
        pose.orientation = about * pose.orientation;
    }
    return pose;
}

FoldingPose FoldingDevice::pose(int stage, double share) const {
    const auto until = [&](int own) { return stage < own ? 0.0 : stage == own ? share : 1.0; };
    FoldingPose pose;
    const double open = opened * (1.0 - until(grip) + part(until(release), 0.0, 0.2));
    const double apart = (0.5 - squeeze) * shape_.haptic_thickness + jaw_radius + open;
    for (int haptic = 0; haptic < 2; ++haptic) {
        const Pose at = grip_at(haptic, until(haptic == 0 ? tuck_upper : tuck_lower));
        const Vec3 out(0.0, (haptic == 0 ? -way_out : way_out) * part(until(release), 0.2, 1.0), 0.0);
        for (int side = 0; side < 2; ++side) {
            const std::size_t i = static_cast<std::size_t>(2 * haptic + side);
            pose.jaw[i] = at;
            pose.jaw[i].position += out + (side == 0 ? apart : -apart) * (at.orientation * Vec3::UnitZ());
            pose.present[i] = tucked_ && stage <= release;
        }
    }
    const double rolled = std::max(tucked_ ? around_jaws : 0.0, 0.5 * bore_);
    pose.radius = 1.0 / mixed(1.0 / flat, 1.0 / rolled, until(roll));
    if (stage >= close) {
        pose.radius = mixed(rolled, 0.5 * bore_, until(close));
    }
    pose.suction = stage < roll ? suction : 0.0;
    return pose;
}

TubeModel FoldingDevice::wings(double radius) const {
    TubeModel tube;
    tube.name = "wings";
    tube.friction = friction_;
    tube.pose.orientation = Quat(std::sqrt(0.5), -std::sqrt(0.5), 0.0, 0.0);  // z to y
    tube.pose.position = Vec3(0.0, 0.0, radius - 0.5 * shape_.centre_thickness);
    tube.stations = {{100.0, radius, radius}};
    return tube;
}

ShellState FoldingDevice::laid_out(ShellState flat) const {
    const Quat onto_front(0.0, 0.0, 1.0, 0.0);  // half a turn about y, along which the haptics lie
    return inverted_ ? moved(std::move(flat), {Vec3::Zero(), onto_front}) : flat;
}

ShellState FoldingDevice::laid_in(const Cartridge& cartridge, const ShellState& folded) const {
    const Pose& from = wings(0.5 * bore_).pose;
    Pose to = cartridge.bore.pose;
    to.position += to.orientation * Vec3(0.0, 0.0, cartridge.loaded_at);
    Pose by;
    const Quat turned = inverted_ ? Quat(0.0, 0.0, 0.0, 1.0) : Quat(1.0, 0.0, 0.0, 0.0);  // half a turn about the bore
    by.orientation = to.orientation * turned * from.orientation.conjugate();
    by.position = to.position - by.orientation * from.position;
    ShellState state = folded;
    state.loads.clear();
    std::fill(state.velocity.begin(), state.velocity.end(), Vec3(Vec3::Zero()));
    std::fill(state.spin.begin(), state.spin.end(), Vec3(Vec3::Zero()));
    state = moved(std::move(state), by);
    state.loaded = true;
    return state;
}

}  // namespace rhexis
