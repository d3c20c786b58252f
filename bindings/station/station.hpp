// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line asks of the station, which it loads when it is wanted.
#pragma once

#include <string>

#include "base/result.hpp"
#include "render/renderer.hpp"
#include "trial/attempt.hpp"

namespace rhexis::station {

struct StationOptions {
    AttemptOptions attempt;
    std::string mapping;  ///< file; empty: the standard one
    std::string events;   ///< file: done again if it is there, else written; empty: neither
    nlohmann::json begun_with =
        nlohmann::json::object();  ///< for that file: "start", "opening", "limit_s" as asked for
    bool again = false;            ///< `events` is done again, step by step
    std::string ghost;             ///< run or recording whose way is shown on request; empty: none
    std::string by;                ///< virtual surgeon who works the devices in a person's place; empty: a person does
    bool pad = false;              ///< with pad and pedal, not with mouse and keys
    bool tracked = false;          ///< with instruments that a tracking system sees
    std::string tracked_at;        ///< its address, "vrpn://HOST"; empty: what it told is in `events`
    std::string registration;      ///< file, see read_registration(); empty: its frame is that of the eye
    bool live = false;             ///< that surgeon keeps to the wall clock
    bool typed = false;            ///< and what it does goes through the X server
    int width = 1280;              ///< of the window [pixels]
    int height = 960;
    bool full_screen = false;
    Stereo stereo = Stereo::off;
    std::string screenshot;  ///< file for what the window shows in the end; empty: none
    int picture_every = 4;   ///< steps, where events are done again
    bool warns = false;      ///< of what is about to go wrong, from the beginning
    bool silent = false;     ///< no sound
    std::string theatre;     ///< address that a monitor looks at; empty: none does
};

/// The one function that the shared object shows.
inline constexpr const char* entry_name = "rhexis_station_train";
using Entry = void(const StationOptions& options, Result<AttemptResult>& result);

/// What the command line asks of a theatre's monitor.
struct MonitorOptions {
    std::string root;        ///< folder of scripts/
    std::string language;    ///< "fr", ...; "" and "en": English
    std::string address;     ///< of the station
    std::string request;     ///< "inject cough", "note ...": asked for, without a window; empty: none
    bool json = false;       ///< each moment as a line on standard output, without a window
    double seconds = 0.0;    ///< so long; 0: until it is closed
    bool once = false;       ///< until the attempt has ended
    std::string screenshot;  ///< PNG file for what the window shows in the end; empty: none
    int width = 1280;        ///< of the window [pixels]
    int height = 800;
};

/// What the command line asks of a debriefing.
struct DebriefingOptions {
    std::string root;        ///< folder of scripts/
    std::string language;    ///< as above
    std::string recording;   ///< file
    std::string ghost;       ///< run or recording of an expert; empty: none
    double at_s = 0.0;       ///< where it begins
    double right_deg = 0.0;  ///< that the camera has gone round the eye
    double up_deg = 0.0;
    double seconds = 0.0;  ///< so long; 0: until it is closed
    std::string screenshot;
    int width = 1280;
    int height = 960;
    bool full_screen = false;
};

inline constexpr const char* debriefing_entry_name = "rhexis_station_debrief";
using DebriefingEntry = void(const DebriefingOptions& options, Status& status);

inline constexpr const char* monitor_entry_name = "rhexis_station_monitor";
using MonitorEntry = void(const MonitorOptions& options, Status& status);

}  // namespace rhexis::station
