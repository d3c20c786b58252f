// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/elastic_assembly.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "math/cholesky.hpp"
#include "math/rotation.hpp"

namespace rhexis {
namespace {

using elastic_kernel::Group;
using elastic_kernel::lanes;
using elastic_kernel::Mode;

int pairs(int nodes) { return nodes * (nodes + 1) / 2; }

void singular_rotation(const double* gradient, double* rotation) {
    Eigen::Map<Mat3>{rotation} = polar_rotation(Eigen::Map<const Mat3>(gradient));
}

}  // namespace

Result<ElasticAssembly> ElasticAssembly::create(const SolidModel& model, const elastic_kernel::Kernel& kernel) {
    if (model.formulation == Formulation::nodal_pressure) {
        return Error{"pressure at nodes cannot be stepped implicitly", model.name,
                     "formulation linear or edge-smoothed"};
    }
    ElasticAssembly result(model, kernel);
    for (int e = 0; e < result.elements_.count(); ++e) {
        const int nodes = result.elements_.first[at(e) + 1] - result.elements_.first[at(e)];
        if (nodes > elastic_kernel::most_nodes) {
            return Error{"an element has " + std::to_string(nodes) + " nodes", model.name,
                         "at most " + std::to_string(elastic_kernel::most_nodes)};
        }
    }
    result.pack_groups();
    return result;
}

ElasticAssembly::ElasticAssembly(const SolidModel& model, const elastic_kernel::Kernel& kernel)
    : ElasticBody(model.damping_mass, model.damping_stiffness),
      model_(&model),
      kernel_(&kernel),
      domains_(element_domains(model.coarse, model.formulation)) {
    elements_ = make_elements(model.coarse, domains_, std::vector<TetStiffness>(model.coarse.tets.size()));
    number_rows();
    moves_.assign(model.coarse.nodes.size(), 0);
}

/// Rows in the order of elimination, and each element's nodes by rows.
void ElasticAssembly::number_rows() {
    const int nodes = static_cast<int>(model_->coarse.nodes.size());
    node_of_ = elimination_order(block_pattern(nodes, elements_.first, elements_.node));
    row_of_.resize(at(nodes));
    for (int row = 0; row < nodes; ++row) {
        row_of_[at(node_of_[at(row)])] = row;
    }
    std::vector<int> element_rows;
    for (const int node : elements_.node) {
        element_rows.push_back(row_of_[at(node)]);
    }
    pattern_ = block_pattern(nodes, elements_.first, element_rows);
}

void ElasticAssembly::pack_groups() {
    const auto count = [this](int e) { return elements_.first[at(e) + 1] - elements_.first[at(e)]; };
    order_.resize(at(elements_.count()));
    std::iota(order_.begin(), order_.end(), 0);
    std::stable_sort(order_.begin(), order_.end(), [&](int a, int b) { return count(a) < count(b); });
    std::size_t data = 0;
    std::size_t index = 0;
    int most = 4;
    for (std::size_t first = 0; first < order_.size(); first += lanes) {
        const std::size_t last = std::min(first + lanes, order_.size()) - 1;
        const int nodes = count(order_[last]);
        groups_.push_back({nodes, nullptr, nullptr});
        data += at(lanes * (2 + 3 * nodes));
        index += at(lanes * (nodes + pairs(nodes)));
        most = std::max(most, nodes);
    }
    data_.assign(data, 0.0);
    index_.assign(index, 0);
    buffer_.resize(at(lanes * elastic_kernel::buffer_length(most)));
    data = index = 0;
    for (Group& group : groups_) {
        group.data = data_.data() + data;
        group.index = index_.data() + index;
        data += at(lanes * (2 + 3 * group.nodes));
        index += at(lanes * (group.nodes + pairs(group.nodes)));
    }
}

/// Stiffness and gradients of the elements; their nodes by ascending row.
void ElasticAssembly::fill_data() {
    double* data = data_.data();
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const Group& group = groups_[i / lanes];
        double* const own = data + i % lanes;
        const int e = order_[i];
        own[0] = 2.0 * elements_.mu[at(e)] * elements_.volume[at(e)];
        own[lanes] = elements_.lambda[at(e)] * elements_.volume[at(e)];
        const int begin = elements_.first[at(e)];
        const int count = elements_.first[at(e) + 1] - begin;
        std::vector<int> local(at(count));
        std::iota(local.begin(), local.end(), begin);
        std::sort(local.begin(), local.end(), [this](int a, int b) {
            return row_of_[at(elements_.node[at(a)])] < row_of_[at(elements_.node[at(b)])];
        });
        for (int a = 0; a < count; ++a) {
            for (int axis = 0; axis < 3; ++axis) {
                own[lanes * (2 + 3 * a + axis)] = elements_.gradient[at(local[at(a)])][axis];
            }
        }
        if (i % lanes == lanes - 1) {
            data += lanes * (2 + 3 * group.nodes);
        }
    }
}

/// Rows of the nodes, and where the blocks of their pairs go; those of nodes that do not move are dropped.
void ElasticAssembly::fill_places() {
    int* index = index_.data();
    const int dropped = 9 * pattern_.blocks();
    std::vector<int> rows;
    for (std::size_t i = 0; i < groups_.size() * lanes; ++i) {
        const Group& group = groups_[i / lanes];
        int* const own = index + i % lanes;
        rows.clear();
        if (i < order_.size()) {
            const int e = order_[i];
            for (int k = elements_.first[at(e)]; k < elements_.first[at(e) + 1]; ++k) {
                rows.push_back(row_of_[at(elements_.node[at(k)])]);
            }
            std::sort(rows.begin(), rows.end());
        }
        const int count = static_cast<int>(rows.size());
        int place = lanes * group.nodes;
        for (int b = 0; b < group.nodes; ++b) {
            own[lanes * b] = b < count ? rows[at(b)] : (count > 0 ? rows[0] : 0);
            for (int a = 0; a <= b; ++a, place += lanes) {
                const bool kept = b < count && moves_[at(rows[at(a)])] != 0 && moves_[at(rows[at(b)])] != 0;
                own[place] = kept ? 9 * pattern_.slot(rows[at(a)], rows[at(b)]) : dropped;
            }
        }
        if (i % lanes == lanes - 1) {
            index += lanes * (group.nodes + pairs(group.nodes));
        }
    }
}

void ElasticAssembly::set_mass(const NodeMass& by_node) {
    const std::vector<std::uint8_t> before = moves_;
    mass_.inertia.assign(at(rows()), 0.0);
    mass_.weight.assign(at(rows()), 0.0);
    for (int row = 0; row < rows(); ++row) {
        const std::size_t node = at(node_of_[at(row)]);
        mass_.inertia[at(row)] = by_node.inertia[node];
        mass_.weight[at(row)] = by_node.weight[node];
        moves_[at(row)] = by_node.inertia[node] > 0.0 ? 1 : 0;
    }
    for (const int node : model_->fixed_nodes) {
        moves_[at(row_of_[at(node)])] = 0;
    }
    if (before != moves_ || present_.empty()) {
        fill_places();
    }
}

bool ElasticAssembly::load(const SolidState& state) {
    if (state.present == present_ && state.fraction == fraction_) {
        return false;
    }
    std::vector<TetStiffness> stiffness = tet_stiffness(*model_, state);
    std::vector<int> changed;
    for (std::size_t t = 0; t < stiffness.size(); ++t) {
        if (present_.empty() || stiffness[t].share != stiffness_[t].share) {
            changed.push_back(static_cast<int>(t));
        }
    }
    stiffness_ = std::move(stiffness);
    update_elements(model_->coarse, domains_, stiffness_, changed, elements_);
    fill_data();
    set_mass(node_mass(*model_, state, stiffness_));
    present_ = state.present;
    fraction_ = state.fraction;
    return true;
}

void ElasticAssembly::run(elastic_kernel::Task task, const std::vector<double>& position, std::vector<double>& force) {
    RHEXIS_ASSERT(position.size() > 3 * at(rows()));
    force.assign(3 * at(rows()) + 1, 0.0);
    task.groups = groups_.data();
    task.count = static_cast<int>(groups_.size());
    task.position = position.data();
    task.force = force.data();
    task.buffer = buffer_.data();
    task.singular = singular_rotation;
    kernel_->assemble(task);
}

void ElasticAssembly::forces(const std::vector<double>& position, std::vector<double>& force) {
    elastic_kernel::Task task;
    task.mode = Mode::forces;
    run(task, position, force);
}

void ElasticAssembly::forces_and_stiffness(const std::vector<double>& position, Mode mode, double scale,
                                           std::vector<double>& force, BlockValues& stiffness) {
    RHEXIS_ASSERT(mode != Mode::forces && stiffness.size() == 9 * at(pattern_.blocks() + 1) + 1);
    clear_upper(pattern_, stiffness);
    elastic_kernel::Task task;
    task.mode = mode;
    task.scale = scale;
    task.stiffness = stiffness.data();
    run(task, position, force);
}

}  // namespace rhexis
