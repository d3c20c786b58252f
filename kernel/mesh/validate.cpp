// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace rhexis {

namespace {

/// Below this share of a regular tetrahedron's volume with the same longest edge an element counts as flat.
constexpr double flat_volume = 1e-6;

class Validator {
public:
    Validator(const TetMesh& mesh, const MeshSource* source) : mesh_(mesh), source_(source) {}

    Status run() {
        for (const auto part : {&Validator::sizes, &Validator::nodes, &Validator::indices, &Validator::shapes,
                                &Validator::orphans, &Validator::duplicates, &Validator::faces}) {
            if (Status status = (this->*part)(); !status.ok()) {
                return status;
            }
        }
        return success();
    }

private:
    Error fault(const std::string& what, const std::string& allowed, const std::vector<int>* lines,
                std::size_t number) const {
        std::string where = source_ != nullptr ? source_->path : "mesh";
        if (lines != nullptr && number < lines->size()) {
            where.append(":").append(std::to_string((*lines)[number]));
        }
        return {what, where, allowed};
    }

    /// The number that a file gives a node or a tetrahedron, or its index.
    [[nodiscard]] std::string node(std::size_t n) const {
        const bool known = source_ != nullptr && n < source_->node_number.size();
        return known ? std::to_string(source_->node_number[n]) : std::to_string(n);
    }
    [[nodiscard]] std::string tet(std::size_t t) const {
        const bool known = source_ != nullptr && t < source_->tet_number.size();
        return known ? std::to_string(source_->tet_number[t]) : std::to_string(t);
    }

    Error node_fault(std::size_t n, const std::string& what, const std::string& allowed) const {
        return fault("node " + node(n) + " " + what, allowed, source_ != nullptr ? &source_->node_line : nullptr, n);
    }

    Error tet_fault(std::size_t t, const std::string& what, const std::string& allowed) const {
        return fault("tetrahedron " + tet(t) + " " + what, allowed, source_ != nullptr ? &source_->tet_line : nullptr,
                     t);
    }

    Status sizes() {
        if (mesh_.tets.empty()) {
            return fault("has no tetrahedra", "at least one", nullptr, 0);
        }
        if (mesh_.region.size() != mesh_.tets.size()) {
            return fault("has " + std::to_string(mesh_.region.size()) + " regions for " +
                             std::to_string(mesh_.tets.size()) + " tetrahedra",
                         "one each", nullptr, 0);
        }
        return success();
    }

    Status nodes() {
        for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
            if (!mesh_.nodes[n].allFinite()) {
                return node_fault(n, "is not at a number", "finite coordinates");
            }
        }
        return success();
    }

    Status indices() {
        const int count = static_cast<int>(mesh_.nodes.size());
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            std::array<int, 4> tet = mesh_.tets[t];
            for (int node : tet) {
                if (node < 0 || node >= count) {
                    return tet_fault(t, "uses node " + std::to_string(node), "0 to " + std::to_string(count - 1));
                }
            }
            std::sort(tet.begin(), tet.end());
            if (std::adjacent_find(tet.begin(), tet.end()) != tet.end()) {
                return tet_fault(t, "uses a node twice", "four different nodes");
            }
            if (mesh_.region[t] < 0) {
                return tet_fault(t, "is in region " + std::to_string(mesh_.region[t]), "0 or more");
            }
        }
        return success();
    }

    Status shapes() {
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            std::array<Vec3, 4> x;
            for (std::size_t k = 0; k < 4; ++k) {
                x[k] = mesh_.nodes[static_cast<std::size_t>(mesh_.tets[t][k])];
            }
            double longest = 0.0;
            for (std::size_t i = 0; i < 3; ++i) {
                for (std::size_t j = i + 1; j < 4; ++j) {
                    longest = std::max(longest, (x[i] - x[j]).norm());
                }
            }
            const double regular = longest * longest * longest / (6.0 * std::sqrt(2.0));
            const double volume = tet_volume(x[0], x[1], x[2], x[3]);
            if (!(std::abs(volume) > flat_volume * regular)) {
                return tet_fault(t, "is flat", "a volume");
            }
            if (volume < 0.0) {
                return tet_fault(t, "is inverted (its volume is negative)", "positive orientation");
            }
        }
        return success();
    }

    Status orphans() {
        std::vector<std::uint8_t> used(mesh_.nodes.size(), 0);
        for (const std::array<int, 4>& tet : mesh_.tets) {
            for (int node : tet) {
                used[static_cast<std::size_t>(node)] = 1;
            }
        }
        const std::vector<std::uint8_t>::const_iterator orphan = std::find(used.cbegin(), used.cend(), 0);
        if (orphan != used.cend()) {
            return node_fault(static_cast<std::size_t>(orphan - used.cbegin()), "belongs to no element",
                              "every node used");
        }
        return success();
    }

    Status duplicates() {
        std::vector<std::pair<std::array<int, 4>, std::size_t>> sorted;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            std::array<int, 4> tet = mesh_.tets[t];
            std::sort(tet.begin(), tet.end());
            sorted.emplace_back(tet, t);
        }
        std::sort(sorted.begin(), sorted.end());
        const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
        const auto twice = std::adjacent_find(sorted.cbegin(), sorted.cend(), same);
        if (twice != sorted.cend()) {
            return tet_fault((twice + 1)->second, "repeats tetrahedron " + tet(twice->second), "each listed once");
        }
        return success();
    }

    Status faces() {
        std::vector<std::pair<std::array<int, 3>, std::size_t>> sorted;
        for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
            for (const std::array<int, 3>& face : tet_faces) {
                std::array<int, 3> nodes{};
                for (std::size_t i = 0; i < 3; ++i) {
                    nodes[i] = mesh_.tets[t][static_cast<std::size_t>(face[i])];
                }
                std::sort(nodes.begin(), nodes.end());
                sorted.emplace_back(nodes, t);
            }
        }
        std::sort(sorted.begin(), sorted.end());
        for (std::size_t i = 2; i < sorted.size(); ++i) {
            if (sorted[i].first == sorted[i - 2].first) {
                return tet_fault(sorted[i].second, "overlaps others: one of its faces is shared by three tetrahedra",
                                 "at most two");
            }
        }
        return success();
    }

    const TetMesh& mesh_;
    const MeshSource* source_;
};

}  // namespace

Status validate_mesh(const TetMesh& mesh, const MeshSource* source) { return Validator(mesh, source).run(); }

}  // namespace rhexis
