// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/torn_opening.hpp"

#include <algorithm>
#include <fstream>

#include "base/index.hpp"
#include "eye/empty_bag.hpp"
#include "observe/opening_radii.hpp"
#include "session/chunk.hpp"
#include "session/prepared_state.hpp"
#include "session/replay.hpp"

namespace rhexis {
namespace {

/// Whether a file begins as a kind of them does, whatever its version.
bool begins_as(const ChunkFile& kind, const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    std::string begin(kind.family.size(), '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    return stream.good() && begin == kind.family;
}

Error at_path(const std::string& path, const Error& error) {
    if (error.where == path) {
        return error;
    }
    return {error.what, error.where.empty() ? path : path + ": " + error.where, error.allowed};
}

Result<Session> session_of_state(const std::string& path) {
    const Result<PreparedState> state = read_state(path);
    if (!state) {
        return state.error();
    }
    Result<Session> session = Session::create(state.value().made.scene, state.value().made.seed);
    if (session) {
        if (Status restored = session.value().restore(state.value().snapshot); !restored) {
            return restored.error();
        }
    }
    return session;
}

Result<Session> session_of_recording(const std::string& path) {
    const Result<Recording> recording = read_recording(path);
    if (!recording) {
        return recording.error();
    }
    if (recording.value().fault.starts_with("damaged")) {
        return Error{"the recording is " + recording.value().fault, path, ""};
    }
    return session_at(recording.value(), recording.value().steps.size());
}

}  // namespace

Result<TornOpening> torn_opening(const Session& session) {
    const std::vector<MembraneModel>& membranes = session.world().membranes;
    const auto capsule = std::find_if(membranes.begin(), membranes.end(),
                                      [](const MembraneModel& model) { return model.name == anterior_capsule_name; });
    if (capsule == membranes.end()) {
        return Error{"it holds no anterior capsule", "", "a run of an exercise with the tissue anterior_capsule"};
    }
    const std::size_t number = static_cast<std::size_t>(capsule - membranes.begin());
    const Result<std::vector<double>> radii = opening_radii(*capsule, session.state().membranes[number]);
    if (!radii) {
        return TornOpening{{}, radii.error()};
    }
    const Status fits = check_opening(radii.value());
    return fits ? TornOpening{radii.value(), {}} : TornOpening{{}, Error{fits.error().what, "", fits.error().allowed}};
}

Result<TornOpening> read_torn_opening(const std::string& path) {
    const bool recorded = begins_as(recording_file, path);
    if (!recorded && !begins_as(state_file, path) && std::ifstream(path, std::ios::binary).get() != EOF) {
        return Error{"this is neither a state nor a recording", path, "a file written by rhexis run (.rhxs, .rhx)"};
    }
    const Result<Session> session = recorded ? session_of_recording(path) : session_of_state(path);
    Result<TornOpening> torn = session ? torn_opening(session.value()) : session.error();
    if (!torn) {
        return at_path(path, torn.error());
    }
    if (torn.value().unfit) {
        torn.value().unfit = at_path(path, *torn.value().unfit);
    }
    return torn;
}

}  // namespace rhexis
