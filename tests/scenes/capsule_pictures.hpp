// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of an anterior capsule: whole, with a flap folded over, with a disc torn away. By geometry alone.
#pragma once

#include <algorithm>
#include <vector>

#include "eye/anatomy.hpp"
#include "eye/anterior_capsule.hpp"
#include "scenes/pictures.hpp"

namespace rhexis::testing {

inline constexpr double torn_radius = 2.5;  ///< of what is torn in these pictures [mm]

/// An eye whose lens is no solid, the instruments of a capsulorhexis withdrawn.
inline Frame capsule_frame(double grade = 3.0, double trypan_blue = 0.0) {
    Patient patient;
    patient.nuclear_grade = grade;
    patient.tetrahedra = 500;
    const EyeModel eye = make_eye(patient).value();
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>();
    model->membranes = {make_anterior_capsule(lens_shape(patient), eye.bag, patient.age, {})};
    model->tools = {make_tool("forceps").value()};
    Frame frame = frame_of(std::shared_ptr<const WorldModel>(std::move(model)));
    frame.membranes = rest_state(*frame.model).membranes;
    std::shared_ptr<EyeAnatomy> anatomy = std::make_shared<EyeAnatomy>(eye.anatomy);
    anatomy->trypan_blue = trypan_blue;
    frame.eye = std::move(anatomy);
    return frame;
}

/// The same eye, all of its capsule taken away.
inline Frame without_capsule(Frame frame) {
    std::shared_ptr<MembraneSheet> none = std::make_shared<MembraneSheet>();
    MembraneState& state = frame.membranes[0];
    state.sheet = std::move(none);
    state.position.clear();
    state.velocity.clear();
    return frame;
}

inline void replace_mesh(TriMesh mesh, MembraneState& state) {
    std::shared_ptr<MembraneSheet> sheet = std::make_shared<MembraneSheet>();
    sheet->neighbours = tri_neighbours(mesh);
    sheet->mesh = std::move(mesh);
    state.sheet = std::move(sheet);
}

/// Takes a disc out of the middle.
inline void tear_disc_away(MembraneState& state) {
    TriMesh mesh = state.sheet->mesh;
    std::erase_if(mesh.triangles, [&](const std::array<int, 3>& t) {
        const Vec3 middle = (mesh.nodes[t[0]] + mesh.nodes[t[1]] + mesh.nodes[t[2]]) / 3.0;
        return middle.head<2>().norm() < torn_radius;
    });
    replace_mesh(std::move(mesh), state);
}

/// Where the flap is folded: across x = fold_line; it lay at larger x and lies over what is left of it.
inline constexpr double fold_line = 0.7;

/// Folds over what a tear along the arc of torn_radius, right of the fold, sets free.
inline void fold_flap(MembraneState& state) {
    TriMesh mesh = state.sheet->mesh;
    const std::vector<Vec3> rest = mesh.nodes;
    std::vector<int> copy(rest.size(), -1);
    std::vector<char> shared(rest.size(), 0);
    std::vector<char> in_flap;
    for (const std::array<int, 3>& t : mesh.triangles) {
        const Vec3 middle = (rest[t[0]] + rest[t[1]] + rest[t[2]]) / 3.0;
        in_flap.push_back(middle.x() > fold_line && middle.head<2>().norm() < torn_radius ? 1 : 0);
        for (int node : t) {
            shared[node] = static_cast<char>(shared[node] | (in_flap.back() != 0 ? 1 : 2));
        }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int& node : mesh.triangles[t]) {
            const bool torn = shared[node] == 3 && rest[node].x() > fold_line + 0.2;
            if (in_flap[t] == 0 || !torn) {
                continue;
            }
            if (copy[node] < 0) {
                copy[node] = static_cast<int>(mesh.nodes.size());
                mesh.nodes.push_back(rest[node]);
                state.position.push_back(state.position[node]);
                state.velocity.emplace_back(Vec3::Zero());
            }
            node = copy[node];
        }
    }
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        if (n < rest.size() && shared[n] != 1) {
            continue;
        }
        Vec3& place = state.position[n];
        place.x() = 2.0 * fold_line - place.x();
        place.z() += 0.05 + 0.12 * place.x() * 0.2;
    }
    replace_mesh(std::move(mesh), state);
}

}  // namespace rhexis::testing
