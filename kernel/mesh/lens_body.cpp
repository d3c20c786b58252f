// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>

#include "mesh/shapes.hpp"
#include "mesh/smoothing.hpp"
#include "mesh/stuffing.hpp"

namespace rhexis {

namespace {

constexpr int sweeps = 20;

/// Where the lattice lies in the shape. Off its symmetries, so that the count changes in small steps with the spacing.
const Vec3 lattice_offset(0.137, 0.291, 0.443);

/// The stuffed solid whose count is closest to the wanted one. The count falls with the cube of the spacing, but in
/// jumps of several elements; so after a few corrections the neighbourhood is searched.
StuffedSolid stuff_to_count(const HalfEllipsoids& shape, int wanted) {
    double spacing = std::cbrt(12.0 * shape_volume(shape) / wanted);
    StuffedSolid best;
    int best_error = -1;
    for (int attempt = 0; attempt < 40; ++attempt) {
        StuffedSolid trial = stuff(shape, spacing, lattice_offset);
        const int count = static_cast<int>(trial.mesh.tets.size());
        const int error = std::abs(count - wanted);
        if (best_error < 0 || error < best_error) {
            best = std::move(trial);
            best_error = error;
        }
        if (100 * error <= wanted) {
            break;
        }
        // Damped after the first corrections, so that a jump across the wanted count is searched, not repeated.
        const double correction = static_cast<double>(count) / wanted - 1.0;
        spacing *= 1.0 + correction / (3.0 + attempt);
    }
    return best;
}

}  // namespace

TetMesh lens_body(const HalfEllipsoids& shape, int tetrahedra) {
    StuffedSolid solid = stuff_to_count(shape, tetrahedra);
    smooth(shape, sweeps, solid);
    return std::move(solid.mesh);
}

TetMesh ball(double radius, int tetrahedra) { return lens_body({radius, radius, radius}, tetrahedra); }

}  // namespace rhexis
