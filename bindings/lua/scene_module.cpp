// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis.scene: bodies, tools and planes that a script puts together, steps and looks into.
#include <cmath>
#include <string>

#include "base/hash.hpp"
#include "base/near_names.hpp"
#include "lua/eye_scene.hpp"
#include "lua/guard.hpp"
#include "lua/json.hpp"
#include "lua/modules.hpp"
#include "lua/objects.hpp"
#include "lua/selection.hpp"
#include "lua/stack.hpp"

namespace rhexis::lua {
namespace {

EyeScene& check_eye(lua_State* L, const char* function) {
    auto* scene = dynamic_cast<EyeScene*>(&check_scene(L, 1));
    if (scene == nullptr) {
        raise(L, std::string(function) + ": only the scene of an eye has this (rhexis.eye.create)");
    }
    return *scene;
}

// ---- stepping

int step(lua_State* L) {
    const long long count = lua_isnoneornil(L, 2) ? 1 : check_integer(L, 2, 0, 100'000'000);
    SceneBody& scene = check_scene(L, 1);
    for (long long k = 0; k < count; ++k) {
        const Status status = scene.step();
        if (!status) {
            lua_pushnil(L);
            push(L, std::string_view(status.error().text()));
            return 2;
        }
    }
    push(L, true);
    return 1;
}

int snapshot(lua_State* L) {
    push_snapshot(L, check_scene(L, 1).snapshot());
    return 1;
}

int restore(lua_State* L) {
    raise_if_failed(L, "restore", check_scene(L, 1).restore(check_snapshot(L, 2)));
    return 0;
}

int set(lua_State* L) {
    check_eye(L, "set").command({CommandKind::set, check_string(L, 2), check_number(L, 3), ""});
    return 0;
}

// ---- looking

int time(lua_State* L) {
    push(L, check_scene(L, 1).state().time_s);
    return 1;
}

int step_count(lua_State* L) {
    push(L, static_cast<long long>(check_scene(L, 1).steps()));
    return 1;
}

int state_hash(lua_State* L) {
    push(L, std::string_view(hex(check_scene(L, 1).state_hash())));
    return 1;
}

const char* partner_name(ContactPartner partner) {
    switch (partner) {
        case ContactPartner::tool:
            return "tool";
        case ContactPartner::bag:
            return "bag";
        case ContactPartner::plane:
            return "plane";
        case ContactPartner::dome:
            return "dome";
        case ContactPartner::support:
            return "support";
        case ContactPartner::tube:
            return "tube";
        case ContactPartner::layer:
            return "layer";
        case ContactPartner::sheet:
            return "sheet";
        case ContactPartner::jaws:
            return "jaws";
    }
    return "";
}

void push_contact(lua_State* L, const Contact& contact) {
    lua_newtable(L);
    if (contact.membrane >= 0) {
        set_field(L, "membrane", contact.membrane + 1);
    } else {
        set_field(L, "solid", contact.solid + 1);
    }
    set_field(L, "partner", partner_name(contact.partner));
    set_field(L, "partner_index", contact.partner_index + 1);
    set_field(L, "point", contact.point);
    set_field(L, "normal", contact.normal);
    set_field(L, "gap", contact.gap);
    set_field(L, "force", contact.force);
    set_field(L, "sliding", contact.sliding);
}

int contacts(lua_State* L) {
    const ContactSet& set = check_scene(L, 1).contacts();
    lua_createtable(L, static_cast<int>(set.size()), 0);
    for (std::size_t k = 0; k < set.size(); ++k) {
        push_contact(L, set[k]);
        lua_rawseti(L, -2, static_cast<lua_Integer>(k + 1));
    }
    return 1;
}

int energy(lua_State* L) {
    double kinetic = 0.0;
    double elastic = 0.0;
    for (const SolidStepReport& solid : check_scene(L, 1).outcome().solids) {
        kinetic += solid.kinetic_energy;
        elastic += solid.elastic_energy;
    }
    lua_newtable(L);
    set_field(L, "kinetic", kinetic);
    set_field(L, "elastic", elastic);
    return 1;
}

void push_solid_report(lua_State* L, const SolidStepReport& report) {
    lua_newtable(L);
    set_field(L, "advance", report.explicit_used ? "explicit" : "implicit");
    set_field(L, "substeps", report.substeps);
    set_field(L, "newton_iterations", report.newton_iterations);
    set_field(L, "solver_iterations", report.solver_iterations);
    set_field(L, "residual", report.residual);
    set_field(L, "stable_step", report.stable_step_s);
    set_field(L, "kinetic_energy", report.kinetic_energy);
    set_field(L, "elastic_energy", report.elastic_energy);
    set_field(L, "inverted", report.inverted);
}

void push_membrane_report(lua_State* L, const MembraneStepReport& report) {
    lua_newtable(L);
    set_field(L, "substeps", report.substeps);
    set_field(L, "newton_iterations", report.newton_iterations);
    set_field(L, "linear_iterations", report.linear_iterations);
    set_field(L, "force", report.force);
    set_field(L, "tears", static_cast<long long>(report.tears.size()));
}

int report(lua_State* L) {
    const StepOutcome& outcome = check_scene(L, 1).outcome();
    lua_newtable(L);
    set_field(L, "rollbacks", outcome.rollbacks);
    set_field(L, "notes", outcome.notes);
    lua_newtable(L);
    for (std::size_t k = 0; k < outcome.solids.size(); ++k) {
        push_solid_report(L, outcome.solids[k]);
        lua_rawseti(L, -2, static_cast<lua_Integer>(k + 1));
    }
    lua_setfield(L, -2, "solids");
    lua_newtable(L);
    for (std::size_t k = 0; k < outcome.membranes.size(); ++k) {
        push_membrane_report(L, outcome.membranes[k]);
        lua_rawseti(L, -2, static_cast<lua_Integer>(k + 1));
    }
    lua_setfield(L, -2, "membranes");
    return 1;
}

int crumb_mass(lua_State* L) {
    double sum = 0.0;
    for (const Debris& crumb : check_scene(L, 1).state().debris) {
        sum += crumb.volume * crumb.density;
    }
    push(L, sum);
    return 1;
}

int removed_mass(lua_State* L) {
    push(L, check_scene(L, 1).state().removed_mass);
    return 1;
}

// By name, or by number from 1.
template <typename Model>
int push_named_part(lua_State* L, const std::vector<Model>& models, const char* class_name, const char* kind) {
    if (lua_type(L, 2) == LUA_TNUMBER) {
        push_part(L, class_name, 1, check_number_of(L, 2, models.size()));
        return 1;
    }
    const std::string name = check_string(L, 2);
    std::vector<std::string> names;
    for (std::size_t k = 0; k < models.size(); ++k) {
        if (models[k].name == name) {
            push_part(L, class_name, 1, static_cast<int>(k));
            return 1;
        }
        names.push_back(models[k].name);
    }
    raise(L, "this scene has no " + std::string(kind) + " '" + name + "' (" + suggestion(name, names) + ")");
}

int membrane(lua_State* L) {
    return push_named_part(L, check_scene(L, 1).model().membranes, membrane_class, "membrane");
}

int solid(lua_State* L) { return push_named_part(L, check_scene(L, 1).model().solids, solid_class, "solid"); }
int tool(lua_State* L) { return push_named_part(L, check_scene(L, 1).model().tools, tool_class, "tool"); }

// "phaco.tip_depth_mm" as observation.phaco.tip_depth_mm.
int observation(lua_State* L) {
    const Session& session = *check_eye(L, "observation").session();
    nlohmann::json tree = nlohmann::json::object();
    for (std::size_t k = 0; k < session.schema().size(); ++k) {
        const MeasureInfo& measure = session.schema()[k];
        const double value = session.observation().values[k];
        const std::size_t dot = measure.name.find('.');
        nlohmann::json& group = tree[measure.name.substr(0, dot)];
        nlohmann::json& leaf = dot == std::string::npos ? group : group[measure.name.substr(dot + 1)];
        if (std::isfinite(value)) {
            leaf = measure.unit == "bool" ? nlohmann::json(value != 0.0) : nlohmann::json(value);
        }
    }
    push_json(L, tree);
    return 1;
}

int measures(lua_State* L) {
    const Session& session = *check_eye(L, "measures").session();
    lua_newtable(L);
    for (std::size_t k = 0; k < session.schema().size(); ++k) {
        lua_newtable(L);
        set_field(L, "name", std::string_view(session.schema()[k].name));
        set_field(L, "unit", std::string_view(session.schema()[k].unit));
        set_field(L, "meaning", std::string_view(session.schema()[k].meaning));
        lua_rawseti(L, -2, static_cast<lua_Integer>(k + 1));
    }
    return 1;
}

int anatomy(lua_State* L) {
    const EyeAnatomy& eye = check_eye(L, "anatomy").session()->eye().anatomy;
    lua_newtable(L);
    set_field(L, "cornea_apex_z", eye.cornea_apex_z);
    set_field(L, "cornea_radius", eye.cornea_radius);
    set_field(L, "limbus_radius", eye.limbus_radius);
    set_field(L, "limbus_z", eye.limbus_z);
    set_field(L, "iris_z", eye.iris_z);
    set_field(L, "pupil_radius", eye.pupil_radius);
    set_field(L, "anterior_chamber_depth", eye.anterior_chamber_depth);
    set_field(L, "incision", eye.incision);
    set_field(L, "incision_width", eye.incision_width);
    set_field(L, "side_port", eye.side_port);
    set_field(L, "side_port_width", eye.side_port_width);
    return 1;
}

}  // namespace

void push_scene_module(lua_State* L) {
    std::vector<luaL_Reg> methods = {{"step", guarded<step>},
                                     {"snapshot", guarded<snapshot>},
                                     {"restore", guarded<restore>},
                                     {"set", guarded<set>},
                                     {"time", guarded<time>},
                                     {"step_count", guarded<step_count>},
                                     {"state_hash", guarded<state_hash>},
                                     {"contacts", guarded<contacts>},
                                     {"energy", guarded<energy>},
                                     {"report", guarded<report>},
                                     {"crumb_mass", guarded<crumb_mass>},
                                     {"removed_mass", guarded<removed_mass>},
                                     {"solid", guarded<solid>},
                                     {"membrane", guarded<membrane>},
                                     {"tool", guarded<tool>},
                                     {"observation", guarded<observation>},
                                     {"measures", guarded<measures>},
                                     {"anatomy", guarded<anatomy>},
                                     {"close", guarded<close_scene>}};
    for (const luaL_Reg& adder : scene_adders()) {
        methods.push_back(adder);
    }
    define_class(L, scene_class, methods, {{"__gc", guarded<close_scene>}});
    define_class(L, snapshot_class, {{"close", guarded<close_snapshot>}}, {{"__gc", guarded<close_snapshot>}});
    define_solid_class(L);
    define_membrane_class(L);
    define_tool_class(L);
    push_library(L, scene_creators());
}

}  // namespace rhexis::lua
