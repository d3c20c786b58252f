// SPDX-License-Identifier: GPL-3.0-or-later
// A folded implant as a start: what ImplantFold makes begins any scene that has the same lens and cartridge, whatever
// else is in it.
#pragma once

#include "session/prepared_state.hpp"

namespace rhexis {

/// True when a setting decides what a folded implant is like.
bool shapes_folded_implant(std::string_view setting);

/// True of a state that holds an implant which lies in an injector, and nothing else.
bool is_folded_implant(const PreparedState& state);

/// The session as it is, with its implant in its injector as the state has it. Fails where tissue or instrument is
/// missing, and names the settings that differ.
Result<Snapshot> with_folded_implant(const Session& session, const PreparedState& state);

}  // namespace rhexis
