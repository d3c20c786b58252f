// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/folded_start.hpp"

#include <algorithm>

#include "session/implant_fold.hpp"
#include "session/scene_differences.hpp"

namespace rhexis {
namespace {

bool lists(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

Status check_has_both(const SceneDescription& scene) {
    const SceneDescription needed = folding_scene({});
    const auto lacks = [](const std::string& what) {
        return Error{"the state holds an implant folded into its injector, but the scene names no " + what, "",
                     "a scene with the tissue implant and the instrument injector"};
    };
    if (!lists(scene.tissues, needed.tissues[0])) {
        return lacks("tissue " + needed.tissues[0]);
    }
    if (!lists(scene.instruments, needed.instruments[0])) {
        return lacks("instrument " + needed.instruments[0]);
    }
    return success();
}

/// Number of the shell that is the implant; the scene has one.
std::size_t implant_of(const WorldModel& world) {
    const auto found = std::find_if(world.shells.begin(), world.shells.end(),
                                    [](const ShellModel& shell) { return shell.name == "implant"; });
    RHEXIS_ASSERT(found != world.shells.end());
    return static_cast<std::size_t>(found - world.shells.begin());
}

}  // namespace

bool shapes_folded_implant(std::string_view setting) {
    return setting.starts_with("implant.") || setting.starts_with("cartridge.");
}

bool is_folded_implant(const PreparedState& state) {
    const SceneDescription folding = folding_scene({});
    return state.made.scene.tissues == folding.tissues && state.made.scene.instruments == folding.instruments &&
           state.snapshot.world.shells.size() == 1 && state.snapshot.world.shells[0].loaded;
}

Result<Snapshot> with_folded_implant(const Session& session, const PreparedState& state) {
    if (Status status = check_has_both(session.scene()); !status) {
        return status.error();
    }
    Snapshot start = session.copy_state();
    SceneDifferences differences;
    differences.add_settings(state.snapshot.settings, start.settings,
                             [](const SettingInfo& info) { return shapes_folded_implant(info.name); });
    if (!differences.text().empty()) {
        return Error{"the implant was folded with other settings: " + differences.text(), "", ""};
    }
    ShellState& implant = start.world.shells[implant_of(session.world())];
    implant = state.snapshot.world.shells[0];
    // numbers of instruments are those of the scene in which it was folded; none holds it
    std::erase_if(implant.touches, [](const ShellTouch& touch) { return touch.partner == ContactPartner::tool; });
    return start;
}

}  // namespace rhexis
