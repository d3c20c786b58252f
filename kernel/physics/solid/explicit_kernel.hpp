// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loops of ExplicitSolid, compiled once per instruction set from one source (explicit_kernel.ipp).
// Elements come in groups of 16 lanes of which no two share a node, so the sums at nodes are the same whether a machine
// works on 4, 8 or 16 lanes at a time; every lane is computed by itself, by + - * / sqrt alone.
// This header declares plain data only: an inline function compiled for one instruction set must never be linked into
// code for another.
#pragma once

#include <cstdint>

namespace rhexis::explicit_kernel {

inline constexpr int lanes = 16;

/// 16 tetrahedra. Lanes without an element have zero stiffness and point at the spare nodes.
struct alignas(64) Group {
    float gradient[6][lanes];        ///< upper triangle of the inverse rest edges, by columns [1/mm]
    float twice_mu[lanes];           ///< -2 mu V [nJ]: negative, so that forces need no sign
    float lambda[lanes];             ///< -lambda V [nJ]; with pressure at nodes 2/3 mu V
    float quarter[lanes];            ///< V / 4 [mm^3]; used with pressure at nodes only
    std::uint32_t offset[4][lanes];  ///< of node a in positions and forces: 4 * node
};

/// Arrays of 4 values per node: x, y, z, and one that the elements may use between two steps.
struct Nodes {
    int count = 0;
    double* position = nullptr;            ///< [mm]
    double* velocity = nullptr;            ///< [mm/s]
    float* probe = nullptr;                ///< where the elements are evaluated, from `origin` [mm]
    float* force = nullptr;                ///< sum of element forces [uN]; zero between steps
    const double* inverse_mass = nullptr;  ///< [1/g]; 0: never moves
    const double* weight_share = nullptr;  ///< weight over inertia [-]
    double origin[4] = {};                 ///< of single precision [mm]; the last 0
};

/// Elements whose pressure comes from their nodes (energy/nodal_pressure.hpp).
struct NodalTask {
    const Group* groups = nullptr;
    int count = 0;
    int nodes = 0;
    const float* pressure = nullptr;  ///< per node k_n / V_n [Pa / mm^3]
    float* trace = nullptr;           ///< scratch: 16 per group
    float* probe = nullptr;           ///< its fourth values are overwritten
    float* force = nullptr;           ///< its fourth values must be zero
};

/// One instruction set.
struct Kernel {
    const char* name;
    /// Adds the elastic force of every group at nodes.probe to nodes.force.
    void (*add_forces)(const Group* groups, int count, const float* probe, float* force);
    /// The same for elements whose pressure comes from their nodes.
    void (*add_nodal_forces)(const NodalTask& task);
    /// v = (v + dt (force / m + share * gravity)) * decay, then force = 0. gravity: 4 values, the last 0.
    void (*accelerate)(const Nodes& nodes, double dt, const double* gravity, double decay);
    /// x += dt v, probe = x - origin + lag v.
    void (*move)(const Nodes& nodes, double dt, double lag);
};

/// Null where the compiler's target is not x86-64.
const Kernel* baseline();
const Kernel* avx2();
const Kernel* avx512();

}  // namespace rhexis::explicit_kernel
