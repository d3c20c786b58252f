// SPDX-License-Identifier: GPL-3.0-or-later
// What a surgeon must notice (docs/picture.md), each as two frames: with it and without.
#pragma once

#include <memory>
#include <vector>

#include "flow/hydrodissection.hpp"
#include "scenes/capsule_pictures.hpp"
#include "scenes/pictures.hpp"

namespace rhexis::testing {

struct Sign {
    const char* name;
    Frame with;
    Frame without;
    double height;           ///< where a surgeon focuses who looks for it, over the lens's equator [mm]
    double contrast_before;  ///< of the picture that was lit evenly and had no film: less must not be left
};

/// The wave of hydrodissection half way under the lens.
inline Frame with_wave(const Frame& frame) {
    Frame made = frame;
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>(*frame.model);
    model->hydrodissection.emplace();
    HydrodissectionState state;
    const BagCells& cells = model->hydrodissection->cells;
    for (int sector = 0; sector < cells.sectors; ++sector) {
        for (int ring = 0; ring < cells.rings; ++ring) {
            state.cleaved.push_back(sector < cells.sectors / 2 ? 1.0 : 0.0);
        }
    }
    made.model = std::move(model);
    made.hydrodissection = std::move(state);
    return made;
}

inline std::vector<Sign> signs() {
    const Frame whole = patient_frame(3.0, 7.5, 1500);
    std::vector<Sign> list;
    Frame trench = whole;
    carve_groove(trench.model->solids[0], trench.solids[0], 0.62, -2.2, 2.2, 0.3);
    list.push_back({"trench", trench, whole, 0.3, 0.0616});
    Frame crack = trench;
    carve_groove(crack.model->solids[0], crack.solids[0], 0.16, -2.6, 2.6, -2.2);
    list.push_back({"crack", crack, trench, -2.2, 0.0614});
    Frame bare = whole;  // what a trench and a crack have gone through: the back of the bag shows
    carve_groove(bare.model->solids[0], bare.solids[0], 2.0, -2.2, 2.2, -2.6);
    Frame folds = bare;
    folds.capsule.emplace();
    folds.capsule->captured = true;
    folds.capsule->place = Vec3(0.4, 0.3, -2.3);
    list.push_back({"folds", folds, bare, -2.3, 0.0595});
    Frame hole = bare;
    hole.capsule.emplace();
    hole.capsule->hole_radius = 0.8;
    hole.capsule->hole_place = Vec3(0.4, 0.3, -2.3);
    list.push_back({"hole", hole, bare, -2.3, 0.0966});
    list.push_back({"wave", with_wave(whole), whole, -1.5, 0.1339});
    const Frame capsule = capsule_frame();
    Frame flap = capsule;
    fold_flap(flap.membranes[0]);
    list.push_back({"flap's edge", flap, capsule, 2.3, 0.1325});
    Frame crumb = whole;
    Debris debris;
    debris.position = Vec3(1.2, -0.8, 2.6);
    debris.volume = 0.1;
    crumb.debris = {debris};
    list.push_back({"crumb", crumb, whole, 2.6, 0.0494});
    return list;
}

}  // namespace rhexis::testing
