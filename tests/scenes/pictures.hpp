// SPDX-License-Identifier: GPL-3.0-or-later
// Frames to draw, for tests and benchmarks of the picture.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>

#include "eye/make_eye.hpp"
#include "flow/frame.hpp"
#include "mesh/shapes.hpp"
#include "render/renderer.hpp"
#include "tools/instruments.hpp"

namespace rhexis::testing {

/// Tip at `tip`, shaft towards the surgeon (-y) and up by `elevation` [rad]; the bevel looks up.
inline Pose hand_pose(const Vec3& tip, double elevation) {
    Pose pose;
    pose.position = tip;
    const double turn = 0.5 * std::numbers::pi - elevation;
    pose.orientation = Quat(Eigen::AngleAxisd(turn, Vec3::UnitX()));
    return pose;
}

/// A frame at rest of a model; tools withdrawn.
inline Frame frame_of(std::shared_ptr<const WorldModel> model) {
    Frame frame;
    const WorldState rest = rest_state(*model);
    frame.solids = rest.solids;
    frame.bags = rest.bags;
    frame.tools.resize(model->tools.size());
    frame.model = std::move(model);
    return frame;
}

inline Frame frame_of(const EyeModel& eye) {
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>();
    model->solids = {eye.lens};
    model->bags = {eye.bag};
    model->tools = {make_tool("phaco").value()};
    Frame frame = frame_of(std::shared_ptr<const WorldModel>(std::move(model)));
    frame.eye = std::make_shared<const EyeAnatomy>(eye.anatomy);
    return frame;
}

/// A patient of this grade at rest, the instrument withdrawn.
inline Frame patient_frame(double grade, double pupil_mm = 7.5, int tetrahedra = 3000) {
    Patient patient;
    patient.nuclear_grade = grade;
    patient.pupil_mm = pupil_mm;
    patient.tetrahedra = tetrahedra;
    return frame_of(make_eye(patient).value());
}

/// A bare frame of one body of uniform extinction; refined: with 8 children per tetrahedron.
inline Frame frame_of(TetMesh mesh, const Vec3& extinction, bool refined) {
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>();
    SolidModel solid;
    solid.name = "body";
    solid.coarse = std::move(mesh);
    solid.coarse.region.assign(solid.coarse.tets.size(), 0);
    if (refined) {
        solid.fine = subdivide(solid.coarse);
    }
    solid.materials.resize(1);
    solid.materials[0].extinction = extinction;
    model->solids.push_back(std::move(solid));
    return frame_of(std::shared_ptr<const WorldModel>(std::move(model)));
}

/// Takes out what a needle of this radius [mm] would: a trench along y from y_low to y_high, whose floor lies at z.
inline void carve_groove(const SolidModel& model, SolidState& state, double half_width, double y_low, double y_high,
                         double floor_z) {
    std::vector<Vec3> fine;
    fine_positions(model.fine, state.position, fine);
    for (std::size_t t = 0; t < model.fine.tets.size(); ++t) {
        Vec3 middle = Vec3::Zero();
        for (int node : model.fine.tets[t]) {
            middle += 0.25 * fine[node];
        }
        const double rise = floor_z + half_width - middle.z();
        const double across = rise > 0.0 ? std::hypot(middle.x(), rise) : std::abs(middle.x());
        if (across < half_width && middle.y() > y_low && middle.y() < y_high) {
            state.fraction[t] = 0.0;
        }
    }
}

/// A groove down to floor_z, and the instrument in it if asked for.
inline Frame sculpted_frame(double grade, double floor_z, bool with_tool) {
    Frame frame = patient_frame(grade);
    carve_groove(frame.model->solids[0], frame.solids[0], 0.62, -2.2, 2.2, floor_z);
    frame.tools[0].present = with_tool;
    frame.tools[0].pose = hand_pose(Vec3(0.1, 0.9, floor_z + 0.25), 0.5);
    return frame;
}

/// A whole eye in whose main wound a shaft bends the cornea so far. [mm]
inline Frame levered_frame(double deflection_mm) {
    Frame frame = patient_frame(3.0, 7.5, 1500);
    const std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>(*frame.model);
    model->globe.emplace();
    model->globe->lips[0] = frame.eye->incision;
    model->globe->widths[0] = frame.eye->incision_width;
    frame.model = model;
    frame.globe.emplace();
    frame.globe->lips[0].deflection = Vec3(0.0, -deflection_mm, 0.0);
    return frame;
}

/// The camera of a scene in which the microscope moves, over this eye's middle: with a round stop and depth of field.
inline Camera microscope_camera_through(const Frame& frame) {
    WorldModel world;
    world.microscope.emplace();
    MicroscopeState microscope;
    microscope.position = Vec3(0.0, 0.0, frame.eye->iris_z);
    return microscope_camera(*frame.eye, world, microscope);
}

}  // namespace rhexis::testing
