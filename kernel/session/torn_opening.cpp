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

Result<std::vector<double>> torn_opening(const Session& session) {
    const std::vector<MembraneModel>& membranes = session.world().membranes;
    const auto capsule = std::find_if(membranes.begin(), membranes.end(),
                                      [](const MembraneModel& model) { return model.name == anterior_capsule_name; });
    if (capsule == membranes.end()) {
        return Error{"it holds no anterior capsule", "", "a run of an exercise with the tissue anterior_capsule"};
    }
    const std::size_t number = static_cast<std::size_t>(capsule - membranes.begin());
    Result<std::vector<double>> radii = opening_radii(*capsule, session.state().membranes[number]);
    if (radii) {
        if (Status fits = check_opening(radii.value()); !fits) {
            return Error{fits.error().what, "", fits.error().allowed};
        }
    }
    return radii;
}

Result<std::vector<double>> read_torn_opening(const std::string& path) {
    const bool recorded = begins_as(recording_file, path);
    if (!recorded && !begins_as(state_file, path) && std::ifstream(path, std::ios::binary).get() != EOF) {
        return Error{"this is neither a state nor a recording", path, "a file written by rhexis run (.rhxs, .rhx)"};
    }
    const Result<Session> session = recorded ? session_of_recording(path) : session_of_state(path);
    Result<std::vector<double>> radii = session ? torn_opening(session.value()) : session.error();
    if (!radii && radii.error().where != path) {
        const std::string where = radii.error().where.empty() ? path : path + ": " + radii.error().where;
        return Error{radii.error().what, where, radii.error().allowed};
    }
    return radii;
}

}  // namespace rhexis
