// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <set>

#include "base/index.hpp"
#include "bench/charts/models.hpp"
#include "bench/timing.hpp"
#include "eye/implant.hpp"
#include "eye/implant_outline.hpp"
#include "math/turn.hpp"
#include "physics/shell/shell_statics.hpp"

namespace rhexis::bench {
namespace {

constexpr double acrylic_modulus = 1.0e6;  ///< [Pa]
constexpr int usual_triangles = 400;       ///< what the budget of exercises chooses (docs/accuracy.md)
/// On either haptic [uN]. The last takes an implant of 13 mm into a bag of 10 mm.
const std::vector<double> haptic_forces{8.0, 16.0, 24.0, 32.0};

/// Straight inwards at the upper haptic's tip.
Vec2 pressed_way(const Vec2& tip) { return -tip.normalized(); }

/// The haptic as a thin curved bar that is clamped at the optic's rim [Love1906]: bending, stretch and shear in its
/// plane, any deflection. By midpoint steps along it, for a moment at the rim at which the tip bears none.
class CurvedBar {
public:
    explicit CurvedBar(const ImplantShape& shape, double scale) : thickness_(shape.haptic_thickness) {
        const Vec2 root = 0.5 * shape.optic_diameter * direction_at(haptic_root);
        places_.push_back(root);
        for (const HapticSection& section : haptic_sections(shape, scale)) {
            places_.push_back(section.middle);
            widths_.push_back(section.width);
        }
        widths_.back() = shape.haptic_width;  // its rounded end is as short as the triangles
    }

    [[nodiscard]] Vec2 tip() const { return places_.back(); }

    /// How far the tip goes along the force.
    [[nodiscard]] double pressed(double force) const {
        const Vec2 way = pressed_way(tip());
        Vec2 end = tip();
        const double most = 20.0 * force;
        std::uintmax_t tries = 60;
        const auto left = [&](double moment) { return march(force * way, moment, end); };
        const auto found =
            boost::math::tools::toms748_solve(left, -most, most, boost::math::tools::eps_tolerance<double>(40), tries);
        left(found.first);
        return way.dot(end - tip());
    }

private:
    /// Moment left at the tip.
    double march(const Vec2& force, double moment, Vec2& end) const {
        Vec2 place = places_.front();
        double turn = 0.0;  // of the sections [rad]
        for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
            const Vec2 rest = places_[i + 1] - places_[i];
            const double length = rest.norm();
            const double area = thickness_ * widths_[i];
            const double bending = acrylic_modulus * area * widths_[i] * widths_[i] / 12.0;
            const Vec2 guess = turned(rest, turn);
            const double amid = moment - 0.5 * cross(guess, force);
            const double half = turn + 0.5 * length * amid / bending;
            const Vec2 along = turned(rest, half) / length;
            const Vec2 across(-along.y(), along.x());
            const Vec2 step = length * ((1.0 + force.dot(along) / (acrylic_modulus * area)) * along +
                                        force.dot(across) / (shear_modulus * shear_share * area) * across);
            turn += length * (moment - 0.5 * cross(step, force)) / bending;
            moment -= cross(step, force);
            place += step;
        }
        end = place;
        return moment;
    }

    static constexpr double shear_modulus = acrylic_modulus / (2.0 * 1.42);
    static constexpr double shear_share = 5.0 / 6.0;  ///< of a rectangle's area

    static double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
    static Vec2 turned(const Vec2& a, double angle) {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        return {c * a.x() - s * a.y(), s * a.x() + c * a.y()};
    }

    double thickness_;
    std::vector<Vec2> places_;
    std::vector<double> widths_;  ///< of the parts between
};

/// The kernel's shell, its optic held.
struct PressedImplant {
    explicit PressedImplant(int triangles) {
        ImplantShape shape;
        shape.triangles = triangles;
        implant = std::move(make_implant(shape)).value();
        implant.model.holds.clear();
        std::set<int> optic;
        for (std::size_t t = 0; t < implant.part.size(); ++t) {
            if (implant.part[t] == ImplantPart::optic) {
                optic.insert(implant.model.mesh.triangles[t].begin(), implant.model.mesh.triangles[t].end());
            }
        }
        for (const int node : optic) {
            implant.model.holds.push_back({node, {true, true, true, true, true, true}});
        }
        load.force.assign(implant.model.mesh.nodes.size(), Vec3::Zero());
        for (const int tip : implant.tip) {
            load.force[at(tip)].head<2>() = pressed_way(implant.model.mesh.nodes[at(tip)].head<2>());
        }
    }

    /// By each of the forces: how far the tips go along them; less where it does not converge.
    [[nodiscard]] std::vector<double> ways() const {
        ShellStatics statics = std::move(ShellStatics::create(implant.model)).value();
        ShellState state = rest_state(implant.model);
        std::vector<double> found;
        double reached = 0.0;
        for (const double force : haptic_forces) {
            if (!statics.load_to(load, reached, force, {}, state).converged) {
                break;
            }
            reached = force;
            const Vec3 moved = state.position[at(implant.tip[0])] - implant.model.mesh.nodes[at(implant.tip[0])];
            found.push_back(moved.dot(load.force[at(implant.tip[0])]));
        }
        return found;
    }

    Implant implant;
    ShellLoad load;
};

std::vector<double> ways_of_bar(double scale) {
    const CurvedBar bar(ImplantShape{}, scale);
    std::vector<double> found;
    for (const double force : haptic_forces) {
        found.push_back(bar.pressed(force));
    }
    return found;
}

std::vector<ChartPoint> measure_implant_bag(const ChartOptions& options) {
    const std::vector<double> answer = ways_of_bar(0.01);
    const double each = static_cast<double>(haptic_forces.size());
    std::vector<ChartPoint> points;
    for (const int triangles : {usual_triangles, 743, 1500, 3000}) {
        const bool is_default = triangles == usual_triangles;
        if (options.only_default && !is_default) {
            continue;
        }
        const PressedImplant implant(triangles);
        const double seconds =
            time_interleaved({[&] { static_cast<void>(implant.ways()); }}, options.repeats)[0].seconds;
        points.push_back(point_of("kernel: shell", std::to_string(triangles) + " triangles", is_default,
                                  rms_share(implant.ways(), answer), seconds / each));
    }
    for (const double scale : {1.0, 0.3, 0.1}) {
        if (!options.only_default) {
            const double seconds = time_interleaved({[&] { ways_of_bar(scale); }}, options.repeats)[0].seconds;
            char setting[48];
            std::snprintf(setting, sizeof setting, "parts of %g mm", 0.26 * scale);
            points.push_back(point_of("curved bar in few parts", setting, false, rms_share(ways_of_bar(scale), answer),
                                      seconds / each));
        }
    }
    return points;
}

}  // namespace

Chart chart_implant_bag() {
    return {"implant_bag",
            "Haptics of an implant whose optic is held, pressed in as by a bag of 10 mm",
            "CPU seconds for one equilibrium",
            "way of the tip, rms over four forces",
            "a thin curved bar, clamped at the optic, any deflection [Love1906]",
            true,
            measure_implant_bag};
}

}  // namespace rhexis::bench
