// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "math/cholesky.hpp"
#include "math/elimination_tree.hpp"
#include "math/grown_pattern.hpp"
#include "math/packed_factor.hpp"
#include "math/pcg.hpp"
#include "math/supernodes.hpp"

using namespace rhexis;

namespace {

/// A grid of nodes, each tied to its neighbours, in the order of elimination.
BlockPattern grid_pattern(int side) {
    std::vector<int> first{0};
    std::vector<int> node;
    const auto tie = [&](int a, int b) {
        node.insert(node.end(), {a, b});
        first.push_back(static_cast<int>(node.size()));
    };
    const auto index = [side](int i, int j, int k) { return i + side * (j + side * k); };
    for (int k = 0; k < side; ++k) {
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                for (const auto& [a, b, c] : {std::array{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}}) {
                    if (i + a < side && j + b < side && k + c < side) {
                        tie(index(i, j, k), index(i + a, j + b, k + c));
                    }
                }
            }
        }
    }
    const int nodes = side * side * side;
    const std::vector<int> order = elimination_order(block_pattern(nodes, first, node));
    std::vector<int> place(at(nodes));
    for (int k = 0; k < nodes; ++k) {
        place[at(order[at(k)])] = k;
    }
    for (int& n : node) {
        n = place[at(n)];
    }
    return block_pattern(nodes, first, node);
}

/// Random symmetric blocks, and a diagonal that makes the whole positive definite.
BlockValues random_matrix(const BlockPattern& pattern, double diagonal, std::uint64_t seed) {
    Rng random(seed);
    BlockValues values = zero_values(pattern);
    for (int i = 0; i < pattern.rows(); ++i) {
        for (int slot = pattern.diagonal[at(i)] + 1; slot < pattern.first[at(i) + 1]; ++slot) {
            Mat3 block;
            for (int k = 0; k < 9; ++k) {
                block(k / 3, k % 3) = 2.0 * random.uniform() - 1.0;
            }
            add_block(values, slot, block);
        }
        add_block(values, pattern.diagonal[at(i)], diagonal * Mat3::Identity() + 0.5 * Mat3::Ones());
    }
    mirror_upper(pattern, values);
    return values;
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

VecX random_vector(int n, std::uint64_t seed) {
    Rng random(seed);
    VecX result(n);
    for (double& x : result) {
        x = random.normal();
    }
    return result;
}

std::vector<float> spread(const VecX& x) {
    std::vector<float> result(static_cast<std::size_t>(x.size() / 3 * 4), 0.0F);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        result[static_cast<std::size_t>(4 * (i / 3) + i % 3)] = static_cast<float>(x[i]);
    }
    return result;
}

double largest_error(const std::vector<float>& x, const VecX& reference) {
    double error = 0.0;
    for (Eigen::Index i = 0; i < reference.size(); ++i) {
        error = std::max(
            error, std::abs(static_cast<double>(x[static_cast<std::size_t>(4 * (i / 3) + i % 3)]) - reference[i]));
    }
    return error / reference.cwiseAbs().maxCoeff();
}

constexpr std::array instruction_sets{"baseline", "avx2", "avx512"};

}  // namespace

TEST_SUITE("math") {
    TEST_CASE("a block matrix is symmetric after mirroring and multiplies like a dense one") {
        const BlockPattern pattern = grid_pattern(4);
        const BlockValues values = random_matrix(pattern, 20.0, 1);
        const MatX full = dense(pattern, values);
        CHECK((full - full.transpose()).cwiseAbs().maxCoeff() == 0.0);
        const VecX x = random_vector(static_cast<int>(full.rows()), 2);
        const VecX expected = full * x;
        VecX y(x.size());
        multiply(pattern, values, {x.data(), static_cast<std::size_t>(x.size())},
                 {y.data(), static_cast<std::size_t>(y.size())});
        CHECK((y - expected).cwiseAbs().maxCoeff() < 1e-13 * expected.cwiseAbs().maxCoeff());
        for (const char* name : instruction_sets) {
            const linear_kernel::Kernel* kernel = linear_kernel::choose(name);
            if (kernel != nullptr) {
                VecX z(x.size());
                kernel->multiply({pattern.rows(), pattern.first.data(), pattern.column.data(), values.data()}, x.data(),
                                 z.data());
                CHECK((z - expected).cwiseAbs().maxCoeff() < 1e-13 * expected.cwiseAbs().maxCoeff());
            }
        }
    }

    TEST_CASE("both factors of CHOLMOD solve, and refuse what is indefinite or not finite") {
        const BlockPattern pattern = grid_pattern(5);
        const BlockValues values = random_matrix(pattern, 20.0, 3);
        const VecX b = random_vector(3 * pattern.rows(), 4);
        const std::size_t n = static_cast<std::size_t>(b.size());
        for (const CholeskyKind kind : {CholeskyKind::simplicial, CholeskyKind::supernodal}) {
            Cholesky factor(pattern, kind);
            REQUIRE(factor.factor(values));
            VecX x(b.size());
            factor.solve({b.data(), n}, {x.data(), n});
            CHECK((dense(pattern, values) * x - b).norm() < 1e-12 * b.norm());
            CHECK_FALSE(factor.factor(random_matrix(pattern, 0.1, 3)));
            CHECK_FALSE(factor.factored());
            BlockValues bad = values;
            bad[7] = std::numeric_limits<double>::quiet_NaN();
            CHECK_FALSE(factor.factor(bad));
        }
    }

    TEST_CASE("an indefinite factor solves, and counts the negative eigenvalues") {
        const BlockPattern pattern = grid_pattern(3);
        for (const double diagonal : {20.0, 2.0, -20.0}) {
            const BlockValues values = random_matrix(pattern, diagonal, 5);
            const MatX a = dense(pattern, values);
            const VecX eigen = Eigen::SelfAdjointEigenSolver<MatX>(a).eigenvalues();
            Cholesky factor(pattern, CholeskyKind::indefinite);
            REQUIRE(factor.factor(values));
            CHECK(factor.negative_pivots() == static_cast<int>((eigen.array() < 0.0).count()));
            const VecX b = VecX::LinSpaced(a.rows(), -1.0, 1.0);
            VecX x(a.rows());
            factor.solve({b.data(), static_cast<std::size_t>(b.size())},
                         {x.data(), static_cast<std::size_t>(x.size())});
            CHECK((a * x - b).norm() < 1e-9 * b.norm());
        }
    }

    TEST_CASE("the packed factor solves to single precision with the same bits for every instruction set") {
        for (const int side : {1, 2, 5, 9}) {
            const BlockPattern pattern = grid_pattern(side);
            const BlockValues values = random_matrix(pattern, 20.0, 5);
            const VecX b = random_vector(3 * pattern.rows(), 6);
            const VecX exact = dense(pattern, values).ldlt().solve(b);
            std::vector<float> first;
            for (const char* name : instruction_sets) {
                const linear_kernel::Kernel* kernel = linear_kernel::choose(name);
                if (kernel == nullptr) {
                    continue;
                }
                PackedFactor factor(pattern, *kernel);
                REQUIRE(factor.factor(values));
                std::vector<float> x = spread(b);
                factor.solve(x);
                CHECK(largest_error(x, exact) < 1e-5);
                if (first.empty()) {
                    first = x;
                }
                CHECK(x == first);
            }
        }
    }

    TEST_CASE("a packed factor that goes from pattern to pattern has the bits of a new one") {
        const linear_kernel::Kernel& kernel = *linear_kernel::choose();
        const BlockPattern first = grid_pattern(7);
        PackedFactor followed(first, kernel);
        REQUIRE(followed.factor(random_matrix(first, 20.0, 5)));
        for (const int side : {3, 9, 2, 7}) {  // of the widest of these some panels are cut
            const BlockPattern pattern = grid_pattern(side);
            const BlockValues values = random_matrix(pattern, 20.0, 11);
            PackedFactor fresh(pattern, kernel);
            followed.follow(pattern);
            CHECK_FALSE(followed.factored());
            CHECK(followed.factor_work() == fresh.factor_work());
            CHECK(followed.solve_work() == fresh.solve_work());
            REQUIRE(fresh.factor(values));
            REQUIRE(followed.factor(values));
            std::vector<float> x = spread(random_vector(3 * pattern.rows(), 6));
            std::vector<float> same = x;
            fresh.solve(x);
            followed.solve(same);
            CHECK(x == same);
        }
    }

    TEST_CASE("a pattern and a factor that grow are those of the whole, as a tear would have them") {
        const linear_kernel::Kernel& kernel = *linear_kernel::choose();
        BlockPattern pattern = grid_pattern(6);
        PackedFactor grown(pattern, kernel);
        Supernodes tree = find_supernodes(pattern);
        int followed = 0;
        Rng random(3);
        for (int round = 0; round < 40; ++round) {
            const int behind = static_cast<int>(random.uniform() * pattern.rows());
            const int own = behind + 1;
            const int rows = pattern.rows() + 1;
            std::vector<int> row_now;
            for (int row = 0; row + 1 < rows; ++row) {
                row_now.push_back(row <= behind ? row : row + 1);
            }
            std::vector<int> first{0};
            std::vector<int> node;
            std::vector<std::uint8_t> changed(at(rows), 0);
            changed[at(behind)] = changed[at(own)] = 1;
            for (int row = 0; row < pattern.rows(); ++row) {
                for (int slot = pattern.diagonal[at(row)] + 1; slot < pattern.first[at(row) + 1]; ++slot) {
                    int a = row_now[at(row)];
                    int b = row_now[at(pattern.column[at(slot)])];
                    const bool moves = (a == behind || b == behind) && (a + b) % 2 == 0;
                    changed[at(a)] |= a == behind || b == behind ? 1 : 0;
                    changed[at(b)] |= a == behind || b == behind ? 1 : 0;
                    a = moves && a == behind ? own : a;
                    b = moves && b == behind ? own : b;
                    node.insert(node.end(), {a, b});
                    first.push_back(static_cast<int>(node.size()));
                }
            }
            const BlockPattern whole = block_pattern(rows, first, node);
            std::vector<std::array<int, 2>> entries;
            for (int row = 0; row < rows; ++row) {
                for (int slot = whole.first[at(row)]; changed[at(row)] != 0 && slot < whole.first[at(row) + 1];
                     ++slot) {
                    entries.push_back({row, whole.column[at(slot)]});
                }
            }
            GrownPattern next = grown_pattern(pattern, rows, row_now, changed, entries);
            CHECK(next.pattern.first == whole.first);
            CHECK(next.pattern.column == whole.column);
            CHECK(next.pattern.diagonal == whole.diagonal);
            CHECK(next.pattern.mirror == whole.mirror);
            for (int row = 0; row < pattern.rows(); ++row) {
                for (int slot = pattern.first[at(row)]; slot < pattern.first[at(row) + 1]; ++slot) {
                    CHECK(next.slot_now[at(slot)] ==
                          whole.slot(row_now[at(row)], row_now[at(pattern.column[at(slot)])]));
                }
            }
            CHECK(next.slot_now.back() == whole.blocks());
            pattern = std::move(next.pattern);
            if (grow(tree, pattern, row_now)) {
                ++followed;
            } else {
                tree = find_supernodes(pattern);
            }
            grown.follow(pattern, row_now);
            const BlockValues values = random_matrix(pattern, 40.0, 11);
            const VecX b = random_vector(3 * rows, 6);
            REQUIRE(grown.factor(values));
            std::vector<float> x = spread(b);
            grown.solve(x);
            CHECK(largest_error(x, dense(pattern, values).ldlt().solve(b)) < 1e-5);
        }
        CHECK(followed >= 30);
    }

    TEST_CASE("a tree of panels that grows has a place for every entry, and says where it has none") {
        const BlockPattern chain = block_pattern(4, std::vector<int>{0, 2, 4, 6}, std::vector<int>{0, 1, 1, 2, 2, 3});
        const std::vector<int> row_now{0, 2, 3, 4};  // a row behind the first
        Supernodes tree = find_supernodes(chain);
        const BlockPattern beside =
            block_pattern(5, std::vector<int>{0, 2, 4, 6, 8}, std::vector<int>{0, 1, 1, 2, 2, 3, 3, 4});
        CHECK(grow(tree, beside, row_now));
        CHECK(tree.first.back() == 5);
        Supernodes pairs = find_supernodes(block_pattern(4, std::vector<int>{0, 2, 4}, std::vector<int>{0, 1, 2, 3}));
        const BlockPattern across = block_pattern(5, std::vector<int>{0, 2, 4, 6}, std::vector<int>{0, 2, 1, 4, 3, 4});
        CHECK_FALSE(grow(pairs, across, row_now));
    }

    TEST_CASE("rows of the factor are where a dense one has entries") {
        const BlockPattern pattern = grid_pattern(4);
        const int n = pattern.rows();
        MatX has = MatX::Zero(n, n);  // elimination of the graph
        for (int i = 0; i < n; ++i) {
            for (int slot = pattern.first[at(i)]; slot < pattern.first[at(i) + 1]; ++slot) {
                has(i, pattern.column[at(slot)]) = 1.0;
            }
        }
        for (int k = 0; k < n; ++k) {
            for (int i = k + 1; i < n; ++i) {
                for (int j = k + 1; j < n && has(i, k) > 0.0; ++j) {
                    has(i, j) = has(j, k) > 0.0 ? 1.0 : has(i, j);
                }
            }
        }
        const std::vector<int> tree = elimination_tree(pattern);
        const FactorRows rows = factor_rows(pattern, tree);
        for (int j = 0; j < n; ++j) {
            std::vector<int> expected;
            for (int i = j + 1; i < n; ++i) {
                if (has(i, j) > 0.0) {
                    expected.push_back(i);
                }
            }
            CHECK(std::vector<int>(rows.row.begin() + rows.first[at(j)], rows.row.begin() + rows.first[at(j) + 1]) ==
                  expected);
            CHECK(tree[at(j)] == (expected.empty() ? -1 : expected.front()));
        }
    }

    TEST_CASE("a pattern with other numbers is that of groups with other numbers") {
        const std::vector<int> first{0, 3, 6, 8};
        const std::vector<int> node{0, 1, 2, 2, 3, 1, 4, 0};
        const std::vector<int> order{3, 0, 4, 2, 1};
        const std::vector<int> place{1, 4, 3, 0, 2};
        std::vector<int> other;
        for (const int n : node) {
            other.push_back(place[at(n)]);
        }
        const BlockPattern expected = block_pattern(5, first, other);
        const BlockPattern result = permuted(block_pattern(5, first, node), order, place);
        CHECK(result.first == expected.first);
        CHECK(result.column == expected.column);
        CHECK(result.diagonal == expected.diagonal);
        CHECK(result.mirror == expected.mirror);
    }

    TEST_CASE("the packed factor refuses what is indefinite or not finite, and recovers") {
        const BlockPattern pattern = grid_pattern(4);
        PackedFactor factor(pattern, *linear_kernel::choose());
        CHECK_FALSE(factor.factor(random_matrix(pattern, 0.1, 7)));
        BlockValues bad = random_matrix(pattern, 20.0, 7);
        bad[9 * at(pattern.diagonal[5])] = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(factor.factor(bad));
        CHECK_FALSE(factor.factored());
        CHECK(factor.factor(random_matrix(pattern, 20.0, 7)));
    }

    TEST_CASE("an unknown instruction set has no kernel") {
        CHECK(linear_kernel::choose("mmx") == nullptr);
        CHECK(linear_kernel::choose("baseline") != nullptr);
    }

    TEST_CASE("conjugate gradients end at the tolerance, start where they are told and report indefinite matrices") {
        const BlockPattern pattern = grid_pattern(4);
        const BlockValues values = random_matrix(pattern, 20.0, 8);
        const VecX b = random_vector(3 * pattern.rows(), 9);
        const std::size_t n = static_cast<std::size_t>(b.size());
        const auto product = [&](const BlockValues& a) {
            return [&pattern, &a](std::span<const double> x, std::span<double> y) { multiply(pattern, a, x, y); };
        };
        const auto nothing = [](std::span<const double> r, std::span<double> z) {
            std::copy(r.begin(), r.end(), z.begin());
        };
        VecX x(b.size());
        PcgWork work;
        const PcgResult cold =
            pcg({b.data(), n}, 1e-10, 500, product(values), nothing, {x.data(), n}, PcgStart::zero, work);
        CHECK(cold.converged);
        CHECK((dense(pattern, values) * x - b).norm() < 1.1e-10);
        const PcgResult warm =
            pcg({b.data(), n}, 2e-10, 500, product(values), nothing, {x.data(), n}, PcgStart::from_x, work);
        CHECK(warm.iterations == 0);
        const BlockValues indefinite = random_matrix(pattern, 0.1, 8);
        const PcgResult odd =
            pcg({b.data(), n}, 1e-10, 500, product(indefinite), nothing, {x.data(), n}, PcgStart::zero, work);
        CHECK_FALSE(odd.converged);
        CHECK_FALSE(odd.definite);
        x[3] = std::numeric_limits<double>::quiet_NaN();
        CHECK_FALSE(
            pcg({b.data(), n}, 1e-10, 500, product(values), nothing, {x.data(), n}, PcgStart::from_x, work).finite);
    }
}
