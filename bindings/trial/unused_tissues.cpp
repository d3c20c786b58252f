// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/unused_tissues.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "session/session.hpp"

namespace rhexis {
namespace {

/// What a picture shows as soon as it is in the scene.
constexpr std::array<std::string_view, 9> shown_always{"lens", "iris",  "cornea", "anterior_capsule",     "implant",
                                                       "lids", "beads", "cortex", "retained_viscoelastic"};

/// As coarse as may be: only the names of its measures count.
SceneDescription coarsest(SceneDescription scene) {
    scene.patient.tetrahedra = 500;
    scene.settings["capsule.triangles"] = 200.0;
    scene.settings["bag.triangles"] = 300.0;
    scene.settings["implant.triangles"] = 400.0;
    return scene;
}

bool names_measure(const ObservationSchema& schema, const std::string& name) {
    return std::any_of(schema.begin(), schema.end(), [&name](const MeasureInfo& info) { return info.name == name; });
}

}  // namespace

std::vector<std::string> unused_tissues(const SceneDescription& scene, const std::vector<std::string>& used) {
    std::vector<std::string> unused;
    for (const std::string& tissue : scene.tissues) {
        if (std::find(shown_always.begin(), shown_always.end(), tissue) != shown_always.end()) {
            continue;
        }
        SceneDescription without = coarsest(scene);
        std::erase(without.tissues, tissue);
        const Result<Session> session = Session::create(without, 1);
        if (!session) {
            continue;  // another part of the scene needs it
        }
        const bool told = std::any_of(used.begin(), used.end(), [&session](const std::string& name) {
            return !names_measure(session.value().schema(), name);
        });
        if (!told) {
            unused.push_back(tissue);
        }
    }
    return unused;
}

}  // namespace rhexis
