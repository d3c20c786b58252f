// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/rng.hpp"
#include "math/block_matrix.hpp"
#include "physics/solve/coupled_matrix.hpp"
#include "physics/solve/kept_solver.hpp"
#include "scenes/eigenvalues.hpp"

using namespace rhexis;

namespace {

/// Four nodes, every one alone or all in one element.
BlockPattern pattern_of_four(bool together) {
    const std::vector<int> nodes{0, 1, 2, 3};
    const std::vector<int> first = together ? std::vector<int>{0, 4} : std::vector<int>{0, 1, 2, 3, 4};
    return block_pattern(4, first, nodes);
}

Mat3 share_of(double turn) {
    Mat3 share;
    share << 0.2, -turn, 0.5, turn, -0.3, 0.1, -0.5, 0.4, 0.6;
    return share;
}

/// A contact of three nodes by weights, and one of a shell's shares with a node.
std::vector<ContactTerm> contacts() {
    const Vec3 normal = Vec3(1.0, 2.0, -0.5).normalized();
    ContactTerm weighted;
    weighted.nodes = {0, 1, 3};
    weighted.weights = {0.7, 0.3, -1.0};
    weighted.stiffness = 5.0 * normal * normal.transpose() + 0.5 * Mat3::Identity();
    ContactTerm turning;
    turning.nodes = {2, -1, -1};
    turning.weights = {-0.8, 0.0, 0.0};
    turning.stiffness = 3.0 * normal * normal.transpose();
    turning.more = {{0, share_of(0.9)}, {1, share_of(-1.7)}, {3, -2.0 * share_of(0.1)}};
    return {weighted, turning};
}

/// Symmetric and positive definite, of four nodes, and like no other.
CoupledMatrix unlike_others(const BlockPattern& pattern, Rng& random) {
    CoupledMatrix matrix(pattern, *linear_kernel::choose());
    matrix.clear_coupling(0);
    MatX root(12, 12);
    for (Eigen::Index i = 0; i < root.size(); ++i) {
        root(i / 12, i % 12) = std::pow(10.0, 2.0 * random.uniform()) * (random.uniform() - 0.5);
    }
    const MatX full = root * root.transpose() + MatX::Identity(12, 12);
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            add_block(matrix.solid(), pattern.slot(i, j), full.block<3, 3>(3 * i, 3 * j));
        }
    }
    return matrix;
}

CoupledMatrix matrix_of(const BlockPattern& pattern) {
    CoupledMatrix matrix(pattern, *linear_kernel::choose());
    matrix.solid() = zero_values(pattern);
    matrix.clear_coupling(0);
    const std::vector<std::uint8_t> moves(4, 1);
    for (const ContactTerm& contact : contacts()) {
        matrix.add(contact, 0.1, moves);
    }
    return matrix;
}

MatX dense(const CoupledMatrix& matrix) {
    MatX result(12, 12);
    for (int column = 0; column < 12; ++column) {
        std::vector<double> unit(13, 0.0);
        std::vector<double> image(13, 0.0);
        unit[static_cast<std::size_t>(column)] = 1.0;
        matrix.multiply({unit.data(), 12}, {image.data(), 12});
        result.col(column) = Eigen::Map<const VecX>(image.data(), 12);
    }
    return result;
}

MatX dense(const BlockPattern& pattern, const BlockValues& values) {
    MatX result = MatX::Zero(12, 12);
    for (int i = 0; i < pattern.rows(); ++i) {
        for (int slot = pattern.first[static_cast<std::size_t>(i)];
             slot < pattern.first[static_cast<std::size_t>(i) + 1]; ++slot) {
            result.block<3, 3>(3 * i, 3 * pattern.column[static_cast<std::size_t>(slot)]) = block_of(values, slot);
        }
    }
    return result;
}

}  // namespace

TEST_SUITE("coupled matrix") {
    TEST_CASE("contacts between nodes without an element act as those with one") {
        const BlockPattern alone = pattern_of_four(false);
        const BlockPattern together = pattern_of_four(true);
        const MatX apart = dense(matrix_of(alone));
        CHECK(matrix_of(alone).has_links());
        CHECK_FALSE(matrix_of(together).has_links());
        CHECK((apart - dense(matrix_of(together))).norm() < 1e-14 * apart.norm());
    }

    TEST_CASE("within its pattern it is no less than it is") {
        const BlockPattern alone = pattern_of_four(false);
        const CoupledMatrix matrix = matrix_of(alone);
        const MatX more = dense(alone, matrix.solid_within_pattern()) - dense(matrix);
        CHECK((more - more.transpose()).norm() < 1e-14 * more.norm());
        const VecX values = scenes::eigenvalues(more);
        CHECK(values[0] > -1e-12);
        CHECK(values[11] > 0.1);
    }

    TEST_CASE("a kept factor that does not serve is tried ever more seldom, until one does") {
        const BlockPattern pattern = pattern_of_four(true);
        KeptSolver solver(pattern, *linear_kernel::choose());
        solver.try_seldom(true);
        Rng random(3);
        std::vector<double> b(12, 1.0);
        b.resize(13);  // a number of padding
        std::vector<double> x(13);
        std::vector<double> image(13);
        std::vector<int> tried;
        for (int i = 0; i < 40; ++i) {
            const CoupledMatrix matrix = unlike_others(pattern, random);
            const KeptSolver::Outcome outcome = solver.solve(matrix, {b.data(), 12}, 1e-9, 100, {x.data(), 12});
            CHECK(outcome.converged);
            CHECK(outcome.factored);
            matrix.multiply(x, image);
            double square = 0.0;
            for (std::size_t k = 0; k < 12; ++k) {
                square += (b[k] - image[k]) * (b[k] - image[k]);
            }
            CHECK(std::sqrt(square) < 1e-8);
            if (outcome.iterations > 4) {
                tried.push_back(i);
            }
        }
        CHECK(tried == std::vector<int>{1, 3, 7, 15, 31});
        const CoupledMatrix same = unlike_others(pattern, random);
        int factored = 0;
        for (int i = 0; i < 80; ++i) {
            factored += solver.solve(same, {b.data(), 12}, 1e-9, 100, {x.data(), 12}).factored ? 1 : 0;
        }
        CHECK(factored < 40);
        CHECK_FALSE(solver.solve(same, {b.data(), 12}, 1e-9, 100, {x.data(), 12}).factored);
    }
}
