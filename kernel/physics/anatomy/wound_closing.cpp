// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/wound_closing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rhexis {

namespace {

constexpr double most_open = 30.0;       ///< of all wounds, share of the chamber's leak_conductance
constexpr double blade_leak = 0.2;       ///< beside a blade, share of that beside another instrument. Proposal
constexpr double least_bite = 0.2;       ///< of a stitch on each side of the outer lip [mm]. Proposal
constexpr double most_bite = 2.5;        ///< [mm]. Proposal
constexpr double least_depth = 0.25;     ///< of a stitch that holds both lips [mm]. Proposal
constexpr double off_middle = 0.35;      ///< share of the width that a stitch may be off the middle. Proposal
constexpr double pulls = 0.4;            ///< astigmatism by a stitch, per length of its bite [dioptres/mm]. Proposal
constexpr double outer_lip_reach = 1.6;  ///< of an outer lip: a sponge there presses on it [mm]. Proposal
constexpr double test_press = 1.0e5;     ///< with which it must be pressed for a test [uN]. Proposal
constexpr double test_s = 0.3;           ///< and for so long [s]. Proposal
constexpr double test_pressure = 10.0 * pascal_per_mmhg;  ///< of an eye that can be tested [Pa]. Proposal
constexpr double runs_off_s = 1.0;                        ///< what lies on a wound [s]. Proposal
constexpr double soaks = 5.0;                             ///< a sponge takes it up [1/s]. Proposal

double pressure_of(const WorldModel& model, const WorldState& state) {
    return eye_pressure(*model.chamber, state.chamber->eye_volume);
}

double burn_of(const WorldState& state, std::size_t which) {
    return which == main_wound ? burn_share(state.chamber->wound) : 0.0;
}

double conductance(const WorldModel& model, const WorldState& state, std::size_t which, double pressure) {
    const Wound& wound = state.wounds->wounds[which];
    return wound_conductance(*model.wounds, wound, burn_of(state, which), pressure, wound.press);
}

/// From a place to the tunnel, which is as wide as the wound.
double distance_to_tunnel(const Wound& wound, const Vec3& place) {
    const Vec3 along = along_lip(wound);
    const double side = std::clamp((place - wound.outer).dot(along), -0.5 * wound.width, 0.5 * wound.width);
    const Vec3 moved = place - side * along;
    const Vec3 line = wound.inner - wound.outer;
    const double share = std::clamp((moved - wound.outer).dot(line) / std::max(line.squaredNorm(), 1e-6), 0.0, 1.0);
    return (moved - wound.outer - share * line).norm();
}

void inject(const WorldModel& model, double jaw, double dt, WorldState& state) {
    const double eased = std::clamp(1.0 - pressure_of(model, state) / model.wounds->most_pressure, 0.0, 1.0);
    const double volume = model.wounds->injection * jaw * eased * dt;
    state.chamber->eye_volume += volume;
    state.wounds->injected += volume;
}

void swell(const WoundsModel& model, const Vec3& tip, double jaw, double dt, WoundsState& state) {
    for (Wound& wound : state.wounds) {
        if (wound.cut && distance_to_tunnel(wound, tip) < model.beside) {
            const double rate = model.hydration * jaw * model.tight / std::max(wound.width, 0.5);
            wound.swelling = std::min(1.0, wound.swelling + rate * dt);
            state.checked = false;
            return;
        }
    }
}

void use_syringe(const WorldModel& model, const ToolModel& tool, const ToolState& hand, double dt, WorldState& state) {
    const Vec3& tip = hand.pose.position;
    if (!hand.present || !(hand.jaw > 0.0) || !(below_front(*model.wounds, tip) > 0.0)) {
        return;
    }
    const bool inside = beyond_back(*model.wounds, tip) > 0.0;
    if (tool.kind == ToolKind::hydrator && !inside) {
        swell(*model.wounds, tip, hand.jaw, dt, *state.wounds);
    } else if (inside && (tool.kind == ToolKind::hydrator || !model.vitreous)) {
        inject(model, hand.jaw, dt, state);  // with vitreous, viscoelastic has an account of its own
    }
}

/// A stitch from one place of the front to another.
void tie(const Vec3& in, const Vec3& out, WoundsState& state) {
    for (Wound& wound : state.wounds) {
        const Vec3 across = across_lip(wound);
        const double first = (in - wound.outer).dot(across);
        const double second = (out - wound.outer).dot(across);
        const double least = std::min(std::abs(first), std::abs(second));
        const double most = std::max(std::abs(first), std::abs(second));
        if (!wound.cut || first * second >= 0.0 || least < least_bite || most > most_bite) {
            continue;
        }
        const Vec3 crossing = in + first / (first - second) * (out - in);
        if (std::abs((crossing - wound.outer).dot(along_lip(wound))) < off_middle * wound.width) {
            ++wound.sutures;
            wound.distortion += pulls * (out - in).norm();
            state.checked = false;
            return;
        }
    }
}

void sew(const WoundsModel& model, const ToolState& hand, WoundsState& state) {
    const Vec3& from = hand.previous_pose.position;
    const Vec3& to = hand.pose.position;
    const double before = below_front(model, from);
    const double depth = hand.present ? below_front(model, to) : 0.0;
    if (!hand.present || beyond_back(model, to) > 0.0) {
        state.stitching = false;  // taken away, or through the whole cornea: that holds nothing
        return;
    }
    if (before <= 0.0 && depth > 0.0) {
        state.stitching = true;
        state.bite = from;
        state.deepest = 0.0;
    }
    state.deepest = std::max(state.deepest, depth);
    if (state.stitching && depth <= 0.0) {
        state.stitching = false;
        if (state.deepest > least_depth) {
            tie(state.bite, to, state);
        }
    }
}

/// Of a sponge, whose end is a ball that the cornea gives way to.
void press_with(const WoundsModel& model, const ToolModel& tool, const ToolState& hand, double dt, WoundsState& state) {
    if (!hand.present || tool.parts.empty()) {
        return;
    }
    const Vec3 ball = hand.pose.to_world(tool.parts[0].a);
    const double deep = tool.parts[0].radius_a + below_front(model, ball);
    if (!(deep > 0.0)) {
        return;
    }
    const Vec3 touched = model.front_centre + model.front_radius * (ball - model.front_centre).normalized();
    for (Wound& wound : state.wounds) {
        const Vec3 off = touched - wound.outer;
        const double side = std::max(0.0, std::abs(off.dot(along_lip(wound))) - 0.5 * wound.width);
        if (wound.cut && std::abs(off.dot(across_lip(wound))) < outer_lip_reach && side < outer_lip_reach) {
            wound.press += model.skin_stiffness * deep;
            wound.fluid /= 1.0 + soaks * dt;
            state.peak_press = std::max(state.peak_press, wound.press);
        }
    }
}

/// Aqueous is made and leaves; blood comes between the coats while it is under more pressure than the eye.
void fill_slowly(const WorldModel& model, double dt, WorldState& state) {
    WoundsState& wounds = *state.wounds;
    const double pressure = pressure_of(model, state);
    const double aqueous = model.wounds->outflow * (model.chamber->rest_pressure - pressure) * dt;
    const double above = model.chamber->rest_pressure + wounds.source - pressure;
    const double blood = wounds.source > 0.0 ? model.wounds->bleeding * std::max(0.0, above) * dt : 0.0;
    wounds.aqueous += aqueous;
    wounds.behind += blood;
    state.chamber->eye_volume += aqueous + blood;
}

/// Tips in the chamber, by the wound that their shafts are in.
std::array<double, wound_count> instruments_in(const WorldModel& model, std::span<const ToolState> tools,
                                               const WoundsState& state) {
    std::array<double, wound_count> leak{};
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const Vec3& tip = tools[i].pose.position;
        const ToolKind kind = model.tools[i].kind;
        if (!tools[i].present || kind == ToolKind::sponge || kind == ToolKind::needle ||
            !(beyond_back(*model.wounds, tip) > 0.0)) {
            continue;
        }
        const Vec3 axis = tools[i].pose.orientation * Vec3::UnitZ();
        std::size_t nearest = main_wound;
        double least = 1e9;
        for (std::size_t k = 0; k < wound_count; ++k) {
            const Vec3 off = state.wounds[k].inner - tip;
            const double distance = (off - std::max(0.0, off.dot(axis)) * axis).norm();
            if (state.wounds[k].cut && distance < least) {
                nearest = k;
                least = distance;
            }
        }
        const double share = kind == ToolKind::blade ? blade_leak : 1.0;
        leak[nearest] += least < 1e9 ? share * model.chamber->leak_conductance : 0.0;
    }
    return leak;
}

void test(const WorldModel& model, double dt, WorldState& state) {
    WoundsState& wounds = *state.wounds;
    const Wound& main = wounds.wounds[main_wound];
    if (!main.cut || main.press < test_press || pressure_of(model, state) < test_pressure) {
        wounds.pressed_s = 0.0;
        return;
    }
    wounds.tested_leak = wounds.pressed_s > 0.0 ? std::max(wounds.tested_leak, main.leak) : main.leak;
    wounds.pressed_s += dt;
    wounds.checked = wounds.checked || wounds.pressed_s >= test_s;
}

}  // namespace

Vec3 across_lip(const Wound& wound) {
    const double rho = wound.outer.head<2>().norm();
    return rho > 0.0 ? Vec3(wound.outer.x() / rho, wound.outer.y() / rho, 0.0) : Vec3(0.0, -1.0, 0.0);
}

Vec3 along_lip(const Wound& wound) {
    const Vec3 across = across_lip(wound);
    return {-across.y(), across.x(), 0.0};
}

void close_wounds(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state) {
    WoundsState& wounds = *state.wounds;
    for (Wound& wound : wounds.wounds) {
        wound.press = 0.0;
        wound.swelling /= 1.0 + dt / model.wounds->swelling_lasts;
    }
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const ToolModel& tool = model.tools[i];
        if (tool.kind == ToolKind::hydrator || tool.kind == ToolKind::cannula) {
            use_syringe(model, tool, tools[i], dt, state);
        } else if (tool.kind == ToolKind::needle) {
            sew(*model.wounds, tools[i], wounds);
        } else if (tool.kind == ToolKind::sponge) {
            press_with(*model.wounds, tool, tools[i], dt, wounds);
        }
    }
    fill_slowly(model, dt, state);
}

double wounds_open(const WorldModel& model, std::span<const ToolState> tools, const WorldState& state) {
    const double pressure = pressure_of(model, state);
    const std::array<double, wound_count> beside = instruments_in(model, tools, *state.wounds);
    double sum = 0.0;
    for (std::size_t i = 0; i < wound_count; ++i) {
        sum += conductance(model, state, i, pressure) + beside[i];
    }
    return model.chamber->leak_conductance > 0.0 ? std::min(most_open, sum / model.chamber->leak_conductance) : 0.0;
}

void share_leak(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state) {
    WoundsState& wounds = *state.wounds;
    const double pressure = pressure_of(model, state);
    const std::array<double, wound_count> beside = instruments_in(model, tools, wounds);
    std::array<double, wound_count> part{};
    double sum = 0.0;
    for (std::size_t i = 0; i < wound_count; ++i) {
        part[i] = conductance(model, state, i, pressure) + beside[i];
        sum += part[i];
    }
    for (std::size_t i = 0; i < wound_count; ++i) {
        Wound& wound = wounds.wounds[i];
        const double gape = gape_of(*model.wounds, wound, burn_of(state, i), pressure, wound.press);
        wound.gape = wound.cut ? std::clamp(gape, 0.0, 1.0) : 0.0;
        wound.leak = sum > 0.0 ? state.flows.leak * part[i] / sum : 0.0;
        wound.fluid = (wound.fluid + std::max(0.0, wound.leak) * dt) / (1.0 + dt / runs_off_s);
    }
    test(model, dt, state);
}

}  // namespace rhexis
