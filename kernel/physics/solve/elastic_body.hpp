// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: what an implicit step needs to know of a body with elastic forces: a solid, a membrane.
// Rows are its nodes in the order of elimination.
#pragma once

#include <cstdint>
#include <vector>

#include "math/block_matrix.hpp"
#include "physics/solid/elastic_kernel.hpp"
#include "physics/solid/solid_share.hpp"

namespace rhexis {

class ElasticBody {
public:
    virtual ~ElasticBody() = default;

    [[nodiscard]] const BlockPattern& pattern() const { return pattern_; }
    [[nodiscard]] const std::vector<int>& node_of() const { return node_of_; }  ///< per row
    [[nodiscard]] const std::vector<int>& row_of() const { return row_of_; }    ///< per node
    /// Per row 1, or 0 for nodes that are fixed or have lost their elements.
    [[nodiscard]] const std::vector<std::uint8_t>& moves() const { return moves_; }
    [[nodiscard]] const NodeMass& mass() const { return mass_; }  ///< per row
    /// Per row: force against its movement per speed, of a fluid at rest [g/s]; or empty for none.
    [[nodiscard]] const std::vector<double>& row_drag() const { return drag_; }
    [[nodiscard]] double damping_mass() const { return damping_mass_; }            ///< Rayleigh, of the mass [1/s]
    [[nodiscard]] double damping_stiffness() const { return damping_stiffness_; }  ///< Rayleigh, of the stiffness [s]
    [[nodiscard]] int rows() const { return static_cast<int>(node_of_.size()); }

    /// Elastic forces [uN] at positions [mm]; both 3 per row and one number of padding.
    virtual void forces(const std::vector<double>& position, std::vector<double>& force) = 0;
    /// Forces, and `scale` times their negative derivative [uN/mm]: the upper triangle only (mirror_upper), zero in the
    /// rows and columns of nodes that do not move. mode: not forces; all but consistent are positive semidefinite.
    virtual void forces_and_stiffness(const std::vector<double>& position, elastic_kernel::Mode mode, double scale,
                                      std::vector<double>& force, BlockValues& stiffness) = 0;

    /// The consistent stiffness is from now on made with the stress that a step from here leads to by linear
    /// prediction, until the next call or forget_prediction(); for bodies that turn far while they strain little.
    /// Others need not.
    virtual void predict(const std::vector<double>& /*position*/, const std::vector<double>& /*step*/) {}
    virtual void forget_prediction() {}

protected:
    ElasticBody(double damping_mass, double damping_stiffness)
        : damping_mass_(damping_mass), damping_stiffness_(damping_stiffness) {}
    ElasticBody(ElasticBody&&) = default;
    ElasticBody& operator=(ElasticBody&&) = default;

    BlockPattern pattern_;
    std::vector<int> node_of_;
    std::vector<int> row_of_;
    std::vector<std::uint8_t> moves_;
    NodeMass mass_;
    std::vector<double> drag_;

private:
    double damping_mass_;
    double damping_stiffness_;
};

}  // namespace rhexis
