// SPDX-License-Identifier: GPL-3.0-or-later
// What the command line asks of the shared object with cameras and calibration, which only its commands load.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "trial/picture_screen.hpp"
#include "trial/sample_link.hpp"

namespace rhexis::tracking {

/// rhexis track CONFIG
struct TrackOptions {
    std::string setup;               ///< file
    double seconds = 0.0;            ///< so long; 0: until it is ended, or there are no more images
    bool json = false;               ///< each set of poses as a line on standard output
    bool silent = false;             ///< tells nobody over the network
    bool as_fast_as_can_be = false;  ///< a synthetic rig, or a folder of images, does not keep to the clock
    std::string keep;                ///< folder for all images, to track them again; empty: they are not kept
    std::string picture;             ///< PNG file for what the cameras saw in the end, with what was made of it
    ScreenOptions screen{};
    OpenScreen* open_screen = nullptr;  ///< window for what the cameras see; null: none
};

/// rhexis track calibrate CONFIG
struct CalibrateOptions {
    std::string setup;
    double seconds = 30.0;  ///< of the wand
    bool refine_lenses = false;
    std::string rig;   ///< file for the result; empty: the setup's own
    std::string page;  ///< HTML file; empty: calibration.html beside the rig
    ScreenOptions screen{};
    OpenScreen* open_screen = nullptr;  ///< window for where the wand was seen; null: none
};

/// rhexis track lenses CONFIG --board BOARD
struct LensesOptions {
    std::string setup;
    std::string board;       ///< as parse_board() reads it
    int views = 40;          ///< of each camera, at most
    double seconds = 300.0;  ///< for which images are looked at, at most
    std::string images;      ///< folder with a folder for each camera; empty: the setup's own source
    std::string keep;        ///< folder for all images; empty: they are not kept
    std::string rig;         ///< file for the result; empty: the setup's own
    std::string page;        ///< HTML file; empty: calibration.html beside the rig
};

/// rhexis track pivot CONFIG BODY
struct PivotOptions {
    std::string setup;
    std::string body;
    double seconds = 10.0;
};

/// rhexis run EXERCISE --through CONFIG
struct ChainOptions {
    std::string setup;
    std::string level;       ///< "images", "markers"; empty: as the setup has it
    std::uint64_t seed = 1;  ///< of noise
};

inline constexpr const char* chain_entry_name = "rhexis_tracking_chain";
using ChainEntry = void(const ChainOptions& options, Result<std::unique_ptr<SampleLink>>& link);

/// rhexis track measure
struct MeasureOptions {
    std::uint64_t first_seed = 101;
    int seeds = 1;
    int marker_seeds = 0;  ///< of what is measured without images; at least `seeds`
    double image_s = 0.5;  ///< of each clip that is rendered
    double marker_s = 4.0;
    int identity_frames = 20000;
    bool chart = true;
    int poses = 6000;           ///< told over the network, each way
    bool network_only = false;  ///< nothing but that
    bool chart_only = false;    ///< nothing but detectors, cameras and markers against compute
    bool json = false;
    std::string keep;  ///< folder for what each part of each seed gave; empty: it is not kept
};

inline constexpr const char* measure_entry_name = "rhexis_tracking_measure";
using MeasureEntry = void(const MeasureOptions& options, Status& status);
inline constexpr const char* track_entry_name = "rhexis_tracking_track";
using TrackEntry = void(const TrackOptions& options, Status& status);
inline constexpr const char* calibrate_entry_name = "rhexis_tracking_calibrate";
using CalibrateEntry = void(const CalibrateOptions& options, Status& status);
inline constexpr const char* lenses_entry_name = "rhexis_tracking_lenses";
using LensesEntry = void(const LensesOptions& options, Status& status);
inline constexpr const char* pivot_entry_name = "rhexis_tracking_pivot";
using PivotEntry = void(const PivotOptions& options, Status& status);
/// rhexis track begin FOLDER
struct BeginOptions {
    std::string folder;
    std::string exercise = "phaco_sculpt";  ///< whose instruments are tracked; an operation: those of all its parts
    std::string root;                       ///< folder that holds scripts/ and curricula/
};

inline constexpr const char* begin_entry_name = "rhexis_tracking_begin";
using BeginEntry = void(const BeginOptions& options, Status& status);

/// rhexis track design INSTRUMENT BODY
struct DesignOptions {
    std::string instrument;
    std::string body;                 ///< file to write
    std::vector<std::string> unlike;  ///< files of bodies that it is not to be taken for
    std::vector<std::string> beside;  ///< likewise, and no distance is found in them either
    double reach_mm = 26.0;           ///< of spheres from the handle's axis
    std::uint64_t seed = 1;
};

inline constexpr const char* design_entry_name = "rhexis_tracking_design";
using DesignEntry = void(const DesignOptions& options, Status& status);

/// rhexis track print BODY STL
struct PrintOptions {
    std::string body;
    std::string stl;
    bool with_shape = true;  ///< in one with the instrument's own shape; else a sleeve to be put on a real one
};

inline constexpr const char* print_entry_name = "rhexis_tracking_print";
using PrintEntry = void(const PrintOptions& options, Status& status);

}  // namespace rhexis::tracking
