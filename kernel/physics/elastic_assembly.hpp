// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: mass, elastic forces and stiffness of one solid, assembled by nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "energy/corotational.hpp"
#include "flow/solid.hpp"
#include "math/block_matrix.hpp"
#include "physics/solid_share.hpp"

namespace rhexis {

/// What the implicit solver keeps of a model, and of the elements that are left in a state.
class ElasticAssembly {
public:
    /// The model must outlive this.
    explicit ElasticAssembly(const SolidModel& model);

    /// Takes over which elements are there and how much of each is left. True if anything changed since the last call.
    bool load(const SolidState& state);

    [[nodiscard]] int nodes() const { return static_cast<int>(moves_.size()); }
    [[nodiscard]] const BlockPattern& pattern() const { return pattern_; }
    /// 1, or 0 for nodes that are fixed or have lost their elements.
    [[nodiscard]] const std::vector<std::uint8_t>& moves() const { return moves_; }
    [[nodiscard]] const NodeMass& mass() const { return mass_; }

    /// Elastic forces on the nodes [uN].
    void forces(const std::vector<Vec3>& position, std::vector<Vec3>& force) const;
    /// Forces, and their negative derivative [uN/mm]; rows and columns of nodes that do not move are zero.
    void forces_and_stiffness(const std::vector<Vec3>& position, Tangent kind, std::vector<Vec3>& force,
                              BlockValues& stiffness) const;

private:
    [[nodiscard]] CorotationalPoint point(int element, const std::vector<Vec3>& position) const;
    void add_forces(int element, const CorotationalPoint& point, std::vector<Vec3>& force) const;
    void add_stiffness(int element, const CorotationalPoint& point, Tangent kind, BlockValues& stiffness) const;

    const SolidModel* model_;
    ElementDomains domains_;
    GradientElements elements_;
    BlockPattern pattern_;
    std::vector<int> slot_;  ///< per element, its pairs of nodes by rows
    std::vector<int> first_slot_;
    std::vector<std::uint8_t> moves_;
    NodeMass mass_;
    std::vector<std::uint8_t> present_;  ///< of the state loaded last
    std::vector<double> fraction_;
};

}  // namespace rhexis
