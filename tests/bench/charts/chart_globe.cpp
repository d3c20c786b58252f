// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "bench/charts/equations.hpp"
#include "bench/charts/models.hpp"
#include "math/rotation.hpp"
#include "physics/anatomy/globe_roll.hpp"

namespace rhexis::bench {
namespace {

constexpr Samples roll_samples{0.02, 100};

/// A globe with a main wound and a side port 12 mm before its middle, and a straight shaft for each.
WorldModel two_shafts() {
    WorldModel model;
    model.globe = GlobeModel{};
    model.globe->front_centre = Vec3(0.0, 0.0, 6.0);
    model.globe->lips = {Vec3(0.0, -5.0, 12.0), Vec3(-5.0, 0.0, 12.0)};
    model.globe->widths = {2.4, 1.0};
    ToolModel tool;
    tool.parts = {{Vec3(0.0, 0.0, 0.1), Vec3(0.0, 0.0, 60.0), 0.1, 0.1}};
    model.tools = {tool, tool};
    return model;
}

/// Where the hands want the lips, off where these lie at rest: aside in 0.3 s, held, back; then both against each
/// other.
std::array<Vec3, lip_count> led_by_hands(double time_s) {
    const auto ramp = [&](double from) { return std::clamp((time_s - from) / 0.3, 0.0, 1.0); };
    return {Vec3(1.2 * (ramp(0.1) - ramp(0.8)), 0.0, 0.0), Vec3(0.0, 0.8 * ramp(1.0), 0.3 * ramp(1.0))};
}

/// From the tip of a shaft to the hand, the same all the time: hands carry shafts without turning them.
std::array<Vec3, lip_count> shaft_axes() {
    return {Vec3(0.0, -5.0, 2.0).normalized(), Vec3(-5.0, 0.0, 1.0).normalized()};
}

/// How far the globe has rolled and how far the cornea is bent at each lip, as hands and eyes meet it.
std::vector<double> roll_looked_at(double angle, double main, double side) { return {angle, main, side}; }

Curves roll_by_kernel(double dt) {
    const WorldModel model = two_shafts();
    WorldState state;
    state.globe = GlobeState{};
    state.tips.resize(2);
    std::vector<ToolState> tools(2);
    return by_steps(
        roll_samples, dt,
        [&](double time_s, double step) {
            const double asked_s = std::floor(time_s / roll_samples.apart) * roll_samples.apart;
            const std::array<Vec3, lip_count> led = led_by_hands(asked_s);
            for (std::size_t i = 0; i < lip_count; ++i) {
                tools[i].present = true;
                const Vec3 axis = shaft_axes()[i];
                const Pose room{model.globe->lips[i] + led[i] - 5.0 * axis, turn_of_z(axis)};
                tools[i].pose = to_eye(*model.globe, *state.globe, room);
            }
            roll_globe(model, tools, step, state);
        },
        [&] {
            return roll_looked_at(roll_angle(*state.globe), state.globe->lips[0].deflection.norm(),
                                  state.globe->lips[1].deflection.norm());
        });
}

/// Torque of the lips, and how far each is bent, where each has gone so far from where it lay.
struct LipPulls {
    Vec3 torque = Vec3::Zero();
    std::array<double, lip_count> bent{};
};

LipPulls lips_pull(const GlobeModel& model, double asked_s, const std::array<Vec3, lip_count>& arms,
                   const std::array<Vec3, lip_count>& gone) {
    LipPulls pulls;
    for (std::size_t i = 0; i < lip_count; ++i) {
        const Vec3 axis = shaft_axes()[i];
        const Vec3 off = led_by_hands(asked_s)[i] - gone[i];
        const Vec3 across = off - off.dot(axis) * axis;
        pulls.bent[i] = across.norm();
        pulls.torque += arms[i].cross(Vec3(model.lip_stiffness * across));
    }
    return pulls;
}

double when_asked(double time_s) { return std::floor(time_s / roll_samples.apart) * roll_samples.apart; }

/// A ball that turns as far as it turns: lips go round on it, and so do their arms. State: quaternion, time.
Equations rolling_ball() {
    const WorldModel model = two_shafts();
    const GlobeModel globe = *model.globe;
    const auto pulls_at = [globe](double asked_s, const Quat& turn) {
        std::array<Vec3, lip_count> arms;
        std::array<Vec3, lip_count> gone;
        for (std::size_t i = 0; i < lip_count; ++i) {
            arms[i] = turn * (globe.lips[i] - globe.centre);
            gone[i] = arms[i] - (globe.lips[i] - globe.centre);
        }
        return lips_pull(globe, asked_s, arms, gone);
    };
    const auto rate = [=](double time_s, const std::vector<double>& state, std::vector<double>& change) {
        const Quat turn = Quat(state[0], state[1], state[2], state[3]).normalized();
        const Eigen::AngleAxisd rolled(turn);
        const Vec3 spin =
            (pulls_at(when_asked(time_s), turn).torque / globe.stiffness - rolled.angle() * rolled.axis()) / globe.lag;
        const Quat turning = Quat(0.0, spin.x(), spin.y(), spin.z()) * turn;
        change[0] = 0.5 * turning.w();
        change[1] = 0.5 * turning.x();
        change[2] = 0.5 * turning.y();
        change[3] = 0.5 * turning.z();
        change[4] = 1.0;
    };
    return {rate, {1.0, 0.0, 0.0, 0.0, 0.0}, [=](const std::vector<double>& state) {
                const Quat turn = Quat(state[0], state[1], state[2], state[3]).normalized();
                const LipPulls pulls = pulls_at(when_asked(state[4] - 0.5 * roll_samples.apart), turn);
                return roll_looked_at(Eigen::AngleAxisd(turn).angle(), pulls.bent[0], pulls.bent[1]);
            }};
}

/// docs/globe.md: a lip goes by roll x arm.
class LinearRoll {
public:
    [[nodiscard]] LipPulls pulls(double asked_s, const Vec3& roll) const {
        std::array<Vec3, lip_count> arms;
        std::array<Vec3, lip_count> gone;
        for (std::size_t i = 0; i < lip_count; ++i) {
            arms[i] = globe_.lips[i] - globe_.centre;
            gone[i] = roll.cross(arms[i]);
        }
        return lips_pull(globe_, asked_s, arms, gone);
    }

    [[nodiscard]] Vec3 rate(double time_s, const Vec3& roll) const {
        return (pulls(when_asked(time_s), roll).torque / globe_.stiffness - roll) / globe_.lag;
    }

    /// By steps; advance: (rate at no roll, its slope, dt, roll).
    template <typename Advance>
    [[nodiscard]] Curves curves(double dt, const Advance& advance) const {
        Vec3 roll = Vec3::Zero();
        double asked_s = 0.0;
        return by_steps(
            roll_samples, dt,
            [&](double time_s, double step) {
                asked_s = when_asked(time_s);
                const Vec3 steady = rate(time_s, Vec3::Zero());
                Mat3 slope;
                for (int k = 0; k < 3; ++k) {
                    slope.col(k) = rate(time_s, Vec3::Unit(k)) - steady;
                }
                advance(steady, slope, step, roll);
            },
            [&] {
                const LipPulls now = pulls(asked_s, roll);
                return roll_looked_at(2.0 * std::atan(0.5 * roll.norm()), now.bent[0], now.bent[1]);
            });
    }

private:
    GlobeModel globe_ = *two_shafts().globe;
};

/// The pull of springs is symmetric: every mode by itself.
Curves roll_by_exponential(double dt) {
    return LinearRoll().curves(dt, [](const Vec3& steady, const Mat3& slope, double step, Vec3& roll) {
        const Eigen::SelfAdjointEigenSolver<Mat3> modes(slope);
        const Vec3 settled = -(modes.eigenvectors().transpose() * steady).cwiseQuotient(modes.eigenvalues());
        const Vec3 left = (step * modes.eigenvalues()).array().exp();
        const Vec3 now = modes.eigenvectors().transpose() * roll;
        roll = modes.eigenvectors() * Vec3(settled + left.cwiseProduct(now - settled));
    });
}

Curves roll_by_euler(double dt) {
    return LinearRoll().curves(dt, [](const Vec3& steady, const Mat3& slope, double step, Vec3& roll) {
        roll += Vec3(step * (steady + slope * roll));
    });
}

std::vector<ChartPoint> measure_globe(const ChartOptions& options) {
    const std::vector<double> steps{0.02, 0.01, 0.005, 0.002, 0.001};
    const double seconds = roll_samples.apart * roll_samples.count;
    std::vector<ChartPoint> points = points_of({{"backward Euler (kernel)", steps, roll_by_kernel, 0.01},
                                                {"explicit Euler", steps, roll_by_euler},
                                                {"the exponential in each step", {0.02, 0.01}, roll_by_exponential}},
                                               integrated(rolling_ball(), roll_samples), seconds, options);
    if (!options.only_default) {
        const std::vector<ChartPoint> linear =
            points_of({{"kernel, against its own linear equations", steps, roll_by_kernel}},
                      roll_by_exponential(roll_samples.apart), seconds, options);
        points.insert(points.end(), linear.begin(), linear.end());
    }
    return points;
}

}  // namespace

Chart chart_globe() {
    return {
        "globe",
        "Shafts carried 1.2 mm off the main wound and back, then 0.8 mm off the side port",
        cpu_per_second,
        "roll and deflection of each lip, rms, share of the most",
        "a rigid ball that turns on the springs of docs/globe.md, by Boost.Odeint (Dormand-Prince, 1e-10) [Ahnert2011]",
        true,
        measure_globe};
}

}  // namespace rhexis::bench
