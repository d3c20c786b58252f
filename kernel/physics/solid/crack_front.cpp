// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/crack_front.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace rhexis {

namespace {

std::array<int, 2> face_edge(const CrackFace& face, std::size_t k) {
    const int a = face.nodes[k];
    const int b = face.nodes[(k + 1) % 3];
    return {std::min(a, b), std::max(a, b)};
}

}  // namespace

void CrackFront::find(const std::vector<CrackFace>& faces, const std::vector<FaceState>& states,
                      const std::vector<std::uint8_t>& present, std::size_t nodes) {
    edges_.clear();
    scratch_.clear();
    surface_edges_.clear();
    role_.assign(nodes, Role::none);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (states[f] == FaceState::broken) {
            for (std::size_t k = 0; k < 3; ++k) {
                scratch_.push_back(face_edge(faces[f], k));
                role_[at(faces[f].nodes[k])] = Role::front;
            }
        }
    }
    if (scratch_.empty()) {
        return;
    }
    nodes_.assign(nodes, {});
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (states[f] != FaceState::surface) {
            continue;
        }
        const auto [t, other] = faces[f].tets;
        // its normal counts only on the way out of what is there
        const double side = (present[at(t)] != 0 ? 1.0 : 0.0) - (other >= 0 && present[at(other)] != 0 ? 1.0 : 0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge edge = face_edge(faces[f], k);
            nodes_[at(faces[f].nodes[k])].outward += side * faces[f].area * faces[f].normal;
            if (role_[at(edge[0])] == Role::front && role_[at(edge[1])] == Role::front) {
                surface_edges_.push_back(edge);
            }
        }
    }
    role_.assign(nodes, Role::none);
    std::sort(scratch_.begin(), scratch_.end());
    std::sort(surface_edges_.begin(), surface_edges_.end());
    for (auto edge = scratch_.begin(); edge != scratch_.end();) {
        const auto next = std::upper_bound(edge, scratch_.end(), *edge);
        if (next - edge == 1 && !std::binary_search(surface_edges_.begin(), surface_edges_.end(), *edge)) {
            edges_.push_back(*edge);
            role_[at((*edge)[0])] = role_[at((*edge)[1])] = Role::front;
        }
        edge = next;
    }
}

void CrackFront::measure(const std::vector<Vec3>& at_rest) {
    for (const Edge& edge : edges_) {
        const double half = 0.5 * (at_rest[at(edge[1])] - at_rest[at(edge[0])]).norm();
        nodes_[at(edge[0])].length += half;
        nodes_[at(edge[1])].length += half;
    }
}

void CrackFront::add_tet(const std::array<int, 4>& tet, const RestTet& rest, const TetStress& stress) {
    const Mat3 own = (Mat3::Identity() + stress.strain) * stress.stress - stress.energy * Mat3::Identity();
    const Mat3 turned = stress.rotation * stress.stress;
    for (std::size_t k = 0; k < 4; ++k) {
        if (role_[at(tet[k])] == Role::none) {
            continue;
        }
        Node& node = nodes_[at(tet[k])];
        node.rotation += stress.rotation;
        node.force += rest.volume * (turned * rest.gradient[k]);
        node.pull += rest.volume * (own * rest.gradient[k]);
        ++node.tets;
    }
}

/// Each node beside the front adds what it pulls to those of the front next to it, in equal parts.
void CrackFront::gather(const std::vector<std::array<int, 4>>& tets, const std::vector<std::uint8_t>& present) {
    scratch_.clear();
    for (std::size_t t = 0; t < tets.size(); ++t) {
        if (present[t] == 0) {
            continue;
        }
        for (const int beside : tets[t]) {
            for (const int node : tets[t]) {
                if (role_[at(beside)] == Role::beside && role_[at(node)] == Role::front) {
                    scratch_.push_back({beside, node});
                }
            }
        }
    }
    std::sort(scratch_.begin(), scratch_.end());
    scratch_.erase(std::unique(scratch_.begin(), scratch_.end()), scratch_.end());
    for (auto first = scratch_.begin(); first != scratch_.end();) {
        const auto last = std::find_if(first, scratch_.end(), [&](const Edge& pair) { return pair[0] != (*first)[0]; });
        const Node& beside = nodes_[at((*first)[0])];
        for (auto pair = first; pair != last; ++pair) {
            nodes_[at((*pair)[1])].pull += beside.pull / static_cast<double>(last - first);
        }
        first = last;
    }
}

void CrackFront::pull(const std::vector<std::array<int, 4>>& tets, const std::vector<RestTet>& rest,
                      const std::vector<TetStress>& stress, const std::vector<std::uint8_t>& present,
                      const std::vector<char>& pressed) {
    for (std::size_t t = 0; t < tets.size(); ++t) {
        if (present[t] != 0 && std::any_of(tets[t].begin(), tets[t].end(), [&](int node) { return has(node); })) {
            for (const int node : tets[t]) {
                role_[at(node)] = has(node) ? Role::front : Role::beside;
            }
        }
    }
    for (std::size_t t = 0; t < tets.size(); ++t) {
        if (present[t] != 0 && std::any_of(tets[t].begin(), tets[t].end(), [&](int node) { return near(node); })) {
            add_tet(tets[t], rest[t], stress[t]);
        }
    }
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        Node& node = nodes_[n];
        if (node.tets == 0) {
            continue;
        }
        node.pull -= node.rotation.transpose() * node.force / node.tets;
        if (node.outward.squaredNorm() > 0.0) {  // a surface does not move through the material
            node.outward.normalize();
            node.pull -= node.outward.dot(node.pull) * node.outward;
        }
        if (pressed[n] != 0) {
            node.pull.setZero();
        }
    }
    gather(tets, present);
}

double CrackFront::energy(const CrackFace& face, const std::vector<Vec3>& at_rest) const {
    double most = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Edge edge = face_edge(face, k);
        if (!std::binary_search(edges_.begin(), edges_.end(), edge)) {
            continue;
        }
        const Vec3 along = (at_rest[at(edge[1])] - at_rest[at(edge[0])]).normalized();
        const Vec3 off = at_rest[at(face.nodes[(k + 2) % 3])] - at_rest[at(edge[0])];
        const Vec3 onward = (off - along.dot(off) * along).normalized();
        double pull = 0.0;
        double length = 0.0;
        for (const int end : edge) {
            const Node& node = nodes_[at(end)];
            const double off_surface = onward.dot(node.outward);  // where it may not go
            const double share = 1.0 - off_surface * off_surface;
            pull += share * onward.dot(node.pull);
            length += share * node.length;
        }
        most = std::max(most, length > 0.0 ? pull / length : 0.0);
    }
    return most;
}

}  // namespace rhexis
