// SPDX-License-Identifier: GPL-3.0-or-later
// A small eye and a hand that pushes into its lens with ultrasound: enough to exercise a session.
#pragma once

#include <string>
#include <vector>

#include "kernel/session/sessions.hpp"

namespace rhexis::test {

inline SceneDescription small_scene() {
    SceneDescription scene;
    scene.patient.tetrahedra = 500;
    scene.tissues = {"lens", "bag", "iris", "cornea"};
    scene.instruments = {"phaco"};
    return scene;
}

/// In from the surgeon's side at 30 degrees, then forward through the lens's front with the pedal down.
inline DeviceSample hand_at(const Session& session, double time_s) {
    const double front = session.eye().lens.coarse.nodes.empty() ? 2.0 : 1.9;
    DeviceSample sample;
    sample.present = true;
    sample.pose.orientation = Quat(Eigen::AngleAxisd(1.05, Vec3::UnitX()));
    sample.pose.position = Vec3(0.1, -1.5 + 2.0 * time_s, front - 0.8 * time_s);
    sample.pedal = time_s > 0.1 ? 2.8 : 1.0;
    return sample;
}

/// Of the lens, emulsified or in crumbs or not [g].
inline double tissue_mass(const Session& session) {
    double sum = session.state().removed_mass + remaining_mass(session.world().solids[0], session.state().solids[0]);
    for (const Debris& crumb : session.state().debris) {
        sum += crumb.volume * crumb.density;
    }
    return sum;
}

inline void operate(Session& session, int steps) {
    for (int i = 0; i < steps; ++i) {
        const DeviceSample sample = hand_at(session, session.time_s() + session.scene().step_s);
        session.step({&sample, 1}, {});
    }
}

inline Session make_session() { return make_session(small_scene()); }

inline std::vector<std::uint64_t> hashes_of(Session& session, int steps) {
    std::vector<std::uint64_t> hashes;
    for (int i = 0; i < steps; ++i) {
        operate(session, 1);
        hashes.push_back(session.state_hash());
    }
    return hashes;
}

/// Operates and records; a checkpoint every `every` steps.
inline void record(const std::string& path, int steps, int every, bool finish = true) {
    Session session = make_session();
    RecordingHeader header;
    header.scene = session.scene();
    header.seed = 1;
    header.curriculum = "test";
    header.identity = R"({"id":"test"})";
    header.build = build_note();
    header.schema = session.schema();
    Result<RecordingWriter> created = RecordingWriter::create(path, header);
    if (!created) {
        throw std::runtime_error(created.error().text());
    }
    RecordingWriter& writer = created.value();
    Status status = writer.add(RecordedStart{session.observation(), session.state_hash()});
    const std::vector<Command> commands{{CommandKind::set, "phaco.power_limit", 0.8, ""}};
    for (int i = 0; i < steps && status; ++i) {
        const DeviceSample sample = hand_at(session, session.time_s() + session.scene().step_s);
        session.step({&sample, 1}, commands);
        status = writer.add(
            RecordedStep{session.step_count(), {sample}, commands, session.observation(), session.state_hash()});
        if (status && (i + 1) % every == 0) {
            status = writer.add(session.snapshot());
        }
    }
    if (status && finish) {
        status = writer.finish();
    }
    if (!status) {
        throw std::runtime_error(status.error().text());
    }
}

}  // namespace rhexis::test
