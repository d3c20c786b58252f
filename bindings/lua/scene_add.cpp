// SPDX-License-Identifier: GPL-3.0-or-later
// Making a scene and adding bodies, tools and planes to it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "lua/bare_scene.hpp"
#include "lua/guard.hpp"
#include "lua/modules.hpp"
#include "lua/objects.hpp"
#include "lua/pose.hpp"
#include "lua/selection.hpp"
#include "lua/stack.hpp"
#include "tools/instruments.hpp"

namespace rhexis::lua {
namespace {

int scene_create(lua_State* L) {
    Options options(L, 1, "rhexis.scene.create");
    const double step_s = options.number("step", 0.01, {1e-5, 0.1, "s"});
    const Vec3 gravity = options.vec3("gravity", Vec3(0.0, 0.0, -9810.0));
    PhysicsSettings settings;
    settings.threads = static_cast<int>(options.integer("threads", 1, 1, 64));
    settings.instruction_set = options.choice("instruction_set", "best", {"best", "baseline", "avx2", "avx512"});
    settings.tolerance = options.number("tolerance", settings.tolerance, {1e-14, 1e-2});
    options.finish();
    if (settings.instruction_set == "best") {
        settings.instruction_set.clear();
    }
    push_scene(L, std::make_unique<BareScene>(step_s, gravity, settings));
    return 1;
}

// The scene at 1 as one that a script may add to.
BareScene& check_bare(lua_State* L, const char* function) {
    auto* scene = dynamic_cast<BareScene*>(&check_scene(L, 1));
    if (scene == nullptr) {
        raise(L, std::string(function) + ": not for the scene of an eye, whose bodies the patient gives");
    }
    return *scene;
}

Material read_material(Options& options) {
    Material material;
    material.young_modulus = options.number("young_modulus", 1000.0, {0.0, 1e9, "Pa", true});
    material.poisson_ratio = options.number("poisson_ratio", 0.45, {0.0, 0.499});
    material.density = options.number("density", 1.05e-3, {0.0, 0.1, "g/mm^3", true});
    material.ablation_energy = options.number("ablation_energy", 0.0, {0.0, 1e6, "mJ/mm^3"});
    material.extinction = options.vec3("extinction", Vec3(0.05, 0.1, 0.2));
    return material;
}

Advance read_advance(Options& options) {
    const std::string word = options.choice("advance", "automatic", {"automatic", "explicit", "implicit"});
    return word == "explicit" ? Advance::explicit_ : word == "implicit" ? Advance::implicit : Advance::automatic;
}

/// How its elements are made and how they go on in time; not every pair of the two exists.
void read_way(Options& options, SolidModel& model) {
    model.advance = read_advance(options);
    // What locks least of what the way can step.
    const char* usual = model.advance == Advance::explicit_ ? "nodal_pressure" : "edge_smoothed";
    const std::string word = options.choice("formulation", usual, {"linear", "nodal_pressure", "edge_smoothed"});
    if (word == "nodal_pressure" && model.advance == Advance::implicit) {
        options.fail("formulation",
                     "nodal_pressure goes with advance \"explicit\"; with \"implicit\": edge_smoothed or linear");
    }
    if (word == "edge_smoothed" && model.advance == Advance::explicit_) {
        options.fail("formulation",
                     "edge_smoothed goes with advance \"implicit\"; with \"explicit\": nodal_pressure or linear");
    }
    // Elements that one way alone can step decide on the way.
    if (word == "nodal_pressure") {
        model.formulation = Formulation::nodal_pressure;
        model.advance = Advance::explicit_;
    } else if (word == "edge_smoothed") {
        model.formulation = Formulation::edge_smoothed;
        model.advance = Advance::implicit;
    }
}

TetMesh read_mesh_option(lua_State* L, Options& options) {
    if (options.push_field("mesh") == LUA_TNIL) {
        options.fail("mesh", "allowed: a mesh from rhexis.mesh");
    }
    TetMesh mesh = check_mesh(L, -1);
    lua_pop(L, 1);
    const Vec3 origin = options.vec3("origin", Vec3::Zero());
    for (Vec3& node : mesh.nodes) {
        node += origin;
    }
    return mesh;
}

/// Once per scene, when there are two that could meet: nothing makes them.
void tell_passing(const BareScene& scene, const char* function, const std::string& name) {
    const WorldModel& model = scene.model();
    if (model.solids.size() + model.membranes.size() == 1) {
        const std::string& other = model.solids.empty() ? model.membranes[0].name : model.solids[0].name;
        std::fprintf(
            stderr, "rhexis: %s: '%s' and '%s' pass through each other: bodies and sheets meet tools and planes only\n",
            function, name.c_str(), other.c_str());
    }
}

int add_solid(lua_State* L) {
    check_bare(L, "add_solid");
    Options options(L, 2, "add_solid");
    SolidModel model;
    model.name = options.string("name", "solid");
    model.coarse = read_mesh_option(L, options);
    const Material material = read_material(options);
    model.materials.assign(
        model.coarse.region.empty()
            ? 1
            : 1 + static_cast<std::size_t>(*std::max_element(model.coarse.region.begin(), model.coarse.region.end())),
        material);
    model.damping_mass = options.number("damping_mass", 0.0, {0.0, 1e4, "1/s"});
    model.damping_stiffness = options.number("damping_stiffness", 0.0, {0.0, 10.0, "s"});
    model.buoyancy_density = options.number("buoyancy_density", 0.0, {0.0, 0.1, "g/mm^3"});
    read_way(options, model);
    const Vec3 velocity = options.vec3("velocity", Vec3::Zero());
    if (options.boolean("fine", true)) {
        model.fine = subdivide(model.coarse);
    }
    options.push_field("fixed");
    model.fixed_nodes = read_some(L, -1, model.coarse.nodes, "add_solid: fixed");
    options.finish();
    tell_passing(check_bare(L, "add_solid"), "add_solid", model.name);
    const int index = check_bare(L, "add_solid").add_solid(std::move(model), velocity);
    push_part(L, solid_class, 1, index);
    return 1;
}

TriMesh read_sheet_option(lua_State* L, Options& options) {
    if (options.push_field("sheet") == LUA_TNIL) {
        options.fail("sheet", "allowed: a sheet from rhexis.mesh");
    }
    TriMesh sheet = check_sheet(L, -1);
    lua_pop(L, 1);
    return sheet;
}

Orthotropic read_orthotropic(Options& options) {
    Orthotropic material;
    material.along = options.number("along", material.along, {0.0, 1e12, "Pa", true});
    material.across = options.number("across", material.along, {0.0, 1e12, "Pa", true});
    material.poisson_ratio = options.number("poisson_ratio", material.poisson_ratio, {-1.0, 10.0});
    material.shear_modulus = options.number("shear_modulus", 0.0, {0.0, 1e12, "Pa"});
    return material;
}

// Fibres all one way, or in circles about the z axis.
MembraneSheet with_fibres(TriMesh mesh, bool circles, const Vec3& fibre, double thickness) {
    MembraneSheet sheet = uniform_sheet(std::move(mesh), circles ? Vec3(Vec3::UnitX()) : fibre, thickness);
    for (std::size_t t = 0; circles && t < sheet.fibre.size(); ++t) {
        const Vec3 front = front_of(sheet.mesh, static_cast<int>(t));
        const Vec3 round = Vec3::UnitZ().cross(triangle_middle(sheet.mesh, static_cast<int>(t)));
        if (round.norm() > 1e-9) {
            sheet.fibre[t] = (round - round.dot(front) * front).normalized();
        }
    }
    return sheet;
}

int add_membrane(lua_State* L) {
    check_bare(L, "add_membrane");
    Options options(L, 2, "add_membrane");
    MembraneModel model;
    model.name = options.string("name", "membrane");
    TriMesh mesh = read_sheet_option(L, options);
    const std::vector<Vec3> nodes = mesh.nodes;
    model.material = read_orthotropic(options);
    const bool circles = options.choice("fibres", "straight", {"straight", "circles"}) == "circles";
    const Vec3 fibre = options.vec3("fibre", Vec3::UnitX());
    const double thickness = options.number("thickness", 0.015, {1e-5, 10.0, "mm"});
    model.sheet = std::make_shared<const MembraneSheet>(with_fibres(std::move(mesh), circles, fibre, thickness));
    model.toughness.along = options.number("toughness_along", model.toughness.along, {1e-3, 1e12, "mJ/m^2"});
    model.toughness.across = options.number("toughness_across", model.toughness.along, {1e-3, 1e12, "mJ/m^2"});
    model.tear_radius = options.number("tear_radius", model.tear_radius, {1e-4, 100.0, "mm"});
    const double turn = options.number("sharpest_turn", 90.0, {0.0, 180.0, "degrees"});
    model.turn_cosine = turn == 90.0 ? 0.0 : std::cos(turn * M_PI / 180.0);
    model.density = options.number("density", model.density, {1e-7, 1.0, "g/mm^3"});
    model.buoyancy_density = options.number("buoyancy_density", 0.0, {0.0, 1.0, "g/mm^3"});
    model.damping_mass = options.number("damping_mass", 0.0, {0.0, 1e6, "1/s"});
    model.damping_stiffness = options.number("damping_stiffness", 0.0, {0.0, 10.0, "s"});
    TearRules rules;
    rules.existing_edges = options.boolean("existing_edges", false);
    options.push_field("fixed");
    model.fixed_nodes = read_some(L, -1, nodes, "add_membrane: fixed");
    options.finish();
    if (Status status = check_membrane(model); !status) {
        raise(L, "add_membrane: " + status.error().text());
    }
    tell_passing(check_bare(L, "add_membrane"), "add_membrane", model.name);
    const int index = check_bare(L, "add_membrane").add_membrane(std::move(model), rules);
    push_part(L, membrane_class, 1, index);
    return 1;
}

int add_tool(lua_State* L, const char* function, ToolModel model, Options& options) {
    model.friction = options.number("friction", model.friction, {0.0, 2.0});
    model.name = options.string("name", model.name);
    Pose pose;
    read_pose(L, options, pose);
    options.finish();
    const int index = check_bare(L, function).add_tool(std::move(model), pose);
    push_part(L, tool_class, 1, index);
    return 1;
}

int add_ball(lua_State* L) {
    check_bare(L, "add_ball");
    Options options(L, 2, "add_ball");
    const double radius = options.number("radius", 0.5, {0.001, 100.0, "mm"});
    ToolModel model;
    model.name = "ball";
    model.parts = {{Vec3::Zero(), Vec3::Zero(), radius, radius}};
    return add_tool(L, "add_ball", std::move(model), options);
}

int add_rod(lua_State* L) {
    check_bare(L, "add_rod");
    Options options(L, 2, "add_rod");
    const double radius = options.number("radius", 0.5, {0.001, 100.0, "mm"});
    const double shaft = options.number("shaft_radius", radius, {0.001, 100.0, "mm"});
    const double length = options.number("length", 10.0, {0.001, 1000.0, "mm"});
    ToolModel model;
    model.name = "rod";
    model.parts = {{Vec3::Zero(), Vec3(0.0, 0.0, length), radius, shaft}};
    return add_tool(L, "add_rod", std::move(model), options);
}

int add_phaco(lua_State* L) {
    check_bare(L, "add_phaco");
    Options options(L, 2, "add_phaco");
    Result<ToolModel> model = make_tool("phaco");
    if (!model) {
        raise(L, "add_phaco: " + model.error().text());
    }
    return add_tool(L, "add_phaco", std::move(model).value(), options);
}

int add_plane(lua_State* L) {
    check_bare(L, "add_plane");
    Options options(L, 2, "add_plane");
    PlaneModel plane;
    plane.point = options.vec3("point", plane.point);
    plane.normal = options.vec3("normal", plane.normal);
    plane.friction = options.number("friction", plane.friction, {0.0, 2.0});
    options.finish();
    if (plane.normal.norm() < 1e-9) {
        raise(L, "add_plane: normal has no length");
    }
    plane.normal.normalize();
    check_bare(L, "add_plane").add_plane(plane);
    return 0;
}

}  // namespace

std::vector<luaL_Reg> scene_creators() { return {{"create", guarded<scene_create>}}; }

std::vector<luaL_Reg> scene_adders() {
    return {{"add_solid", guarded<add_solid>}, {"add_membrane", guarded<add_membrane>},
            {"add_ball", guarded<add_ball>},   {"add_rod", guarded<add_rod>},
            {"add_phaco", guarded<add_phaco>}, {"add_plane", guarded<add_plane>}};
}

}  // namespace rhexis::lua
