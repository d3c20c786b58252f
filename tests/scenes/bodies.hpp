// SPDX-License-Identifier: GPL-3.0-or-later
// Solids that tests and benchmarks share.
#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "flow/eye_model.hpp"
#include "flow/solid.hpp"

namespace rhexis::scenes {

/// The numbers in a text file of node indices.
Result<std::vector<int>> read_nodes(const std::string& path, std::size_t node_count);

/// A body of one material: fine mesh, no damping, no fixed nodes, no buoyancy.
SolidModel body(const std::string& name, TetMesh mesh, double young_modulus, double poisson_ratio);

/// A bar of nx * ny * nz cubic cells (5 tetrahedra each) from the origin along +x, clamped at x = 0.
/// The bar of the bending table: 4 x 1 x 1 mm, n cells across: bar(4 n, n, n, 1.0 / n, 3000, nu).
SolidModel clamped_bar(int nx, int ny, int nz, double cell, double young_modulus, double poisson_ratio);

/// A free cube of `cells`^3 cells and edge `edge` [mm] centred on the origin.
SolidModel cube(int cells, double edge, double young_modulus, double poisson_ratio);

/// A free ball about the origin.
SolidModel ball_body(double radius, int tetrahedra, double young_modulus, double poisson_ratio);

/// The default patient's eye, its lens with about that many tetrahedra.
EyeModel default_eye(int tetrahedra = 3000);

/// A reference mesh and its load case (tests/data/meshes/README.md).
struct ReferenceCase {
    SolidModel solid;             ///< rim fixed; E, nu, density and damping of the load case
    std::vector<int> poke_nodes;  ///< that share the load
    Vec3 load = Vec3::Zero();     ///< total over the poke nodes [uN]
    Vec3 gravity = Vec3::Zero();  ///< [mm/s^2]
    double step_s = 0.01;
    double load_period_s = 0.5;  ///< timed runs: load * (1 - cos(2 pi t / period)) / 2
    int warm_up_steps = 100;
    int measured_steps = 400;
};

/// name: "lens_3000" or "lens_12000". Reads <folder>/tests/data/meshes; folder: the source tree.
Result<ReferenceCase> reference_case(const std::string& name, const std::string& folder = ".");

}  // namespace rhexis::scenes
