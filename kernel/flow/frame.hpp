// SPDX-License-Identifier: GPL-3.0-or-later
// session -> render: an immutable picture of one moment. Render never sees the live state.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "flow/eye_model.hpp"
#include "flow/world.hpp"

namespace rhexis {

struct Frame {
    std::shared_ptr<const WorldModel> model;
    std::shared_ptr<const EyeAnatomy> eye;  ///< null: a bare scene from a script
    std::vector<SolidState> solids;
    std::vector<MembraneState> membranes;
    std::vector<ShellState> shells;
    std::vector<BagState> bags;
    std::vector<ToolState> tools;
    std::optional<CapsuleState> capsule;
    std::optional<IrisState> iris;
    std::vector<Debris> debris;
    std::optional<MicroscopeState> microscope;
    double time_s = 0.0;
    std::optional<VitreousState> vitreous{};
    std::optional<WoundsState> wounds{};
    std::optional<GlobeState> globe{};
    std::optional<ProlapseState> prolapse{};
    std::optional<HydrodissectionState> hydrodissection{};
    std::optional<CortexState> cortex{};
    std::optional<RetainedViscoelasticState> retained{};
    std::optional<LidsState> lids{};
};

/// Where the picture is taken from. Orthogonal views are not needed: a microscope is far away.
struct Camera {
    Vec3 eye = Vec3(0.0, 0.0, 200.0);  ///< [mm]
    Vec3 target = Vec3::Zero();
    Vec3 up = Vec3::UnitY();
    double field_mm = 15.0;  ///< height of the field at the target [mm]
    double stop_mm = 0.0;    ///< diameter of the round field, dark outside of it; 0: the whole picture is field [mm]
    double aperture = 0.0;   ///< half the angle of the light from a point, as a sine; 0: all is sharp
    double focus_mm = 0.0;   ///< height of what is sharp over the target, along the view [mm]
    double light = 1.0;      ///< of the lamps, times as much
    double aside_mm =
        0.0;  ///< of the camera to its right, while what lies at the target stays where it is: an eye of two
};

/// Pixels, row by row from the top, 8 bits each.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<unsigned char> rgb;  ///< 3 * width * height
};

}  // namespace rhexis
