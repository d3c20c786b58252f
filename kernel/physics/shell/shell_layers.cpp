// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_layers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr double near_in_thicknesses = 1.5;  // half a turn at the tightest takes pi / 2 along the middle
constexpr double skin = 0.2;                 // how far beyond its reach a search looks [mm]
constexpr double hair = 1e-9;                // more than that of a distance [mm]
constexpr std::size_t word_bits = 64;

using Edges = std::vector<std::vector<std::pair<int, double>>>;

Edges edges_of(const TriMesh& mesh) {
    Edges edges(mesh.nodes.size());
    for (const std::array<int, 3>& n : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = n[k];
            const int b = n[(k + 1) % 3];
            const double length = (mesh.nodes[at(a)] - mesh.nodes[at(b)]).norm();
            edges[at(a)].emplace_back(b, length);
            edges[at(b)].emplace_back(a, length);
        }
    }
    return edges;
}

/// Nodes within `reach` of the starts along edges, ascending, by letting distances fall until none does.
std::vector<int> within(const Edges& edges, const std::array<int, 3>& starts, double reach,
                        std::vector<double>& distance) {
    std::vector<int> found(starts.begin(), starts.end());
    for (const int start : starts) {
        distance[at(start)] = 0.0;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (const auto& [other, length] : edges[at(found[i])]) {
            const double along = distance[at(found[i])] + length;
            if (along < reach && along < distance[at(other)]) {
                distance[at(other)] = along;
                found.push_back(other);
            }
        }
    }
    for (const int node : found) {
        distance[at(node)] = HUGE_VAL;
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace

ShellLayers::ShellLayers(const ShellModel& model) : model_(&model) { find_near(edges_of(model.mesh)); }

void ShellLayers::find_near(const Edges& edges) {
    std::vector<double> distance(model_->mesh.nodes.size(), HUGE_VAL);
    near_words_ = (model_->mesh.nodes.size() + word_bits - 1) / word_bits;
    near_.assign(near_words_ * model_->mesh.triangles.size(), 0);
    for (std::size_t t = 0; t < model_->mesh.triangles.size(); ++t) {
        for (const int node :
             within(edges, model_->mesh.triangles[t], near_in_thicknesses * model_->thickness[t], distance)) {
            near_[t * near_words_ + at(node) / word_bits] |= std::uint64_t{1} << at(node) % word_bits;
        }
    }
}

bool ShellLayers::is_near(int triangle, const ShellPlace& place) const {
    const std::uint64_t* const own = near_.data() + at(triangle) * near_words_;
    return std::any_of(place.nodes.begin(), place.nodes.end(),
                       [own](int n) { return n >= 0 && (own[at(n) / word_bits] >> at(n) % word_bits & 1) != 0; });
}

/// How far samples and triangles have gone since the last search; what all share does not count. The farthest.
double ShellLayers::find_moved(const ShellSamples& on, const std::vector<Vec3>& points) {
    if (points_.size() != points.size()) {
        return HUGE_VAL;
    }
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        mean += points[i] - points_[i];
    }
    mean /= static_cast<double>(points.size());
    double most = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        moved_[i] = (points[i] - points_[i] - mean).norm();
        most = std::max(most, moved_[i]);
    }
    for (std::size_t f = 0; f < on.facets.size(); ++f) {
        double& own = triangle_moved_[f / at(on.facets_each)];
        own = f % at(on.facets_each) == 0 ? 0.0 : own;
        for (const int corner : on.facets[f]) {
            own = std::max(own, moved_[at(corner)]);
        }
    }
    return most;
}

void ShellLayers::look(const ShellSamples& on, const std::vector<Vec3>& points, double gap) {
    if (2.0 * find_moved(on, points) < skin && gap == gap_) {
        return;
    }
    moved_.assign(points.size(), 0.0);
    triangle_moved_.assign(model_->mesh.triangles.size(), 0.0);
    points_ = points;
    gap_ = gap;
    bound(on);
    find_around();
    candidates_.clear();
    first_.assign(1, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        find(points[i], on.samples[i]);
        first_.push_back(static_cast<int>(candidates_.size()));
    }
}

/// Where the triangles and their samples are, and how thick.
void ShellLayers::bound(const ShellSamples& on) {
    boxes_.assign(model_->mesh.triangles.size(), Box{});
    halves_.assign(boxes_.size(), 0.0);
    for (std::size_t f = 0; f < on.facets.size(); ++f) {
        const std::size_t t = f / at(on.facets_each);
        for (std::size_t k = 0; k < 3; ++k) {
            boxes_[t].add(points_[at(on.facets[f][k])], 0.0);
            halves_[t] = std::max(halves_[t], 0.5 * on.corners[f][k].thickness);
        }
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
        boxes_[at(on.samples[i].triangle)].add(points_[i], 0.0);
    }
    thickest_ = *std::max_element(halves_.begin(), halves_.end());
}

void ShellLayers::find_around() {
    grid_.fill(boxes_);
    around_.resize(boxes_.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const Vec3 middle = 0.5 * (boxes_[i].low + boxes_[i].high);
        const Vec3 half = 0.5 * (boxes_[i].high - boxes_[i].low);
        const double own = halves_[i] + gap_ + skin + hair;
        around_[i].clear();
        grid_.near(middle, half.maxCoeff() + own + thickest_, [&](int t) {
            const Box& other = boxes_[at(t)];
            const Vec3 apart =
                (0.5 * (other.low + other.high) - middle).cwiseAbs() - half - 0.5 * (other.high - other.low);
            const double reach = own + halves_[at(t)];
            if (apart.cwiseMax(0.0).squaredNorm() <= reach * reach) {
                around_[i].push_back(t);
            }
        });
        std::sort(around_[i].begin(), around_[i].end());
    }
}

/// Adds what comes near a sample to the candidates.
void ShellLayers::find(const Vec3& point, const ShellSamples::Sample& sample) {
    const double around = 0.5 * sample.place.thickness + gap_ + skin;
    for (const int t : around_[at(sample.triangle)]) {
        const double own = around + halves_[at(t)];
        const double square = square_to(boxes_[at(t)], point);
        if (square <= own * own && !is_near(t, sample.place)) {
            candidates_.push_back({t, std::sqrt(square) - own + skin});
        }
    }
}

void ShellLayers::learn(std::size_t sample, Candidate& candidate, double apart) const {
    candidate.spare = std::max(candidate.spare, apart - gap_ - closed(sample, candidate.triangle) - hair);
}

}  // namespace rhexis
