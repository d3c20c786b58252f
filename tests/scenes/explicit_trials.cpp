// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/explicit_trials.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "physics/solid/stable_step.hpp"

namespace rhexis::scenes {
namespace {

ExplicitSolid solid_of(const SolidModel& model) { return ExplicitSolid::create(model, "").value(); }

double mass_left(const SolidModel& model, const SolidState& state) {
    double sum = 0.0;
    for (std::size_t t = 0; t < model.coarse.tets.size(); ++t) {
        const TetPoints x = corners(model.coarse.nodes, model.coarse.tets[t]);
        sum += state.present[t] != 0
                   ? tet_volume(x[0], x[1], x[2], x[3]) * model.materials[at(model.coarse.region[t])].density
                   : 0.0;
    }
    return sum;
}

Motion motion_of(const ExplicitSolid& solid, SolidState& state) {
    solid.store(state);
    std::vector<double> mass;
    for (int i = 0; i < static_cast<int>(state.position.size()); ++i) {
        mass.push_back(solid.mass(i));
    }
    return scenes::motion_of(state, mass);
}

constexpr int flight_samples = 1000;

/// Without damping: stretched, spinning and flying.
SolidState thrown(SolidModel& model) {
    model.damping_mass = 0.0;
    model.damping_stiffness = 0.0;
    model.fixed_nodes.clear();
    SolidState state = rest_state(model);
    const Vec3 spin(3.0, -2.0, 5.0);
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        state.velocity[i] = Vec3(2.0, 1.0, -1.0) + spin.cross(state.position[i]);
        state.position[i] = state.position[i].cwiseProduct(Vec3(1.05, 0.97, 1.02));
    }
    return state;
}

/// Mean of the last tenth against that of the first, relative.
double drift_of(const std::vector<double>& series) {
    const auto tenth = static_cast<std::ptrdiff_t>(series.size() / 10);
    const double first = std::accumulate(series.begin(), series.begin() + tenth, 0.0);
    return std::accumulate(series.end() - tenth, series.end(), 0.0) / first - 1.0;
}

/// Linear tetrahedra in double precision.
class ExactForces {
public:
    explicit ExactForces(const SolidModel& model) : model_(model) {
        for (const std::array<int, 4>& tet : model.coarse.tets) {
            rest_.push_back(rest_tet(corners(model.coarse.nodes, tet)));
        }
    }

    void add(const std::vector<Vec3>& x, std::vector<Vec3>& force) const {
        for (std::size_t t = 0; t < rest_.size(); ++t) {
            const Vec12 pull = corotational_tet_gradient(rest_[t], lame_of(t), corners(x, model_.coarse.tets[t]));
            for (std::size_t k = 0; k < 4; ++k) {
                force[at(model_.coarse.tets[t][k])] -= pull.segment<3>(static_cast<Eigen::Index>(3 * k));
            }
        }
    }

    /// Stiffness at rest of each tetrahedron.
    [[nodiscard]] std::vector<Mat12> stiffness() const {
        std::vector<Mat12> list;
        for (std::size_t t = 0; t < rest_.size(); ++t) {
            list.push_back(corotational_tet_hessian(
                rest_[t], lame_of(t), corners(model_.coarse.nodes, model_.coarse.tets[t]), Tangent::consistent));
        }
        return list;
    }

private:
    [[nodiscard]] Lame lame_of(std::size_t t) const {
        const Material& material = model_.materials[at(model_.coarse.region[t])];
        return lame(material.young_modulus, material.poisson_ratio);
    }

    const SolidModel& model_;
    std::vector<RestTet> rest_;
};

/// Of the stiffness at rest, in double precision [s].
double exact_limit(const SolidModel& model) {
    constexpr int iterations = 1000;  // of the power method: a sliver's eigenvalue stands out, others are near enough
    const ExplicitSolid solid = solid_of(model);
    const std::vector<Mat12> stiffness = ExactForces(model).stiffness();
    std::vector<double> scale;
    for (int i = 0; i < static_cast<int>(model.coarse.nodes.size()); ++i) {
        scale.push_back(solid.mass(i) > 0.0 ? 1.0 / std::sqrt(solid.mass(i)) : 0.0);
    }
    const auto product = [&](const VecX& x, VecX& y) {
        y.setZero(x.size());
        for (std::size_t t = 0; t < stiffness.size(); ++t) {
            Vec12 own;
            for (std::size_t k = 0; k < 4; ++k) {
                const int node = model.coarse.tets[t][k];
                own.segment<3>(static_cast<Eigen::Index>(3 * k)) = scale[at(node)] * x.segment<3>(3 * node);
            }
            own = stiffness[t] * own;
            for (std::size_t k = 0; k < 4; ++k) {
                const int node = model.coarse.tets[t][k];
                y.segment<3>(3 * node) += scale[at(node)] * own.segment<3>(static_cast<Eigen::Index>(3 * k));
            }
        }
    };
    Rng rng(1, "largest eigenvalue");
    VecX now(static_cast<Eigen::Index>(3 * scale.size()));
    for (double& number : now) {
        number = 2.0 * rng.uniform() - 1.0;
    }
    VecX next;
    double largest = 0.0;
    for (int i = 0; i < iterations; ++i) {
        now.normalize();
        product(now, next);
        largest = next.norm();
        now.swap(next);
    }
    return symplectic_limit(largest, model.damping_stiffness);
}

}  // namespace

double total_energy(const SolidModel& model, const SolidState& state, const ExplicitSolid& solid) {
    double energy = elastic_energy(model, state);
    for (std::size_t i = 0; i < state.velocity.size(); ++i) {
        energy += 0.5 * solid.mass(static_cast<int>(i)) * state.velocity[i].squaredNorm();
    }
    return energy;
}

Recovery recover(SolidModel model, BadStart start, double seconds) {
    SolidState state = rest_state(model);
    place_badly(state, start);
    ExplicitSolid solid = solid_of(model);
    solid.load(state);
    Recovery result;
    result.inverted_at_start = inverted_share(model, state);
    const double first = total_energy(model, state, solid);
    // far from rest the stiffness is up to twice that at rest: half a stable step
    const double dt = 0.5 * solid.stable_step();
    constexpr int samples = 50;
    const int between = std::max(1, static_cast<int>(seconds / dt / samples));
    double last = first;
    for (int s = 0; s < samples; ++s) {
        for (int k = 0; k < between; ++k) {
            solid.predict(dt, Vec3::Zero(), {});
            solid.move(dt);
        }
        solid.store(state);
        const double now = total_energy(model, state, solid);
        result.largest_rise = std::max(result.largest_rise, (now - last) / first);
        last = now;
    }
    result.finite = solid.finite();
    result.energy_left = last / first;
    result.inverted_at_end = inverted_share(model, state);
    return result;
}

Deletion delete_all(SolidModel model, int per_round, int round) {
    SolidState state = rest_state(model);
    ExplicitSolid solid = solid_of(model);
    const double whole = solid.stable_step();
    const double mass = mass_left(model, state);
    Rng rng(4, "deletion");
    std::vector<int> left(model.coarse.tets.size());
    std::iota(left.begin(), left.end(), 0);
    Deletion result;
    result.smallest_step = 1.0;
    double removed = 0.0;
    while (!left.empty()) {
        for (int k = 0; k < per_round && !left.empty(); ++k) {
            const std::int64_t pick = rng.integer(0, static_cast<std::int64_t>(left.size()) - 1);
            const int t = left[static_cast<std::size_t>(pick)];
            left[static_cast<std::size_t>(pick)] = left.back();
            left.pop_back();
            state.present[at(t)] = 0;
            const TetPoints x = corners(model.coarse.nodes, model.coarse.tets[at(t)]);
            removed += tet_volume(x[0], x[1], x[2], x[3]) * model.materials[at(model.coarse.region[at(t)])].density;
        }
        solid.load(state);
        const double limit = solid.stable_step();
        result.smallest_step = std::min(result.smallest_step, limit / whole);
        const double dt = 0.8 * std::min(limit, whole);
        for (int k = 0; k < round; ++k, ++result.steps) {
            solid.predict(dt, Vec3(0.0, 0.0, -9810.0), {});
            solid.move(dt);
        }
        solid.store(state);
        for (const Vec3& v : state.velocity) {
            result.fastest = std::max(result.fastest, v.norm());
        }
        result.mass_error = std::max(result.mass_error, std::abs(removed + mass_left(model, state) - mass) / mass);
        if (!solid.finite()) {
            return result;
        }
    }
    result.finite = solid.finite();
    return result;
}

Flight fly(SolidModel model, int steps, double share) {
    SolidState state = thrown(model);
    ExplicitSolid solid = solid_of(model);
    solid.load(state);
    const double dt = share * solid.stable_step();
    const Motion before = motion_of(solid, state);
    std::vector<double> energy;
    std::vector<double> heat;
    for (int k = 0; k < steps; ++k) {
        solid.predict(dt, Vec3::Zero(), {});
        solid.move(dt);
        if ((k + 1) % std::max(1, steps / flight_samples) == 0) {
            heat.push_back(motion_of(solid, state).heat);
            energy.push_back(total_energy(model, state, solid));
        }
    }
    const Motion after = motion_of(solid, state);
    Flight result;
    result.linear_drift = (after.linear - before.linear).norm() / before.linear_scale / steps;
    result.angular_drift = (after.angular - before.angular).norm() / before.angular_scale / steps;
    result.energy_drift = drift_of(energy);
    result.temperature = drift_of(heat);
    return result;
}

double drift_in_double(SolidModel model, int steps, double share) {
    SolidState state = thrown(model);
    ExplicitSolid solid = solid_of(model);
    const double dt = share * solid.stable_step();
    const ExactForces forces(model);
    std::vector<Vec3> force(state.position.size());
    std::vector<double> energy;
    for (int k = 0; k < steps; ++k) {
        force.assign(force.size(), Vec3::Zero());
        forces.add(state.position, force);
        for (std::size_t i = 0; i < force.size(); ++i) {
            state.velocity[i] += dt / solid.mass(static_cast<int>(i)) * force[i];
            state.position[i] += dt * state.velocity[i];
        }
        if ((k + 1) % std::max(1, steps / flight_samples) == 0) {
            energy.push_back(total_energy(model, state, solid));
        }
    }
    return drift_of(energy);
}

Limit probe_limit(const SolidModel& model) {
    const auto bounded_at = [&model](double factor) {
        ExplicitSolid solid = solid_of(model);
        const double dt = factor * solid.stable_step();
        Rng rng(6, "kick");
        const int nodes = static_cast<int>(model.coarse.nodes.size());
        for (int i = 0; i < nodes; ++i) {
            solid.set_velocity(i, 10.0 * (uniform3(rng) - Vec3::Constant(0.5)));
        }
        for (int k = 0; k < 1500; ++k) {
            solid.predict(dt, Vec3::Zero(), {});
            solid.move(dt);
        }
        double fastest = 0.0;
        for (int i = 0; i < nodes; ++i) {
            fastest = std::max(fastest, solid.velocity(i).norm());
        }
        return solid.finite() && fastest < 100.0;
    };
    Limit limit;
    limit.step = solid_of(model).stable_step();
    limit.exact = exact_limit(model);
    limit.below = bounded_at(0.97);
    limit.beyond = !bounded_at(1.1 * std::max(1.0, limit.exact / limit.step));
    return limit;
}

void flatten_one(SolidModel& model, double share) {
    const std::array<int, 4>& tet = model.coarse.tets[0];
    std::vector<Vec3>& x = model.coarse.nodes;
    const Vec3 across = (x[at(tet[2])] - x[at(tet[1])]).cross(x[at(tet[3])] - x[at(tet[1])]).normalized();
    const double height = (x[at(tet[0])] - x[at(tet[1])]).dot(across);
    x[at(tet[0])] -= (1.0 - share) * height * across;
}

}  // namespace rhexis::scenes
