// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_samples.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
namespace {

/// Of a triangle, at share[k] of its corners.
ShellPlace place_in(const ShellModel& model, const std::vector<double>& thickness, std::size_t triangle,
                    const std::array<double, 3>& share) {
    const std::array<int, 3>& n = model.mesh.triangles[triangle];
    const double all = share[0] * share[1] * share[2];
    ShellPlace place;
    place.nodes = n;
    place.blend = share;
    for (std::size_t k = 0; k < 3; ++k) {
        const double own = share[k];
        place.weights[k] = own * own * (3.0 - 2.0 * own) + 2.0 * all;
        place.thickness += own * thickness[at(n[k])];
        for (const std::size_t j : {(k + 1) % 3, (k + 2) % 3}) {
            place.arms[k] +=
                (own * own * share[j] + 0.5 * all) * (model.mesh.nodes[at(n[j])] - model.mesh.nodes[at(n[k])]);
        }
    }
    return place;
}

/// By nodes: the mean of their triangles', by area.
std::vector<double> thickness_of_nodes(const ShellModel& model) {
    std::vector<double> sum(model.mesh.nodes.size(), 0.0);
    std::vector<double> area(model.mesh.nodes.size(), 0.0);
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        const std::array<int, 3>& n = model.mesh.triangles[t];
        const double own =
            triangle_area(model.mesh.nodes[at(n[0])], model.mesh.nodes[at(n[1])], model.mesh.nodes[at(n[2])]);
        for (const int node : n) {
            sum[at(node)] += own * model.thickness[t];
            area[at(node)] += own;
        }
    }
    for (std::size_t n = 0; n < sum.size(); ++n) {
        sum[n] /= area[n];
    }
    return sum;
}

/// A lattice point of a triangle, the same from either side of an edge: node and share of up to three corners.
using Key = std::array<std::array<int, 2>, 3>;

Key key_of(const std::array<int, 3>& nodes, const std::array<int, 3>& share) {
    Key key;
    for (std::size_t k = 0; k < 3; ++k) {
        key[k] = share[k] > 0 ? std::array<int, 2>{nodes[k], share[k]} : std::array<int, 2>{-1, 0};
    }
    std::sort(key.begin(), key.end());
    return key;
}

/// Without the nodes that take no part.
ShellPlace trimmed(ShellPlace place) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (place.blend[k] == 0.0) {
            place.nodes[k] = -1;
        }
    }
    return place;
}

class Lattice {
public:
    Lattice(const ShellModel& model, int cuts, ShellSamples& result)
        : model_(&model), cuts_(cuts), thickness_(thickness_of_nodes(model)), result_(&result) {
        for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
            for (int i = 0; i < 3; ++i) {
                std::array<int, 3> share{};
                share[at(i)] = cuts;
                sample(t, share);
            }
        }
    }

    void add(std::size_t triangle, const std::array<std::array<int, 3>, 3>& shares) {
        std::array<int, 3> facet{};
        std::array<ShellPlace, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            facet[k] = sample(triangle, shares[k]);
            corners[k] = place(triangle, shares[k]);
        }
        const std::array<int, 3>& n = model_->mesh.triangles[triangle];
        const double third =
            triangle_area(model_->mesh.nodes[at(n[0])], model_->mesh.nodes[at(n[1])], model_->mesh.nodes[at(n[2])]) /
            (3.0 * cuts_ * cuts_);
        for (const int one : facet) {
            result_->samples[at(one)].area += third;
        }
        result_->facets.push_back(facet);
        result_->corners.push_back(corners);
    }

private:
    [[nodiscard]] ShellPlace place(std::size_t triangle, const std::array<int, 3>& share) const {
        std::array<double, 3> real{};
        for (std::size_t k = 0; k < 3; ++k) {
            real[k] = static_cast<double>(share[k]) / cuts_;
        }
        return place_in(*model_, thickness_, triangle, real);
    }

    int sample(std::size_t triangle, const std::array<int, 3>& share) {
        const auto [found, added] = known_.try_emplace(key_of(model_->mesh.triangles[triangle], share),
                                                       static_cast<int>(result_->samples.size()));
        if (added) {
            result_->samples.push_back({trimmed(place(triangle, share)), 0.0, 0.0, static_cast<int>(triangle)});
        }
        return found->second;
    }

    const ShellModel* model_;
    int cuts_;
    std::vector<double> thickness_;
    ShellSamples* result_;
    std::map<Key, int> known_;
};

Vec3 at_rest(const ShellModel& model, const ShellPlace& place) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
        if (place.nodes[k] >= 0) {
            sum += place.weights[k] * model.mesh.nodes[at(place.nodes[k])] + place.arms[k];
        }
    }
    return sum;
}

/// A side of one facet only.
struct Side {
    std::size_t facet = 0;
    std::size_t from = 0;  ///< corner of it; the side goes to the next
};

std::vector<Side> find_border(const ShellSamples& on) {
    std::map<std::pair<int, int>, std::pair<Side, int>> sides;
    for (std::size_t f = 0; f < on.facets.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            auto& [side, count] = sides[std::minmax(on.facets[f][k], on.facets[f][(k + 1) % 3])];
            side = {f, k};
            ++count;
        }
    }
    std::vector<Side> border;
    for (const auto& [ends, found] : sides) {
        if (found.second == 1) {
            border.push_back(found.first);
        }
    }
    return border;
}

/// Samples along a side from one end to the other, new ones between them where they would be too far apart.
std::vector<int> samples_along(const ShellModel& model, const std::vector<double>& thickness, const Side& side,
                               double spacing, ShellSamples& on) {
    const std::size_t to = (side.from + 1) % 3;
    const std::array<ShellPlace, 3>& corner = on.corners[side.facet];
    const double length = (at_rest(model, corner[side.from]) - at_rest(model, corner[to])).norm();
    const double thinner = std::min(corner[side.from].thickness, corner[to].thickness);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / (spacing * thinner))));
    const std::size_t triangle = side.facet / at(on.facets_each);
    std::vector<int> along{on.facets[side.facet][side.from]};
    for (int i = 1; i < pieces; ++i) {
        const double far = static_cast<double>(i) / pieces;
        std::array<double, 3> share{};
        for (std::size_t k = 0; k < 3; ++k) {
            share[k] = (1.0 - far) * corner[side.from].blend[k] + far * corner[to].blend[k];
        }
        along.push_back(static_cast<int>(on.samples.size()));
        on.samples.push_back(
            {trimmed(place_in(model, thickness, triangle, share)), 0.0, 0.0, static_cast<int>(triangle)});
    }
    along.push_back(on.facets[side.facet][to]);
    return along;
}

/// Half of the way between two samples along the edge goes to each of them. spacing: at most, in thicknesses.
void find_edge(const ShellModel& model, double spacing, ShellSamples& on) {
    const std::vector<double> thickness = thickness_of_nodes(model);
    for (const Side& side : find_border(on)) {
        const std::vector<int> along = samples_along(model, thickness, side, spacing, on);
        for (std::size_t i = 0; i + 1 < along.size(); ++i) {
            ShellSamples::Sample& a = on.samples[at(along[i])];
            ShellSamples::Sample& b = on.samples[at(along[i + 1])];
            const double half = 0.5 * (at_rest(model, a.place) - at_rest(model, b.place)).norm();
            a.edge += half * a.place.thickness;
            b.edge += half * b.place.thickness;
        }
    }
}

}  // namespace

ShellPlace place_between(const std::array<ShellPlace, 3>& places, const std::array<double, 3>& share) {
    ShellPlace result;
    result.nodes = places[0].nodes;
    for (std::size_t i = 0; i < 3; ++i) {
        result.thickness += share[i] * places[i].thickness;
        for (std::size_t k = 0; k < 3; ++k) {
            result.weights[k] += share[i] * places[i].weights[k];
            result.arms[k] += share[i] * places[i].arms[k];
            result.blend[k] += share[i] * places[i].blend[k];
        }
    }
    return result;
}

ShellSamples shell_samples(const ShellModel& model, int level, double edge_spacing) {
    RHEXIS_ASSERT(level >= 0 && level <= 4);
    const int cuts = 1 << level;
    ShellSamples result;
    result.facets_each = cuts * cuts;
    Lattice lattice(model, cuts, result);
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        for (int i = 0; i < cuts; ++i) {
            for (int j = 0; i + j < cuts; ++j) {
                const int k = cuts - i - j;
                lattice.add(t, {{{i, j, k}, {i + 1, j, k - 1}, {i, j + 1, k - 1}}});
                if (k > 1) {
                    lattice.add(t, {{{i + 1, j, k - 1}, {i + 1, j + 1, k - 2}, {i, j + 1, k - 1}}});
                }
            }
        }
    }
    find_edge(model, edge_spacing, result);
    return result;
}

}  // namespace rhexis
