// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

#include "bench/charts/models.hpp"
#include "bench/timing.hpp"
#include "flow/chamber.hpp"
#include "physics/anatomy/capsule_wall.hpp"
#include "tools/phaco_tip.hpp"

namespace rhexis::bench {
namespace {

/// A clamped flat sheet, without friction or bending; principal forces per length linear in the stretches, both as of
/// the sheet at rest [YangFeng1970]. By steps of Runge and Kutta's method of order 4 outward from its middle, for a
/// stretch there at which the edge stays where it is.
class ClampedSheet {
public:
    struct Shape {
        double stretch = 1.0;  ///< at the middle
        double depth = 0.0;    ///< [mm]
        double force = 0.0;    ///< [uN]
    };

    ClampedSheet(const CapsuleModel& capsule, double radius, int steps)
        : radius_(radius),
          steps_(steps),
          poisson_ratio_(capsule.poisson_ratio),
          stiffness_(capsule.membrane_stiffness / (1.0 - capsule.poisson_ratio * capsule.poisson_ratio)) {}

    /// Under a round end on a shaft as wide that has come so deep [mm]: the stretch at the middle is sought.
    [[nodiscard]] Shape under_end(double ball, double depth) const {
        Shape found;
        root(1.0 + 1e-7, 2.6, [&](double stretch) {
            found = stretched(ball, stretch);
            return found.depth - depth;
        });
        return found;
    }

    /// Under a pressure on one side [Pa].
    [[nodiscard]] Shape under_pressure(double pressure) const {
        Shape found;
        root(1.0001, 2.0, [&](double stretch) {
            const double start = 1e-4 * radius_;
            const State end = march({stretch * start, 0.0, start * all_round(stretch)}, start, radius_,
                                    [&](double at, const State& now) { return inflated(pressure, at, now); });
            found = {stretch, std::abs(end[1]), 0.0};
            return end[0] - radius_;
        });
        return found;
    }

private:
    using State = std::array<double, 3>;
    static constexpr double upright = 0.5 * std::numbers::pi;  ///< slope of the shaft

    template <typename Function>
    static void root(double low, double high, const Function& function) {
        std::uintmax_t most = 60;
        const auto found =
            boost::math::tools::toms748_solve(function, low, high, boost::math::tools::eps_tolerance<double>(40), most);
        function(0.5 * (found.first + found.second));
    }

    /// Force per length where a sheet is stretched alike both ways.
    [[nodiscard]] double all_round(double stretch) const {
        return stiffness_ * (1.0 + poisson_ratio_) * (stretch - 1.0);
    }

    /// With so much stretch at the middle: how much of the sheet at rest lies on the end is sought.
    [[nodiscard]] Shape stretched(double ball, double stretch) const {
        Shape found;
        root(1e-4 * ball, 0.99 * radius_, [&](double contact) {
            const double start = 1e-3 * contact;
            // on the end: slope, force along the meridian times radius at rest, height
            const State on = march({stretch * start / ball, start * all_round(stretch), 0.0}, start, contact,
                                   [&](double at, const State& now) { return wrapped(ball, at, now); });
            const double slope = std::min(on[0], upright);
            const double down = on[1] * std::sin(slope);
            if (!(down > 0.0)) {
                return -radius_;  // so much would be slack
            }
            // beyond: radius, height and force outward times radius at rest
            const State off = march({ball * std::sin(slope), 0.0, on[1] * std::cos(slope)}, contact, radius_,
                                    [&](double at, const State& now) { return free_sheet(down, at, now); });
            found = {stretch, on[2] + off[1], 2.0 * std::numbers::pi * down};
            return off[0] - radius_;
        });
        return found;
    }

    /// Both stretches' forces from that along the meridian and the stretch around: {stretch along, force around}.
    [[nodiscard]] std::array<double, 2> across(double along, double around) const {
        const double stretch = 1.0 + along / stiffness_ - poisson_ratio_ * (around - 1.0);
        return {stretch, stiffness_ * (around - 1.0 + poisson_ratio_ * (stretch - 1.0))};
    }

    [[nodiscard]] State wrapped(double ball, double at, const State& now) const {
        const double slope = std::min(now[0], upright);
        const auto [stretch, hoop] = across(now[1] / at, ball * std::sin(slope) / at);
        const bool on_shaft = now[0] >= upright;
        return {on_shaft ? 0.0 : stretch / ball, on_shaft ? 0.0 : hoop * std::cos(slope), stretch * std::sin(slope)};
    }

    [[nodiscard]] State free_sheet(double down, double at, const State& now) const {
        const double along = std::hypot(now[2], down);
        const auto [stretch, hoop] = across(along / at, now[0] / at);
        return {stretch * now[2] / along, stretch * down / along, hoop};
    }

    [[nodiscard]] State inflated(double pressure, double at, const State& now) const {
        const double down = 0.5 * pressure * now[0] * now[0];
        const double along = std::hypot(now[2], down);
        const auto [stretch, hoop] = across(along / at, now[0] / at);
        return {stretch * now[2] / along, stretch * down / along, hoop - pressure * now[0] * stretch * down / along};
    }

    /// In equal ratios of the radius at rest.
    template <typename Rate>
    [[nodiscard]] State march(State state, double from, double to, const Rate& rate) const {
        const double ratio = std::pow(to / from, 1.0 / steps_);
        const auto moved = [](State now, double share, const State& by) {
            for (std::size_t i = 0; i < now.size(); ++i) {
                now[i] += share * by[i];
            }
            return now;
        };
        for (int i = 0; i < steps_; ++i) {
            const double dr = (ratio - 1.0) * from;
            const State first = rate(from, state);
            const State second = rate(from + 0.5 * dr, moved(state, 0.5 * dr, first));
            const State third = rate(from + 0.5 * dr, moved(state, 0.5 * dr, second));
            const State last = rate(from + dr, moved(state, dr, third));
            state =
                moved(moved(moved(moved(state, dr / 6.0, first), dr / 3.0, second), dr / 3.0, third), dr / 6.0, last);
            from += dr;
        }
        return state;
    }

    double radius_;
    int steps_;
    double poisson_ratio_;
    double stiffness_;
};

/// What is told of one push or pull.
using OfSheet = std::function<double(double radius, double load)>;

/// [mm]; as deep as the kernel's formulas are for.
std::vector<double> dimple_depths(double ball) {
    std::vector<double> depths;
    const double deepest = ball < 0.15 ? 1.2 : ball < 0.3 ? 1.6 : 2.0;  // where the strain is 1.1 at most
    for (int i = 1; 0.2 * i < deepest + 1e-9; ++i) {
        depths.push_back(0.2 * i);
    }
    return depths;
}

std::vector<double> bore_suctions(double) {
    std::vector<double> suctions;
    for (const double mmhg : {25.0, 50.0, 75.0, 100.0, 125.0, 150.0}) {
        suctions.push_back(mmhg * pascal_per_mmhg);
    }
    return suctions;
}

/// A line: something told of ends or bores of several radii, and what it should be.
struct SheetLine {
    std::string name;
    OfSheet told;
    OfSheet answer;
    std::vector<double> radii;  ///< [mm]
    std::function<std::vector<double>(double radius)> loads = dimple_depths;
    double default_radius = 0.0;  ///< 0: not what exercises take
};

std::string millimetres(double length) {
    char text[32];
    std::snprintf(text, sizeof text, "%g mm", length);
    return text;
}

ChartPoint point_of_sheet(const SheetLine& line, double radius, const ChartOptions& options) {
    const std::vector<double> loads = line.loads(radius);
    std::vector<double> told;
    std::vector<double> answer;
    for (const double load : loads) {  // as shares: else the deepest alone would count
        const double right = line.answer(radius, load);
        told.push_back(line.told(radius, load) / right);
        answer.push_back(1.0);
    }
    double kept = 0.0;  // so that the compiler does not leave it out
    const double seconds =
        time_interleaved({[&] { kept += line.told(radius, loads.back()); }}, options.repeats)[0].seconds;
    ChartPoint point =
        point_of(line.name, millimetres(radius), radius == line.default_radius, rms_share(told, answer), seconds);
    if (!std::isfinite(kept)) {
        point.failure = "not a number";
    }
    return point;
}

/// Of a point that is pushed through the middle of the sheet [Komaragiri2005].
double point_force(const CapsuleModel& capsule, double depth) {
    const double nu = capsule.poisson_ratio;
    const double yielding = 1.0491 - 0.1462 * nu - 0.15827 * nu * nu;
    const double share = depth / (yielding * capsule.dimple_radius);
    return capsule.membrane_stiffness * capsule.dimple_radius * share * share * share;
}

std::vector<SheetLine> sheet_lines(const CapsuleModel& capsule) {
    constexpr int fine_steps = 800;
    const std::vector<double> ends{0.1, 0.2, 0.32, 0.45, 0.8};
    const auto sheet = [&capsule](int steps) { return ClampedSheet(capsule, capsule.dimple_radius, steps); };
    const OfSheet force = [sheet](double ball, double depth) { return sheet(fine_steps).under_end(ball, depth).force; };
    const OfSheet strain = [sheet](double ball, double depth) {
        return sheet(fine_steps).under_end(ball, depth).stretch - 1.0;
    };
    const OfSheet bulge = [&capsule](double bore, double suction) {
        return ClampedSheet(capsule, bore, fine_steps).under_pressure(suction).stretch - 1.0;
    };
    std::vector<SheetLine> lines;
    lines.push_back({"kernel: force by the radius of the end",
                     [&capsule](double ball, double depth) { return dimple_force(capsule, ball, depth); }, force, ends,
                     dimple_depths, phaco_tip().parts.front().radius_a});
    lines.push_back({"kernel: strain under it",
                     [&capsule](double ball, double depth) { return dimple_strain(capsule, ball, depth); }, strain,
                     ends});
    lines.push_back({"kernel: strain of a sheet sucked into a bore",
                     [&capsule](double bore, double suction) { return bulge_strain(capsule, bore, suction); },
                     bulge,
                     {0.15, 0.35},
                     bore_suctions});
    lines.push_back({"force of a point (closed form)",
                     [&capsule](double, double depth) { return point_force(capsule, depth); }, force, ends});
    for (const int steps : {10, 40, 160}) {
        lines.push_back(
            {"the equations in " + std::to_string(steps) + " steps",
             [sheet, steps](double ball, double depth) { return sheet(steps).under_end(ball, depth).force; },
             force,
             {0.45}});
    }
    return lines;
}

std::vector<ChartPoint> measure_posterior_capsule(const ChartOptions& options) {
    const CapsuleModel capsule;
    std::vector<ChartPoint> points;
    for (const SheetLine& line : sheet_lines(capsule)) {
        for (const double radius : line.radii) {
            if (!options.only_default || radius == line.default_radius) {
                points.push_back(point_of_sheet(line, radius, options));
            }
        }
    }
    return points;
}

}  // namespace

Chart chart_posterior_capsule() {
    return {
        "posterior_capsule",
        "Posterior capsule pushed by round ends as deep as 2 mm, or sucked into a bore",
        "CPU seconds for one force or strain",
        "force or strain, rms of shares over depths or suctions",
        "a clamped elastic sheet under a smooth round end [YangFeng1970], integrated and shot; a point's closed form "
        "[Komaragiri2005]",
        true,
        measure_posterior_capsule};
}

}  // namespace rhexis::bench
