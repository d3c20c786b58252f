// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: what an implicit step needs to know of a body with elastic forces: a solid, a membrane.
// Rows are its nodes in the order of elimination.
#pragma once

#include <cstdint>
#include <vector>

#include "math/block_matrix.hpp"
#include "physics/elastic_kernel.hpp"
#include "physics/solid_share.hpp"

namespace rhexis {

class ElasticBody {
public:
    virtual ~ElasticBody() = default;

    [[nodiscard]] virtual const BlockPattern& pattern() const = 0;
    [[nodiscard]] virtual const std::vector<int>& node_of() const = 0;  ///< per row
    [[nodiscard]] virtual const std::vector<int>& row_of() const = 0;   ///< per node
    /// Per row 1, or 0 for nodes that are fixed or have lost their elements.
    [[nodiscard]] virtual const std::vector<std::uint8_t>& moves() const = 0;
    [[nodiscard]] virtual const NodeMass& mass() const = 0;      ///< per row
    [[nodiscard]] virtual double damping_mass() const = 0;       ///< Rayleigh damping, share of the mass [1/s]
    [[nodiscard]] virtual double damping_stiffness() const = 0;  ///< Rayleigh damping, share of the stiffness [s]
    [[nodiscard]] int rows() const { return static_cast<int>(node_of().size()); }

    /// Elastic forces [uN] at positions [mm]; both 3 per row and one number of padding.
    virtual void forces(const std::vector<double>& position, std::vector<double>& force) = 0;
    /// Forces, and `scale` times their negative derivative [uN/mm]: the upper triangle only (mirror_upper), zero in the
    /// rows and columns of nodes that do not move. mode: not forces; all but consistent are positive semidefinite.
    virtual void forces_and_stiffness(const std::vector<double>& position, elastic_kernel::Mode mode, double scale,
                                      std::vector<double>& force, BlockValues& stiffness) = 0;
};

}  // namespace rhexis
