// SPDX-License-Identifier: GPL-3.0-or-later
// A thin sheet of a scene: where it is, what pulls at it, and its tears.
#include <algorithm>
#include <string>

#include "base/index.hpp"
#include "lua/bare_scene.hpp"
#include "lua/guard.hpp"
#include "lua/modules.hpp"
#include "lua/objects.hpp"
#include "lua/selection.hpp"
#include "lua/stack.hpp"
#include "physics/membrane/membrane_body.hpp"

namespace rhexis::lua {
namespace {

struct MembranePart {
    SceneBody& scene;
    int index;
    const MembraneModel& model;
    const MembraneState& state;
};

MembranePart check_membrane_part(lua_State* L) {
    const ScenePart part = check_part(L, 1, membrane_class);
    return {part.scene, part.handle.index, part.scene.model().membranes[at(part.handle.index)],
            part.scene.state().membranes[at(part.handle.index)]};
}

BareScene& check_own(lua_State* L, const char* function) {
    auto* scene = dynamic_cast<BareScene*>(&check_membrane_part(L).scene);
    if (scene == nullptr) {
        raise(L, std::string(function) + ": not for the tissue of an eye, which only instruments change");
    }
    return *scene;
}

/// Nodes meant by the argument at 2, by where they are at rest; at least one.
std::vector<int> check_nodes(lua_State* L, const char* function) {
    const std::vector<Vec3> points = check_membrane_part(L).state.sheet->mesh.nodes;  // a copy: a selector runs script
    std::vector<int> nodes = read_selection(L, 2, points, function);
    if (nodes.empty()) {
        raise(L, std::string(function) + ": no node was selected");
    }
    return nodes;
}

int name(lua_State* L) {
    push(L, std::string_view(check_membrane_part(L).model.name));
    return 1;
}

int node_count(lua_State* L) {
    push(L, static_cast<long long>(check_membrane_part(L).state.position.size()));
    return 1;
}

int triangle_count(lua_State* L) {
    push(L, static_cast<long long>(check_membrane_part(L).state.sheet->mesh.triangles.size()));
    return 1;
}

int position(lua_State* L) {
    const MembranePart membrane = check_membrane_part(L);
    push(L, membrane.state.position[at(check_number_of(L, 2, membrane.state.position.size()))]);
    return 1;
}

int rest_position(lua_State* L) {
    const MembranePart membrane = check_membrane_part(L);
    push(L, membrane.state.sheet->mesh.nodes[at(check_number_of(L, 2, membrane.state.position.size()))]);
    return 1;
}

int center(lua_State* L) {
    const std::vector<int> nodes = check_nodes(L, "center");
    const MembranePart membrane = check_membrane_part(L);
    Vec3 sum = Vec3::Zero();
    for (const int node : nodes) {
        sum += membrane.state.position[at(node)];
    }
    push(L, Vec3(sum / static_cast<double>(nodes.size())));
    return 1;
}

int select(lua_State* L) {
    const std::vector<Vec3> points = check_membrane_part(L).state.sheet->mesh.nodes;
    push_numbers(L, read_selection(L, 2, points, "select"));
    return 1;
}

int load(lua_State* L) {
    check_own(L, "load");
    SheetLoad load;
    load.nodes = check_nodes(L, "load");
    load.total = check_vec3(L, 3);
    check_own(L, "load").membrane(check_membrane_part(L).index).loads.push_back(std::move(load));
    return 0;
}

int clear_loads(lua_State* L) {
    check_own(L, "clear_loads").membrane(check_membrane_part(L).index).loads.clear();
    return 0;
}

int move(lua_State* L) {
    check_own(L, "move");
    const std::vector<int> nodes = check_nodes(L, "move");
    const Vec3 by = check_vec3(L, 3);
    const MembranePart membrane = check_membrane_part(L);
    for (const int node : nodes) {
        if (!is_fixed(membrane.model, *membrane.state.sheet, node)) {
            raise(L, "move: node " + std::to_string(node + 1) + " is free: allowed: fixed nodes");
        }
    }
    MembraneState& state = check_own(L, "move").membrane(membrane.index);
    for (const int node : nodes) {
        state.position[at(node)] += by;
    }
    return 0;
}

/// Force of the sheet on what holds the nodes.
int force(lua_State* L) {
    const std::vector<int> nodes = check_nodes(L, "force");
    const MembranePart membrane = check_membrane_part(L);
    push(L, elastic_force(membrane.model, membrane.state, nodes));
    return 1;
}

int energy(lua_State* L) {
    const MembranePart membrane = check_membrane_part(L);
    push(L, elastic_energy(membrane.model, membrane.state));
    return 1;
}

int puncture(lua_State* L) {
    check_own(L, "puncture");
    const Vec3 place = check_vec3(L, 2);
    const Vec3 direction = check_vec3(L, 3);
    const MembranePart membrane = check_membrane_part(L);
    const int nearest = nearest_triangle(membrane.state.sheet->mesh, place);
    raise_if_failed(L, "puncture", check_own(L, "puncture").puncture(membrane.index, nearest, place, direction));
    return 0;
}

int tips(lua_State* L) {
    const MembranePart membrane = check_membrane_part(L);
    lua_createtable(L, static_cast<int>(membrane.state.tips.size()), 0);
    for (std::size_t i = 0; i < membrane.state.tips.size(); ++i) {
        const TearTip& tip = membrane.state.tips[i];
        lua_newtable(L);
        push(L, membrane.state.sheet->mesh.nodes[at(tip.node)]);
        lua_setfield(L, -2, "rest");
        push(L, membrane.state.position[at(tip.node)]);
        lua_setfield(L, -2, "position");
        push(L, tip.direction);
        lua_setfield(L, -2, "direction");
        lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
    }
    return 1;
}

int torn(lua_State* L) {
    const MembranePart membrane = check_membrane_part(L);
    lua_newtable(L);
    set_field(L, "area", membrane.state.torn_area);
    set_field(L, "energy", membrane.state.torn_energy);
    return 1;
}

}  // namespace

void define_membrane_class(lua_State* L) {
    define_class(L, membrane_class,
                 {{"name", guarded<name>},
                  {"node_count", guarded<node_count>},
                  {"triangle_count", guarded<triangle_count>},
                  {"position", guarded<position>},
                  {"rest_position", guarded<rest_position>},
                  {"center", guarded<center>},
                  {"select", guarded<select>},
                  {"load", guarded<load>},
                  {"clear_loads", guarded<clear_loads>},
                  {"move", guarded<move>},
                  {"force", guarded<force>},
                  {"energy", guarded<energy>},
                  {"puncture", guarded<puncture>},
                  {"tips", guarded<tips>},
                  {"torn", guarded<torn>}},
                 {});
}

}  // namespace rhexis::lua
