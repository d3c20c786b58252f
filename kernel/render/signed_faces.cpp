// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/signed_faces.hpp"

#include "mesh/adjacency.hpp"

namespace rhexis {

namespace {

/// One level of a solid's mesh, fine where there is one.
struct FaceLevel {
    const std::vector<std::array<int, 4>>& tets;
    const std::vector<std::array<int, 4>>& neighbours;
    const std::vector<Vec3>& nodes;
    int children;  ///< tetrahedra per coarse one
};

double share_left(const SolidState& state, const FaceLevel& level, int t) {
    return level.children == 8 ? state.fraction[t] : static_cast<double>(state.present[t]);
}

void append_face(const FaceLevel& level, int t, int k, const Vec3& change, FaceStream& stream) {
    SignedFace face;
    for (int i = 0; i < 3; ++i) {
        face.corners[i] = level.nodes[level.tets[t][tet_faces[k][i]]];
        if (!face.corners[i].allFinite()) {
            return;
        }
    }
    face.change = change.cast<float>();
    stream.push_back(face);
}

void append_changes(const SolidModel& model, const SolidState& state, const FaceLevel& level, FaceStream& stream) {
    const std::vector<int>& region = model.coarse.region;
    const int count = static_cast<int>(level.tets.size());
    for (int t = 0; t < count; ++t) {
        const double share = share_left(state, level, t);
        const int tissue = region[t / level.children];
        for (int k = 0; k < 4; ++k) {
            const int other = level.neighbours[t][k];
            if (other >= 0 && other < t) {
                continue;
            }
            const double share_beyond = other < 0 ? 0.0 : share_left(state, level, other);
            const int tissue_beyond = other < 0 ? tissue : region[other / level.children];
            if (share == share_beyond && tissue == tissue_beyond) {
                continue;
            }
            const Vec3 change =
                share * model.materials[tissue].extinction - share_beyond * model.materials[tissue_beyond].extinction;
            if (!change.isZero(0.0)) {
                append_face(level, t, k, change, stream);
            }
        }
    }
}

}  // namespace

void append_signed_faces(const SolidModel& model, const SolidState& state, std::vector<Vec3>& fine,
                         FaceStream& stream) {
    if (model.fine.tets.empty()) {
        const std::vector<std::array<int, 4>> neighbours = face_neighbours(model.coarse.tets);
        append_changes(model, state, {model.coarse.tets, neighbours, state.position, 1}, stream);
        return;
    }
    fine_positions(model.fine, state.position, fine);
    append_changes(model, state, {model.fine.tets, model.fine.neighbours, fine, 8}, stream);
}

std::vector<Vec3> coarse_extinction(const SolidModel& model) {
    std::vector<Vec3> result;
    result.reserve(model.coarse.tets.size());
    for (int region : model.coarse.region) {
        result.push_back(model.materials[region].extinction);
    }
    return result;
}

}  // namespace rhexis
