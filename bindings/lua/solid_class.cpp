// SPDX-License-Identifier: GPL-3.0-or-later
// A deformable body of a scene, and a live view of its nodes.
#include <string>

#include "lua/bare_scene.hpp"
#include "lua/guard.hpp"
#include "lua/modules.hpp"
#include "lua/objects.hpp"
#include "lua/selection.hpp"
#include "lua/stack.hpp"

namespace rhexis::lua {
namespace {

struct SolidPart {
    SceneBody& scene;
    int index;
    const SolidModel& model;
    const SolidState& state;
};

SolidPart solid_of(const ScenePart& part) {
    const auto index = static_cast<std::size_t>(part.handle.index);
    return {part.scene, part.handle.index, part.scene.model().solids[index], part.scene.state().solids[index]};
}

SolidPart check_solid(lua_State* L) { return solid_of(check_part(L, 1, solid_class)); }

BareScene& check_own(lua_State* L, const char* function) {
    auto* scene = dynamic_cast<BareScene*>(&check_solid(L).scene);
    if (scene == nullptr) {
        raise(L, std::string(function) + ": not for the tissue of an eye, which only instruments change");
    }
    return *scene;
}

int name(lua_State* L) {
    push(L, std::string_view(check_solid(L).model.name));
    return 1;
}

int node_count(lua_State* L) {
    push(L, static_cast<long long>(check_solid(L).state.position.size()));
    return 1;
}

int tetrahedron_count(lua_State* L) {
    long long present = 0;
    for (const std::uint8_t one : check_solid(L).state.present) {
        present += one;
    }
    push(L, present);
    return 1;
}

int position(lua_State* L) {
    const SolidPart solid = check_solid(L);
    push(L, solid.state.position[static_cast<std::size_t>(check_number_of(L, 2, solid.state.position.size()))]);
    return 1;
}

int velocity(lua_State* L) {
    const SolidPart solid = check_solid(L);
    push(L, solid.state.velocity[static_cast<std::size_t>(check_number_of(L, 2, solid.state.velocity.size()))]);
    return 1;
}

int positions(lua_State* L) {
    const SolidPart solid = check_solid(L);
    lua_createtable(L, static_cast<int>(solid.state.position.size()), 0);
    for (std::size_t k = 0; k < solid.state.position.size(); ++k) {
        push(L, solid.state.position[k]);
        lua_rawseti(L, -2, static_cast<lua_Integer>(k + 1));
    }
    return 1;
}

// Mean place of the listed nodes, or of all.
int center(lua_State* L) {
    const std::vector<Vec3> points = check_solid(L).state.position;  // a copy: a selector runs script
    std::vector<int> nodes = read_selection(L, 2, points, "center");
    Vec3 sum = Vec3::Zero();
    if (lua_isnoneornil(L, 2)) {
        for (const Vec3& point : points) {
            sum += point;
        }
        push(L, Vec3(sum / static_cast<double>(points.size())));
        return 1;
    }
    if (nodes.empty()) {
        raise(L, "center: no node was selected");
    }
    for (const int node : nodes) {
        sum += points[static_cast<std::size_t>(node)];
    }
    push(L, Vec3(sum / static_cast<double>(nodes.size())));
    return 1;
}

int select(lua_State* L) {
    const std::vector<Vec3> points = check_solid(L).model.coarse.nodes;  // a copy: a selector runs script
    push_numbers(L, read_selection(L, 2, points, "select"));
    return 1;
}

double tet_mass(const SolidPart& solid, std::size_t t) {
    const TetMesh& mesh = solid.model.coarse;
    const std::array<int, 4>& n = mesh.tets[t];
    const auto at = [&](int k) { return mesh.nodes[static_cast<std::size_t>(n[static_cast<std::size_t>(k)])]; };
    const std::size_t region = mesh.region.empty() ? 0 : static_cast<std::size_t>(mesh.region[t]);
    return tet_volume(at(0), at(1), at(2), at(3)) * solid.model.materials[region].density *
           remaining_fraction(solid.model, solid.state, static_cast<int>(t));
}

int mass(lua_State* L) {
    const SolidPart solid = check_solid(L);
    double sum = 0.0;
    for (std::size_t t = 0; t < solid.model.coarse.tets.size(); ++t) {
        sum += tet_mass(solid, t);
    }
    push(L, sum);
    return 1;
}

int volume(lua_State* L) {
    const SolidPart solid = check_solid(L);
    TetMesh now;
    now.nodes = solid.state.position;
    for (std::size_t t = 0; t < solid.model.coarse.tets.size(); ++t) {
        if (solid.state.present[t] != 0) {
            now.tets.push_back(solid.model.coarse.tets[t]);
        }
    }
    push(L, mesh_volume(now));
    return 1;
}

int fraction(lua_State* L) {
    const SolidPart solid = check_solid(L);
    const int tet = check_number_of(L, 2, solid.model.coarse.tets.size());
    push(L, solid.state.present[static_cast<std::size_t>(tet)] == 0
                ? 0.0
                : remaining_fraction(solid.model, solid.state, tet));
    return 1;
}

int load(lua_State* L) {
    check_own(L, "load");
    const std::vector<Vec3> points = check_solid(L).model.coarse.nodes;
    NodeLoad load;
    load.nodes = read_selection(L, 2, points, "load");
    load.total = check_vec3(L, 3);
    load.solid = check_solid(L).index;
    if (load.nodes.empty()) {
        raise(L, "load: no node was selected");
    }
    check_own(L, "load").add_load(std::move(load));
    return 0;
}

int clear_loads(lua_State* L) {
    check_own(L, "clear_loads").clear_loads(check_solid(L).index);
    return 0;
}

std::vector<Vec3> centroids(const SolidPart& solid) {
    std::vector<Vec3> points;
    for (const std::array<int, 4>& tet : solid.model.coarse.tets) {
        Vec3 sum = Vec3::Zero();
        for (const int node : tet) {
            sum += solid.state.position[static_cast<std::size_t>(node)];
        }
        points.emplace_back(sum / 4.0);
    }
    return points;
}

int remove(lua_State* L) {
    check_own(L, "remove");
    const std::vector<Vec3> points = centroids(check_solid(L));
    const std::vector<int> tets = read_selection(L, 2, points, "remove");
    check_own(L, "remove").remove(check_solid(L).index, tets);
    push(L, static_cast<long long>(tets.size()));
    return 1;
}

int view(lua_State* L) {
    check_solid(L);
    lua_getiuservalue(L, 1, 1);
    push_part(L, view_class, -1, check_part(L, 1, solid_class).handle.index);
    return 1;
}

// ---- View

SolidPart check_view(lua_State* L) {
    const ScenePart part = check_part(L, 1, view_class);
    if (part.handle.revision != part.scene.revision()) {
        raise(L, "mesh changed: elements were removed since this view was made; take a new one with solid:view()");
    }
    return solid_of(part);
}

int view_index(lua_State* L) {
    const SolidPart solid = check_view(L);
    if (lua_isinteger(L, 2) == 0 || lua_tointeger(L, 2) < 1 ||
        lua_tointeger(L, 2) > static_cast<lua_Integer>(solid.state.position.size())) {
        raise(L, "a view has nodes 1 to " + std::to_string(solid.state.position.size()) + ", not " + describe(L, 2));
    }
    push(L, solid.state.position[static_cast<std::size_t>(lua_tointeger(L, 2) - 1)]);
    return 1;
}

int view_length(lua_State* L) {
    push(L, static_cast<long long>(check_view(L).state.position.size()));
    return 1;
}

}  // namespace

void define_solid_class(lua_State* L) {
    define_class(L, solid_class,
                 {{"name", guarded<name>},
                  {"node_count", guarded<node_count>},
                  {"tetrahedron_count", guarded<tetrahedron_count>},
                  {"position", guarded<position>},
                  {"velocity", guarded<velocity>},
                  {"positions", guarded<positions>},
                  {"center", guarded<center>},
                  {"select", guarded<select>},
                  {"mass", guarded<mass>},
                  {"volume", guarded<volume>},
                  {"fraction", guarded<fraction>},
                  {"load", guarded<load>},
                  {"clear_loads", guarded<clear_loads>},
                  {"remove", guarded<remove>},
                  {"view", guarded<view>}},
                 {});
    define_class(L, view_class, {}, {{"__index", guarded<view_index>}, {"__len", guarded<view_length>}});
}

}  // namespace rhexis::lua
