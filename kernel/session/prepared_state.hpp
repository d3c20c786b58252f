// SPDX-License-Identifier: GPL-3.0-or-later
// States to start from (.rhxs): a moment of one run, from which others begin. The line of session/chunk.hpp, then three
// chunks as in a recording: header, checkpoint, end.
#pragma once

#include <string>

#include "base/result.hpp"
#include "session/recording.hpp"

namespace rhexis {

struct PreparedState {
    RecordingHeader made;  ///< by which run
    Snapshot snapshot;
};

/// The file appears whole or not at all.
Status write_state(const std::string& path, const PreparedState& state);

/// Fails on a file that is no state, of another version, cut short, or damaged anywhere.
Result<PreparedState> read_state(const std::string& path);

/// Puts a session that has not begun into the state: tissues as they were then; instruments outside the eye, because no
/// hand holds them yet; clock and counters of the measures at zero; settings of the machine as the session has them.
/// Fails, naming all differences, when the session was built for another patient, other tissues, instruments or step,
/// or for fixed settings of other values. A folded implant is only laid into the session's injector: folded_start.hpp.
Status start_from(Session& session, const PreparedState& state);

/// A session that begins in the state of a file; at rest if the path is empty. Where the scene gives no opening of its
/// bag, it is that of the state.
Result<Session> create_session(const SceneDescription& scene, std::uint64_t seed, const std::string& state);

}  // namespace rhexis
