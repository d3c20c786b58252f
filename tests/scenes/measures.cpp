// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/measures.hpp"

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "physics/solid/solid_share.hpp"

namespace rhexis::scenes {

TetPoints corners(const std::vector<Vec3>& x, const std::array<int, 4>& tet) {
    const auto at = [&](std::size_t corner) { return x[static_cast<std::size_t>(tet[corner])]; };
    return {at(0), at(1), at(2), at(3)};
}

double inverted_share(const SolidModel& model, const SolidState& state) {
    int inverted = 0;
    for (const std::array<int, 4>& tet : model.coarse.tets) {
        const TetPoints x = corners(state.position, tet);
        inverted += tet_volume(x[0], x[1], x[2], x[3]) <= 0.0 ? 1 : 0;
    }
    return static_cast<double>(inverted) / static_cast<double>(model.coarse.tets.size());
}

double elastic_energy(const SolidModel& model, const SolidState& state) {
    double energy = 0.0;
    const std::vector<TetStiffness> stiffness = tet_stiffness(model, state);
    for (std::size_t t = 0; t < stiffness.size(); ++t) {
        const RestTet rest = rest_tet(corners(model.coarse.nodes, model.coarse.tets[t]));
        energy += stiffness[t].share * corotational_tet_energy(rest, {stiffness[t].lambda, stiffness[t].mu},
                                                               corners(state.position, model.coarse.tets[t]));
    }
    return energy;
}

double tip_sag(const SolidModel& model, const std::vector<Vec3>& position) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < position.size(); ++i) {
        if (model.coarse.nodes[i].x() > 4.0 - 1e-9) {
            sum += model.coarse.nodes[i].z() - position[i].z();
            ++count;
        }
    }
    return sum / count;
}

Motion motion_of(const SolidState& state, const std::vector<double>& mass) {
    Motion motion;
    double total = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        const Vec3 p = mass[i] * state.velocity[i];
        total += mass[i];
        motion.linear += p;
        motion.angular += state.position[i].cross(p);
        motion.linear_scale += p.norm();
        motion.angular_scale += state.position[i].norm() * p.norm();
        motion.kinetic += 0.5 * p.dot(state.velocity[i]);
    }
    motion.heat = motion.kinetic - 0.5 * motion.linear.squaredNorm() / total;
    return motion;
}

void place_badly(SolidState& state, BadStart start) {
    Vec3 low = state.position[0];
    Vec3 high = low;
    for (const Vec3& x : state.position) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    Rng rng(3, "bad start");
    for (Vec3& x : state.position) {
        if (start == BadStart::random) {
            const Vec3 place = uniform3(rng);
            x = low + place.cwiseProduct(high - low);
        } else if (start == BadStart::flat) {
            // not quite flat: an exactly flat body is in balance
            x.z() = 0.5 * (low.z() + high.z()) + 1e-3 * rng.uniform();
        } else {
            x.z() = -x.z() + 1e-3 * rng.uniform();
        }
    }
}

}  // namespace rhexis::scenes
