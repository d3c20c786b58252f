// SPDX-License-Identifier: GPL-3.0-or-later
// What an instrument looks like: files in assets/instruments, in the instrument's frame (its end at the origin) [mm].
//
//   { "about": "...",                      what it is
//     "same_as": "NAME",                   as that one; nothing else then
//     "with_own_parts": true,              besides what it touches with
//     "parts": [
//       { "wire": [[x, y, z], ...],        a rod along these points, of a radius at each
//         "radius": [r, ...],
//         "section": [a, b],               its section, across x and along it, as much wider [1, 1]
//         "smooth": true,                  bent, not broken, at the points between
//         "ends": "round" | "flat" | "open",
//         "bore": r, ... },                of an open end
//       { "plate": [[x, z], ...],          a flat outline across y, counter-clockwise seen from +y; its edge is ground
//         "thickness": t, "edge": w, ... },    over w
//       { "own_part": i, ... } ] }         one of the cones that it touches with
//
// Each part has a "finish" (titanium, bore, sleeve, steel, clear, hub, sponge, nylon), and may have
// "opens": { "about": [x, y, z], "axis": [x, y, z], "deg": d }: it turns so far as the jaws are open.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "math/types.hpp"

namespace rhexis {

/// What a part of an instrument looks like.
enum class ToolFinish { titanium, bore, sleeve, steel, skin, lash, drape, clear, hub, sponge, nylon };

/// Light comes through it.
inline bool is_clear(ToolFinish finish) { return finish == ToolFinish::sleeve || finish == ToolFinish::clear; }

enum class WireEnds { round, flat, open };

/// A part turns about this as the jaws open.
struct Hinge {
    Vec3 about = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();  ///< unit
    double open_rad = 0.0;      ///< when they are open
};

struct ToolWire {
    std::vector<Vec3> points;   ///< two or more
    std::vector<double> radii;  ///< at each
    std::array<double, 2> section{1.0, 1.0};
    WireEnds ends = WireEnds::round;
    double bore = 0.0;
};

struct ToolPlate {
    std::vector<Vec2> outline;  ///< x and z; three or more, convex
    double thickness = 0.1;
    double edge = 0.1;
};

struct ToolShapePart {
    ToolFinish finish = ToolFinish::steel;
    std::optional<Hinge> hinge{};
    std::optional<ToolWire> wire{};  ///< one of these three
    std::optional<ToolPlate> plate{};
    int own_part = -1;
    WireEnds own_ends = WireEnds::round;
};

struct ToolShape {
    bool with_own_parts = false;
    std::vector<ToolShapePart> parts;
};

/// Reads one. The error names the part, the field and what is allowed.
Result<ToolShape> read_tool_shape(const std::string& text, const std::string& where);

/// That of an instrument of this name, where there is a file of it; none: it looks as what it touches with.
std::optional<ToolShape> shape_of_instrument(const std::string& name);

}  // namespace rhexis
