// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/prepared_state.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "base/output_file.hpp"
#include "base/text_file.hpp"
#include "flow/microscope.hpp"
#include "session/chunk.hpp"
#include "session/codec.hpp"
#include "session/folded_start.hpp"
#include "session/scene_differences.hpp"

namespace rhexis {
namespace {

constexpr std::size_t largest_state = std::size_t{1} << 30;

/// The payload of the chunk at the front of the bytes, which is taken from them.
Result<std::string_view> take_chunk(std::string_view& bytes, ChunkKind kind, const std::string& path) {
    const ChunkView chunk = next_chunk(bytes);
    if (chunk.state == ChunkState::cut) {
        return Error{"the state is cut short", path, ""};
    }
    if (chunk.state == ChunkState::damaged || chunk.kind != kind) {
        return Error{"the state is damaged", path, ""};
    }
    bytes.remove_prefix(chunk.size);
    return chunk.payload;
}

/// Of a bag.
std::string text_of(const std::vector<double>& opening) {
    if (opening.empty()) {
        return "a circle";
    }
    const auto [least, most] = std::minmax_element(opening.begin(), opening.end());
    char text[64];
    std::snprintf(text, sizeof text, "torn, %.2f to %.2f mm from the axis", *least, *most);
    return text;
}

/// The microscope stands beside the eye: a state fits a scene with it and one without.
std::vector<std::string> without_microscope(std::vector<std::string> instruments) {
    std::erase(instruments, microscope_name);
    return instruments;
}

Status check_same_scene(const PreparedState& state, const SceneDescription& here, const Snapshot& fresh) {
    const SceneDescription& there = state.made.scene;
    SceneDifferences differences;
    differences.add("patient.age", there.patient.age, here.patient.age);
    differences.add("patient.nuclear_grade", there.patient.nuclear_grade, here.patient.nuclear_grade);
    differences.add("patient.cortical_opacity", there.patient.cortical_opacity, here.patient.cortical_opacity);
    differences.add("patient.pupil_mm", there.patient.pupil_mm, here.patient.pupil_mm);
    differences.add("patient.side", there.patient.side, here.patient.side);
    differences.add("patient.tetrahedra", there.patient.tetrahedra, here.patient.tetrahedra);
    differences.add("tissues", there.tissues, here.tissues);
    differences.add("instruments", without_microscope(there.instruments), without_microscope(here.instruments));
    differences.add("step_s", there.step_s, here.step_s);
    if (there.opening != here.opening) {
        const std::string torn = text_of(there.opening);
        const bool alike = torn == text_of(here.opening);
        differences.add("opening", torn, alike ? "another" : text_of(here.opening));
    }
    differences.add_settings(state.snapshot.settings, fresh.settings,
                             [](const SettingInfo& info) { return !info.name.starts_with("microscope."); });
    return differences.text().empty()
               ? success()
               : Status(Error{"the state was made for another scene: " + differences.text(), "", ""});
}

}  // namespace

Status write_state(const std::string& path, const PreparedState& state) {
    return write_file(path, first_line(state_file) + make_chunk(ChunkKind::header, encode(state.made)) +
                                make_chunk(ChunkKind::checkpoint, encode(state.snapshot)) +
                                make_chunk(ChunkKind::end, ""));
}

Result<PreparedState> read_state(const std::string& path) {
    const Result<std::string> content = read_text_file(path, largest_state);
    if (!content) {
        return content.error();
    }
    std::string_view bytes = content.value();
    const Status kind = check_first_line(state_file, bytes, path);
    if (!kind) {
        return kind.error();
    }
    bytes.remove_prefix(first_line(state_file).size());
    std::string_view payloads[3];
    const ChunkKind kinds[3] = {ChunkKind::header, ChunkKind::checkpoint, ChunkKind::end};
    for (int i = 0; i < 3; ++i) {
        const Result<std::string_view> payload = take_chunk(bytes, kinds[i], path);
        if (!payload) {
            return payload.error();
        }
        payloads[i] = payload.value();
    }
    std::optional<RecordingHeader> header = decode_header(payloads[0]);
    std::optional<Snapshot> snapshot = decode_snapshot(payloads[1]);
    if (!header || !snapshot || !bytes.empty()) {
        // the checksums hold, so these bytes were meant: by a program that keeps other things
        return Error{"the state holds something else than this program keeps", path, "make it again"};
    }
    return PreparedState{std::move(*header), std::move(*snapshot)};
}

Status start_from(Session& session, const PreparedState& state) {
    if (is_folded_implant(state)) {
        const Result<Snapshot> start = with_folded_implant(session, state);
        return start ? session.restore(start.value()) : start.error();
    }
    const Snapshot fresh = session.copy_state();
    Status same = check_same_scene(state, session.scene(), fresh);
    if (!same) {
        return same;
    }
    Snapshot start = state.snapshot;
    start.tools = fresh.tools;
    start.settings = fresh.settings;
    start.observer_memory = fresh.observer_memory;
    start.step = fresh.step;
    start.world.time_s = fresh.world.time_s;
    start.world.microscope = fresh.world.microscope;
    return session.restore(start);
}

Result<Session> create_session(const SceneDescription& scene, std::uint64_t seed, const std::string& state) {
    if (state.empty()) {
        return Session::create(scene, seed);
    }
    // what is wrong with the scene comes before what is wrong with the state
    Result<Session> session = Session::create(scene, seed);
    const Result<PreparedState> read = session ? read_state(state) : session.error();
    if (!read) {
        return read.error();
    }
    const SceneDescription& made = read.value().made.scene;
    if (scene.opening.empty() && !made.opening.empty()) {
        SceneDescription torn = scene;
        torn.opening = made.opening;
        session = Session::create(torn, seed);
    }
    const Status started = session ? start_from(session.value(), read.value()) : session.error();
    if (!started) {
        return Error{started.error().what, state, started.error().allowed};
    }
    return session;
}

}  // namespace rhexis
