// SPDX-License-Identifier: GPL-3.0-or-later
// Tremor of the hand: root mean square of the tip's movement in the band of 6 to 12 Hz over the last seconds.
// Band-pass: second-order section with constant peak gain [BristowJohnson2005].
#include <cmath>
#include <limits>
#include <numbers>

#include "observe/measure_group.hpp"

namespace rhexis {
namespace {

constexpr double band_low_hz = 6.0;
constexpr double band_high_hz = 12.0;
constexpr double averaging_s = 2.0;

struct BandPass {
    double b0 = 0.0;
    double a1 = 0.0;
    double a2 = 0.0;
};

BandPass band_pass(double dt) {
    const double centre_hz = std::sqrt(band_low_hz * band_high_hz);
    const double omega = 2.0 * std::numbers::pi * centre_hz * dt;
    const double alpha = std::sin(omega) * 0.5 * (band_high_hz - band_low_hz) / centre_hz;
    return {alpha / (1.0 + alpha), -2.0 * std::cos(omega) / (1.0 + alpha), (1.0 - alpha) / (1.0 + alpha)};
}

/// Memory per axis, then the mean square, then whether the tool was present.
enum AxisMemory : std::size_t { x1, x2, y1, y2, axis_memory };
constexpr std::size_t mean_square = 3 * axis_memory;
constexpr std::size_t was_present = mean_square + 1;

class TremorMeasures : public MeasureGroup {
public:
    TremorMeasures(std::string instrument, int tool, double dt)
        : name_(std::move(instrument)), tool_(tool), filter_(band_pass(dt)) {}

    void describe(ObservationSchema& schema) const override {
        schema.push_back(
            {name_ + ".tremor_um", "um", "Trembling of the tip, 6 to 12 Hz, over the last seconds (RMS)."});
    }
    [[nodiscard]] std::size_t memory_size() const override { return was_present + 1; }

    void measure(const ObserveInput& input, const LensView&, std::span<double> memory,
                 std::span<double> values) const override {
        const ToolState& tool = input.tools[tool_];
        if (!tool.present) {
            memory[was_present] = 0.0;
            values[0] = std::numeric_limits<double>::quiet_NaN();
            return;
        }
        if (memory[was_present] == 0.0) {
            begin(tool.pose.position, memory);
        }
        const double share = std::min(1.0, input.dt / averaging_s);
        memory[mean_square] += share * (filtered_square(tool.pose.position, memory) - memory[mean_square]);
        values[0] = 1e3 * std::sqrt(memory[mean_square]);
    }

private:
    /// As if the tip had always rested where it appears.
    static void begin(const Vec3& position, std::span<double> memory) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::span<double> m = memory.subspan(axis * axis_memory, axis_memory);
            m[x1] = m[x2] = position[static_cast<Eigen::Index>(axis)];
            m[y1] = m[y2] = 0.0;
        }
        memory[mean_square] = 0.0;
        memory[was_present] = 1.0;
    }

    [[nodiscard]] double filtered_square(const Vec3& position, std::span<double> memory) const {
        double square = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::span<double> m = memory.subspan(axis * axis_memory, axis_memory);
            const double x = position[static_cast<Eigen::Index>(axis)];
            const double y = filter_.b0 * (x - m[x2]) - filter_.a1 * m[y1] - filter_.a2 * m[y2];
            m[x2] = m[x1];
            m[x1] = x;
            m[y2] = m[y1];
            m[y1] = y;
            square += y * y;
        }
        return square;
    }

    std::string name_;
    int tool_;
    BandPass filter_;
};

}  // namespace

std::unique_ptr<MeasureGroup> tremor_measures(const std::string& instrument, int tool, double dt) {
    return std::make_unique<TremorMeasures>(instrument, tool, dt);
}

}  // namespace rhexis
