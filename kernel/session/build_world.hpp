// SPDX-License-Identifier: GPL-3.0-or-later
// From a description to what is simulated: the eye of the patient, and a world with the tissues and tools that are
// named.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "base/result.hpp"
#include "eye/implant.hpp"
#include "flow/scene.hpp"
#include "flow/world.hpp"
#include "tools/injector.hpp"

namespace rhexis {

struct BuiltWorld {
    EyeModel eye;
    std::shared_ptr<const WorldModel> world;
};

/// All settings with their values: the standard ones, and over them those of the scene.
std::map<std::string, double> all_settings(const SceneDescription& scene);

/// What the settings say of implant and injector.
ImplantShape implant_shape(const std::map<std::string, double>& settings);
InjectorShape injector_shape(const std::map<std::string, double>& settings);

/// True when the scene names a tissue.
bool has_tissue(const SceneDescription& scene, const std::string& name);

/// Whether an implant comes into the eye through an injector, in which it lies folded at first.
bool injects(const SceneDescription& scene);

/// The description has passed check_scene.
Result<BuiltWorld> build_world(const SceneDescription& scene);

}  // namespace rhexis
