// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/elastic_assembly.hpp"

#include <algorithm>

#include "base/assert.hpp"

namespace rhexis {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

ElasticAssembly::ElasticAssembly(const SolidModel& model)
    : model_(&model), domains_(element_domains(model.coarse, model.formulation)) {
    const std::vector<TetStiffness> whole(model.coarse.tets.size());
    elements_ = make_elements(model.coarse, domains_, whole);
    pattern_ = block_pattern(static_cast<int>(model.coarse.nodes.size()), elements_.first, elements_.node);
    first_slot_.push_back(0);
    for (int e = 0; e < elements_.count(); ++e) {
        for (int a = elements_.first[at(e)]; a < elements_.first[at(e) + 1]; ++a) {
            for (int b = elements_.first[at(e)]; b < elements_.first[at(e) + 1]; ++b) {
                slot_.push_back(pattern_.slot(elements_.node[at(a)], elements_.node[at(b)]));
            }
        }
        first_slot_.push_back(static_cast<int>(slot_.size()));
    }
    moves_.assign(model.coarse.nodes.size(), 0);
}

bool ElasticAssembly::load(const SolidState& state) {
    if (state.present == present_ && state.fraction == fraction_) {
        return false;
    }
    present_ = state.present;
    fraction_ = state.fraction;
    const std::vector<TetStiffness> stiffness = tet_stiffness(*model_, state);
    elements_ = make_elements(model_->coarse, domains_, stiffness);
    mass_ = node_mass(*model_, state, stiffness);
    std::transform(mass_.inertia.begin(), mass_.inertia.end(), moves_.begin(),
                   [](double mass) { return static_cast<std::uint8_t>(mass > 0.0); });
    for (const int node : model_->fixed_nodes) {
        moves_[at(node)] = 0;
    }
    return true;
}

CorotationalPoint ElasticAssembly::point(int element, const std::vector<Vec3>& position) const {
    const int begin = elements_.first[at(element)];
    const Vec3& origin = position[at(elements_.node[at(begin)])];
    Mat3 gradient = Mat3::Zero();
    for (int k = begin + 1; k < elements_.first[at(element) + 1]; ++k) {
        // differences first: positions far from the origin lose no digits
        gradient += (position[at(elements_.node[at(k)])] - origin) * elements_.gradient[at(k)].transpose();
    }
    return corotational_point(gradient);
}

void ElasticAssembly::add_forces(int element, const CorotationalPoint& point, std::vector<Vec3>& force) const {
    const Mat3 stress = corotational_stress(point, {elements_.lambda[at(element)], elements_.mu[at(element)]});
    for (int k = elements_.first[at(element)]; k < elements_.first[at(element) + 1]; ++k) {
        force[at(elements_.node[at(k)])] -= elements_.volume[at(element)] * (stress * elements_.gradient[at(k)]);
    }
}

void ElasticAssembly::add_stiffness(int element, const CorotationalPoint& point, Tangent kind,
                                    BlockValues& stiffness) const {
    const Lame material{elements_.lambda[at(element)], elements_.mu[at(element)]};
    const CorotationalTangent tangent = corotational_tangent(point, material, kind);
    const int begin = elements_.first[at(element)];
    const int end = elements_.first[at(element) + 1];
    int slot = first_slot_[at(element)];
    for (int a = begin; a < end; ++a) {
        for (int b = begin; b < end; ++b, ++slot) {
            if (moves_[at(elements_.node[at(a)])] != 0 && moves_[at(elements_.node[at(b)])] != 0) {
                add_block(stiffness, slot_[at(slot)],
                          elements_.volume[at(element)] *
                              tangent.block(elements_.gradient[at(a)], elements_.gradient[at(b)]));
            }
        }
    }
}

void ElasticAssembly::forces(const std::vector<Vec3>& position, std::vector<Vec3>& force) const {
    force.assign(position.size(), Vec3::Zero());
    for (int e = 0; e < elements_.count(); ++e) {
        if (elements_.volume[at(e)] > 0.0) {
            add_forces(e, point(e, position), force);
        }
    }
}

void ElasticAssembly::forces_and_stiffness(const std::vector<Vec3>& position, Tangent kind, std::vector<Vec3>& force,
                                           BlockValues& stiffness) const {
    RHEXIS_ASSERT(stiffness.size() == 9 * at(pattern_.blocks()) + 1);
    force.assign(position.size(), Vec3::Zero());
    std::fill(stiffness.begin(), stiffness.end(), 0.0);
    for (int e = 0; e < elements_.count(); ++e) {
        if (elements_.volume[at(e)] > 0.0) {
            const CorotationalPoint deformation = point(e, position);
            add_forces(e, deformation, force);
            add_stiffness(e, deformation, kind, stiffness);
        }
    }
}

}  // namespace rhexis
