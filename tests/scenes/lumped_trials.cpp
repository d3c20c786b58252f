// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/lumped_trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/assert.hpp"
#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "session/session.hpp"
#include "session/settings.hpp"

namespace rhexis::scenes {
namespace {

constexpr double sampled_s = 0.02;
constexpr double asked_s = 0.5;  ///< for which a hand asks for the same

/// Of models and machine; what only chooses meshes, pictures or where an exercise begins is left as it is.
bool is_hard(std::string_view name) {
    constexpr auto kinds = std::to_array<std::string_view>(
        {"capsule.hole_mm", "capsule.strength", "cortex.", "cutter.", "hydrodissection.", "ia.", "machine.", "phaco.",
         "suprachoroidal.", "tamponade.", "viscoelastic.", "vitreous.", "wound.", "wounds.", "zonules."});
    return std::any_of(kinds.begin(), kinds.end(), [&](std::string_view kind) { return name.starts_with(kind); });
}

SceneDescription described(const LumpedScene& parts, std::uint64_t seed, double dt) {
    SceneDescription scene;
    scene.patient.tetrahedra = 500;
    scene.tissues = parts.tissues;
    scene.instruments = parts.instruments;
    scene.step_s = dt;
    Rng rng(seed, "extreme settings");
    for (const SettingInfo& info : setting_table()) {
        // a machine that hardly runs is no trial
        const bool high = rng.uniform() < (info.live ? 0.85 : 0.5);
        if (is_hard(info.name)) {
            scene.settings[std::string(info.name)] = high ? info.maximum : info.minimum;
        }
    }
    return scene;
}

/// What a hand does from one moment on, until it does something else.
struct Asked {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::Zero();
    double pedal = 0.0;
    double jaw = 0.0;
    bool present = true;
};

/// Per instrument what it does, half a second each.
std::vector<std::vector<Asked>> hands_of(const LumpedScene& parts, std::uint64_t seed, double seconds) {
    Rng rng(seed, "hands");
    const auto anywhere = [&] { return Vec3(uniform3(rng).cwiseProduct(Vec3(6.0, 6.0, 4.0)) - Vec3(3.0, 3.0, 2.0)); };
    std::vector<std::vector<Asked>> hands(parts.instruments.size());
    for (std::vector<Asked>& hand : hands) {
        Vec3 place = anywhere();
        for (double time = 0.0; time < seconds - 1e-9; time += asked_s) {
            Asked asked;
            asked.from = place;
            asked.to = place = rng.uniform() < 0.5 ? place : anywhere();
            asked.pedal = std::round(3.0 * rng.uniform());
            asked.jaw = std::round(rng.uniform());
            asked.present = rng.uniform() < 0.8;
            hand.push_back(asked);
        }
    }
    return hands;
}

DeviceSample sample_of(const std::vector<Asked>& hand, int instrument, double end_s) {
    const double before = end_s - 1e-9;
    const Asked& asked = hand[static_cast<std::size_t>(before / asked_s)];
    const double share = std::fmod(before, asked_s) / asked_s;
    DeviceSample sample;
    sample.instrument = instrument;
    sample.present = asked.present;
    sample.pose.orientation = Quat(Eigen::AngleAxisd(1.05, Vec3::UnitX()));
    sample.pose.position = asked.from + share * (asked.to - asked.from);
    sample.pedal = asked.pedal;
    sample.jaw = asked.jaw;
    return sample;
}

double least_of(const std::vector<double>& values) {
    return values.empty() ? 0.0 : *std::min_element(values.begin(), values.end());
}

/// Of all that can only be there or not [mm^3].
double lowest_volume(const WorldState& state) {
    std::vector<double> volumes{0.0};
    if (state.cortex) {
        volumes.push_back(least_of(state.cortex->volume));
        volumes.push_back(least_of(state.cortex->attached));
    }
    if (state.retained) {
        volumes.insert(volumes.end(), {state.retained->front, state.retained->behind, state.retained->angle});
    }
    if (state.vitreous) {
        const VitreousState& own = *state.vitreous;
        volumes.insert(volumes.end(),
                       {own.front[0], own.front[1], own.plug[0], own.plug[1], own.wound, own.filled, own.cut});
    }
    if (state.hydrodissection) {
        const HydrodissectionState& own = *state.hydrodissection;
        volumes.insert(volumes.end(), {own.trapped, own.filled, own.lifted, least_of(own.cleaved)});
    }
    if (state.wounds) {
        volumes.push_back(state.wounds->behind);
        for (const Wound& wound : state.wounds->wounds) {
            volumes.insert(volumes.end(), {wound.fluid, wound.swelling});
        }
    }
    if (state.prolapse) {
        volumes.push_back(state.prolapse->length);
    }
    return least_of(volumes);
}

bool all_finite_in(const Session& session) {
    const std::vector<double>& values = session.observation().values;
    // measures of what is not there are no numbers by intent; infinite ones never are
    return std::none_of(values.begin(), values.end(), [](double value) { return std::isinf(value); }) &&
           std::isfinite(session.state().chamber->eye_volume) && std::isfinite(session.state().chamber->tube_volume);
}

/// Pressure of the eye at every sample [Pa].
std::vector<double> run_at(const LumpedScene& parts, std::uint64_t seed, double seconds, double dt, Extremes& found) {
    Result<Session> made = Session::create(described(parts, seed, dt), seed);
    if (!made) {
        assertion_failed(made.error().text().c_str(), __FILE__, __LINE__);
    }
    Session& session = made.value();
    const std::vector<std::vector<Asked>> hands = hands_of(parts, seed, seconds);
    const int each = static_cast<int>(std::lround(sampled_s / dt));
    std::vector<double> pressures;
    std::vector<DeviceSample> samples(hands.size());
    for (int i = 1; i <= std::lround(seconds / dt); ++i) {
        for (std::size_t hand = 0; hand < hands.size(); ++hand) {
            samples[hand] = sample_of(hands[hand], static_cast<int>(hand), i * dt);
        }
        const StepOutcome outcome = session.step(samples, {});
        found.failures += outcome.failure == StepFailure::none ? 0 : 1;
        found.finite = found.finite && all_finite_in(session);
        found.lowest = std::min(found.lowest, lowest_volume(session.state()));
        const double pressure = eye_pressure(*session.world().chamber, session.state().chamber->eye_volume);
        found.pressure = std::max(found.pressure, std::abs(pressure));
        if (i % each == 0) {
            pressures.push_back(pressure);
        }
    }
    return pressures;
}

/// Share of the samples, within the last half of what is asked for, at which the pressure turns by more than a mmHg.
double turns_in(const std::vector<double>& pressures) {
    const int each = static_cast<int>(std::lround(asked_s / sampled_s));
    int looked = 0;
    int turned = 0;
    for (int i = 2; i < static_cast<int>(pressures.size()); ++i) {
        if (i % each < each / 2 + 2) {
            continue;
        }
        const auto at_sample = [&](int k) { return pressures[static_cast<std::size_t>(k)]; };
        const double before = at_sample(i - 1) - at_sample(i - 2);
        const double now = at_sample(i) - at_sample(i - 1);
        ++looked;
        turned += before * now < 0.0 && std::min(std::abs(before), std::abs(now)) > pascal_per_mmhg ? 1 : 0;
    }
    return static_cast<double>(turned) / looked;
}

}  // namespace

std::span<const LumpedScene> lumped_scenes() {
    static const std::array<LumpedScene, 6> scenes{{
        {"cortex", {"bag", "capsule", "iris", "cornea", "globe", "chamber", "wounds", "cortex"}, {"ia_tip"}},
        {"viscoelastic", {"bag", "capsule", "iris", "cornea", "globe", "chamber", "retained_viscoelastic"}, {"ia_tip"}},
        {"vitreous",
         {"bag", "capsule", "iris", "cornea", "chamber", "wounds", "zonules", "vitreous"},
         {"cutter", "cannula"}},
        {"iris and wounds", {"iris", "cornea", "globe", "chamber", "wounds"}, {"phaco", "hydration_cannula"}},
        {"tip alone", {"chamber", "iris", "cornea"}, {"phaco"}},
        {"hydrodissection",
         {"lens", "bag", "capsule", "iris", "cornea", "chamber", "hydrodissection"},
         {"saline_cannula"},
         true},
    }};
    return scenes;
}

Extremes run_extremes(const LumpedScene& scene, std::uint64_t seed, double seconds) {
    Extremes found;
    const std::vector<double> coarse = run_at(scene, seed, seconds, 0.02, found);
    found.chatter = turns_in(coarse);
    const std::vector<double> fine = run_at(scene, seed, seconds, 0.001, found);
    double square = 0.0;
    for (std::size_t i = 0; i < fine.size(); ++i) {
        square += (coarse[i] - fine[i]) * (coarse[i] - fine[i]) / static_cast<double>(fine.size());
    }
    const auto [low, high] = std::minmax_element(fine.begin(), fine.end());
    found.apart = std::sqrt(square) / std::max(*high - *low, pascal_per_mmhg);
    return found;
}

}  // namespace rhexis::scenes
