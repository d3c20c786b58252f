// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/crack.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/adjacency.hpp"

namespace rhexis {

namespace {

constexpr double least_force = 1000.0;  ///< of tools on the solid, below which nothing is looked at [uN]
constexpr std::size_t most_faces = 8;   ///< that break in a step

double tool_force(const ContactSet& contacts, int solid) {
    double sum = 0.0;
    for (const Contact& contact : contacts) {
        if (contact.solid == solid && contact.partner == ContactPartner::tool) {
            sum += contact.force.norm();
        }
    }
    return sum;
}

TetPoints points_of(const std::vector<Vec3>& nodes, const std::array<int, 4>& tet) {
    return {nodes[tet[0]], nodes[tet[1]], nodes[tet[2]], nodes[tet[3]]};
}

bool share_node(const std::array<int, 3>& a, const std::array<int, 3>& b) {
    return std::any_of(a.begin(), a.end(), [&](int node) { return std::find(b.begin(), b.end(), node) != b.end(); });
}

}  // namespace

CrackFinder::CrackFinder(const SolidModel& model) {
    tough_ = std::any_of(model.materials.begin(), model.materials.end(),
                         [](const Material& material) { return material.toughness > 0.0; });
    if (!tough_) {
        return;
    }
    for (const std::array<int, 4>& tet : model.coarse.tets) {
        rest_.push_back(rest_tet(points_of(model.coarse.nodes, tet)));
    }
    const std::vector<std::array<int, 4>> neighbours = face_neighbours(model.coarse.tets);
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t) {
        for (std::size_t k = 0; k < 4; ++k) {
            const int other = neighbours[t][k];
            if (other <= t) {
                continue;
            }
            const std::array<int, 4>& tet = model.coarse.tets[t];
            Face face;
            face.tets = {t, other};
            face.nodes = {tet[tet_faces[k][0]], tet[tet_faces[k][1]], tet[tet_faces[k][2]]};
            const std::vector<Vec3>& x = model.coarse.nodes;
            const Vec3 area = (x[face.nodes[1]] - x[face.nodes[0]]).cross(x[face.nodes[2]] - x[face.nodes[0]]);
            face.normal = area.normalized();
            face.height = 3.0 * (rest_[t].volume + rest_[other].volume) / area.norm();
            faces_.push_back(face);
        }
    }
    std::sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) { return a.tets < b.tets; });
}

void CrackFinder::find_stress(const SolidModel& model, const SolidState& state) {
    const std::size_t tets = model.coarse.tets.size();
    shear_.assign(tets, Mat3::Zero());
    theta_.assign(tets, 0.0);
    mean_.assign(model.coarse.nodes.size(), 0.0);
    std::vector<double> volume(model.coarse.nodes.size(), 0.0);
    for (std::size_t t = 0; t < tets; ++t) {
        if (state.present[t] == 0) {
            continue;
        }
        const std::array<int, 4>& tet = model.coarse.tets[t];
        const Material& material = model.materials[model.coarse.region[t]];
        const CorotationalPoint point = corotational_point(tet_gradient(rest_[t], points_of(state.position, tet)));
        const Mat3 stretch = point.rotation.transpose() * point.gradient;
        shear_[t] = lame(material.young_modulus, material.poisson_ratio).mu *
                    (stretch + stretch.transpose() - 2.0 * Mat3::Identity());
        theta_[t] = point.trace - 3.0;
        for (const int node : tet) {
            mean_[node] += rest_[t].volume * theta_[t];
            volume[node] += rest_[t].volume;
        }
    }
    for (std::size_t n = 0; n < mean_.size(); ++n) {
        mean_[n] = volume[n] > 0.0 ? mean_[n] / volume[n] : 0.0;
    }
    for (std::size_t t = 0; t < tets; ++t) {
        const std::array<int, 4>& tet = model.coarse.tets[t];
        theta_[t] = 0.25 * (mean_[tet[0]] + mean_[tet[1]] + mean_[tet[2]] + mean_[tet[3]]);
    }
}

/// Tetrahedra that a tool presses on, those that have the whole edge or the node that it touches: the mesh does not
/// resolve the stress beside a point.
void CrackFinder::mark_touched(const SolidModel& model, const ContactSet& contacts, int solid) {
    touched_.assign(model.coarse.tets.size(), 0);
    std::vector<std::array<int, 2>> pressed;
    std::vector<char> node_pressed(model.coarse.nodes.size(), 0);
    for (const Contact& contact : contacts) {
        if (contact.solid == solid && contact.partner == ContactPartner::tool) {
            pressed.push_back({contact.nodes[0], contact.nodes[1] < 0 ? contact.nodes[0] : contact.nodes[1]});
            node_pressed[pressed.back()[0]] = node_pressed[pressed.back()[1]] = 1;
        }
    }
    const auto has = [](const std::array<int, 4>& tet, int node) {
        return std::find(tet.begin(), tet.end(), node) != tet.end();
    };
    for (std::size_t t = 0; t < touched_.size(); ++t) {
        const std::array<int, 4>& tet = model.coarse.tets[t];
        if (std::none_of(tet.begin(), tet.end(), [&](int node) { return node_pressed[node] != 0; })) {
            continue;
        }
        touched_[t] =
            std::any_of(pressed.begin(), pressed.end(),
                        [&](const std::array<int, 2>& nodes) { return has(tet, nodes[0]) && has(tet, nodes[1]); })
                ? 1
                : 0;
    }
}

void CrackFinder::look(const SolidModel& model, const SolidState& state, const ContactSurface& surface,
                       const ContactSet& contacts, int solid) {
    find_stress(model, state);
    mark_touched(model, contacts, solid);
    open_.assign(model.coarse.nodes.size(), 0);
    for (const SurfaceVertex& vertex : surface.vertices()) {
        if (vertex.nodes[1] < 0) {
            open_[vertex.nodes[0]] = 1;
        }
    }
    ratios_.assign(faces_.size(), 0.0);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (std::binary_search(state.broken.begin(), state.broken.end(), faces_[f].tets)) {
            for (const int node : faces_[f].nodes) {
                open_[node] = 1;
            }
        }
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        const Face& face = faces_[f];
        const int open = open_[face.nodes[0]] + open_[face.nodes[1]] + open_[face.nodes[2]];
        const auto [a, b] = face.tets;
        if (open < 2 || touched_[a] != 0 || touched_[b] != 0 || state.present[a] == 0 || state.present[b] == 0 ||
            std::binary_search(state.broken.begin(), state.broken.end(), face.tets)) {
            continue;
        }
        const Material& first = model.materials[model.coarse.region[a]];
        const Material& second = model.materials[model.coarse.region[b]];
        const double toughness = std::min(first.toughness, second.toughness);
        if (!(toughness > 0.0)) {
            continue;
        }
        const double share = rest_[a].volume / (rest_[a].volume + rest_[b].volume);
        const auto tension = [&](int t, const Material& material) {
            return face.normal.dot(shear_[t] * face.normal) +
                   lame(material.young_modulus, material.poisson_ratio).lambda * theta_[t];
        };
        const double pull = share * tension(a, first) + (1.0 - share) * tension(b, second);
        const double modulus = std::min(first.young_modulus, second.young_modulus);
        ratios_[f] = pull > 0.0 ? crack_factor * pull * pull * face.height / (2.0 * modulus * toughness) : 0.0;
    }
}

void CrackFinder::find(const SolidModel& model, const SolidState& state, const ContactSurface& surface,
                       const ContactSet& contacts, int solid, std::vector<BrokenFace>& broken) {
    broken.clear();
    if (!tough_ || tool_force(contacts, solid) < least_force) {
        return;
    }
    look(model, state, surface, contacts, solid);
    std::vector<int> order;
    for (std::size_t f = 0; f < ratios_.size(); ++f) {
        if (ratios_[f] > 1.0) {
            order.push_back(static_cast<int>(f));
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return ratios_[a] > ratios_[b]; });
    std::vector<int> taken;
    for (const int f : order) {
        const bool beside = std::any_of(taken.begin(), taken.end(),
                                        [&](int other) { return share_node(faces_[f].nodes, faces_[other].nodes); });
        if (!beside && taken.size() < most_faces) {
            taken.push_back(f);
            broken.push_back(faces_[f].tets);
        }
    }
    std::sort(broken.begin(), broken.end());
}

}  // namespace rhexis
