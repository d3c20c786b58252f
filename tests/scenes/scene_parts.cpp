// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/scene_parts.hpp"

#include <algorithm>

namespace rhexis::scenes {
namespace {

void add_if(bool there, const char* name, std::vector<std::string>& names) {
    if (there) {
        names.emplace_back(name);
    }
}

std::vector<std::string> built_parts(const WorldModel& world) {
    std::vector<std::string> names;
    for (const SolidModel& solid : world.solids) {
        names.push_back(solid.name);
    }
    for (const MembraneModel& membrane : world.membranes) {
        names.push_back(membrane.name);
    }
    for (const ShellModel& shell : world.shells) {
        names.push_back(shell.name);
    }
    add_if(!world.bags.empty(), "bag", names);
    add_if(!world.bags.empty() && world.bags[0].breakable, "zonules", names);
    add_if(!world.domes.empty(), "cornea", names);
    add_if(world.chamber.has_value(), "chamber", names);
    add_if(world.capsule.has_value(), "capsule", names);
    add_if(world.iris.has_value(), "iris", names);
    add_if(world.viscoelastic.has_value(), "viscoelastic", names);
    add_if(world.vitreous.has_value(), "vitreous", names);
    add_if(world.wounds.has_value(), "wounds", names);
    add_if(world.globe.has_value(), "globe", names);
    add_if(world.prolapse.has_value(), "prolapse", names);
    add_if(world.hydrodissection.has_value(), "hydrodissection", names);
    add_if(world.cortex.has_value(), "cortex", names);
    add_if(world.retained.has_value(), "retained_viscoelastic", names);
    add_if(world.microscope.has_value(), "microscope", names);
    add_if(world.lids.has_value(), "lids", names);
    add_if(world.beads.has_value(), "beads", names);
    return names;
}

std::vector<std::string> drawn_parts_of(const Frame& frame) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        names.push_back(frame.model->solids[i].name);
    }
    for (std::size_t i = 0; i < frame.membranes.size(); ++i) {
        names.push_back(frame.model->membranes[i].name);
    }
    for (std::size_t i = 0; i < frame.shells.size(); ++i) {
        names.push_back(frame.model->shells[i].name);
    }
    add_if(!frame.bags.empty(), "bag", names);
    add_if(!frame.bags.empty() && frame.bags[0].zonules.has_value(), "zonules", names);
    add_if(frame.eye && frame.eye->has_cornea, "cornea", names);
    add_if(frame.eye && frame.eye->has_iris, "iris", names);
    add_if(frame.capsule.has_value(), "capsule", names);
    add_if(frame.vitreous.has_value(), "vitreous", names);
    add_if(frame.wounds.has_value(), "wounds", names);
    add_if(frame.globe.has_value(), "globe", names);
    add_if(frame.prolapse.has_value(), "prolapse", names);
    add_if(frame.hydrodissection.has_value(), "hydrodissection", names);
    add_if(frame.cortex.has_value(), "cortex", names);
    add_if(frame.retained.has_value(), "retained_viscoelastic", names);
    add_if(frame.lids.has_value(), "lids", names);
    add_if(frame.model->beads.has_value(), "beads", names);
    return names;
}

std::vector<std::string> sorted_names(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

SceneParts parts_of(const Session& session) {
    SceneParts parts;
    parts.built = sorted_names(built_parts(session.world()));
    for (const auto& [name, part] : session.profile().parts) {
        if (part.calls > 0) {
            parts.stepped.push_back(name);
        }
    }
    parts.drawn = sorted_names(drawn_parts_of(session.frame()));
    return parts;
}

}  // namespace rhexis::scenes
