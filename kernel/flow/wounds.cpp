// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow/wounds.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {

namespace {

constexpr double usual_pressure = 20.0 * pascal_per_mmhg;  ///< of an eye in which a wound is tested [Pa]
constexpr double usual_press = 2.8e5;                      ///< an ounce on the outer lip [uN] [Masket2014]

/// Of a ball, on its upper half, `across` from its axis.
Vec3 on_ball(const Vec3& centre, double radius, const Vec2& across) {
    const double square = std::max(0.0, radius * radius - across.squaredNorm());
    return {centre.x() + across.x(), centre.y() + across.y(), centre.z() + std::sqrt(square)};
}

}  // namespace

WoundsState rest_state(const WoundsModel& model) {
    WoundsState state;
    state.wounds = model.start;
    return state;
}

double below_front(const WoundsModel& model, const Vec3& place) {
    return model.front_radius - (place - model.front_centre).norm();
}

double beyond_back(const WoundsModel& model, const Vec3& place) {
    return model.back_radius - (place - model.back_centre).norm();
}

double inset_of(const WoundsModel& model, const Vec3& place) { return model.limbus_radius - place.head<2>().norm(); }

Wound made_wound(const WoundsModel& model, const Vec2& direction, double tunnel, double width, double inset) {
    Wound wound;
    wound.begun = wound.cut = true;
    const double inner = model.limbus_radius - inset;
    wound.inner = on_ball(model.back_centre, model.back_radius, inner * direction);
    // The outer lip is as far from the inner one as the tunnel is long, but not nearer than the cornea is thick.
    double near = inner;
    double far = inner + std::max(tunnel, 0.1);
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (near + far);
        const Vec3 outer = on_ball(model.front_centre, model.front_radius, middle * direction);
        ((outer - wound.inner).norm() < tunnel ? near : far) = middle;
    }
    wound.outer = on_ball(model.front_centre, model.front_radius, near * direction);
    wound.mark = wound.inner;
    wound.tunnel = tunnel;
    wound.planes = 2;
    wound.width = width;
    return wound;
}

double gape_of(const WoundsModel& model, const Wound& wound, double burn, double pressure, double press) {
    const double ratio =
        wound.tunnel / std::max(wound.width, 0.1) / model.seal_ratio * (wound.planes > 1 ? 1.0 : model.one_plane);
    const double valve = model.valve * std::max(0.0, pressure) / usual_pressure * std::max(0.0, ratio - 0.5);
    const double swelling = model.swelling_seals * wound.swelling * (1.0 - model.burn_stiffens * burn);
    return 1.0 - ratio - valve - swelling - model.suture_closes * wound.sutures + model.burn_gapes * burn +
           model.press_gapes * press / usual_press;
}

double wound_conductance(const WoundsModel& model, const Wound& wound, double burn, double pressure, double press) {
    if (!wound.cut) {
        return 0.0;
    }
    const double slit = model.widest_slit * std::clamp(gape_of(model, wound, burn, pressure, press), 0.0, 1.0);
    return wound.width * slit * slit * slit / (12.0 * model.viscosity * std::max(wound.tunnel, 0.3));
}

double volume_in_front(const ChamberState& chamber, const WoundsState* wounds) {
    return chamber.eye_volume - (wounds != nullptr ? wounds->behind : 0.0);
}

}  // namespace rhexis
