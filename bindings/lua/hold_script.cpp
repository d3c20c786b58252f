// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/hold_script.hpp"

#include "lua/samples.hpp"
#include "lua/stack.hpp"

namespace rhexis {
namespace {

void push_hold(lua_State* L, const std::string& instrument) {
    lua_getfield(L, -1, "held");
    lua::push(L, std::string_view(instrument));
    lua_call(L, 1, 1);
}

}  // namespace

Result<HoldScript> HoldScript::load(const std::string& root) {
    LuaOptions options;
    options.folders = {{root + "/scripts", "scripts"}};
    Result<LuaState> state = LuaState::create(std::move(options));
    if (!state) {
        return state.error();
    }
    HoldScript script(std::move(state).value());
    const Status status = script.state_.run([&](lua_State* L) {
        lua_getglobal(L, "require");
        lua_pushstring(L, "surgeons.instruments");
        lua_call(L, 1, 1);
        script.instruments_ = LuaRef(script.state_, L);
    });
    return status ? Result<HoldScript>(std::move(script)) : status.error();
}

Result<std::string> HoldScript::wound_of(const std::string& instrument) {
    std::string name;
    const Status status = state_.run([&](lua_State* L) {
        instruments_.push(L);
        push_hold(L, instrument);
        lua_getfield(L, -1, "wound");
        name = lua_tostring(L, -1);
    });
    return status ? Result<std::string>(name) : status.error();
}

Result<Vec3> HoldScript::of_wound(const char* function, const Vec3& wound) {
    Vec3 place = Vec3::Zero();
    const Status status = state_.run([&](lua_State* L) {
        instruments_.push(L);
        lua_getfield(L, -1, function);
        lua::push(L, wound);
        lua_call(L, 1, 1);
        place = lua::place_from(L);
    });
    return status ? Result<Vec3>(place) : status.error();
}

Result<Vec3> HoldScript::outside(const Vec3& wound) { return of_wound("outside", wound); }
Result<Vec3> HoldScript::way_out(const Vec3& wound) { return of_wound("way_out", wound); }

Result<Quat> HoldScript::orientation(const std::string& instrument, const std::optional<Vec3>& wound, const Vec3& tip,
                                     double turned_deg) {
    Quat turned = Quat::Identity();
    const Status status = state_.run([&](lua_State* L) {
        instruments_.push(L);
        lua_getfield(L, -1, "orientation");
        lua_insert(L, -2);
        push_hold(L, instrument);
        lua_remove(L, -2);
        if (wound) {
            lua::push(L, *wound);
        } else {
            lua_pushnil(L);
        }
        lua::push(L, tip);
        lua_pushnumber(L, turned_deg);
        lua_call(L, 4, 1);
        turned = lua::orientation_from(L);
    });
    return status ? Result<Quat>(turned) : status.error();
}

}  // namespace rhexis
