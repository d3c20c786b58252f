// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/bodies.hpp"

#include <fstream>
#include <utility>

#include "eye/make_eye.hpp"
#include "mesh/io.hpp"
#include "mesh/shapes.hpp"

namespace rhexis::scenes {

Result<std::vector<int>> read_nodes(const std::string& path, std::size_t node_count) {
    std::ifstream file(path);
    std::vector<int> nodes;
    for (int node = 0; file >> node;) {
        if (node < 0 || static_cast<std::size_t>(node) >= node_count) {
            return Error{"lists node " + std::to_string(node), path, "a node of the mesh"};
        }
        nodes.push_back(node);
    }
    if (nodes.empty()) {
        return Error{"lists no nodes", path, "node indices"};
    }
    return nodes;
}

SolidModel body(const std::string& name, TetMesh mesh, double young_modulus, double poisson_ratio) {
    SolidModel solid;
    solid.name = name;
    solid.coarse = std::move(mesh);
    solid.fine = subdivide(solid.coarse);
    Material material;
    material.name = "tissue";
    material.young_modulus = young_modulus;
    material.poisson_ratio = poisson_ratio;
    material.ablation_energy = 30.0;
    solid.materials = {material};
    return solid;
}

SolidModel clamped_bar(int nx, int ny, int nz, double cell, double young_modulus, double poisson_ratio) {
    SolidModel solid = body("bar", bar(nx, ny, nz, cell), young_modulus, poisson_ratio);
    solid.fixed_nodes = nodes_on_plane(solid.coarse, Vec3::Zero(), Vec3::UnitX());
    return solid;
}

SolidModel cube(int cells, double edge, double young_modulus, double poisson_ratio) {
    return body("cube", bar(cells, cells, cells, edge / cells, Vec3::Constant(-0.5 * edge)), young_modulus,
                poisson_ratio);
}

SolidModel ball_body(double radius, int tetrahedra, double young_modulus, double poisson_ratio) {
    return body("ball", ball(radius, tetrahedra), young_modulus, poisson_ratio);
}

EyeModel default_eye(int tetrahedra) {
    Patient patient;
    patient.tetrahedra = tetrahedra;
    return make_eye(patient).value();
}

Result<ReferenceCase> reference_case(const std::string& name, const std::string& folder) {
    const std::string base = folder + "/tests/data/meshes/" + name;
    Result<MeshFile> file = read_tet_mesh(base + ".vtk");
    if (!file.ok()) {
        return file.error();
    }
    ReferenceCase result;
    result.solid = body(name, std::move(file.value().mesh), 5000.0, 0.45);
    result.solid.damping_mass = 0.1;
    result.solid.damping_stiffness = 0.01;
    result.load = Vec3(0.0, 0.0, -5000.0);
    result.gravity = Vec3(0.0, 0.0, -9810.0);
    const std::pair<const char*, std::vector<int>*> lists[] = {{".fixed.txt", &result.solid.fixed_nodes},
                                                               {".poke.txt", &result.poke_nodes}};
    for (const auto& [ending, nodes] : lists) {
        const Result<std::vector<int>> read = read_nodes(base + ending, result.solid.coarse.nodes.size());
        if (!read.ok()) {
            return read.error();
        }
        *nodes = read.value();
    }
    return result;
}

}  // namespace rhexis::scenes
