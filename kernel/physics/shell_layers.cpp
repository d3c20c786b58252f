// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell_layers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr double near_in_thicknesses = 1.5;  // half a turn at the tightest takes pi / 2 along the middle
constexpr int most_cells = 64;               // each way

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
    for (std::size_t t = 0; t < model_->mesh.triangles.size(); ++t) {
        near_.push_back(within(edges, model_->mesh.triangles[t], near_in_thicknesses * model_->thickness[t], distance));
    }
}

std::array<int, 3> ShellLayers::cell_of(const Vec3& point) const {
    std::array<int, 3> cell{};
    for (int k = 0; k < 3; ++k) {
        const double along = std::clamp((point[k] - low_[k]) / cell_, 0.0, static_cast<double>(cells_[at(k)] - 1));
        cell[at(k)] = static_cast<int>(along);
    }
    return cell;
}

void ShellLayers::take(std::vector<Box> boxes) {
    boxes_ = std::move(boxes);
    Box all;
    double size = 0.0;
    for (const Box& box : boxes_) {
        all.low = all.low.cwiseMin(box.low);
        all.high = all.high.cwiseMax(box.high);
        size += (box.high - box.low).maxCoeff();
    }
    low_ = all.low;
    cell_ = std::max(size / static_cast<double>(boxes_.size()), (all.high - all.low).maxCoeff() / most_cells);
    for (int k = 0; k < 3; ++k) {
        cells_[at(k)] = std::max(1, static_cast<int>((all.high[k] - all.low[k]) / cell_) + 1);
    }
    offset_.assign(at(cells_[0] * cells_[1] * cells_[2]) + 1, 0);
    const auto each_cell = [this](const Box& box, const auto& take) {
        const std::array<int, 3> first = cell_of(box.low);
        const std::array<int, 3> last = cell_of(box.high);
        for (int z = first[2]; z <= last[2]; ++z) {
            for (int y = first[1]; y <= last[1]; ++y) {
                for (int x = first[0]; x <= last[0]; ++x) {
                    take(at((z * cells_[1] + y) * cells_[0] + x));
                }
            }
        }
    };
    for (const Box& box : boxes_) {
        each_cell(box, [this](std::size_t cell) { ++offset_[cell + 1]; });
    }
    for (std::size_t i = 1; i < offset_.size(); ++i) {
        offset_[i] += offset_[i - 1];
    }
    triangles_.resize(at(offset_.back()));
    std::vector<int> next(offset_.begin(), offset_.end() - 1);
    for (std::size_t t = 0; t < boxes_.size(); ++t) {
        each_cell(boxes_[t], [&](std::size_t cell) { triangles_[at(next[cell]++)] = static_cast<int>(t); });
    }
}

void ShellLayers::find(const Vec3& point, double reach, const std::array<int, 3>& nodes,
                       std::vector<int>& triangles) const {
    triangles.clear();
    const std::array<int, 3> first = cell_of(point - Vec3::Constant(reach));
    const std::array<int, 3> last = cell_of(point + Vec3::Constant(reach));
    for (int z = first[2]; z <= last[2]; ++z) {
        for (int y = first[1]; y <= last[1]; ++y) {
            for (int x = first[0]; x <= last[0]; ++x) {
                const std::size_t cell = at((z * cells_[1] + y) * cells_[0] + x);
                triangles.insert(triangles.end(), triangles_.begin() + offset_[cell],
                                 triangles_.begin() + offset_[cell + 1]);
            }
        }
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::erase_if(triangles, [&](int t) {
        const Vec3 nearest = point.cwiseMax(boxes_[at(t)].low).cwiseMin(boxes_[at(t)].high);
        const std::vector<int>& near = near_[at(t)];
        return (nearest - point).squaredNorm() > reach * reach || std::any_of(nodes.begin(), nodes.end(), [&](int n) {
                   return n >= 0 && std::binary_search(near.begin(), near.end(), n);
               });
    });
}

}  // namespace rhexis
