// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis.mesh: tetrahedral meshes and triangle sheets to build, read, measure and write.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "eye/anatomy.hpp"
#include "lua/guard.hpp"
#include "lua/modules.hpp"
#include "lua/objects.hpp"
#include "lua/selection.hpp"
#include "lua/stack.hpp"
#include "mesh/io.hpp"
#include "mesh/quality.hpp"
#include "mesh/shapes.hpp"

namespace rhexis::lua {
namespace {

constexpr long long max_cells = 200;  // along one side of a bar

int mesh_bar(lua_State* L) {
    Options options(L, 1, "rhexis.mesh.bar");
    std::array<int, 3> cells{8, 2, 2};
    const Vec3 given = options.vec3("cells", Vec3(8, 2, 2));
    for (int k = 0; k < 3; ++k) {
        if (given[k] != std::floor(given[k]) || given[k] < 1 || given[k] > max_cells) {
            options.push_field("cells");
            options.fail("cells", "allowed: three whole numbers from 1 to 200");
        }
        cells[static_cast<std::size_t>(k)] = static_cast<int>(given[k]);
    }
    const double cell = options.number("cell", 1.0, {0.001, 1000.0, "mm"});
    const Vec3 origin = options.vec3("origin", Vec3::Zero());
    options.finish();
    if (given.prod() > 200000.0) {
        raise(L, "rhexis.mesh.bar: too many cells: allowed: 200000 in all");
    }
    push_mesh(L, bar(cells[0], cells[1], cells[2], cell, origin));
    return 1;
}

int mesh_ball(lua_State* L) {
    Options options(L, 1, "rhexis.mesh.ball");
    const double radius = options.number("radius", 2.0, {0.001, 1000.0, "mm"});
    const long long tetrahedra = options.integer("tetrahedra", 1000, 300, 100000);
    options.finish();
    push_mesh(L, ball(radius, static_cast<int>(tetrahedra)));
    return 1;
}

int mesh_lens(lua_State* L) {
    Options options(L, 1, "rhexis.mesh.lens");
    Patient patient;
    patient.age = options.number("age", patient.age, {20.0, 95.0, "years"});
    HalfEllipsoids shape = lens_shape(patient);
    shape.radius = options.number("radius", shape.radius, {1.0, 10.0, "mm"});
    shape.anterior = options.number("anterior", shape.anterior, {0.3, 10.0, "mm"});
    shape.posterior = options.number("posterior", shape.posterior, {0.3, 10.0, "mm"});
    const long long tetrahedra = options.integer("tetrahedra", 3000, 300, 100000);
    options.finish();
    push_mesh(L, lens_body(shape, static_cast<int>(tetrahedra)));
    return 1;
}

int mesh_read(lua_State* L) {
    Result<MeshFile> file = read_tet_mesh(check_string(L, 1));
    if (!file) {
        raise(L, "rhexis.mesh.read: " + file.error().text());
    }
    if (const int unused = file.value().nodes_of_no_cell; unused > 0) {
        std::fprintf(stderr, "rhexis: %s: %d %s of no element %s left out\n", check_string(L, 1).c_str(), unused,
                     unused == 1 ? "node" : "nodes", unused == 1 ? "is" : "are");
    }
    push_mesh(L, std::move(file.value().mesh));
    return 1;
}

int mesh_sheet(lua_State* L) {
    Options options(L, 1, "rhexis.mesh.sheet");
    const std::string shape = options.choice("shape", "square", {"square", "round"});
    const double size = options.number("size", 10.0, {0.001, 1000.0, "mm"});
    const long long triangles = options.integer("triangles", 1500, 8, 100000);
    const double jitter = options.number("jitter", 0.0, {0.0, 0.3});
    const long long seed = options.integer("seed", 1, 0, 1000000000);
    options.finish();
    TriMesh sheet = shape == "square" ? square_sheet(size, static_cast<int>(triangles))
                                      : round_sheet(0.5 * size, static_cast<int>(triangles));
    push_sheet(L, jitter > 0.0 ? jittered(std::move(sheet), jitter, static_cast<std::uint64_t>(seed)) : sheet);
    return 1;
}

int mesh_read_sheet(lua_State* L) {
    Result<TriMesh> sheet = read_tri_mesh(check_string(L, 1));
    if (!sheet) {
        raise(L, "rhexis.mesh.read_sheet: " + sheet.error().text());
    }
    push_sheet(L, std::move(sheet).value());
    return 1;
}

int sheet_info(lua_State* L) {
    const TriMesh& sheet = check_sheet(L, 1);
    lua_newtable(L);
    set_field(L, "nodes", static_cast<long long>(sheet.nodes.size()));
    set_field(L, "triangles", static_cast<long long>(sheet.triangles.size()));
    set_field(L, "area", mesh_area(sheet));
    set_field(L, "mean_edge", mean_edge(sheet));
    set_field(L, "smallest_angle", smallest_angle(sheet) * 180.0 / M_PI);
    return 1;
}

int sheet_node(lua_State* L) {
    const TriMesh& sheet = check_sheet(L, 1);
    push(L, sheet.nodes[static_cast<std::size_t>(check_number_of(L, 2, sheet.nodes.size()))]);
    return 1;
}

int sheet_select(lua_State* L) {
    const std::vector<Vec3> nodes = check_sheet(L, 1).nodes;  // a copy: the script's function may close the sheet
    push_numbers(L, read_selection(L, 2, nodes, "select"));
    return 1;
}

int write(lua_State* L) {
    const TetMesh& mesh = check_mesh(L, 1);
    raise_if_failed(L, "write", write_tet_mesh(mesh, check_string(L, 2)));
    return 0;
}

int info(lua_State* L) {
    const TetMesh& mesh = check_mesh(L, 1);
    const MeshQuality quality = mesh_quality(mesh);
    lua_newtable(L);
    set_field(L, "nodes", static_cast<long long>(mesh.nodes.size()));
    set_field(L, "tetrahedra", static_cast<long long>(mesh.tets.size()));
    set_field(L, "volume", quality.volume);
    set_field(L, "min_ratio", quality.min_ratio);
    set_field(L, "mean_ratio", quality.mean_ratio);
    set_field(L, "min_height", quality.min_height);
    set_field(L, "worst", quality.worst + 1);
    return 1;
}

int node(lua_State* L) {
    const TetMesh& mesh = check_mesh(L, 1);
    push(L, mesh.nodes[static_cast<std::size_t>(check_number_of(L, 2, mesh.nodes.size()))]);
    return 1;
}

int tetrahedron(lua_State* L) {
    const TetMesh& mesh = check_mesh(L, 1);
    const std::array<int, 4>& tet = mesh.tets[static_cast<std::size_t>(check_number_of(L, 2, mesh.tets.size()))];
    push_numbers(L, {tet.begin(), tet.end()});
    return 1;
}

int select(lua_State* L) {
    const std::vector<Vec3> nodes = check_mesh(L, 1).nodes;  // a copy: the script's function may close the mesh
    push_numbers(L, read_selection(L, 2, nodes, "select"));
    return 1;
}

}  // namespace

void push_mesh_module(lua_State* L) {
    define_class(L, mesh_class,
                 {{"write", guarded<write>},
                  {"info", guarded<info>},
                  {"node", guarded<node>},
                  {"tetrahedron", guarded<tetrahedron>},
                  {"select", guarded<select>},
                  {"close", guarded<close_mesh>}},
                 {{"__gc", guarded<close_mesh>}});
    define_class(L, sheet_class,
                 {{"info", guarded<sheet_info>},
                  {"node", guarded<sheet_node>},
                  {"select", guarded<sheet_select>},
                  {"close", guarded<close_sheet>}},
                 {{"__gc", guarded<close_sheet>}});
    push_library(L, {{"bar", guarded<mesh_bar>},
                     {"ball", guarded<mesh_ball>},
                     {"lens", guarded<mesh_lens>},
                     {"read", guarded<mesh_read>},
                     {"sheet", guarded<mesh_sheet>},
                     {"read_sheet", guarded<mesh_read_sheet>}});
}

}  // namespace rhexis::lua
