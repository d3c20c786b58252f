// SPDX-License-Identifier: GPL-3.0-or-later
// How fluently the hands work: way, movements, rest and jerk of all instruments together. 98.9 % of the power of
// voluntary movement lies below 2 Hz [Riviere1997]; velocities are therefore smoothed by three poles at 4 Hz, which
// together let through what is below 2 Hz and leave tremor out (tremor_measures.cpp has it).
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double pole_s = 1.0 / (2.0 * std::numbers::pi * 4.0);
constexpr double still_below = 0.5;     // [mm/s], proposal
constexpr double movement_above = 2.0;  // [mm/s], proposal; slow work is 1 to 5 mm/s

/// Memory of all, then of every instrument: three poles of three axes, whether it was there, whether it moves.
enum Memory : std::size_t { path, entries, movements, square, time, common };
constexpr std::size_t was_present = 9;
constexpr std::size_t moves = 10;
constexpr std::size_t per_tool = 11;

struct Smoothed {
    double speed = 0.0;         ///< [mm/s]
    double jerk_squared = 0.0;  ///< [mm^2/s^6]
};

/// One step of the poles.
Smoothed smooth(const Vec3& velocity, double dt, std::span<double> poles) {
    const double share = dt / (pole_s + dt);
    double speed_squared = 0.0;
    double jerk_squared = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::span<double> p = poles.subspan(3 * axis, 3);
        p[0] += share * (velocity[static_cast<Eigen::Index>(axis)] - p[0]);
        p[1] += share * (p[0] - p[1]);
        p[2] += share * (p[1] - p[2]);
        const double jerk = (p[0] - 2.0 * p[1] + p[2]) / (pole_s * pole_s);  // second derivative of the last pole
        speed_squared += p[2] * p[2];
        jerk_squared += jerk * jerk;
    }
    return {std::sqrt(speed_squared), jerk_squared};
}

/// The instrument does something though it need not move.
bool works(const ToolModel& model, const ToolState& tool) {
    const bool injects = model.kind == ToolKind::cannula && tool.jaw > 0.0;
    return injects || tool.aspiration > 0.0 || tool.power > 0.0 || tool.jaw != tool.previous_jaw;
}

/// Under the iris, where the microscope does not show it.
bool hidden(const ToolState& tool, const EyeAnatomy& eye) {
    const Vec3& tip = tool.pose.position;
    return tip.z() < eye.iris_z && std::hypot(tip.x(), tip.y()) > eye.pupil_radius;
}

class MotionMeasures : public MeasureGroup {
public:
    explicit MotionMeasures(std::size_t tools) : tools_(tools) {}

    void describe(ObservationSchema& schema) const override {
        schema.push_back(
            {"instruments.path_mm", "mm", "Length of the ways of all tips inside the eye so far, added up."});
        schema.push_back({"instruments.entries", "1", "Times that an instrument came into the eye so far."});
        schema.push_back({"instruments.movements", "1",
                          "Movements so far: times that a tip got faster than 2 mm/s after it had rested."});
        schema.push_back({"instruments.idle", "bool",
                          "An instrument is in the eye, but none moves (0.5 mm/s), draws, cuts or grasps."});
        schema.push_back(
            {"instruments.jerk_mm_s3", "mm/s^3", "Jerk of the tips below 2 Hz, without tremor, so far (RMS)."});
        schema.push_back(
            {"instruments.hidden", "bool", "A tip is under the iris outside the pupil, where it cannot be seen."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return common + per_tool * tools_; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        bool any = false;
        bool busy = false;
        bool unseen = false;
        for (std::size_t i = 0; i < tools_; ++i) {
            const ToolState& tool = input.tools[i];
            const std::span<double> own = memory.subspan(common + i * per_tool, per_tool);
            if (!tool.present) {
                std::fill(own.begin(), own.end(), 0.0);
                continue;
            }
            any = true;
            busy = follow(tool, input.dt, memory, own) || works(input.world.tools[i], tool) || busy;
            unseen = unseen || hidden(tool, input.eye.anatomy);
        }
        values[0] = memory[path];
        values[1] = memory[entries];
        values[2] = memory[movements];
        values[3] = any && !busy ? 1.0 : 0.0;
        values[4] =
            memory[time] > 0.0 ? std::sqrt(memory[square] / memory[time]) : std::numeric_limits<double>::quiet_NaN();
        values[5] = unseen ? 1.0 : 0.0;
    }

private:
    std::size_t tools_;

    /// Whether it moves.
    static bool follow(const ToolState& tool, double dt, std::span<double> memory, std::span<double> own) {
        if (own[was_present] == 0.0) {
            own[was_present] = 1.0;
            memory[entries] += 1.0;
        }
        const Vec3 way = tool.pose.position - tool.previous_pose.position;
        memory[path] += way.norm();
        const Smoothed now = smooth(way / dt, dt, own);
        memory[square] += now.jerk_squared * dt;
        memory[time] += dt;
        if (own[moves] == 0.0 && now.speed > movement_above) {
            own[moves] = 1.0;
            memory[movements] += 1.0;
        } else if (now.speed < still_below) {
            own[moves] = 0.0;
        }
        return now.speed >= still_below;
    }
};

}  // namespace

std::unique_ptr<MeasureGroup> motion_measures(std::size_t tools) { return std::make_unique<MotionMeasures>(tools); }

}  // namespace rhexis
