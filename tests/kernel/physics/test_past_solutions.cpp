// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/index.hpp"
#include "base/rng.hpp"
#include "math/block_matrix.hpp"
#include "math/pcg.hpp"
#include "physics/solve/kept_solver.hpp"
#include "physics/solve/past_solutions.hpp"

using namespace rhexis;

namespace {

constexpr int nodes = 40;
constexpr std::size_t body = 6;

/// A chain of nodes, each tied to the next two, with a contact to a rigid body and one between its ends.
struct Chain {
    BlockPattern pattern;
    CoupledMatrix matrix;

    explicit Chain(const linear_kernel::Kernel& kernel) : pattern(pattern_of_chain()), matrix(pattern, kernel) {
        Rng random(5);
        matrix.solid() = zero_values(pattern);
        matrix.clear_coupling(1);
        for (int i = 0; i < nodes; ++i) {
            const Mat3 root = Mat3::Identity() + 0.1 * Mat3::NullaryExpr([&] { return random.uniform() - 0.5; });
            add_block(matrix.solid(), pattern.diagonal[at(i)], 9.0 * root * root.transpose());
            for (int j = i + 1; j < std::min(nodes, i + 3); ++j) {
                const Mat3 block = Mat3::NullaryExpr([&] { return random.uniform() - 0.5; });
                add_block(matrix.solid(), pattern.slot(i, j), block);
                add_block(matrix.solid(), pattern.slot(j, i), block.transpose());
            }
        }
        matrix.rigid() = 20.0 * MatX::Identity(body, body);
        ContactTerm with_body;
        with_body.nodes = {3, 4, -1};
        with_body.weights = {0.4, 0.6, 0.0};
        with_body.body = 0;
        with_body.arm = Vec3(0.5, -0.2, 0.1);
        with_body.stiffness = Mat3::Identity();
        ContactTerm ends;
        ends.nodes = {0, nodes - 1, -1};
        ends.weights = {1.0, -1.0, 0.0};
        ends.stiffness = 2.0 * Mat3::Identity();
        const std::vector<std::uint8_t> moves(nodes, 1);
        matrix.add(with_body, 1.0, moves);
        matrix.add(ends, 1.0, moves);
    }
    static BlockPattern pattern_of_chain() {
        std::vector<int> first{0};
        std::vector<int> members;
        for (int i = 0; i + 2 < nodes; ++i) {
            members.insert(members.end(), {i, i + 1, i + 2});
            first.push_back(static_cast<int>(members.size()));
        }
        return block_pattern(nodes, first, members);
    }
};

std::vector<double> some(std::size_t n, Rng& random) {
    std::vector<double> result(n);
    for (double& number : result) {
        number = random.uniform() - 0.5;
    }
    return result;
}

std::vector<double> product(const CoupledMatrix& matrix, std::vector<double> x) {
    std::vector<double> image(x.size() + 1);
    x.push_back(0.0);
    matrix.multiply({x.data(), x.size() - 1}, {image.data(), x.size() - 1});
    image.pop_back();
    return image;
}

double left_of(const CoupledMatrix& matrix, const std::vector<double>& b, const std::vector<double>& x) {
    std::vector<double> r = product(matrix, x);
    for (std::size_t i = 0; i < r.size(); ++i) {
        r[i] -= b[i];
    }
    return std::sqrt(dot(r, r) / dot(b, b));
}

const std::vector<const char*> sets{"baseline", "avx2", "avx512"};

}  // namespace

TEST_SUITE("past solutions") {
    TEST_CASE("many vectors at once are multiplied as each alone, with the same bits on every instruction set") {
        std::vector<std::vector<double>> images;
        std::vector<std::vector<double>> guesses;
        for (const char* const set : sets) {
            const linear_kernel::Kernel* const kernel = linear_kernel::choose(set);
            if (kernel == nullptr) {
                continue;
            }
            const Chain chain(*kernel);
            CHECK(chain.matrix.has_links());
            const std::size_t n = chain.matrix.size();
            Rng random(7);
            const std::vector<double> all = some(linear_kernel::many * n, random);
            std::vector<double> image(all.size());
            chain.matrix.multiply_many(all, image);
            for (std::size_t v = 0; v < linear_kernel::many; ++v) {
                std::vector<double> alone(n);
                for (std::size_t i = 0; i < n; ++i) {
                    alone[i] = all[linear_kernel::many * i + v];
                }
                alone = product(chain.matrix, alone);
                for (std::size_t i = 0; i < n; ++i) {
                    CHECK(image[linear_kernel::many * i + v] == doctest::Approx(alone[i]).epsilon(1e-12));
                }
            }
            images.push_back(image);
            PastSolutions past;
            past.keep(some(n, random));
            past.keep(some(n, random));
            std::vector<double> guess(2 * n);
            past.project(chain.matrix, some(n, random), {guess.data(), n}, {guess.data() + n, n});
            guesses.push_back(guess);
        }
        REQUIRE_FALSE(images.empty());
        for (const std::vector<double>& image : images) {
            CHECK(image == images.front());
        }
        for (const std::vector<double>& guess : guesses) {
            CHECK(guess == guesses.front());
        }
    }

    TEST_CASE("what earlier solutions span is found, and what is not is left over") {
        const Chain chain(*linear_kernel::choose());
        const std::size_t n = chain.matrix.size();
        Rng random(11);
        PastSolutions past;
        CHECK_FALSE(past.any(n));
        std::vector<double> sum(n, 0.0);
        std::vector<double> x(n);
        std::vector<double> image(n);
        for (int k = 0; k < 5; ++k) {
            const std::vector<double> one = some(n, random);
            past.keep(one);
            past.keep(one);  // twice the same: nothing of its own
            for (std::size_t i = 0; i < n; ++i) {
                sum[i] += (k >= 1 ? 0.3 * k : 0.0) * one[i];  // the first has been pushed out
            }
        }
        CHECK(past.any(n));
        CHECK_FALSE(past.any(n - 3));
        const std::vector<double> b = product(chain.matrix, sum);
        past.project(chain.matrix, b, x, image);
        CHECK(left_of(chain.matrix, b, x) < 1e-10);
        const std::vector<double> other = some(n, random);
        past.project(chain.matrix, other, x, image);
        const std::vector<double> its = product(chain.matrix, x);
        for (std::size_t i = 0; i < n; ++i) {
            CHECK(image[i] == doctest::Approx(its[i]).epsilon(1e-9));
        }
        CHECK(left_of(chain.matrix, other, x) > 0.1);
        past.keep(some(n - 3, random));
        CHECK_FALSE(past.any(n));
        past.forget();
        CHECK_FALSE(past.any(n - 3));
    }

    TEST_CASE("a solution that ran away is taken for nothing") {
        const Chain chain(*linear_kernel::choose());
        const std::size_t n = chain.matrix.size();
        Rng random(17);
        PastSolutions past;
        std::vector<double> wild = some(n, random);
        wild[7] = 1e200;
        past.keep(wild);
        const std::vector<double> good = some(n, random);
        past.keep(good);
        std::vector<double> x(n);
        std::vector<double> image(n);
        past.project(chain.matrix, product(chain.matrix, good), x, image);
        for (std::size_t i = 0; i < n; ++i) {
            CHECK(x[i] == doctest::Approx(good[i]).epsilon(1e-6));
        }
    }

    TEST_CASE("a load that goes on smoothly takes fewer iterations than one that leaps, and both are solved") {
        const auto iterations = [](bool leaps, bool foretells) {
            Chain chain(*linear_kernel::choose());
            KeptSolver solver(chain.pattern, *linear_kernel::choose());
            solver.foretell(foretells);
            const std::size_t n = chain.matrix.size();
            Rng random(13);
            const std::vector<double> sine = some(n, random);
            const std::vector<double> cosine = some(n, random);
            std::vector<double> x(n + 1);
            int sum = 0;
            for (int step = 0; step < 40; ++step) {
                for (int i = 0; i < nodes; ++i) {  // the matrix drifts from its factor
                    add_block(chain.matrix.solid(), chain.pattern.diagonal[at(i)], 0.02 * Mat3::Identity());
                }
                const double t = leaps ? 7.7 * step * step : 0.1 * step;
                std::vector<double> b = leaps ? some(n, random) : sine;
                for (std::size_t i = 0; i < n; ++i) {
                    b[i] = std::sin(t) * b[i] + std::cos(t) * cosine[i];
                }
                const KeptSolver::Outcome outcome = solver.solve(chain.matrix, b, 1e-9, 100, {x.data(), n});
                CHECK(outcome.converged);
                CHECK(left_of(chain.matrix, b, {x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n)}) < 1e-8);
                sum += step >= 10 ? outcome.iterations : 0;
            }
            return sum;
        };
        CHECK(iterations(false, true) < 0.8 * iterations(true, true));
        CHECK(iterations(false, true) < 0.8 * iterations(false, false));
    }
}
