// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/injector.hpp"

#include "base/numbers.hpp"
#include "base/ranges.hpp"

namespace rhexis {
namespace {

constexpr double wall = 0.15;           // of the nozzle [mm]
constexpr double nozzle_length = 5.0;   // [mm]
constexpr double funnel_length = 6.0;   // [mm]
constexpr double chamber_length = 9.0;  // that an implant may take whose haptics lie on its optic [mm]
constexpr double longer = 5.5;          // the chamber where they do not [mm]
constexpr double plunger_gap = 0.5;     // before an implant of that length [mm]
constexpr double plunger_out = 1.0;     // of the tip at the end of its stroke [mm]
constexpr double plunger_play = 0.8;    // radius of the plunger, share of the nozzle's
constexpr double plunger_friction = 0.2;
constexpr double hand_speed = 40.0;       // that it can push it with [mm/s]
constexpr double shaft_radius = 3.0;      // of the hand piece [mm]
constexpr double injector_length = 60.0;  // [mm]

}  // namespace

Status check_injector(const InjectorShape& shape) {
    return check_ranges({{"chamber", shape.chamber, 1.0, 4.0, " mm"},
                         {"nozzle", shape.nozzle, 1.0, shape.chamber, " mm"},
                         {"friction", shape.friction, 0.0, 2.0, ""},
                         {"push", shape.push, 1.0, 100.0, " N"}},
                        "cartridge");
}

ToolModel injector(const InjectorShape& shape) {
    const double chamber = 0.5 * shape.chamber;
    const double nozzle = 0.5 * shape.nozzle;
    ToolModel tool;
    tool.name = "injector";
    tool.kind = ToolKind::injector;
    tool.friction = plunger_friction;
    const double outer = nozzle + wall;
    const double end = nozzle_length + funnel_length;
    const double room = chamber_length + (shape.tucked ? 0.0 : longer);
    tool.parts = {{Vec3(0.0, 0.0, outer), Vec3(0.0, 0.0, nozzle_length), outer, outer},
                  {Vec3(0.0, 0.0, nozzle_length), Vec3(0.0, 0.0, end), outer, chamber + wall},
                  {Vec3(0.0, 0.0, end + room), Vec3(0.0, 0.0, injector_length), shaft_radius, shaft_radius}};
    Cartridge& cartridge = tool.cartridge.emplace();
    cartridge.bore.name = "cartridge";
    cartridge.bore.pose.orientation = Quat(0.0, 1.0, 0.0, 0.0);  // half a turn about x
    cartridge.bore.stations = {{-end, chamber, chamber}, {-nozzle_length, nozzle, nozzle}, {0.0, nozzle, nozzle}};
    cartridge.bore.lip = 0.5 * wall;
    cartridge.bore.friction = shape.friction;
    cartridge.loaded_at = -end - 0.5 * room;
    cartridge.room = room;
    cartridge.plunger_radius = plunger_play * nozzle;
    cartridge.plunger_from = cartridge.loaded_at - 0.5 * room - plunger_gap;
    cartridge.stroke = plunger_out - cartridge.plunger_from;
    cartridge.most_force = 1e6 * shape.push;
    cartridge.fastest = hand_speed;
    return tool;
}

}  // namespace rhexis
