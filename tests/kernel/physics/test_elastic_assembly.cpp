// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/index.hpp"
#include "physics/solid/elastic_assembly.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rng.hpp"
#include "energy/corotational.hpp"
#include "math/random_vectors.hpp"
#include "mesh/shapes.hpp"
#include "support/finite_difference.hpp"

using namespace rhexis;
using elastic_kernel::Mode;

namespace {

SolidModel small_bar(Formulation formulation) {
    SolidModel model;
    model.name = "bar";
    model.coarse = bar(3, 2, 2, 0.5);
    model.materials = {Material{.name = "gel", .young_modulus = 3000.0, .poisson_ratio = 0.45, .density = 1e-3}};
    model.formulation = formulation;
    return model;
}

ElasticAssembly make(const SolidModel& model, const char* instruction_set) {
    Result<ElasticAssembly> made = ElasticAssembly::create(model, *elastic_kernel::choose(instruction_set));
    REQUIRE(made.ok());
    made.value().load(rest_state(model));
    return std::move(made).value();
}

/// Positions by rows: the rest shape turned, stretched and shaken; shake in mm.
std::vector<double> shaken(const SolidModel& model, const ElasticAssembly& assembly, double shake, std::uint64_t seed) {
    Rng random(seed);
    const Quat turn = Quat(1.0, 0.4, -0.7, 0.2).normalized();
    std::vector<double> x(3 * model.coarse.nodes.size() + 1, 0.0);
    for (int row = 0; row < assembly.rows(); ++row) {
        const Vec3 noise = normal3(random);
        Eigen::Map<Vec3>(x.data() + 3 * row) =
            turn * (1.1 * model.coarse.nodes[at(assembly.node_of()[at(row)])]) + shake * noise;
    }
    return x;
}

struct Reference {
    VecX force;
    MatX stiffness;
    double energy = 0.0;
};

/// By the formulas of energy/, element after element.
Reference reference(const SolidModel& model, const ElasticAssembly& assembly, const std::vector<double>& x,
                    Tangent kind) {
    const ElementDomains domains = element_domains(model.coarse, model.formulation);
    const GradientElements elements = make_elements(model.coarse, domains, tet_stiffness(model, rest_state(model)));
    const int n = 3 * assembly.rows();
    Reference result{VecX::Zero(n), MatX::Zero(n, n), 0.0};
    for (int e = 0; e < elements.count(); ++e) {
        Mat3 gradient = Mat3::Zero();
        const auto row = [&](int k) { return 3 * assembly.row_of()[at(elements.node[at(k)])]; };
        for (int k = elements.first[at(e)]; k < elements.first[at(e) + 1]; ++k) {
            gradient += Eigen::Map<const Vec3>(x.data() + row(k)) * elements.gradient[at(k)].transpose();
        }
        const CorotationalPoint point = corotational_point(gradient);
        const Lame material{elements.lambda[at(e)], elements.mu[at(e)]};
        const double volume = elements.volume[at(e)];
        const CorotationalTangent tangent = corotational_tangent(point, material, kind);
        const Mat3 stress = corotational_stress(point, material);
        result.energy += volume * corotational_energy(point, material);
        for (int a = elements.first[at(e)]; a < elements.first[at(e) + 1]; ++a) {
            result.force.segment<3>(row(a)) -= volume * (stress * elements.gradient[at(a)]);
            for (int b = elements.first[at(e)]; b < elements.first[at(e) + 1]; ++b) {
                result.stiffness.block<3, 3>(row(a), row(b)) +=
                    volume * tangent.block(elements.gradient[at(a)], elements.gradient[at(b)]);
            }
        }
    }
    return result;
}

MatX dense(const BlockPattern& pattern, const BlockValues& values) {
    MatX result = MatX::Zero(3 * pattern.rows(), 3 * pattern.rows());
    for (int i = 0; i < pattern.rows(); ++i) {
        for (int slot = pattern.first[at(i)]; slot < pattern.first[at(i) + 1]; ++slot) {
            result.block<3, 3>(3 * i, 3 * pattern.column[at(slot)]) = block_of(values, slot);
        }
    }
    return result;
}

constexpr std::array<std::pair<Mode, Tangent>, 3> modes{
    {{Mode::warped, Tangent::warped}, {Mode::consistent, Tangent::consistent}, {Mode::projected, Tangent::projected}}};

}  // namespace

TEST_SUITE("physics") {
    TEST_CASE("forces and stiffness in lanes equal the formulas, deformed mildly and beyond inversion") {
        for (const Formulation formulation : {Formulation::linear, Formulation::edge_smoothed}) {
            const SolidModel model = small_bar(formulation);
            ElasticAssembly assembly = make(model, "");
            for (const double shake : {0.02, 0.4}) {
                const std::vector<double> x = shaken(model, assembly, shake, 11);
                for (const auto& [mode, tangent] : modes) {
                    const Reference expected = reference(model, assembly, x, tangent);
                    std::vector<double> force;
                    BlockValues stiffness = zero_values(assembly.pattern());
                    assembly.forces_and_stiffness(x, mode, 2.0, force, stiffness);
                    mirror_upper(assembly.pattern(), stiffness);
                    const Eigen::Map<const VecX> f(force.data(), expected.force.size());
                    CHECK((f - expected.force).norm() < 1e-10 * expected.force.norm());
                    const MatX k = dense(assembly.pattern(), stiffness);
                    CHECK((k - 2.0 * expected.stiffness).norm() < 1e-8 * expected.stiffness.norm());
                    std::vector<double> alone;
                    assembly.forces(x, alone);
                    CHECK(alone == force);
                }
            }
        }
    }

    TEST_CASE("force and consistent stiffness are the derivatives of the energy") {
        const SolidModel model = small_bar(Formulation::linear);
        ElasticAssembly assembly = make(model, "");
        const std::vector<double> x = shaken(model, assembly, 0.05, 12);
        std::vector<double> force;
        BlockValues stiffness = zero_values(assembly.pattern());
        assembly.forces_and_stiffness(x, Mode::consistent, 1.0, force, stiffness);
        mirror_upper(assembly.pattern(), stiffness);
        const int n = 3 * assembly.rows();
        const auto moved = [&](const VecX& offset) {
            std::vector<double> y = x;
            for (int i = 0; i < n; ++i) {
                y[at(i)] += offset[i];
            }
            return y;
        };
        const auto energy = [&](const VecX& offset) -> VecX {
            return VecX::Constant(1, reference(model, assembly, moved(offset), Tangent::warped).energy);
        };
        const auto force_at = [&](const VecX& offset) -> VecX {
            std::vector<double> f;
            assembly.forces(moved(offset), f);
            return Eigen::Map<const VecX>(f.data(), n);
        };
        const MatX gradient = -Eigen::Map<const VecX>(force.data(), n).transpose();
        CHECK(test::derivative_error(energy, VecX::Zero(n), gradient, 1e-3) < 1e-6);
        const MatX tangent = -dense(assembly.pattern(), stiffness);
        CHECK(test::derivative_error(force_at, VecX::Zero(n), tangent, 1e-4) < 1e-6);
    }

    TEST_CASE("every instruction set gives the same forces and stiffness to the last bit") {
        for (const Formulation formulation : {Formulation::linear, Formulation::edge_smoothed}) {
            const SolidModel model = small_bar(formulation);
            for (const auto& [mode, tangent] : modes) {
                std::vector<double> first_force;
                BlockValues first_stiffness;
                for (const char* name : {"baseline", "avx2", "avx512"}) {
                    if (elastic_kernel::choose(name) == nullptr) {
                        continue;
                    }
                    ElasticAssembly assembly = make(model, name);
                    const std::vector<double> x = shaken(model, assembly, 0.3, 13);
                    std::vector<double> force;
                    BlockValues stiffness = zero_values(assembly.pattern());
                    assembly.forces_and_stiffness(x, mode, 0.7, force, stiffness);
                    if (first_force.empty()) {
                        first_force = force;
                        first_stiffness = stiffness;
                    }
                    CHECK(force == first_force);
                    CHECK(stiffness == first_stiffness);
                }
            }
        }
    }

    TEST_CASE("elements that are gone pull at nothing, and nodes without elements or fixed drop out of the stiffness") {
        SolidModel model = small_bar(Formulation::linear);
        model.fixed_nodes = {0, 1};
        ElasticAssembly assembly = make(model, "");
        SolidState state = rest_state(model);
        for (std::size_t t = 0; t < state.present.size(); ++t) {
            const std::array<int, 4>& tet = model.coarse.tets[t];
            state.present[t] = std::find(tet.begin(), tet.end(), 5) == tet.end() ? 1 : 0;
        }
        CHECK(assembly.load(state));
        CHECK_FALSE(assembly.load(state));
        const std::vector<double> x = shaken(model, assembly, 0.1, 14);
        std::vector<double> force;
        BlockValues stiffness = zero_values(assembly.pattern());
        assembly.forces_and_stiffness(x, Mode::warped, 1.0, force, stiffness);
        mirror_upper(assembly.pattern(), stiffness);
        const MatX k = dense(assembly.pattern(), stiffness);
        for (const int node : {0, 1, 5}) {
            const int row = assembly.row_of()[at(node)];
            CHECK(assembly.moves()[at(row)] == 0);
            CHECK(k.middleRows<3>(3 * row).norm() == 0.0);
        }
        const int orphan = assembly.row_of()[5];
        CHECK(Eigen::Map<const Vec3>(force.data() + 3 * orphan).norm() == 0.0);
        CHECK(k.norm() > 0.0);
    }

    TEST_CASE("a position that is not finite gives forces that are not") {
        const SolidModel model = small_bar(Formulation::linear);
        ElasticAssembly assembly = make(model, "");
        std::vector<double> x = shaken(model, assembly, 0.0, 15);
        x[4] = std::nan("");
        std::vector<double> force;
        assembly.forces(x, force);
        double sum = 0.0;
        for (const double f : force) {
            sum += f;
        }
        CHECK_FALSE(std::isfinite(sum));
    }
}
