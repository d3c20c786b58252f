// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/solid_energy.hpp"

#include "energy/corotational.hpp"
#include "energy/nodal_pressure.hpp"
#include "physics/solid/solid_share.hpp"

namespace rhexis {

SolidEnergy::SolidEnergy(const SolidModel& model) : domains_(element_domains(model.coarse, model.formulation)) {}

void SolidEnergy::update(const SolidModel& model, const SolidState& state) {
    const std::vector<TetStiffness> now = tet_stiffness(model, state);
    if (stiffness_.empty()) {
        stiffness_ = now;
        elements_ = make_elements(model.coarse, domains_, stiffness_);
        inertia_ = node_mass(model, state, stiffness_).inertia;
        return;
    }
    std::vector<int> changed;
    for (std::size_t t = 0; t < now.size(); ++t) {
        if (now[t].share != stiffness_[t].share) {
            changed.push_back(static_cast<int>(t));
        }
    }
    if (!changed.empty()) {
        stiffness_ = now;
        update_elements(model.coarse, domains_, stiffness_, changed, elements_);
        inertia_ = node_mass(model, state, stiffness_).inertia;
    }
}

double SolidEnergy::kinetic(const SolidModel& model, const SolidState& state) {
    update(model, state);
    double sum = 0.0;
    for (std::size_t i = 0; i < inertia_.size(); ++i) {
        sum += 0.5 * inertia_[i] * state.velocity[i].squaredNorm();
    }
    return sum;
}

double SolidEnergy::elastic(const SolidModel& model, const SolidState& state) {
    update(model, state);
    const bool nodal = domains_.formulation == Formulation::nodal_pressure;
    std::vector<double> theta(nodal ? model.coarse.tets.size() : 0, 0.0);
    double sum = 0.0;
    for (int e = 0; e < elements_.count(); ++e) {
        if (!(elements_.volume[e] > 0.0)) {
            continue;
        }
        Mat3 gradient = Mat3::Zero();
        const Vec3& origin = state.position[elements_.node[elements_.first[e]]];
        for (int k = elements_.first[e]; k < elements_.first[e + 1]; ++k) {
            gradient += (state.position[elements_.node[k]] - origin) * elements_.gradient[k].transpose();
        }
        const CorotationalPoint point = corotational_point(gradient);
        sum += elements_.volume[e] * corotational_energy(point, {elements_.lambda[e], elements_.mu[e]});
        if (nodal) {
            theta[e] = point.trace - 3.0;
        }
    }
    if (nodal) {
        const NodePatches patches = node_patches(model.coarse, domains_.rest_volume, stiffness_);
        sum += nodal_pressure_energy(model.coarse, domains_.rest_volume, stiffness_, patches, theta);
    }
    return sum;
}

int SolidEnergy::inverted(const SolidModel& model, const SolidState& state, double least) {
    update(model, state);
    int count = 0;
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        if (stiffness_[t].share > least) {
            const std::array<int, 4>& tet = model.coarse.tets[t];
            const std::vector<Vec3>& x = state.position;
            count += tet_volume(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) < 0.0 ? 1 : 0;
        }
    }
    return count;
}

}  // namespace rhexis
