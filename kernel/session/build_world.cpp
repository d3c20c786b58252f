// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/build_world.hpp"

#include <algorithm>

#include "eye/make_eye.hpp"
#include "session/settings.hpp"
#include "tools/instruments.hpp"

namespace rhexis {
namespace {

void set_up_bag(BagModel& bag, const std::map<std::string, double>& settings) {
    bag.opening_radius = 0.5 * settings.at("capsulorhexis.diameter_mm");
    for (ZonuleSpring& zonule : bag.zonules) {
        zonule.stiffness *= settings.at("zonules.strength");
    }
}

/// Nuclei that are harder than this are given so much more inertia that their waves are no faster: the stable step of
/// grade 6 doubles. The lens moves slowly, so what it does under a tool stays (docs/accuracy.md) [Pa].
constexpr double fastest_modulus = 20000.0;

/// The way the scene asks for, or substeps; each with elements it can step. In contact an implicit step of the lens
/// costs more than all the substeps of its time (docs/accuracy.md).
void set_up_lens(SolidModel& lens, Advance asked) {
    const bool implicit = asked == Advance::implicit;
    lens.advance = implicit ? Advance::implicit : Advance::explicit_;
    for (Material& material : lens.materials) {
        material.inertia_scale = implicit ? 1.0 : std::max(1.0, material.young_modulus / fastest_modulus);
    }
    lens.formulation = implicit ? Formulation::linear : Formulation::nodal_pressure;
}

constexpr double side_port_width = 1.0;  // [mm]

bool has_instrument(const SceneDescription& scene, const std::string& name) {
    return std::find(scene.instruments.begin(), scene.instruments.end(), name) != scene.instruments.end();
}

}  // namespace

std::map<std::string, double> all_settings(const SceneDescription& scene) {
    std::map<std::string, double> settings;
    for (const SettingInfo& info : setting_table()) {
        settings[std::string(info.name)] = info.standard;
    }
    for (const auto& [name, value] : scene.settings) {
        settings[name] = value;
    }
    return settings;
}

bool has_tissue(const SceneDescription& scene, const std::string& name) {
    return std::find(scene.tissues.begin(), scene.tissues.end(), name) != scene.tissues.end();
}

Result<BuiltWorld> build_world(const SceneDescription& scene) {
    Result<EyeModel> eye = make_eye(scene.patient);
    if (!eye) {
        return eye.error();
    }
    set_up_bag(eye.value().bag, all_settings(scene));
    set_up_lens(eye.value().lens, scene.advance);
    eye.value().anatomy.has_iris = has_tissue(scene, "iris");
    eye.value().anatomy.has_cornea = has_tissue(scene, "cornea");
    eye.value().anatomy.side_port_width = has_instrument(scene, "spatula") ? side_port_width : 0.0;
    std::shared_ptr<WorldModel> world = std::make_shared<WorldModel>();
    if (has_tissue(scene, "lens")) {
        world->solids.push_back(eye.value().lens);
    }
    if (has_tissue(scene, "bag")) {
        world->bags.push_back(eye.value().bag);
    }
    for (const std::string& name : scene.instruments) {
        Result<ToolModel> tool = make_tool(name);
        if (!tool) {
            return tool.error();
        }
        world->tools.push_back(std::move(tool).value());
    }
    return BuiltWorld{std::move(eye).value(), std::move(world)};
}

}  // namespace rhexis
