// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line asks of the shared object with cameras and calibration, which only its commands load.
#pragma once

#include <string>

#include "base/result.hpp"

namespace rhexis::tracking {

/// rhexis track CONFIG
struct TrackOptions {
    std::string setup;               ///< file
    double seconds = 0.0;            ///< so long; 0: until it is ended, or there are no more images
    bool json = false;               ///< each set of poses as a line on standard output
    bool silent = false;             ///< tells nobody over the network
    bool as_fast_as_can_be = false;  ///< a synthetic rig, or a folder of images, does not keep to the clock
    std::string picture;             ///< PNG file for what the cameras saw in the end, with what was made of it
};

/// rhexis track calibrate CONFIG
struct CalibrateOptions {
    std::string setup;
    double seconds = 30.0;  ///< of the wand
    bool refine_lenses = false;
    std::string rig;   ///< file for the result; empty: the setup's own
    std::string page;  ///< HTML file; empty: calibration.html beside the rig
};

/// rhexis track pivot CONFIG BODY
struct PivotOptions {
    std::string setup;
    std::string body;
    double seconds = 10.0;
};

inline constexpr const char* track_entry_name = "rhexis_tracking_track";
using TrackEntry = void(const TrackOptions& options, Status& status);
inline constexpr const char* calibrate_entry_name = "rhexis_tracking_calibrate";
using CalibrateEntry = void(const CalibrateOptions& options, Status& status);
inline constexpr const char* pivot_entry_name = "rhexis_tracking_pivot";
using PivotEntry = void(const PivotOptions& options, Status& status);
/// A folder with a setup, the rig as a builder would write it, and bodies, to begin with.
inline constexpr const char* begin_entry_name = "rhexis_tracking_begin";
using BeginEntry = void(const std::string& folder, Status& status);
/// A body's posts and ring as an STL file.
inline constexpr const char* print_entry_name = "rhexis_tracking_print";
using PrintEntry = void(const std::string& body, const std::string& stl, Status& status);

}  // namespace rhexis::tracking
