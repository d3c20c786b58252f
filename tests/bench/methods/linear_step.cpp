// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/methods/linear_step.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "base/index.hpp"
#include "bench/methods/matrix_free_product.hpp"
#include "energy/corotational_tet.hpp"
#include "math/cholesky.hpp"
#include "math/packed_factor.hpp"
#include "math/pcg.hpp"
#include "math/rotation.hpp"
#include "physics/solid/elastic_assembly.hpp"

namespace rhexis::bench {
namespace {

using View = std::span<const double>;
using Out = std::span<double>;

ElasticAssembly assembly_of(const SolidModel& model) {
    return std::move(ElasticAssembly::create(model, *elastic_kernel::choose({}))).value();
}

}  // namespace

const char* name_of(StepMethod method) {
    switch (method) {
        case StepMethod::matrix_free_cg_25:
            return "matrix_free_cg_25";
        case StepMethod::matrix_free_cg:
            return "matrix_free_cg";
        case StepMethod::block_jacobi_pcg:
            return "block_jacobi_pcg";
        case StepMethod::cholmod_simplicial:
            return "cholmod_simplicial";
        case StepMethod::cholmod_supernodal:
            return "cholmod_supernodal";
        case StepMethod::single_factor:
            return "single_factor";
        case StepMethod::first_factor:
            return "first_factor";
        case StepMethod::first_factor_warped:
            return "first_factor_warped";
    }
    return "";
}

std::vector<Vec3> moving_load(const scenes::ReferenceCase& scene, double time_s) {
    std::vector<Vec3> result(scene.solid.coarse.nodes.size(), Vec3::Zero());
    const double share = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * time_s / scene.load_period_s);
    for (const int node : scene.poke_nodes) {
        result[at(node)] = share * scene.load / static_cast<double>(scene.poke_nodes.size());
    }
    return result;
}

struct LinearStep::Parts {
    Parts(const scenes::ReferenceCase& reference, StepMethod chosen, double wanted)
        : scene(reference),
          method(chosen),
          tolerance(wanted),
          elastic(assembly_of(reference.solid)),
          linear(*linear_kernel::choose()),
          state(rest_state(reference.solid)),
          values(zero_values(elastic.pattern())) {
        elastic.load(state);
    }

    [[nodiscard]] bool free_of_matrix() const {
        return method == StepMethod::matrix_free_cg_25 || method == StepMethod::matrix_free_cg;
    }
    [[nodiscard]] std::size_t size() const { return 3 * at(elastic.rows()); }

    void gather() {
        x.assign(size() + 1, 0.0);
        v.assign(size(), 0.0);
        for (int row = 0; row < elastic.rows(); ++row) {
            const std::size_t node = at(elastic.node_of()[at(row)]);
            Eigen::Map<Vec3>(x.data() + 3 * row) = state.position[node];
            Eigen::Map<Vec3>(v.data() + 3 * row) = state.velocity[node];
        }
    }

    /// y = A u without a matrix.
    void multiply_free(View u, Out y) {
        for (int row = 0; row < elastic.rows(); ++row) {
            by_node[at(elastic.node_of()[at(row)])] = Eigen::Map<const Vec3>(u.data() + 3 * row);
        }
        product->apply(by_node, image_by_node);
        for (int row = 0; row < elastic.rows(); ++row) {
            Eigen::Map<Vec3> own(y.data() + 3 * row);
            const Eigen::Map<const Vec3> from(u.data() + 3 * row);
            own = elastic.moves()[at(row)] == 0
                      ? Vec3(from)
                      : Vec3(inertia(row) * from + weight() * image_by_node[at(elastic.node_of()[at(row)])]);
        }
    }
    void multiply(View u, Out y) {
        if (free_of_matrix()) {
            multiply_free(u, y);
        } else {
            linear.multiply(
                {elastic.rows(), elastic.pattern().first.data(), elastic.pattern().column.data(), values.data()},
                u.data(), y.data());
        }
    }
    [[nodiscard]] double weight() const { return scene.step_s * (scene.step_s + scene.solid.damping_stiffness); }
    [[nodiscard]] double inertia(int row) const {
        return (1.0 + scene.step_s * scene.solid.damping_mass) * elastic.mass().inertia[at(row)];
    }

    void build() {
        gather();
        if (free_of_matrix()) {
            elastic.forces(x, force);
            product.emplace(scene.solid, state);
            by_node.resize(state.position.size());
            return;
        }
        elastic.forces_and_stiffness(x, elastic_kernel::Mode::warped, weight(), force, values);
        for (int row = 0; row < elastic.rows(); ++row) {
            add_block(values, elastic.pattern().diagonal[at(row)],
                      (elastic.moves()[at(row)] != 0 ? inertia(row) : 1.0) * Mat3::Identity());
        }
        mirror_upper(elastic.pattern(), values);
    }

    void right_side() {
        b.assign(size(), 0.0);
        multiply(v, b);
        const std::vector<Vec3> load = moving_load(scene, time);
        for (int row = 0; row < elastic.rows(); ++row) {
            Eigen::Map<Vec3> own(b.data() + 3 * row);
            const double mass = elastic.mass().inertia[at(row)];
            const Vec3 pull = Eigen::Map<const Vec3>(force.data() + 3 * row) +
                              elastic.mass().weight[at(row)] * scene.gravity + load[at(elastic.node_of()[at(row)])];
            own = elastic.moves()[at(row)] != 0
                      ? Vec3(scene.step_s * pull + mass * Eigen::Map<const Vec3>(v.data() + 3 * row) - own)
                      : Vec3::Zero();
        }
    }

    /// Rotation of each node's surroundings, by rows: the polar part of the sum of its elements' deformation.
    std::vector<Mat3> node_rotations() const {
        std::vector<Mat3> sum(at(elastic.rows()), Mat3::Zero());
        for (const std::array<int, 4>& tet : scene.solid.coarse.tets) {
            TetPoints rest;
            TetPoints now;
            for (std::size_t a = 0; a < 4; ++a) {
                rest[a] = scene.solid.coarse.nodes[at(tet[a])];
                now[a] = state.position[at(tet[a])];
            }
            const RestTet shape = rest_tet(rest);
            const Mat3 gradient = shape.volume * tet_gradient(shape, now);
            for (const int node : tet) {
                sum[at(elastic.row_of()[at(node)])] += gradient;
            }
        }
        for (Mat3& m : sum) {
            m = polar_rotation(m);
        }
        return sum;
    }

    void solve_single(View r, Out z, const std::vector<Mat3>& turn) {
        single.assign(4 * at(elastic.rows()), 0.0F);
        const double scale = 1.0 / std::max(1e-300, std::sqrt(dot(r, r)));
        for (int row = 0; row < elastic.rows(); ++row) {
            const Eigen::Map<const Vec3> own(r.data() + 3 * row);
            const Vec3 turned = turn.empty() ? Vec3(own) : Vec3(turn[at(row)].transpose() * own);
            for (int c = 0; c < 3; ++c) {
                single[at(4 * row + c)] = static_cast<float>(scale * turned[c]);
            }
        }
        packed->solve(single);
        for (int row = 0; row < elastic.rows(); ++row) {
            const float* const own = single.data() + 4 * row;
            const Vec3 back = Vec3(own[0], own[1], own[2]) / scale;
            Eigen::Map<Vec3>(z.data() + 3 * row) = turn.empty() ? back : Vec3(turn[at(row)] * back);
        }
    }

    std::function<void(View, Out)> preconditioner() {
        switch (method) {
            case StepMethod::matrix_free_cg_25:
            case StepMethod::matrix_free_cg:
                return [](View r, Out z) { std::copy(r.begin(), r.end(), z.begin()); };
            case StepMethod::block_jacobi_pcg: {
                inverse.resize(at(elastic.rows()));
                for (int row = 0; row < elastic.rows(); ++row) {
                    inverse[at(row)] = block_of(values, elastic.pattern().diagonal[at(row)]).inverse();
                }
                return [this](View r, Out z) {
                    for (int row = 0; row < elastic.rows(); ++row) {
                        Eigen::Map<Vec3>(z.data() + 3 * row) =
                            inverse[at(row)] * Eigen::Map<const Vec3>(r.data() + 3 * row);
                    }
                };
            }
            case StepMethod::cholmod_simplicial:
            case StepMethod::cholmod_supernodal:
                if (!exact) {
                    exact.emplace(elastic.pattern(), method == StepMethod::cholmod_simplicial
                                                         ? CholeskyKind::simplicial
                                                         : CholeskyKind::supernodal);
                }
                exact->factor(values);
                return [this](View r, Out z) { exact->solve(r, z); };
            case StepMethod::single_factor:
            case StepMethod::first_factor:
            case StepMethod::first_factor_warped:
                break;
        }
        if (!packed || method == StepMethod::single_factor) {
            if (!packed) {
                packed.emplace(elastic.pattern(), linear);
            }
            packed->factor(values);
        }
        turns = method == StepMethod::first_factor_warped ? node_rotations() : std::vector<Mat3>();
        return [this](View r, Out z) { solve_single(r, z, turns); };
    }

    const scenes::ReferenceCase& scene;
    StepMethod method;
    double tolerance;
    ElasticAssembly elastic;
    const linear_kernel::Kernel& linear;
    SolidState state;
    double time = 0.0;
    BlockValues values;
    std::vector<double> x, v, force, b, change;
    std::vector<Vec3> by_node, image_by_node;
    std::optional<MatrixFreeProduct> product;
    std::optional<Cholesky> exact;
    std::optional<PackedFactor> packed;
    std::vector<float> single;
    std::vector<Mat3> inverse, turns;
    PcgWork work;
};

LinearStep::LinearStep(const scenes::ReferenceCase& scene, StepMethod method, double tolerance)
    : parts_(std::make_unique<Parts>(scene, method, tolerance)) {}
LinearStep::~LinearStep() = default;

const SolidState& LinearStep::state() const { return parts_->state; }

LinearStep::Report LinearStep::advance() {
    Parts& p = *parts_;
    p.time += p.scene.step_s;
    p.build();
    p.right_side();
    p.change.resize(p.size());
    const double size = std::sqrt(dot(p.b, p.b));
    const int limit = p.method == StepMethod::matrix_free_cg_25 ? 25 : 5000;
    const PcgResult result = pcg(
        p.b, p.tolerance * size, limit, [&p](View u, Out y) { p.multiply(u, y); }, p.preconditioner(), p.change,
        PcgStart::zero, p.work);
    for (int row = 0; row < p.elastic.rows(); ++row) {
        const std::size_t node = at(p.elastic.node_of()[at(row)]);
        p.state.velocity[node] += Eigen::Map<const Vec3>(p.change.data() + 3 * row);
        p.state.position[node] += p.scene.step_s * p.state.velocity[node];
    }
    return {result.iterations, result.residual / size};
}

}  // namespace rhexis::bench
