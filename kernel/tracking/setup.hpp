// SPDX-License-Identifier: GPL-3.0-or-later
// All that a tracking computer is told in one file: cameras, bodies, where images come from, who may hear.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tracking/calibration/board.hpp"
#include "tracking/sources/capture_source.hpp"
#include "tracking/sources/folder_source.hpp"
#include "tracking/sources/spot_source.hpp"
#include "tracking/tracker.hpp"

namespace rhexis::tracking {

/// Cameras that are not there: a rig drawn by seed, before which a clip is played.
struct SyntheticPlan {
    std::uint64_t seed = 1;
    std::string clip = "tremor";
    bool images = true;    ///< else spots straight from the markers
    double seconds = 0.0;  ///< 0: the clip's own time, over and over
    double rate_hz = 120.0;
};

using SourcePlan = std::variant<SyntheticPlan, FolderPlan, CapturePlan>;

struct ServePlan {
    std::string address = "127.0.0.1";
    int vrpn_port = 3883;  ///< -1: not at all
    int igtl_port = -1;    ///< likewise; OpenIGTLink's own is 18944
};

struct Setup {
    std::string path{};      ///< of the file
    std::string rig_path{};  ///< "" where the rig is the synthetic one's, as its builder took it to be
    Rig rig{};
    std::vector<MarkerBody> bodies{};
    std::vector<std::string> body_paths{};  ///< of their files
    std::optional<int> head{};              ///< index of the body on the mannequin's head
    SourcePlan source{};
    std::vector<double> wand_mm{};  ///< where the spheres of the calibration's wand lie along it
    double wand_radius_mm = 3.0;    ///< of these spheres
    SpotSettings spots{};
    ServePlan serve{};
    std::string inputs{};  ///< address of a VRPN server with jaws, pedal and staff; empty: none
};

/// A JSON file; paths in it are relative to it:
/// {"rig": "rig.json", "bodies": ["head.json", ...], "head": "head", "threshold": 60, "wand_mm": [0, 80, 200],
///  "wand_radius_mm": 3, "source": {"kind": "synthetic", "seed": 1, "clip": "tremor", "level": "images"}
///         or {"kind": "folder", "path": "shots", "rate_hz": 120}
///         or {"kind": "cameras", "devices": ["0", "1", ...], "rate_hz": 120},
///  "serve": {"address": "127.0.0.1", "vrpn": 3883, "igtl": 18944, "others_may_hear": false},
///  "inputs": {"vrpn": "192.168.1.8"}}
/// The error names file and field: no such file, bodies too alike, no head among them, an address of other computers
/// without "others_may_hear".
Result<Setup> read_setup(const std::string& path);

/// Spots from the setup's source, from its beginning. A clip of a synthetic one shows the first six instruments.
Result<std::unique_ptr<SpotSource>> open_source(const Setup& setup);

/// Spots of a waved wand: the synthetic rig waves one; of other sources it is what they show.
Result<std::unique_ptr<SpotSource>> open_wand(const Setup& setup);

/// Images of a board: before each camera of the synthetic rig it is held so often; of other sources they are what they
/// show.
Result<std::unique_ptr<FrameSource>> open_boards(const Setup& setup, const GridPlan& board, int views);

}  // namespace rhexis::tracking
