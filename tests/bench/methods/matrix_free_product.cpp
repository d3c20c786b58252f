// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/matrix_free_product.hpp"

#include "energy/corotational_tet.hpp"
#include "physics/solid/solid_share.hpp"

namespace rhexis::bench {

MatrixFreeProduct::MatrixFreeProduct(const SolidModel& model, const SolidState& state) {
    const std::vector<TetStiffness> stiffness = tet_stiffness(model, state);
    for (std::size_t t = 0; t < stiffness.size(); ++t) {
        TetPoints rest;
        TetPoints now;
        for (std::size_t a = 0; a < 4; ++a) {
            const auto node = static_cast<std::size_t>(model.coarse.tets[t][a]);
            rest[a] = model.coarse.nodes[node];
            now[a] = state.position[node];
        }
        const RestTet tet = rest_tet(rest);
        const Mat3 rotation = corotational_point(tet_gradient(tet, now)).rotation;
        Element element;
        element.node = model.coarse.tets[t];
        for (std::size_t a = 0; a < 3; ++a) {
            Eigen::Map<Vec3>(&element.gradient[3 * a]) = rotation * tet.gradient[a + 1];
        }
        const double volume = tet.volume * stiffness[t].share;
        element.mu = volume * stiffness[t].mu;
        element.lambda = volume * stiffness[t].lambda;
        elements_.push_back(element);
    }
}

void MatrixFreeProduct::apply(const std::vector<Vec3>& x, std::vector<Vec3>& y) const {
    y.assign(x.size(), Vec3::Zero());
    for (const Element& e : elements_) {
        const Vec3& x0 = x[static_cast<std::size_t>(e.node[0])];
        const Vec3 d1 = x[static_cast<std::size_t>(e.node[1])] - x0;
        const Vec3 d2 = x[static_cast<std::size_t>(e.node[2])] - x0;
        const Vec3 d3 = x[static_cast<std::size_t>(e.node[3])] - x0;
        const Eigen::Map<const Vec3> g1(&e.gradient[0]);
        const Eigen::Map<const Vec3> g2(&e.gradient[3]);
        const Eigen::Map<const Vec3> g3(&e.gradient[6]);
        Mat3 a = d1 * g1.transpose();
        a.noalias() += d2 * g2.transpose();
        a.noalias() += d3 * g3.transpose();
        Mat3 stress = e.mu * (a + a.transpose());
        stress.diagonal().array() += e.lambda * a.trace();
        const Vec3 f1 = stress * g1;
        const Vec3 f2 = stress * g2;
        const Vec3 f3 = stress * g3;
        y[static_cast<std::size_t>(e.node[1])] += f1;
        y[static_cast<std::size_t>(e.node[2])] += f2;
        y[static_cast<std::size_t>(e.node[3])] += f3;
        y[static_cast<std::size_t>(e.node[0])] -= f1 + f2 + f3;
    }
}

}  // namespace rhexis::bench
