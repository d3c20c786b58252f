// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "eye/capsular_bag.hpp"
#include "math/rotation.hpp"
#include "physics/anatomy/bag_motion.hpp"

namespace rhexis::bench {
namespace {

constexpr Samples bag_samples{0.02, 50};
constexpr int substeps_of_bag = 64;  ///< that the kernel takes where a bag holds nothing
constexpr int lost_pairs = 5;        ///< of zonules: a gap of 75 degrees
constexpr double swung_mm = 0.05;    ///< for the swing, along the axis
constexpr double swung_mass = 0.21;  ///< of a bag with its lens [g]
constexpr Samples swing_samples{0.02, 10};

/// A bag with a gap and a hook in it.
BagModel gapped_bag() {
    BagModel bag = make_bag({4.6, 1.9, 2.7}, 0.2, 68.0);
    ZonuleModel zonules;
    zonules.lost.assign(bag.zonules.size(), 0);
    std::fill_n(zonules.lost.begin(), 2 * lost_pairs, std::uint8_t{1});
    bag.breakable = zonules;
    bag.cushion = 2000.0;
    return bag;
}

BagState gapped_state(const BagModel& bag) {
    BagState state;
    state.zonules = rest_state(*bag.breakable);
    CapsuleHook hook;
    hook.on_bag = Vec3(bag.opening_radius * std::cos(0.5), bag.opening_radius * std::sin(0.5), 1.5);
    hook.at_limbus = Vec3(5.82 * std::cos(0.5), 5.82 * std::sin(0.5), 2.0);
    hook.length = (hook.at_limbus - hook.on_bag).norm();
    state.zonules->hooks.push_back(hook);
    return state;
}

/// Of an instrument on the wall: pushed aside and back, turned, let go.
Vec6 load_on_bag(double time_s) {
    Vec6 load = Vec6::Zero();
    if (time_s > 0.1 && time_s < 0.4) {
        load << 3000.0, 1000.0, -2000.0, 0.0, 4000.0, 0.0;
    } else if (time_s > 0.4 && time_s < 0.7) {
        load << -2000.0, 0.0, 1000.0, 2000.0, 0.0, 6000.0;
    }
    return load;
}

/// How far its middle has gone, each way, and how far it has turned about axes across and along that of the eye.
std::vector<double> bag_looked_at(const Vec3& place, const Quat& turn) {
    const Vec3 half = turn.vec() / turn.w();
    return {place.head<2>().norm(), place.z(), half.head<2>().norm(), half.z()};
}

Curves bag_by_kernel(double dt, int substeps) {
    const BagModel model = gapped_bag();
    BagState state = gapped_state(model);
    return by_steps(
        bag_samples, dt,
        [&](double time_s, double step) {
            state.load = load_on_bag(time_s);
            for (int i = 0; i < substeps; ++i) {
                accelerate_bag(model, step / substeps, state);
                move_bag(step / substeps, state);
            }
        },
        [&] { return bag_looked_at(state.pose.position, state.pose.orientation); });
}

/// Backward Euler, as the implicit way takes a bag on with a lens: Newton's method on one step.
void step_bag_implicitly(const BagModel& model, double dt, BagState& state) {
    const Pose before = state.pose;
    Vec6 speed_before;
    speed_before << state.velocity, state.angular_velocity;
    Vec6 moved = Vec6::Zero();
    for (int i = 0; i < 8; ++i) {
        const Vec6 speed = moved / dt;
        const Pose pose{before.position + moved.head<3>(), turned(before.orientation, moved.tail<3>())};
        const RigidTerm term = bag_term(model, state, pose, speed, dt);
        const Vec6 residual = term.force - term.mass * (speed - speed_before) / dt;
        const Eigen::Matrix<double, 6, 6> matrix = term.mass / (dt * dt) + term.stiffness;
        moved += Vec6(matrix.llt().solve(residual));
    }
    state.pose = {before.position + moved.head<3>(), turned(before.orientation, moved.tail<3>())};
    state.velocity = moved.head<3>() / dt;
    state.angular_velocity = moved.tail<3>() / dt;
}

Curves bag_by_backward_euler(double dt) {
    const BagModel model = gapped_bag();
    BagState state = gapped_state(model);
    return by_steps(
        bag_samples, dt,
        [&](double time_s, double step) {
            state.load = load_on_bag(time_s);
            step_bag_implicitly(model, step, state);
        },
        [&] { return bag_looked_at(state.pose.position, state.pose.orientation); });
}

/// docs/zonules.md, written out: what pulls at the bag, about its middle.
class BagEquations {
public:
    BagEquations(BagModel model, const BagState& state) : model_(std::move(model)), hooks_(state.zonules->hooks) {}

    [[nodiscard]] Vec6 pull(const Vec3& place, const Quat& turn) const {
        Vec6 sum = Vec6::Zero();
        for (std::size_t i = 0; i < model_.zonules.size(); ++i) {
            const ZonuleSpring& spring = model_.zonules[i];
            const Vec3 rest = spring.on_ciliary - spring.on_bag;
            const Vec3 arm = turn * spring.on_bag;
            const Vec3 way = spring.on_ciliary - place - arm;
            Vec3 force = spring.stiffness * (way.norm() - rest.norm()) * way.normalized();
            if (model_.breakable->lost[i] != 0) {
                const double tension = spring.on_bag.z() > 0.0 ? 1.2 * spring.stiffness : 0.0;
                force = -tension * rest.normalized();
            }
            add(arm, force, sum);
        }
        for (const CapsuleHook& hook : hooks_) {
            const Vec3 arm = turn * hook.on_bag;
            const Vec3 way = hook.at_limbus - place - arm;
            add(arm, std::max(0.0, 4000.0 + 6000.0 * (way.norm() - hook.length)) * way.normalized(), sum);
        }
        sum.z() -= model_.cushion * place.z();
        return sum;
    }

    /// State: place, quaternion, velocity, spin.
    [[nodiscard]] Equations moving() const {
        const double depth = 0.5 * (model_.shape.anterior + model_.shape.posterior);
        const double square = (2.0 * model_.shape.radius * model_.shape.radius + depth * depth) / 3.0;
        const auto rate = [this, square](double time_s, const std::vector<double>& state, std::vector<double>& change) {
            const Eigen::Map<const Vec3> place(state.data());
            const Quat turn(state[3], state[4], state[5], state[6]);
            const Eigen::Map<const Vec3> velocity(state.data() + 7);
            const Eigen::Map<const Vec3> spin(state.data() + 10);
            const Vec6 all = pull(place, turn.normalized()) + load_on_bag(time_s);
            const Quat turning = Quat(0.0, spin.x(), spin.y(), spin.z()) * turn;
            Eigen::Map<Vec3>(change.data()) = velocity;
            Eigen::Map<Eigen::Vector4d>(change.data() + 3) =
                0.5 * Eigen::Vector4d(turning.w(), turning.x(), turning.y(), turning.z());
            Eigen::Map<Vec3>(change.data() + 7) = (all.head<3>() - model_.damping * velocity) / model_.mass;
            Eigen::Map<Vec3>(change.data() + 10) =
                (all.tail<3>() - model_.damping * square * spin) / (2.0 / 3.0 * model_.mass * square);
        };
        std::vector<double> start(13, 0.0);
        start[3] = 1.0;
        return {rate, start, [](const std::vector<double>& state) {
                    const Quat turn(state[3], state[4], state[5], state[6]);
                    return bag_looked_at(Vec3(state[0], state[1], state[2]), turn.normalized());
                }};
    }

private:
    static void add(const Vec3& arm, const Vec3& force, Vec6& sum) {
        sum.head<3>() += force;
        sum.tail<3>() += arm.cross(force);
    }

    BagModel model_;
    std::vector<CapsuleHook> hooks_;
};

/// Whole zonules, no drag: along the axis, from swung_mm.
Curves swing_by_kernel(double dt) {
    BagModel model = make_bag({4.6, 1.9, 2.7}, 0.2, 68.0);
    model.mass = swung_mass;
    model.damping = 0.0;
    BagState state;
    state.pose.position.z() = swung_mm;
    return by_steps(
        swing_samples, dt,
        [&](double, double step) {
            for (int i = 0; i < substeps_of_bag; ++i) {
                accelerate_bag(model, step / substeps_of_bag, state);
                move_bag(step / substeps_of_bag, state);
            }
        },
        [&] { return std::vector<double>{state.pose.position.z()}; });
}

/// A cosine, with the frequency of springs in a ring that stand at an angle.
Curves swing_in_closed_form() {
    const BagModel model = make_bag({4.6, 1.9, 2.7}, 0.2, 68.0);
    double stiffness = 0.0;
    for (const ZonuleSpring& spring : model.zonules) {
        const double along = (spring.on_ciliary - spring.on_bag).normalized().z();
        stiffness += spring.stiffness * along * along;
    }
    Curves curves(1);
    for (int i = 1; i <= swing_samples.count; ++i) {
        curves[0].push_back(swung_mm * std::cos(std::sqrt(stiffness / swung_mass) * i * swing_samples.apart));
    }
    return curves;
}

std::vector<ChartPoint> measure_zonules(const ChartOptions& options) {
    const BagModel model = gapped_bag();
    const BagEquations equations(model, gapped_state(model));
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002};
    const double seconds = bag_samples.apart * bag_samples.count;
    const auto by_kernel = [](double dt) { return bag_by_kernel(dt, substeps_of_bag); };
    std::vector<ChartPoint> points =
        points_of({{"kernel, 64 substeps (bag alone)", steps, by_kernel, 0.01},
                   {"backward Euler (kernel with a lens, implicit)", steps, bag_by_backward_euler},
                   {"kernel, 16 substeps", steps, [](double dt) { return bag_by_kernel(dt, 16); }}},
                  integrated(equations.moving(), bag_samples), seconds, options);
    if (!options.only_default) {
        const std::vector<ChartPoint> swung =
            points_of({{"kernel, swing of 0.05 mm without drag, against a cosine", steps, swing_by_kernel}},
                      swing_in_closed_form(), swing_samples.apart * swing_samples.count, options);
        points.insert(points.end(), swung.begin(), swung.end());
    }
    return points;
}

}  // namespace

Chart chart_zonules() {
    return {"zonules",
            "A bag with a gap of 75 degrees and a hook, pushed, turned and let go",
            cpu_per_second,
            "place and turn of the bag, rms, share of the most",
            "the equations of docs/zonules.md by Boost.Odeint (Dormand-Prince, 1e-10) [Ahnert2011]; a cosine",
            true,
            measure_zonules};
}

}  // namespace rhexis::bench
