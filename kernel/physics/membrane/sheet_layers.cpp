// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/sheet_layers.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace rhexis {
namespace {

constexpr double layer_margin = 0.1;    // more than moves in a substep: within which layers may meet [mm]
constexpr double most_reach = 0.25;     // [mm]
constexpr double deepest_layer = 0.15;  // below a layer from which what is folded over still comes up again [mm]
constexpr double onset = 0.02;          // depth over which the spring gains its stiffness [mm]
constexpr double level = 0.3;           // of the distance that layers keep: so far below, what is folded over is above
constexpr double clear = 0.5;           // of the distance that layers keep: higher, it is above whatever way it looks
constexpr double steepest = 0.2;        // cosine, from where it looked at rest, of what something can lie on
constexpr double near_at_rest = 1.5;    // edges: what belongs to the fold itself
constexpr double beyond_edges = -0.1;   // share of a corner to which a triangle reaches beyond its edges
constexpr double cell_size = 0.4;       // of the grid [mm]
constexpr int most_layer_cells = 200;   // each way; what is farther lies in the last

Vec3 normal_of(const std::vector<Vec3>& x, const std::array<int, 3>& n) {
    return (x[at(n[1])] - x[at(n[0])]).cross(x[at(n[2])] - x[at(n[0])]);
}

/// Weights of the corners of the place below a point.
std::array<double, 3> weights_below(const std::vector<Vec3>& x, const std::array<int, 3>& n, const Vec3& point) {
    const Vec3 a = x[at(n[1])] - x[at(n[0])];
    const Vec3 b = x[at(n[2])] - x[at(n[0])];
    const Vec3 way = point - x[at(n[0])];
    const Vec3 normal = a.cross(b);
    const double square = normal.squaredNorm();
    const double v = way.cross(b).dot(normal) / square;
    const double w = a.cross(way).dot(normal) / square;
    return {1.0 - v - w, v, w};
}

Vec3 place_of(const std::vector<Vec3>& x, const std::array<int, 3>& n, const std::array<double, 3>& w) {
    return w[0] * x[at(n[0])] + w[1] * x[at(n[1])] + w[2] * x[at(n[2])];
}

/// Whether a node is so close to a triangle at rest that they are of the same fold, or of the two lips of a tear.
bool near_in_sheet(const TriMesh& mesh, int node, const std::array<int, 3>& n) {
    const Vec3& own = mesh.nodes[at(node)];
    const Vec3 middle = (mesh.nodes[at(n[0])] + mesh.nodes[at(n[1])] + mesh.nodes[at(n[2])]) / 3.0;
    const double edge = (mesh.nodes[at(n[1])] - mesh.nodes[at(n[0])]).squaredNorm() +
                        (mesh.nodes[at(n[2])] - mesh.nodes[at(n[1])]).squaredNorm() +
                        (mesh.nodes[at(n[0])] - mesh.nodes[at(n[2])]).squaredNorm();
    return (own - middle).squaredNorm() < near_at_rest * near_at_rest * edge / 3.0;
}

}  // namespace

/// False where nothing is folded.
bool SheetLayers::take_layers(const MembraneState& state) {
    const TriMesh& mesh = state.sheet->mesh;
    const std::vector<Vec3>& x = state.position;
    layers_.resize(mesh.triangles.size());
    upright_.assign(x.size(), 0.0);
    fold_ = Box{};
    for (std::size_t t = 0; t < layers_.size(); ++t) {
        Layer& layer = layers_[t];
        layer.nodes = mesh.triangles[t];
        const std::array<int, 3>& n = layer.nodes;
        const Vec3 now = normal_of(x, n);
        const Vec3 front = normal_of(mesh.nodes, n);
        const double size = now.norm();
        const double cosine = size > 0.0 ? now.dot(front) / (size * front.norm()) : 0.0;
        layer.over = cosine < 0.0;
        layer.up.setZero();
        if (std::abs(cosine) > steepest) {
            layer.up = (layer.over ? -1.0 : 1.0) / size * now;
        }
        layer.corner = x[at(n[0])];
        layer.low = x[at(n[0])].cwiseMin(x[at(n[1])]).cwiseMin(x[at(n[2])]);
        layer.high = x[at(n[0])].cwiseMax(x[at(n[1])]).cwiseMax(x[at(n[2])]);
        for (const int node : n) {
            upright_[at(node)] += cosine * size;
            if (layer.over) {
                fold_.add(x[at(node)], layer_margin);
            }
        }
    }
    return fold_.low.x() <= fold_.high.x();
}

int SheetLayers::cell(double x, double y) const {
    const int column = std::clamp(static_cast<int>((x - grid_.low.x()) / cell_size), 0, grid_.columns - 1);
    const int row = std::clamp(static_cast<int>((y - grid_.low.y()) / cell_size), 0, grid_.rows - 1);
    return row * grid_.columns + column;
}

bool SheetLayers::in_view(const Layer& layer) const {
    return layer.up.squaredNorm() > 0.0 && layer.low.x() < fold_.high.x() && layer.high.x() > fold_.low.x() &&
           layer.low.y() < fold_.high.y() && layer.high.y() > fold_.low.y();
}

/// Where something is folded; elsewhere nothing lies on anything.
void SheetLayers::fill_grid() {
    grid_.low = fold_.low.head<2>();
    grid_.columns = std::clamp(static_cast<int>((fold_.high.x() - fold_.low.x()) / cell_size) + 1, 1, most_layer_cells);
    grid_.rows = std::clamp(static_cast<int>((fold_.high.y() - fold_.low.y()) / cell_size) + 1, 1, most_layer_cells);
    grid_.offset.assign(at(grid_.columns * grid_.rows) + 1, 0);
    const auto in_cells = [&](const Layer& layer, const auto& take) {
        if (!in_view(layer)) {
            return;
        }
        const int first = cell(layer.low.x() - layer_margin, layer.low.y() - layer_margin);
        const int last = cell(layer.high.x() + layer_margin, layer.high.y() + layer_margin);
        for (int row = first / grid_.columns; row <= last / grid_.columns; ++row) {
            for (int column = first % grid_.columns; column <= last % grid_.columns; ++column) {
                take(row * grid_.columns + column);
            }
        }
    };
    for (const Layer& layer : layers_) {
        in_cells(layer, [&](int k) { ++grid_.offset[at(k) + 1]; });
    }
    for (std::size_t k = 1; k < grid_.offset.size(); ++k) {
        grid_.offset[k] += grid_.offset[k - 1];
    }
    grid_.triangles.resize(at(grid_.offset.back()));
    std::vector<int> next(grid_.offset.begin(), grid_.offset.end() - 1);
    for (int t = 0; t < static_cast<int>(layers_.size()); ++t) {
        in_cells(layers_[at(t)], [&](int k) { grid_.triangles[at(next[at(k)]++)] = t; });
    }
}

/// Of what a node is above, the highest: of what looks as it did at rest, or of what is folded.
void SheetLayers::meet(const MembraneModel& model, const MembraneState& state, int node) {
    const Vec3& x = state.position[at(node)];
    const bool over = upright_[at(node)] < 0.0;
    const double least = over ? -level * distance_ : clear * distance_;
    double highest = std::min(most_reach, distance_ + layer_margin);
    Meeting found{-1, -1, Vec3::Zero(), 0.0, false};
    std::array<double, 3> share{};
    const int k = cell(x.x(), x.y());
    for (int i = grid_.offset[at(k)]; i < grid_.offset[at(k) + 1]; ++i) {
        const int triangle = grid_.triangles[at(i)];
        const Layer& layer = layers_[at(triangle)];
        if (x.x() < layer.low.x() - layer_margin || x.x() > layer.high.x() + layer_margin ||
            x.y() < layer.low.y() - layer_margin || x.y() > layer.high.y() + layer_margin || (over && layer.over)) {
            continue;
        }
        const double height = layer.up.dot(x - layer.corner);
        if (!(height < highest) || height < -deepest_layer || (height < least && !was_above(node, layer)) ||
            near_in_sheet(state.sheet->mesh, node, layer.nodes)) {
            continue;
        }
        const std::array<double, 3> weights = weights_below(state.position, layer.nodes, x);
        if (*std::min_element(weights.begin(), weights.end()) > beyond_edges) {
            highest = height;
            found = {node, triangle, layer.up, 0.0, false};
            share = weights;
        }
    }
    if (found.node < 0) {
        return;
    }
    const std::array<int, 3>& below = layers_[at(found.triangle)].nodes;
    Vec3 place = place_of(state.position, below, share);
    found.level = found.up.dot(place + dt_ * place_of(state.velocity, below, share)) + distance_;
    place.z() -= state.support.lift;
    found.on_support = bag_distance(model.support->shape, place).distance < distance_;
    list_.push_back(found);
    for (const int corner : below) {
        bears_[at(corner)] = 1;
    }
}

/// Whether a node was above a triangle, or one that shares a corner with it, at the end of the substep before.
bool SheetLayers::was_above(int node, const Layer& layer) const {
    const int known = above_[at(node)];
    if (known < 0) {
        return false;
    }
    const std::array<int, 3>& other = layers_[at(known)].nodes;
    return std::find_first_of(other.begin(), other.end(), layer.nodes.begin(), layer.nodes.end()) != other.end();
}

void SheetLayers::look(const MembraneModel& model, const MembraneState& state, double stiffness, double dt) {
    list_.clear();
    dt_ = dt;
    distance_ = model.layer_distance;
    stiffness_ = stiffness;
    if (distance_ == 0.0 || state.tips.empty()) {
        return;
    }
    if (!take_layers(state)) {
        return;
    }
    fill_grid();
    const int nodes = static_cast<int>(state.position.size());
    above_.assign(at(nodes), -1);
    for (const SheetTouch& touch : state.touches) {
        if (touch.node >= 0 && touch.triangle >= 0) {
            above_[at(touch.node)] = touch.triangle;
        }
    }
    // what bears a layer is not itself above one: two that cross would lift each other for ever
    bears_.assign(at(nodes), 0);
    for (const bool over : {true, false}) {
        for (int node = 0; node < nodes; ++node) {
            const Vec3& x = state.position[at(node)];
            const bool inside =
                x.x() > fold_.low.x() && x.x() < fold_.high.x() && x.y() > fold_.low.y() && x.y() < fold_.high.y();
            if (inside && !is_out(*state.sheet, node) && (upright_[at(node)] < 0.0) == over && bears_[at(node)] == 0) {
                meet(model, state, node);
            }
        }
    }
}

void SheetLayers::remember(std::vector<SheetTouch>& touches) const {
    for (const Meeting& meeting : list_) {
        touches.push_back({meeting.triangle, meeting.node, ContactPartner::support, 0, Vec3::Zero()});
    }
}

double SheetLayers::gap(const Meeting& meeting, const std::vector<Vec3>& position) const {
    return meeting.up.dot(position[at(meeting.node)]) - meeting.level;
}

double SheetLayers::force_at(double depth) const {
    return stiffness_ * (depth < onset ? 0.5 * depth * depth / onset : depth - 0.5 * onset);
}

void SheetLayers::terms(const std::vector<Vec3>& position, std::vector<ContactTerm>& terms) const {
    for (const Meeting& meeting : list_) {
        const double depth = -gap(meeting, position);
        if (depth > 0.0) {
            ContactTerm& term = terms.emplace_back();
            term.nodes[0] = meeting.node;
            term.force = force_at(depth) * meeting.up;
            term.stiffness = stiffness_ * std::min(1.0, depth / onset) * meeting.up * meeting.up.transpose();
        }
    }
}

double SheetLayers::force_on_support(const std::vector<Vec3>& position) const {
    double sum = 0.0;
    for (const Meeting& meeting : list_) {
        const double depth = -gap(meeting, position);
        sum -= meeting.on_support && depth > 0.0 ? force_at(depth) * meeting.up.z() : 0.0;
    }
    return sum;
}

}  // namespace rhexis
