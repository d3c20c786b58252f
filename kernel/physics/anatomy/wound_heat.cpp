// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/wound_heat.hpp"

namespace rhexis {

namespace {

constexpr double heating = 20.0;                        ///< by full power [K/s]
constexpr double tissue_cooling = 0.1;                  ///< [1/s]
constexpr double fluid_cooling = 4.0 / (1000.0 / 3.0);  ///< per flow: 4 / s at 20 ml/min = 1000 / 3 mm^3/s [1/mm^3]
constexpr double tissue_temperature = 34.0;             ///< [degrees C]
constexpr double fluid_temperature = 24.0;              ///< of a bottle in the theatre [degrees C]
constexpr double shrinking_temperature = 60.0;          ///< of collagen [degrees C]
constexpr double widest_gape = 2.0;

}  // namespace

void heat_wound(double power, double infusion, double dt, WoundState& wound) {
    const double flow = fluid_cooling * infusion;
    wound.temperature =
        (wound.temperature + dt * (heating * power + tissue_cooling * tissue_temperature + flow * fluid_temperature)) /
        (1.0 + dt * (tissue_cooling + flow));
    if (wound.temperature >= shrinking_temperature) {
        wound.hot_s += dt;
    }
}

double wound_gape(const WoundState& wound, bool instrument) {
    return (instrument ? 1.0 : 0.0) + widest_gape * burn_share(wound);
}

}  // namespace rhexis
