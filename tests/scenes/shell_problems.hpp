// SPDX-License-Identifier: GPL-3.0-or-later
// Reference problems of thin shells through large rotations [Sze2004], as meshes of any fineness with their loads and
// what is known of the answer. Units are those of the sources; any coherent ones serve.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "flow/shell.hpp"

namespace rhexis::scenes {

struct ShellProblem {
    std::string name;
    ShellModel model;
    ShellLoad load;  ///< at factor 1
    std::function<std::array<double, 2>(const ShellState&)> measure;
    struct Row {
        double factor;
        std::array<double, 2> measure;
    };
    std::vector<Row> reference;
};

/// Cells of a grid over the unit square, moved by a map: node (i, j) is i + (nx + 1) j.
enum class GridCut {
    alternate,  ///< two triangles to a cell, diagonals in turn
    crossed,    ///< four triangles about the cell's middle
    one_way,    ///< two triangles to a cell, diagonals all the same
};
TriMesh grid_mesh(int nx, int ny, GridCut cut, const std::function<Vec3(double, double)>& map);

/// Strip of 10 by 1 by 0.1 clamped at one end, a force of 4 across the other; measures: -U, W of the free end.
/// Reference: the elastica, by shooting.
ShellProblem cantilever_shear(int length, int width, GridCut cut = GridCut::alternate);
/// Strip of 12 by 1 by 0.1 bent by an end moment to a full circle; measures as above. Reference: closed form.
ShellProblem cantilever_moment(int length, int width, GridCut cut = GridCut::alternate);
/// Flat ring, slit and clamped along one lip, the other lifted by a line force; W of the inner and the outer end.
ShellProblem slit_ring(int around, int across, GridCut cut = GridCut::alternate);
/// A quarter of a hemisphere with a hole of 18 degrees, pulled along x and pushed along y; outward and inward.
ShellProblem open_hemisphere(int around, int up, GridCut cut = GridCut::alternate);
/// An eighth of a cylinder between diaphragms, pinched; -W under the force, U at its side.
ShellProblem pinched_cylinder(int around, int along, GridCut cut = GridCut::alternate);
/// A quarter of a hinged cylindrical roof of thickness 12.7 or 6.35 under a central force; W there, twice. Reference of
/// 12.7: load factor at the limit points only.
ShellProblem hinged_roof(int each_way, double thickness, GridCut cut = GridCut::alternate);
/// An eighth of a cylinder with open ends, pulled apart at the middle [Sze2004]: on the way its wall goes over from
/// bending to stretching and snaps. At full load 40 mN in all; outward where it is pulled, inward at the side.
ShellProblem pulled_cylinder(int around, int along, GridCut cut = GridCut::alternate);

/// Square plate of side 1 and thickness 0.01, clamped all around, under a small central force; W there, twice.
/// Reference: 5.612e-3 F a^2 / D [Timoshenko1959].
ShellProblem clamped_plate(int each_way, GridCut cut = GridCut::alternate);

/// Buckling load of the strip of cantilever_shear when pushed at its free end: pi^2 E I / (4 L^2).
ShellProblem euler_column(int length, int width);

}  // namespace rhexis::scenes
