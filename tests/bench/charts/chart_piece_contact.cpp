// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bench/charts/models.hpp"
#include "bench/timing.hpp"
#include "mesh/shapes.hpp"
#include "physics/contact/piece_contact.hpp"
#include "physics/physics.hpp"
#include "scenes/bodies.hpp"

namespace rhexis::bench {
namespace {

constexpr double usual_cell = 2.0 / 3.0;  ///< as large as those of a lens of 3,000 tetrahedra [mm]
constexpr double usual_step = 0.01;       ///< [s]
constexpr double off_grid = 0.25;         ///< the second piece's nodes from the first's, sideways, in cells
constexpr double lens_inertia = 3e-4;     ///< what exercises seek for the lens [s]

/// Two pieces of one body: their cells are cubes of five tetrahedra.
class TwoPieces {
public:
    TwoPieces(const TetMesh& first, const TetMesh& second, double modulus, double sought_step)
        : first_nodes_(first.nodes.size()) {
        TetMesh both = first;
        both.nodes.insert(both.nodes.end(), second.nodes.begin(), second.nodes.end());
        for (std::array<int, 4> tet : second.tets) {
            for (int& node : tet) {
                node += static_cast<int>(first_nodes_);
            }
            both.tets.push_back(tet);
            both.region.push_back(0);
        }
        SolidModel solid = scenes::body("pieces", both, modulus, 0.0);
        solid.advance = Advance::explicit_;
        solid.formulation = Formulation::nodal_pressure;
        solid.sought_step = sought_step;
        world.solids = {solid};
        world.gravity = Vec3::Zero();
        state = rest_state(world);
    }

    [[nodiscard]] bool is_second(std::size_t node) const { return node >= first_nodes_; }

    /// Runs, told before each step how much of the time is over; false where a step fails.
    bool run(double seconds, double dt, const std::function<void(double share)>& before = {}) {
        Result<Physics> made = Physics::create(std::make_shared<WorldModel>(world), {});
        if (!made) {
            return false;
        }
        Physics physics = std::move(made).value();
        ContactSet contacts;
        Profile profile;
        WorldState next;
        const int count = static_cast<int>(std::lround(seconds / dt));
        for (int i = 0; i < count; ++i) {
            if (before) {
                before((i + 1.0) / count);
            }
            if (physics.advance(state, {}, dt, next, contacts, profile).failure != StepFailure::none) {
                return false;
            }
            std::swap(state, next);
        }
        return true;
    }

    /// Of the second piece's middle.
    [[nodiscard]] Vec3 mean(const std::vector<Vec3>& values) const {
        const TetMesh& mesh = world.solids[0].coarse;
        Vec3 sum = Vec3::Zero();
        double mass = 0.0;
        for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
            for (const int node : mesh.tets[t]) {
                if (is_second(static_cast<std::size_t>(node))) {
                    sum += tet_mass(world.solids[0], static_cast<int>(t)) * values[node];
                    mass += tet_mass(world.solids[0], static_cast<int>(t));
                }
            }
        }
        return sum / mass;
    }

    WorldModel world;
    WorldState state;

private:
    std::size_t first_nodes_;
};

TetMesh block(const Vec3& size, double cell, const Vec3& origin) {
    const auto count = [cell](double length) { return static_cast<int>(std::lround(length / cell)); };
    return bar(count(size.x()), count(size.y()), count(size.z()), cell, origin);
}

/// A share of what it should be; 0 where a step failed.
using OfPieces = std::function<double(double cell, double dt)>;

/// Equal bars that meet end to end exchange their velocities [SaintVenant1867].
double rebound(double cell, double dt) {
    constexpr double speed = 20.0;  // [mm/s]
    const double aside = off_grid * cell;
    TwoPieces bars(block({8.0, 2.0, 2.0}, cell, {-8.05, 0.0, 0.0}), block({8.0, 2.0, 2.0}, cell, {0.05, aside, aside}),
                   5000.0, 0.0);
    for (std::size_t i = 0; i < bars.state.solids[0].velocity.size(); ++i) {
        bars.state.solids[0].velocity[i].x() = bars.is_second(i) ? -speed : speed;
    }
    return bars.run(0.06, dt) ? bars.mean(bars.state.solids[0].velocity).x() / speed : 0.0;
}

/// Blocks on one another, the lower held below: Hooke's law, 2 % each.
double pressed(double cell, double dt) {
    constexpr double modulus = 50000.0;
    constexpr double strain = 0.02;
    const double aside = off_grid * cell;
    TwoPieces blocks(block({2.0, 2.0, 2.0}, cell, {0.0, 0.0, -2.0}), block({2.0, 2.0, 2.0}, cell, {aside, aside, 0.0}),
                     modulus, lens_inertia);
    SolidModel& solid = blocks.world.solids[0];
    solid.damping_mass = 20.0;
    NodeLoad load;
    for (int node = 0; node < static_cast<int>(solid.coarse.nodes.size()); ++node) {
        const double z = solid.coarse.nodes[node].z();
        if (z < -2.0 + 1e-9) {
            solid.fixed_nodes.push_back(node);
        } else if (z > 2.0 - 1e-9) {
            load.nodes.push_back(node);
        }
    }
    const bool done = blocks.run(0.6, dt, [&](double share) {
        load.total.z() = -4.0 * modulus * strain * std::min(1.0, 1.5 * share);
        blocks.state.loads = {load};
    });
    double sunk = 0.0;
    for (const int node : load.nodes) {
        sunk += (2.0 - blocks.state.solids[0].position[node].z()) / static_cast<double>(load.nodes.size());
    }
    return done ? sunk / (4.0 * strain) : 0.0;
}

/// A block on a slab that is held below, both tilted by twice and a half the angle of friction: Coulomb's law.
double slid(double cell, double dt) {
    constexpr double seconds = 0.06;
    constexpr double slope = 0.5;
    const double aside = 1.0 + off_grid * cell;
    TwoPieces pieces(block({8.0, 4.0, 2.0}, cell, {0.0, 0.0, -2.0}), block({2.0, 2.0, 2.0}, cell, {aside, aside, 0.0}),
                     50000.0, 0.0);
    const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
    pieces.world.gravity = 9810.0 * cosine * Vec3(slope, 0.0, -1.0);
    SolidModel& solid = pieces.world.solids[0];
    for (int node = 0; node < static_cast<int>(solid.coarse.nodes.size()); ++node) {
        if (solid.coarse.nodes[node].z() < -2.0 + 1e-9) {
            solid.fixed_nodes.push_back(node);
        }
    }
    const double from = pieces.mean(pieces.state.solids[0].position).x();
    const double acceleration = 9810.0 * cosine * (slope - piece_friction);
    const bool done = pieces.run(seconds, dt);
    const double way = pieces.mean(pieces.state.solids[0].position).x() - from;
    return done ? way / (0.5 * acceleration * seconds * seconds) : 0.0;
}

struct PieceTest {
    std::string name;
    OfPieces share;
    double seconds = 0.0;
};

std::vector<PieceTest> piece_tests() {
    return {{"two bars that rebound", rebound, 0.06},
            {"a block pressed on another", pressed, 0.6},
            {"a block on a slope", slid, 0.06}};
}

/// Of each test alone and of all together.
std::vector<ChartPoint> points_of_pieces(double cell, double dt, const ChartOptions& options) {
    char setting[48];
    std::snprintf(setting, sizeof setting, "%.2g mm, %s", cell, milliseconds(dt).c_str());
    std::vector<ChartPoint> points;
    double square = 0.0;
    double cost = 0.0;
    for (const PieceTest& test : piece_tests()) {
        const double error = std::min(1.0, std::abs(test.share(cell, dt) - 1.0));
        const double seconds =
            options.only_default ? 0.0 : time_interleaved({[&] { test.share(cell, dt); }}, 1)[0].seconds / test.seconds;
        points.push_back(point_of(test.name, setting, false, error, seconds));
        square += error * error / 3.0;
        cost += seconds / 3.0;
    }
    const bool is_default = cell == usual_cell && dt == usual_step;
    points.insert(points.begin(), point_of("kernel: all three", setting, is_default, std::sqrt(square), cost));
    return points;
}

std::vector<ChartPoint> measure_piece_contact(const ChartOptions& options) {
    if (options.only_default) {
        return {points_of_pieces(usual_cell, usual_step, options).front()};
    }
    std::vector<ChartPoint> points;
    for (const double cell : {1.0, usual_cell, 0.5}) {
        for (const double dt : {0.02, usual_step, 0.005, 0.002}) {
            if (cell == usual_cell || dt == usual_step) {
                const std::vector<ChartPoint> found = points_of_pieces(cell, dt, options);
                points.insert(points.end(), found.begin(), found.end());
            }
        }
    }
    std::stable_sort(points.begin(), points.end(),
                     [](const ChartPoint& a, const ChartPoint& b) { return a.way < b.way; });
    return points;
}

}  // namespace

Chart chart_piece_contact() {
    return {"piece_contact",
            "Pieces of one body: bars that collide, a block pressed on another, one on a slope",
            cpu_per_second,
            "velocity, shortening or way, share; at most 100 %",
            "exchange of velocities [SaintVenant1867], Hooke's law, Coulomb's law (closed forms)",
            true,
            measure_piece_contact};
}

}  // namespace rhexis::bench
