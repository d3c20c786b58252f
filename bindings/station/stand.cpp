// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/stand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "flow/microscope.hpp"
#include "session/settings.hpp"

namespace rhexis::station {
namespace {

constexpr double fingers = 4.0;  ///< whole ways per second: as virtual surgeons have it
constexpr double plunger = 0.3;  ///< likewise, of what takes its time

StandInstrument instrument_of(const ToolModel& tool) {
    switch (tool.kind) {
        case ToolKind::forceps:
            return {tool.name, Squeeze::closes, fingers, true};
        case ToolKind::cannula:
        case ToolKind::hydrator:
        case ToolKind::drape:
            return {tool.name, Squeeze::presses, fingers, true};
        case ToolKind::injector:
        case ToolKind::ring:
            return {tool.name, Squeeze::pushes, plunger, true};
        case ToolKind::capsule_hook:
        case ToolKind::speculum:
        case ToolKind::needle:
        case ToolKind::sponge:
            return {tool.name, Squeeze::presses, fingers, true};
        default:
            return {tool.name, Squeeze::nothing, 0.0, true};
    }
}

/// About a sixtieth of the range, rounded to 1, 2 or 5.
double notch_of(double range) {
    const double about = range / 60.0;
    const double power = std::pow(10.0, std::floor(std::log10(about)));
    const double digit = about / power;
    return power * (digit < 1.5 ? 1.0 : digit < 3.5 ? 2.0 : digit < 7.5 ? 5.0 : 10.0);
}

/// Which instrument turns the settings of a prefix into something.
bool has_use(std::string_view setting, const WorldModel& world) {
    constexpr auto uses = std::to_array<std::pair<std::string_view, ToolKind>>({
        {"phaco.", ToolKind::phaco},
        {"machine.", ToolKind::phaco},
        {"ia.", ToolKind::aspirator},
        {"machine.bottle", ToolKind::aspirator},
        {"cutter.", ToolKind::cutter},
    });
    return std::any_of(uses.begin(), uses.end(), [&](const auto& use) {
        return setting.starts_with(use.first) &&
               std::any_of(world.tools.begin(), world.tools.end(),
                           [&](const ToolModel& tool) { return tool.kind == use.second; });
    });
}

std::vector<Dial> dials_of(const Session& session) {
    std::vector<Dial> dials;
    const std::map<std::string, double>& given = session.scene().settings;
    for (const SettingInfo& info : setting_table()) {
        if (!info.live || info.tissue || !has_use(info.name, session.world())) {
            continue;
        }
        const auto set = given.find(std::string(info.name));
        const bool is_switch = info.meaning.starts_with("1: ");
        dials.push_back({std::string(info.name), std::string(info.unit), info.minimum, info.maximum,
                         is_switch ? 1.0 : notch_of(info.maximum - info.minimum),
                         set == given.end() ? info.standard : set->second});
    }
    return dials;
}

}  // namespace

Stand make_stand(const Session& session, const nlohmann::json& declared) {
    Stand stand;
    for (const ToolModel& tool : session.world().tools) {
        stand.instruments.push_back(instrument_of(tool));
    }
    if (session.world().microscope) {
        stand.instruments.push_back({microscope_name, Squeeze::nothing, 0.0, false});
    }
    stand.dials = dials_of(session);
    for (const nlohmann::json& request : declared) {
        stand.requests.push_back({request.value("id", ""), request.value("title", "")});
    }
    return stand;
}

}  // namespace rhexis::station
