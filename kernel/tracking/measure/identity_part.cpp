// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies taken for another, and bodies told that are not there: without images, for a million exposures.
#include <algorithm>
#include <numbers>

#include "base/rng.hpp"
#include "math/random_vectors.hpp"
#include "tracking/measure/measured_parts.hpp"
#include "tracking/sources/synthetic_source.hpp"

namespace rhexis::tracking {
namespace {

Vec3 drawn(double most, Rng& rng) { return most * (2.0 * uniform3(rng) - Vec3::Ones()); }

/// Instruments that cross before all cameras, each on its own way through the others' and turning; every third of a
/// second some marker is hidden.
void disturb(synthetic::Clip& clip, Rng& rng) {
    constexpr double wander_mm = 30.0;
    constexpr double turn = 0.35;
    constexpr double hidden_s = 0.3;
    for (std::size_t i = 0; i < clip.bodies.size(); ++i) {
        if (clip.bodies[i].name == "head") {
            continue;
        }
        for (int wave = 0; wave < 2; ++wave) {
            const double phase = 2.0 * std::numbers::pi * rng.uniform();
            clip.motions[i].moves.push_back({drawn(wander_mm, rng), 0.2 + 0.5 * rng.uniform(), phase});
            clip.motions[i].turns.push_back({drawn(turn, rng), 0.2 + 0.5 * rng.uniform(), phase});
        }
    }
    for (double time_s = 0.2; time_s < clip.duration_s; time_s += hidden_s) {
        const auto body = static_cast<int>(rng.integer(0, static_cast<std::int64_t>(clip.bodies.size()) - 1));
        const auto markers = static_cast<std::int64_t>(clip.bodies[static_cast<std::size_t>(body)].markers.size());
        clip.covers.push_back({-1, body, static_cast<int>(rng.integer(0, markers - 1)), time_s, time_s + hidden_s});
    }
    clip.specks = 3.0;
}

/// Some that rest on the drape, where several cameras see them, and some that go round as on wet metal.
void add_more_glints(double time_s, synthetic::Scene& scene) {
    for (int i = 0; i < 6; ++i) {
        const double turn = 2.0 * std::numbers::pi * (i / 6.0 + 0.7 * time_s);
        scene.glints.push_back({{70.0 - 25.0 * i, -60.0 + 20.0 * i, 5.0 * i}, 180.0, 3.0});
        scene.glints.push_back({{60.0 * std::cos(turn), 60.0 * std::sin(turn), 40.0 + 8.0 * i}, 200.0, 4.0});
    }
}

/// Of one instrument nothing is there but its handle and the hand.
void take_away(const synthetic::Clip& clip, std::size_t body, synthetic::Scene& scene) {
    std::ptrdiff_t first = 0;
    for (std::size_t i = 0; i < body; ++i) {
        first += static_cast<std::ptrdiff_t>(clip.bodies[i].markers.size());
    }
    const auto begin = scene.spheres.begin() + first;
    scene.spheres.erase(begin, begin + static_cast<std::ptrdiff_t>(clip.bodies[body].markers.size()));
}

/// What the rig's own frame is off, in which the head alone is told: calibration knows the cameras' places to each
/// other, and that of all together to some millimetres only. Instruments are told by the head.
Vec3 frame_offset(const TipTrace& head) {
    std::array<std::vector<double>, 3> off;
    for (const TipSample& sample : head) {
        for (std::size_t k = 0; sample.seen && k < 3; ++k) {
            off[k].push_back((sample.told.position - sample.is.position)[static_cast<Eigen::Index>(k)]);
        }
    }
    return {share_of(std::move(off[0]), 0.5), share_of(std::move(off[1]), 0.5), share_of(std::move(off[2]), 0.5)};
}

/// Adds up: exposures, bodies that were told and were there, that were wrong, and that were not there.
void count(const ClipRun& run, std::size_t absent, Numbers& numbers) {
    constexpr std::size_t head = 0;
    constexpr double wrong_mm = 5.0;
    constexpr double wrong_deg = 5.0;
    double told = 0.0;
    double wrong = 0.0;
    double false_ones = 0.0;
    for (std::size_t i = 0; i < run.traces.size(); ++i) {
        const Vec3 offset = i == head ? frame_offset(run.traces[i]) : Vec3(Vec3::Zero());
        for (const TipSample& sample : run.traces[i]) {
            if (!sample.seen) {
                continue;
            }
            const bool off = (sample.told.position - sample.is.position - offset).norm() > wrong_mm ||
                             axis_off_deg(sample) > wrong_deg;
            told += i == absent ? 0.0 : 1.0;
            wrong += i != absent && off ? 1.0 : 0.0;
            false_ones += i == absent ? 1.0 : 0.0;
        }
    }
    numbers["identity.exposures"].push_back(static_cast<double>(run.traces[0].size()));
    numbers["identity.told"].push_back(told);
    numbers["identity.wrong"].push_back(wrong);
    numbers["identity.false"].push_back(false_ones);
}

}  // namespace

Result<Numbers> measure_identity(const Setting& setting, int number, int exposures) {
    const std::size_t instruments = setting.bodies.size() - 1;  // the head is the first
    Numbers numbers;
    for (int done = 0, turn = 0; done < exposures; ++turn) {
        const std::uint64_t chance =
            (setting.seed * 1000 + static_cast<std::uint64_t>(number)) * 1000 + static_cast<std::uint64_t>(turn);
        Result<synthetic::Clip> clip = setting.clip("crossing");
        if (!clip) {
            return clip.error();
        }
        Rng rng(chance, "identities");
        disturb(clip.value(), rng);
        const std::size_t absent = 1 + static_cast<std::size_t>(turn) % instruments;
        synthetic::Stage stage;
        stage.scene = [&clip, absent](double time_s, synthetic::Scene& scene) {
            scene_at(clip.value(), time_s, scene);
            take_away(clip.value(), absent, scene);
            add_more_glints(time_s, scene);
        };
        synthetic::Film film;
        film.seed = chance;
        film.centre = synthetic::SpotCentre::light;  // of a million; more glints and specks are spots then
        film.delivery.lost = 0.02;
        film.delivery.late = 0.01;
        film.frames = std::min(exposures - done, static_cast<int>(clip.value().duration_s * film.delivery.rate_hz));
        const Result<std::unique_ptr<SpotSource>> source = film_markers(setting.rig, stage, film);
        if (!source) {
            return source.error();
        }
        const Result<ClipRun> run =
            track_spots(*source.value(), setting.solver(), clip.value(), setting.clip_plan(false, 1e9));
        if (!run) {
            return run.error();
        }
        count(run.value(), absent, numbers);
        done += static_cast<int>(film.frames);
    }
    return numbers;
}

}  // namespace rhexis::tracking
