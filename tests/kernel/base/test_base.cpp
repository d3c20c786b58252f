// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "base/hash.hpp"
#include "base/result.hpp"
#include "base/rng.hpp"
#include "base/slot_map.hpp"
#include "base/threads.hpp"

using namespace rhexis;

TEST_SUITE("base") {
    TEST_CASE("an error reads as one line with place, fault and what is allowed") {
        const Error error{"pupil_mm is 12", "curriculum.lua:7", "3 to 9"};
        CHECK(error.text() == "curriculum.lua:7: pupil_mm is 12 (3 to 9)");
    }

    TEST_CASE("streams of random numbers differ by purpose and repeat by seed") {
        Rng a(1, "tremor");
        Rng b(1, "tremor");
        Rng c(1, "lapse");
        const std::uint32_t first = a.next();
        CHECK(first == b.next());
        CHECK(first != c.next());
    }

    TEST_CASE("normal deviates have mean 0 and variance 1") {
        Rng rng(7);
        double sum = 0.0;
        double squares = 0.0;
        const int n = 100000;
        for (int i = 0; i < n; ++i) {
            const double x = rng.normal();
            sum += x;
            squares += x * x;
        }
        CHECK(std::abs(sum / n) < 0.02);
        CHECK(std::abs(squares / n - 1.0) < 0.02);
    }

    TEST_CASE("a state hash tells numbers apart but not the sign of zero") {
        StateHash a;
        StateHash b;
        StateHash c;
        a.add(0.0);
        b.add(-0.0);
        c.add(1.0);
        CHECK(a.value() == b.value());
        CHECK(a.value() != c.value());
        CHECK(sha256_hex("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }

    TEST_CASE("a stale id finds nothing") {
        SlotMap<int> map;
        const SlotId first = map.insert(1);
        CHECK(map.erase(first));
        const SlotId second = map.insert(2);
        CHECK(map.find(first) == nullptr);
        REQUIRE(map.find(second) != nullptr);
        CHECK(*map.find(second) == 2);
        CHECK(map.find(SlotId{}) == nullptr);
    }

    TEST_CASE("each chunk runs once whatever the number of threads") {
        for (const int threads : {1, 2, 4}) {
            ThreadPool pool(threads);
            for (int round = 0; round < 200; ++round) {
                std::vector<std::atomic<int>> runs(13);
                pool.for_each_chunk(13, [&](int chunk) { ++runs[static_cast<std::size_t>(chunk)]; });
                for (const std::atomic<int>& count : runs) {
                    CHECK(count == 1);
                }
            }
        }
    }
}
