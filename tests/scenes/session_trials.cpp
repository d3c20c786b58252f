// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/session_trials.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "session/session.hpp"

namespace rhexis::scenes {
namespace {

constexpr int spike_steps = 20;  // 200 ms
constexpr int spike_begins = 90;
constexpr double pause_s = 1.0;

/// Forward and slowly down into the front of the lens, with ultrasound.
DeviceSample hand_at(double time_s) {
    DeviceSample sample;
    sample.present = true;
    sample.pose.orientation = Quat(Eigen::AngleAxisd(1.05, Vec3::UnitX()));
    sample.pose.position = Vec3(0.1, -3.0 + 4.0 * time_s, 2.6 - 0.8 * time_s);
    sample.pedal = 2.8;
    return sample;
}

bool arrives(Disturbance disturbance, int call) {
    if (disturbance == Disturbance::missing) {
        return call % 3 == 0;
    }
    if (disturbance == Disturbance::spike) {
        return call < spike_begins || call >= spike_begins + spike_steps;
    }
    return true;
}

/// Mean shift of the corners of what is left of the lens.
Vec3 shift(const Session& session, const std::vector<Vec3>& before) {
    const TetMesh& mesh = session.world().solids[0].coarse;
    const SolidState& now = session.state().solids[0];
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        for (int k = 0; now.present[t] != 0 && k < 4; ++k) {
            const auto node = static_cast<std::size_t>(mesh.tets[t][static_cast<std::size_t>(k)]);
            sum += now.position[node] - before[node];
            ++count;
        }
    }
    return sum / std::max(1, count);
}

}  // namespace

Disturbed disturb(Disturbance disturbance, Advance advance) {
    SceneDescription scene;
    scene.patient.tetrahedra = 1000;
    scene.tissues = {"lens", "bag"};
    scene.instruments = {"phaco"};
    scene.advance = advance;
    Result<Session> created = Session::create(scene, 1);
    RHEXIS_ASSERT(created.ok());
    Session& session = created.value();
    Disturbed result;
    const std::vector<Vec3> start = session.state().solids[0].position;
    std::vector<Vec3> before = start;
    const int calls = static_cast<int>(std::lround(1.5 / scene.step_s));
    for (int call = 0; call < calls; ++call) {
        const double paused = disturbance == Disturbance::pause && call >= spike_begins ? pause_s : 0.0;
        const DeviceSample sample = hand_at(scene.step_s * (call + 1) + paused);
        const bool there = arrives(disturbance, call);
        const StepOutcome outcome =
            session.step(there ? std::span<const DeviceSample>(&sample, 1) : std::span<const DeviceSample>(), {});
        ++result.calls;
        result.most_substeps = std::max(result.most_substeps, outcome.solids[0].substeps);
        result.rollbacks += outcome.rollbacks;
        result.failures += outcome.failure == StepFailure::none ? 0 : 1;
        result.jump = std::max(result.jump, shift(session, before).norm());
        before = session.state().solids[0].position;
        for (const Contact& contact : session.contacts()) {
            if (contact.partner == ContactPartner::tool) {
                result.penetration = std::max(result.penetration, -contact.gap);
            }
        }
    }
    result.steps = static_cast<int>(session.step_count());
    result.shift = shift(session, start);
    result.removed = session.state().removed_mass;
    return result;
}

}  // namespace rhexis::scenes
