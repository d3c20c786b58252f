// SPDX-License-Identifier: GPL-3.0-or-later
// Grooves told apart, on fills that are drawn column by column.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include "base/rng.hpp"
#include "eye/make_eye.hpp"
#include "math/random_vectors.hpp"
#include "observe/groove_arms.hpp"

using namespace rhexis;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// The columns of a lens, and what is cut out of them.
struct Plate {
    ColumnGrid grid;
    ColumnFill fill;

    Plate() {
        Patient patient;
        patient.tetrahedra = 500;
        grid = make_columns(make_eye(patient).value().lens, 0.2);
        fill.removed.assign(grid.cells(), 0.0);
    }

    void cut(int cell, double depth) {
        if (grid.inside(cell)) {
            fill.removed[cell] = std::max(fill.removed[cell], std::min(depth, grid.thickness(cell)));
        }
    }

    /// A groove through `middle`, `turn` degrees from +y to +x; its floor falls off towards both sides and ends.
    void groove(const Vec2& middle, double turn, double length, double width, double depth) {
        const Vec2 along(std::sin(turn * degree), std::cos(turn * degree));
        for (int cell = 0; cell < grid.cells(); ++cell) {
            const Vec2 offset = grid.centre(cell) - middle;
            const double t = std::abs(offset.dot(along)) / (0.5 * length);
            const double s = std::abs(offset.x() * along.y() - offset.y() * along.x()) / (0.5 * width);
            if (t <= 1.0 && s <= 1.0) {
                cut(cell, depth * (1.0 - 0.3 * t * t) * (1.0 - 0.4 * s * s));
            }
        }
    }

    /// A few tenths off here and there, and single columns gone right through.
    void noise(std::uint64_t seed) {
        Rng rng(seed, "plate");
        for (int cell = 0; cell < grid.cells(); ++cell) {
            const double chance = rng.uniform();
            cut(cell, chance < 0.03 ? 3.0 : 0.15 * rng.uniform());
        }
    }

    /// What a surgeon's strokes left: a row of columns per line, the farthest from the surgeon first, with the depth
    /// [mm] rounded up; '.': whole, '_': no lens.
    void footprint(const std::string& file) {
        std::ifstream lines("tests/data/grooves/" + file);
        std::string line;
        for (int row = grid.count - 1; row >= 0 && std::getline(lines, line); --row) {
            for (int i = 0; i < grid.count; ++i) {
                const char mark = line.at(static_cast<std::size_t>(i));
                if (mark >= '1' && mark <= '9') {
                    cut(row * grid.count + i, mark - '0' - 0.5);
                }
            }
        }
    }

    [[nodiscard]] std::vector<GrooveShape> arms() const { return GrooveFinder().find(grid, fill); }
};

double turn_of(const GrooveShape& groove) { return std::atan2(groove.direction.x(), groove.direction.y()) / degree; }

}  // namespace

TEST_SUITE("observe") {
    TEST_CASE("one groove is found as one, with its length, width, depth and direction") {
        for (const double turn : {0.0, 20.0, 47.0, -33.0, 85.0}) {
            for (const double width : {1.0, 2.2}) {
                CAPTURE(turn);
                CAPTURE(width);
                Plate plate;
                plate.groove(Vec2(0.3, 0.5), turn, 5.0, width, 3.0);
                const std::vector<GrooveShape> arms = plate.arms();
                REQUIRE(arms.size() == 1);
                CHECK(arms[0].length == doctest::Approx(5.0).epsilon(0.1));
                CHECK(arms[0].width == doctest::Approx(width).epsilon(0.2));
                CHECK(arms[0].depth == doctest::Approx(3.0).epsilon(0.1));
                CHECK(arms[0].depth_share > 0.55);
                CHECK(arms[0].depth_share < 0.75);
                CHECK(std::abs(turn_of(arms[0]) - turn) < 4.0);
            }
        }
    }

    TEST_CASE("a cross is two grooves at its angle: slim at 90, 60 and 30 degrees, stout at 90 and 60") {
        struct Cross {
            double angle;
            double width;
            double length;
        };
        for (const Cross& cross : {Cross{90.0, 1.0, 5.0}, Cross{60.0, 1.0, 5.0}, Cross{30.0, 0.8, 6.0},
                                   Cross{90.0, 2.2, 5.2}, Cross{60.0, 2.0, 5.6}, Cross{90.0, 2.8, 5.4}}) {
            for (const double turn : {0.0, 12.0, -38.0}) {
                CAPTURE(cross.angle);
                CAPTURE(cross.width);
                CAPTURE(turn);
                Plate plate;
                plate.groove(Vec2(0.0, 0.3), turn, cross.length, cross.width, 3.2);
                plate.groove(Vec2(0.2, 0.0), turn + cross.angle, cross.length, cross.width, 2.6);
                const std::vector<GrooveShape> arms = plate.arms();
                REQUIRE(arms.size() == 2);
                CHECK(std::abs(angle_between(arms[0], arms[1]) / degree - cross.angle) < 6.5);
                CHECK(std::abs(std::remainder(turn_of(arms[0]) - turn, 180.0)) < 5.0);
                for (const GrooveShape& arm : arms) {
                    CHECK(arm.length == doctest::Approx(cross.length).epsilon(0.12));
                }
                // The depth of the second is its own, not that of the first where they cross.
                CHECK(arms[0].depth > arms[1].depth);
            }
        }
    }

    TEST_CASE("crosses in every direction, off the middle and ragged: two, within 5 degrees, nearly always") {
        int crosses = 0;
        int two = 0;
        int close = 0;
        Rng rng(7, "crosses");
        for (const auto& cut : {std::pair{90.0, 2.2}, {90.0, 2.8}, {75.0, 1.6}, {60.0, 2.0}}) {
            const double angle = cut.first;
            const double width = cut.second;
            for (double turn = -88.0; turn < 90.0; turn += 11.0) {
                CAPTURE(angle);
                CAPTURE(width);
                CAPTURE(turn);
                const auto near_middle = [&] { return Vec2(0.4 * uniform2(rng) - Vec2::Constant(0.2)); };
                Plate plate;
                plate.groove(near_middle(), turn, 5.3, width, 3.2);
                plate.groove(near_middle(), turn + angle, 5.3, width, 2.6);
                plate.noise(static_cast<std::uint64_t>(crosses++));
                const std::vector<GrooveShape> arms = plate.arms();
                REQUIRE(arms.size() >= 2);
                two += arms.size() == 2 ? 1 : 0;
                close += std::abs(angle_between(arms[0], arms[1]) / degree - angle) < 5.0 ? 1 : 0;
            }
        }
        CHECK(two >= 0.95 * crosses);
        CHECK(close >= 0.95 * crosses);
    }

    TEST_CASE("ragged crosses, as surgeons left them: the bands that explain both grooves, not one over their middle") {
        struct Footprint {
            const char* file;
            double turn;   ///< of the deeper groove
            double angle;  ///< by which the other lies across it
        };
        for (const Footprint& one : {Footprint{"cross_1.txt", -2.0, 85.0}, Footprint{"cross_2.txt", -2.0, 85.0},
                                     Footprint{"cross_3.txt", -12.0, 82.0}, Footprint{"cross_4.txt", -12.0, 82.0}}) {
            CAPTURE(one.file);
            Plate plate;
            plate.footprint(one.file);
            const std::vector<GrooveShape> arms = plate.arms();
            REQUIRE(arms.size() == 2);
            const auto deeper = std::min_element(arms.begin(), arms.end(), [&](const auto& a, const auto& b) {
                return std::abs(turn_of(a) - one.turn) < std::abs(turn_of(b) - one.turn);
            });
            CHECK(std::abs(turn_of(*deeper) - one.turn) < 4.0);
            CHECK(std::abs(angle_between(arms[0], arms[1]) / degree - one.angle) < 4.0);
        }
    }

    TEST_CASE("a shallow second groove across a deep first is seen as soon as it is long enough") {
        Plate plate;
        plate.groove(Vec2(0.0, 0.0), 90.0, 5.2, 2.2, 3.4);
        plate.groove(Vec2(0.0, 0.5), 0.0, 5.0, 1.6, 0.5);
        const std::vector<GrooveShape> arms = plate.arms();
        REQUIRE(arms.size() == 2);
        CHECK(arms[1].depth < 0.6);
        CHECK(arms[1].length == doctest::Approx(5.0).epsilon(0.12));
        CHECK(angle_between(arms[0], arms[1]) / degree > 84.0);
    }

    TEST_CASE("two parallel grooves are two at no angle") {
        Plate plate;
        plate.groove(Vec2(-1.2, 0.0), 10.0, 5.0, 1.0, 2.5);
        plate.groove(Vec2(1.2, 0.2), 10.0, 5.0, 1.0, 2.0);
        const std::vector<GrooveShape> arms = plate.arms();
        REQUIRE(arms.size() == 2);
        CHECK(angle_between(arms[0], arms[1]) / degree < 4.0);
    }

    TEST_CASE("a pit is no groove, and does not hide one") {
        Plate plate;
        plate.groove(Vec2(1.8, 0.0), 0.0, 2.0, 2.0, 3.0);
        CHECK(plate.arms().empty());
        plate.groove(Vec2(-1.2, 0.0), 0.0, 4.6, 1.0, 2.5);
        REQUIRE(plate.arms().size() == 1);
        CHECK(plate.arms()[0].width < 1.4);
    }

    TEST_CASE("nothing, and noise, are no groove; noise does not split one") {
        CHECK(Plate().arms().empty());
        for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
            Plate plate;
            plate.noise(seed);
            CHECK(plate.arms().empty());
            plate.groove(Vec2(0.0, 0.0), 15.0, 5.0, 1.6, 2.5);
            REQUIRE(plate.arms().size() == 1);
            CHECK(std::abs(turn_of(plate.arms()[0]) - 15.0) < 4.0);
        }
    }
}
