// SPDX-License-Identifier: GPL-3.0-or-later
// How a hand holds an instrument, as scripts/surgeons/instruments.lua says: the same for virtual surgeons and people.
#pragma once

#include <optional>
#include <string>

#include "base/result.hpp"
#include "lua/lua_state.hpp"
#include "math/types.hpp"

namespace rhexis {

class HoldScript {
public:
    static Result<HoldScript> load(const std::string& root);

    /// Name of the landmark that its shaft goes through: "incision", "side_port_site", ...
    Result<std::string> wound_of(const std::string& instrument);
    /// Where a tip is taken up and put down: outside a wound [mm].
    Result<Vec3> outside(const Vec3& wound);
    /// Direction outwards through a wound, unit.
    Result<Vec3> way_out(const Vec3& wound);
    /// With its tip at a place, its shaft through the wound (none: there is no wound), rolled by so many degrees.
    Result<Quat> orientation(const std::string& instrument, const std::optional<Vec3>& wound, const Vec3& tip,
                             double turned_deg);

private:
    explicit HoldScript(LuaState state) : state_(std::move(state)) {}
    Result<Vec3> of_wound(const char* function, const Vec3& wound);

    LuaState state_;
    LuaRef instruments_;
};

}  // namespace rhexis
