// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/lifted_strip.hpp"

#include <cmath>

#include "scenes/shell_contacts.hpp"

namespace rhexis::scenes {
namespace {

constexpr int stations = 2000;
constexpr int halvings = 60;

/// An elastica from its free end inwards, under a force of direction (-s, c) there: theta'' = -F / EI (c cos theta + s
/// sin theta) outwards.
struct End {
    double angle = 0.0;  ///< at the clamp
    double x = 0.0;      ///< of the free end from the clamp
    double z = 0.0;
};

End from_free_end(double tip_angle, double share, double length, double s, double c) {
    double angle = tip_angle;
    double bend = 0.0;
    End end;
    const double h = length / stations;
    for (int i = 0; i < stations; ++i) {  // Heun, second order
        const double pull = share * (c * std::cos(angle) + s * std::sin(angle));
        const double ahead = angle - h * bend;
        const double bend_ahead = bend + h * pull;
        const double pull_ahead = share * (c * std::cos(ahead) + s * std::sin(ahead));
        const double middle = angle - 0.5 * h * bend - 0.125 * h * h * pull;
        end.x += h * std::cos(middle);
        end.z += h * std::sin(middle);
        angle -= 0.5 * h * (bend + bend_ahead);
        bend += 0.5 * h * (pull + pull_ahead);
    }
    end.angle = angle;
    return end;
}

template <typename Function>
double root(double low, double high, const Function& f) {
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

ShellModel LiftedStrip::model() const {
    ShellModel model = flat_strip(length, width, thickness, 40, 2);
    hold_line(model, 0.0);
    return model;
}

PlaneModel LiftedStrip::plane(double share) const {
    PlaneModel plane{Vec3::Zero(), Vec3(-std::sin(tilt), 0.0, std::cos(tilt)), 0.0};
    plane.point = Vec3(length, 0.0, share * lift) - 0.5 * thickness * plane.normal;
    return plane;
}

double LiftedStrip::force() const {
    const double s = std::sin(tilt);
    const double c = std::cos(tilt);
    const double bending = model().material.young_modulus * width * std::pow(thickness, 3.0) / 12.0;
    const auto tip = [&](double force) {
        const double share = force / bending;
        const double angle =
            root(0.0, 0.5 * M_PI, [&](double a) { return from_free_end(a, share, length, s, c).angle; });
        return from_free_end(angle, share, length, s, c);
    };
    return root(0.0, 4.0 * bending / (length * length), [&](double force) {
        const End end = tip(force);
        return -s * (end.x - length) + c * (end.z - lift);
    });
}

}  // namespace rhexis::scenes
