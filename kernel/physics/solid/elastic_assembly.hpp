// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: mass, elastic forces and stiffness of one solid, by rows: the nodes in the order of elimination.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.hpp"
#include "flow/solid.hpp"
#include "math/block_matrix.hpp"
#include "physics/solve/elastic_body.hpp"

namespace rhexis {

/// What the implicit solver keeps of a model, and of the elements that are left in a state.
class ElasticAssembly final : public ElasticBody {
public:
    /// The model must outlive this. Fails on elements of more nodes than the kernel takes.
    static Result<ElasticAssembly> create(const SolidModel& model, const elastic_kernel::Kernel& kernel);

    /// Takes over which elements are there and how much of each is left. True if anything changed since the last call.
    bool load(const SolidState& state);

    void forces(const std::vector<double>& position, std::vector<double>& force) override;
    void forces_and_stiffness(const std::vector<double>& position, elastic_kernel::Mode mode, double scale,
                              std::vector<double>& force, BlockValues& stiffness) override;

private:
    ElasticAssembly(const SolidModel& model, const elastic_kernel::Kernel& kernel);
    void number_rows();
    void pack_groups();
    void fill_data();
    void fill_places();
    void set_mass(const NodeMass& by_node);
    void run(elastic_kernel::Task task, const std::vector<double>& position, std::vector<double>& force);

    const SolidModel* model_;
    const elastic_kernel::Kernel* kernel_;
    ElementDomains domains_;
    GradientElements elements_;
    std::vector<int> order_;  ///< elements as they are packed into lanes
    std::vector<elastic_kernel::Group> groups_;
    std::vector<double> data_;
    std::vector<int> index_;
    std::vector<double> buffer_;
    std::vector<TetStiffness> stiffness_;
    std::vector<std::uint8_t> present_;  ///< of the state loaded last
    std::vector<double> fraction_;
};

}  // namespace rhexis
