// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis.eye: the eye of a patient as a scene, with instruments to operate by hand.
#include <string>

#include "lua/eye_scene.hpp"
#include "lua/guard.hpp"
#include "lua/modules.hpp"
#include "lua/objects.hpp"
#include "lua/stack.hpp"

namespace rhexis::lua {
namespace {

Patient read_patient_fields(Options& options) {
    Patient patient;
    patient.age = options.number("age", patient.age, {20.0, 95.0, "years"});
    patient.nuclear_grade = options.number("nuclear_grade", patient.nuclear_grade, {1.0, 6.0, "(LOCS III)"});
    patient.cortical_opacity = options.number("cortical_opacity", patient.cortical_opacity, {0.0, 1.0, ""});
    patient.pupil_mm = options.number("pupil_mm", patient.pupil_mm, {3.0, 9.0, "mm"});
    patient.side = options.choice("side", patient.side, {"right", "left"});
    patient.tetrahedra = static_cast<int>(options.integer("tetrahedra", patient.tetrahedra, 500, 24000));
    return patient;
}

// {["phaco.power_limit"] = 0.6}; names and ranges are checked by the session.
void read_settings(lua_State* L, Options& options, SceneDescription& scene) {
    const int type = options.push_field("settings");
    if (type != LUA_TNIL && type != LUA_TTABLE) {
        options.fail("settings", "allowed: a table of names and numbers");
    }
    if (type == LUA_TTABLE) {
        lua_pushnil(L);
        while (lua_next(L, -2) != 0) {
            if (lua_type(L, -2) != LUA_TSTRING || lua_type(L, -1) != LUA_TNUMBER) {
                options.fail("settings", "allowed: a table of names and numbers");
            }
            scene.settings[lua_tostring(L, -2)] = lua_tonumber(L, -1);
            lua_pop(L, 1);
        }
    }
    lua_pop(L, 1);
}

int create(lua_State* L) {
    Options options(L, 1, "rhexis.eye.create");
    SceneDescription scene;
    scene.patient = read_patient_fields(options);
    scene.tissues = options.strings("tissues", {"lens", "bag", "iris", "cornea"});
    scene.instruments = options.strings("instruments", {"phaco"});
    scene.step_s = options.number("step", 0.01, {0.001, 0.02, "s"});
    scene.threads = static_cast<int>(options.integer("threads", 1, 1, 64));
    const std::string advance = options.choice("advance", "automatic", {"automatic", "explicit", "implicit"});
    scene.advance = advance == "explicit"   ? Advance::explicit_
                    : advance == "implicit" ? Advance::implicit
                                            : Advance::automatic;
    const long long seed = options.integer("seed", 1, 0, 9'000'000'000'000'000);
    read_settings(L, options, scene);
    options.finish();
    Result<Session> session = Session::create(scene, static_cast<std::uint64_t>(seed));
    if (!session) {
        raise(L, "rhexis.eye.create: " + session.error().text());
    }
    push_scene(L, std::make_unique<EyeScene>(std::move(session).value()));
    return 1;
}

}  // namespace

void push_eye_module(lua_State* L) { push_library(L, {{"create", guarded<create>}}); }

}  // namespace rhexis::lua
