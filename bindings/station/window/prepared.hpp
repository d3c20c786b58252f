// SPDX-License-Identifier: GPL-3.0-or-later
// What an attempt in the window is begun with: read and checked before a window opens.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lua/hold_script.hpp"
#include "station/event_source.hpp"
#include "station/ghost.hpp"
#include "station/mapping.hpp"
#include "station/station.hpp"
#include "station/window/panels.hpp"
#include "station/words.hpp"

namespace rhexis::station {

struct Prepared {
    std::string title;  ///< of the exercise
    double step_s = 0.01;
    std::vector<std::string> instruments;  ///< of the scene
    std::string mapping_file;
    Mapping mapping;
    std::vector<MappingOffer> offers;
    std::string own;                ///< where a person's mapping is kept
    std::optional<EventFile> file;  ///< to be done again
    std::optional<EventWriter> writer;
    std::optional<Ghost> ghost;
    std::optional<HoldScript> holds;  ///< always there
    Words words;
};

Result<Prepared> prepare(const StationOptions& options);

/// As reports and events call what is operated with.
std::string device_of(const StationOptions& options);

/// What comes from the devices counts: a person's, or what is typed in a person's place.
bool operates(const StationOptions& options);

/// No wall clock: each step waits for its picture, where it has one.
bool is_stepped(const StationOptions& options);

}  // namespace rhexis::station
