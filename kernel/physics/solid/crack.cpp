// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/crack.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

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

bool has(const std::array<int, 4>& tet, int node) { return std::find(tet.begin(), tet.end(), node) != tet.end(); }

/// Per node the lowest one at the same place: nodes that were split lie where they came from.
std::vector<int> first_at_place(const std::vector<Vec3>& nodes) {
    std::vector<int> order(nodes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto less = [&](int a, int b) {
        return std::lexicographical_compare(nodes[a].begin(), nodes[a].end(), nodes[b].begin(), nodes[b].end());
    };
    std::stable_sort(order.begin(), order.end(), less);
    std::vector<int> first(nodes.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && !less(order[i - 1], order[i]);
        first[order[i]] = same ? first[order[i - 1]] : order[i];
    }
    return first;
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
    first_ = first_at_place(model.coarse.nodes);
    for (std::array<int, 4> tet : model.coarse.tets) {
        for (int& node : tet) {
            node = first_[node];
        }
        together_.push_back(tet);
    }
    find_faces(model);
}

void CrackFinder::find_faces(const SolidModel& model) {
    const std::vector<std::array<int, 4>> neighbours = face_neighbours(together_);
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t) {
        for (std::size_t k = 0; k < 4; ++k) {
            const int other = neighbours[t][k];
            if (other >= 0 && other <= t) {
                continue;
            }
            CrackFace face;
            face.tets = {t, other};
            face.nodes = {together_[t][tet_faces[k][0]], together_[t][tet_faces[k][1]], together_[t][tet_faces[k][2]]};
            face.area = 3.0 * rest_[t].volume * rest_[t].gradient[k].norm();
            face.normal = -rest_[t].gradient[k].normalized();
            face.height = other < 0 ? 0.0 : 1.5 * (rest_[t].volume + rest_[other].volume) / face.area;
            faces_.push_back(face);
        }
    }
    std::sort(faces_.begin(), faces_.end(), [](const CrackFace& a, const CrackFace& b) {
        return std::pair(a.tets[1] < 0, a.tets) < std::pair(b.tets[1] < 0, b.tets);
    });
    for (const CrackFace& face : faces_) {
        const auto [t, other] = face.tets;
        int shared = 0;
        for (const int node : model.coarse.tets[t]) {
            shared += other >= 0 && has(model.coarse.tets[other], node) ? 1 : 0;
        }
        apart_.push_back(shared < 3 ? 1 : 0);
    }
}

void CrackFinder::find_states(const SolidState& state) {
    states_.assign(faces_.size(), FaceState::none);
    auto next = state.broken.begin();  // both are ascending
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        const auto [t, other] = faces_[f].tets;
        const bool here = state.present[t] != 0;
        const bool there = other >= 0 && state.present[other] != 0;
        while (other >= 0 && next != state.broken.end() && *next < faces_[f].tets) {
            ++next;
        }
        if (here && there && next != state.broken.end() && *next == faces_[f].tets) {
            states_[f] = FaceState::broken;
        } else if (here && there && apart_[f] == 0) {
            states_[f] = FaceState::whole;
        } else if (here || there) {
            states_[f] = FaceState::surface;
        }
    }
}

/// Changes of volume, averaged over the tetrahedra around each node, then over the nodes of each tetrahedron.
void CrackFinder::average_pressure(const SolidModel& model, const SolidState& state) {
    mean_.assign(model.coarse.nodes.size(), 0.0);
    std::vector<double> volume(model.coarse.nodes.size(), 0.0);
    for (std::size_t t = 0; t < rest_.size(); ++t) {
        if (state.present[t] == 0) {
            continue;
        }
        for (const int node : model.coarse.tets[t]) {
            mean_[node] += rest_[t].volume * stress_[t].strain.trace();
            volume[node] += rest_[t].volume;
        }
    }
    for (std::size_t n = 0; n < mean_.size(); ++n) {
        mean_[n] = volume[n] > 0.0 ? mean_[n] / volume[n] : 0.0;
    }
}

void CrackFinder::find_stress(const SolidModel& model, const SolidState& state) {
    stress_.resize(rest_.size());
    for (std::size_t t = 0; t < rest_.size(); ++t) {
        if (state.present[t] != 0) {
            const CorotationalPoint point =
                corotational_point(tet_gradient(rest_[t], points_of(state.position, model.coarse.tets[t])));
            stress_[t].rotation = point.rotation;
            stress_[t].strain = point.rotation.transpose() * point.gradient - Mat3::Identity();
        }
    }
    average_pressure(model, state);
    for (std::size_t t = 0; t < rest_.size(); ++t) {
        if (state.present[t] == 0) {
            continue;
        }
        const std::array<int, 4>& tet = model.coarse.tets[t];
        const Material& material = model.materials[model.coarse.region[t]];
        const Lame moduli = lame(material.young_modulus, material.poisson_ratio);
        const double swelling = 0.25 * (mean_[tet[0]] + mean_[tet[1]] + mean_[tet[2]] + mean_[tet[3]]);
        TetStress& own = stress_[t];
        const Mat3 even = (swelling - own.strain.trace()) / 3.0 * Mat3::Identity();
        const Mat3 strain = 0.5 * (own.strain + own.strain.transpose()) + even;
        own.stress = 2.0 * moduli.mu * strain + moduli.lambda * swelling * Mat3::Identity();
        own.energy = 0.5 * own.stress.cwiseProduct(strain).sum();
    }
}

/// Tetrahedra that a tool presses on, those that have the whole edge or the node that it touches: the mesh does not
/// resolve the stress beside a point.
void CrackFinder::mark_touched(const SolidModel& model, const ContactSet& contacts, int solid) {
    touched_.assign(model.coarse.tets.size(), 0);
    std::vector<std::array<int, 2>> pressed;
    pressed_.assign(model.coarse.nodes.size(), 0);
    for (const Contact& contact : contacts) {
        if (contact.solid == solid && contact.partner == ContactPartner::tool) {
            pressed.push_back({contact.nodes[0], contact.nodes[1] < 0 ? contact.nodes[0] : contact.nodes[1]});
            pressed_[first_[pressed.back()[0]]] = pressed_[first_[pressed.back()[1]]] = 1;
        }
    }
    for (std::size_t t = 0; t < touched_.size(); ++t) {
        const std::array<int, 4>& tet = model.coarse.tets[t];
        if (std::none_of(tet.begin(), tet.end(), [&](int node) { return pressed_[first_[node]] != 0; })) {
            continue;
        }
        touched_[t] =
            std::any_of(pressed.begin(), pressed.end(),
                        [&](const std::array<int, 2>& nodes) { return has(tet, nodes[0]) && has(tet, nodes[1]); })
                ? 1
                : 0;
    }
}

void CrackFinder::mark_open(const ContactSurface& surface) {
    open_.assign(first_.size(), 0);
    for (const SurfaceVertex& vertex : surface.vertices()) {
        if (vertex.nodes[1] < 0) {
            open_[first_[vertex.nodes[0]]] = 1;
        }
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        if (states_[f] == FaceState::broken) {
            for (const int node : faces_[f].nodes) {
                open_[node] = 1;
            }
        }
    }
}

double CrackFinder::tension_energy(const CrackFace& face, double modulus) const {
    const auto [a, b] = face.tets;
    const double share = rest_[a].volume / (rest_[a].volume + rest_[b].volume);
    const auto across = [&](int tet) { return face.normal.dot(stress_[tet].stress * face.normal); };
    const double tension = std::max(0.0, share * across(a) + (1.0 - share) * across(b));
    return crack_factor * tension * tension * face.height / (2.0 * modulus);
}

void CrackFinder::look(const SolidModel& model, const SolidState& state, const ContactSurface& surface,
                       const ContactSet& contacts, int solid) {
    find_stress(model, state);
    find_states(state);
    mark_touched(model, contacts, solid);
    mark_open(surface);
    front_.find(faces_, states_, state.present, first_.size());
    if (!front_.empty()) {
        front_.measure(model.coarse.nodes);
        front_.pull(together_, rest_, stress_, state.present, pressed_);
    }
    ratios_.assign(faces_.size(), 0.0);
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        const CrackFace& face = faces_[f];
        const auto [a, b] = face.tets;
        const int open = open_[face.nodes[0]] + open_[face.nodes[1]] + open_[face.nodes[2]];
        if (states_[f] != FaceState::whole || open < 2 || touched_[a] != 0 || touched_[b] != 0) {
            continue;
        }
        const Material& first = model.materials[model.coarse.region[a]];
        const Material& second = model.materials[model.coarse.region[b]];
        const double toughness = std::min(first.toughness, second.toughness);
        if (!(toughness > 0.0)) {
            continue;
        }
        const bool near_front =
            std::any_of(face.nodes.begin(), face.nodes.end(), [&](int node) { return front_.near(node); });
        const double modulus = std::min(first.young_modulus, second.young_modulus);
        ratios_[f] = (near_front ? front_.energy(face, model.coarse.nodes) : tension_energy(face, modulus)) / toughness;
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
