// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/membrane_body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"
#include "math/cholesky.hpp"
#include "math/grown_pattern.hpp"
#include "physics/membrane/added_rows.hpp"

namespace rhexis {
namespace {

using elastic_kernel::Mode;

// of the nodes that were there when the order of elimination was made: with more, a new one has so many fewer entries
// that it pays. Proposal: of 1.05 to 1.3, none cost tear_split 4 % less
constexpr double most_growth = 1.1;

TrianglePoints points_of(const std::vector<Vec3>& nodes, const TriMesh& mesh, int triangle) {
    const std::array<int, 3>& n = mesh.triangles[at(triangle)];
    return {nodes[at(n[0])], nodes[at(n[1])], nodes[at(n[2])]};
}

/// By nodes.
BlockPattern pattern_of(const TriMesh& mesh) {
    std::vector<int> first(mesh.triangles.size() + 1);
    std::vector<int> nodes(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        first[t + 1] = static_cast<int>(3 * t + 3);
        std::copy(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                  nodes.begin() + static_cast<std::ptrdiff_t>(3 * t));
    }
    return block_pattern(static_cast<int>(mesh.nodes.size()), first, nodes);
}

std::vector<int> inverse(const std::vector<int>& order) {
    std::vector<int> result(order.size());
    for (int i = 0; i < static_cast<int>(order.size()); ++i) {
        result[at(order[at(i)])] = i;
    }
    return result;
}

/// Whether a triangle is made of the same in both sheets.
bool same_triangle(const MembraneSheet& a, const MembraneSheet& b, std::size_t t) {
    if (a.mesh.triangles[t] != b.mesh.triangles[t] || a.fibre[t] != b.fibre[t] || a.thickness[t] != b.thickness[t] ||
        a.stiffness[t] != b.stiffness[t]) {
        return false;
    }
    return std::all_of(a.mesh.triangles[t].begin(), a.mesh.triangles[t].end(),
                       [&](int node) { return a.mesh.nodes[at(node)] == b.mesh.nodes[at(node)]; });
}

struct SpringPull {
    Vec3 force = Vec3::Zero();
    Mat3 stiffness = Mat3::Zero();  ///< positive semidefinite
};

SpringPull pull_of(const NodeSpring& spring, double lift, const Vec3& x) {
    SpringPull pull;
    const Vec3 way = spring.anchor + (spring.on_support ? lift : 0.0) * Vec3::UnitZ() - x;
    if (spring.slack == 0.0) {
        return {spring.stiffness * way, spring.stiffness * Mat3::Identity()};
    }
    const double length = way.norm();
    const double stretch = length - spring.slack;
    if (!(stretch > 0.0) || !(length > 0.0)) {
        return pull;
    }
    const Vec3 along = way / length;
    pull.force = spring.stiffness * stretch * along;
    pull.stiffness = spring.stiffness *
                     (along * along.transpose() + stretch / length * (Mat3::Identity() - along * along.transpose()));
    return pull;
}

}  // namespace

PlaneFrame frame_of(const TriMesh& mesh, int triangle) { return plane_frame(points_of(mesh.nodes, mesh, triangle)); }

MembraneTriangle membrane_triangle(const MembraneModel& model, const MembraneSheet& sheet, int triangle,
                                   const PlaneFrame& frame) {
    const TrianglePoints rest = points_of(sheet.mesh.nodes, sheet.mesh, triangle);
    const Vec2 fibre = frame.to_plane(sheet.fibre[at(triangle)]).normalized();
    return {shape_gradients(rest, frame), triangle_area(rest[0], rest[1], rest[2]) * sheet.thickness[at(triangle)],
            sheet.stiffness[at(triangle)] * plane_stiffness(model.material, fibre), model.slack_share};
}

std::vector<MembraneTriangle> membrane_triangles(const MembraneModel& model, const MembraneSheet& sheet) {
    std::vector<MembraneTriangle> result;
    result.reserve(sheet.mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(sheet.mesh.triangles.size()); ++t) {
        result.push_back(membrane_triangle(model, sheet, t, frame_of(sheet.mesh, t)));
    }
    return result;
}

TrianglePoints points_now(const MembraneState& state, int triangle) {
    return points_of(state.position, state.sheet->mesh, triangle);
}

double elastic_energy(const MembraneModel& model, const MembraneState& state) {
    double sum = 0.0;
    const std::vector<MembraneTriangle> triangles = membrane_triangles(model, *state.sheet);
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        sum += triangles[at(t)].volume * membrane_state(triangles[at(t)], points_now(state, t)).energy;
    }
    return sum;
}

Vec3 elastic_force(const MembraneModel& model, const MembraneState& state, const std::vector<int>& nodes) {
    std::vector<std::uint8_t> wanted(state.position.size(), 0);
    for (const int node : nodes) {
        wanted[at(node)] = 1;
    }
    Vec3 sum = Vec3::Zero();
    const std::vector<MembraneTriangle> triangles = membrane_triangles(model, *state.sheet);
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        TrianglePoints force;
        membrane_forces(triangles[at(t)], points_now(state, t), force);
        for (std::size_t a = 0; a < 3; ++a) {
            sum += wanted[at(state.sheet->mesh.triangles[at(t)][a])] != 0 ? force[a] : Vec3(Vec3::Zero());
        }
    }
    return sum;
}

MembraneBody::MembraneBody(const MembraneModel& model, std::shared_ptr<const MembraneSheet> sheet,
                           const membrane_kernel::Kernel& kernel)
    : ElasticBody(model.damping_mass, model.damping_stiffness),
      model_(&model),
      sheet_(std::move(sheet)),
      kernel_(&kernel) {
    make();
}

void MembraneBody::make() {
    const BlockPattern by_nodes = pattern_of(sheet_->mesh);
    node_of_ = elimination_order(by_nodes);
    row_of_ = inverse(node_of_);
    pattern_ = permuted(by_nodes, node_of_, row_of_);
    ordered_rows_ = rows();
    triangles_ = membrane_triangles(*model_, *sheet_);
    lay_out_lanes(0);
    find_moving();
    hang();
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        pack(t);
    }
    weigh();
}

std::vector<int> MembraneBody::follow(std::shared_ptr<const MembraneSheet> sheet, bool keep_order) {
    std::optional<std::vector<int>> row_now;
    if (keep_order) {
        row_now = grow(sheet);
    }
    if (row_now) {
        return *row_now;
    }
    sheet_ = std::move(sheet);
    make();
    return {};
}

/// Triangles that are not those of the sheet before.
std::vector<int> MembraneBody::changed_triangles(const MembraneSheet& now) const {
    std::vector<int> changed;
    for (std::size_t t = 0; t < now.mesh.triangles.size(); ++t) {
        if (t >= triangles_.size() || !same_triangle(*sheet_, now, t)) {
            changed.push_back(static_cast<int>(t));
        }
    }
    return changed;
}

/// Whether changed triangles tie no two nodes of before that nothing tied: a tear never does, a state that was gone
/// back to and torn otherwise may.
bool MembraneBody::ties_known(const TriMesh& mesh, const std::vector<int>& changed) const {
    return std::all_of(changed.begin(), changed.end(), [&](int t) {
        const std::array<int, 3>& corners = mesh.triangles[at(t)];
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = corners[k];
            const int b = corners[(k + 1) % 3];
            if (std::max(a, b) < rows() && pattern_.slot(row_of_[at(a)], row_of_[at(b)]) < 0) {
                return false;
            }
        }
        return true;
    });
}

/// Takes over a sheet that came from the one before by tears; where the rows before are now. None, and nothing done, if
/// the order of elimination is not worth keeping, or an earlier state was gone back to.
std::optional<std::vector<int>> MembraneBody::grow(const std::shared_ptr<const MembraneSheet>& sheet) {
    const TriMesh& mesh = sheet->mesh;
    const std::size_t known = triangles_.size();
    if (at(rows()) > mesh.nodes.size() || known > mesh.triangles.size() ||
        static_cast<double>(mesh.nodes.size()) > most_growth * ordered_rows_) {
        return std::nullopt;
    }
    const std::vector<int> changed = changed_triangles(*sheet);
    if (!ties_known(mesh, changed)) {
        return std::nullopt;
    }
    std::optional<RowsWithAdded> order = with_added_nodes(node_of_, row_of_, pattern_, mesh, changed);
    if (!order) {
        return std::nullopt;
    }
    std::vector<std::uint8_t> touched(mesh.nodes.size(), 0);  // nodes whose neighbours may be others
    for (const int t : changed) {
        for (const int node : mesh.triangles[at(t)]) {
            touched[at(node)] = 1;
        }
        for (std::size_t k = 0; k < 3 && at(t) < known; ++k) {
            touched[at(sheet_->mesh.triangles[at(t)][k])] = 1;
        }
    }
    node_of_ = std::move(order->node_of);
    row_of_ = std::move(order->row_of);
    sheet_ = sheet;
    renumber(touched, order->row_now);
    triangles_.resize(mesh.triangles.size());
    lay_out_lanes(known);
    find_moving();
    hang();
    for (const int t : changed) {
        triangles_[at(t)] = membrane_triangle(*model_, *sheet_, t, frame_of(mesh, t));
        pack(at(t));
    }
    weigh();
    return std::move(order->row_now);
}

/// Pattern and places of the triangles that stay.
void MembraneBody::renumber(const std::vector<std::uint8_t>& touched, const std::vector<int>& row_now) {
    std::vector<std::array<int, 2>> entries;
    for (const std::array<int, 3>& corners : sheet_->mesh.triangles) {
        for (const int node : corners) {
            for (std::size_t k = 0; k < 3 && touched[at(node)] != 0; ++k) {
                entries.push_back({row_of_[at(node)], row_of_[at(corners[k])]});
            }
        }
    }
    std::vector<std::uint8_t> changed(node_of_.size(), 0);
    for (int row = 0; row < rows(); ++row) {
        if (touched[at(node_of_[at(row)])] != 0) {
            changed[at(row)] = 1;
            entries.push_back({row, row});
        }
    }
    GrownPattern grown = grown_pattern(pattern_, rows(), row_now, changed, std::move(entries));
    pattern_ = std::move(grown.pattern);
    constexpr std::size_t each = std::size_t{membrane_kernel::places} * membrane_kernel::lanes;
    constexpr std::size_t corners = std::size_t{3} * membrane_kernel::lanes;
    for (std::size_t first = 0; first < index_.size(); first += each) {
        int* const group = index_.data() + first;
        for (std::size_t i = 0; i < corners; ++i) {
            group[i] = row_now[at(group[i])];
        }
        for (std::size_t i = corners; i < each; ++i) {
            group[i] = 9 * grown.slot_now[at(group[i] / 9)];
        }
    }
}

void MembraneBody::find_moving() {
    moves_.resize(node_of_.size());
    for (int row = 0; row < rows(); ++row) {
        moves_[at(row)] = is_fixed(*model_, *sheet_, node_of_[at(row)]) ? 0 : 1;
    }
}

/// Copies of a node share its spring.
void MembraneBody::hang() {
    const std::vector<int>& origin = sheet_->origin;
    const int known = static_cast<int>(model_->sheet->mesh.nodes.size());
    std::vector<int> first(at(known) + 1, 0);  // of the copies of each node of the model's sheet
    for (const int own : origin) {
        if (own >= 0) {
            ++first[at(own) + 1];
        }
    }
    for (int node = 0; node < known; ++node) {
        first[at(node) + 1] += first[at(node)];
    }
    std::vector<int> copies(at(first.back()));
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int node = 0; node < static_cast<int>(origin.size()); ++node) {
        if (origin[at(node)] >= 0) {
            copies[at(next[at(origin[at(node)])]++)] = node;
        }
    }
    springs_.clear();
    for (const NodeSpring& spring : model_->springs) {
        const int begin = first[at(spring.node)];
        const int end = first[at(spring.node) + 1];
        for (int i = begin; i < end; ++i) {
            springs_.push_back(spring);
            springs_.back().node = row_of_[at(copies[at(i)])];
            springs_.back().stiffness /= static_cast<double>(end - begin);
        }
    }
}

/// Corners by ascending row, so that their pairs are in the upper triangle.
std::array<std::size_t, 3> MembraneBody::by_rows(std::size_t triangle) const {
    const std::array<int, 3>& nodes = sheet_->mesh.triangles[triangle];
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return row_of_[at(nodes[a])] < row_of_[at(nodes[b])]; });
    return order;
}

/// Room for all triangles in the kernel's arrays, of which the first `known` are there; lanes without one add nothing.
void MembraneBody::lay_out_lanes(std::size_t known) {
    constexpr std::size_t lanes = membrane_kernel::lanes;
    groups_ = static_cast<int>((triangles_.size() + lanes - 1) / lanes);
    data_.resize(at(groups_ * membrane_kernel::numbers) * lanes, 0.0);
    index_.resize(at(groups_ * membrane_kernel::places) * lanes, 0);
    for (std::size_t t = known; t < at(groups_) * lanes; ++t) {
        double* const numbers = data_.data() + t / lanes * membrane_kernel::numbers * lanes + t % lanes;
        int* const places = index_.data() + t / lanes * membrane_kernel::places * lanes + t % lanes;
        for (std::size_t k = 0; k < membrane_kernel::numbers; ++k) {
            numbers[k * lanes] = 0.0;
        }
        for (std::size_t k = 0; k < membrane_kernel::places; ++k) {
            places[k * lanes] = k < 3 ? 0 : 9 * pattern_.blocks();  // dropped
        }
    }
}

/// Lays a triangle out for the kernel.
void MembraneBody::pack(std::size_t t) {
    const std::size_t group = t / membrane_kernel::lanes;
    const std::size_t lane = t % membrane_kernel::lanes;
    const std::array<std::size_t, 3> order = by_rows(t);
    pack_numbers(triangles_[t], order, data_.data() + group * membrane_kernel::numbers * membrane_kernel::lanes + lane);
    std::array<int, 3> rows{};
    for (std::size_t a = 0; a < 3; ++a) {
        rows[a] = row_of_[at(sheet_->mesh.triangles[t][order[a]])];
    }
    pack_places(rows, index_.data() + group * membrane_kernel::places * membrane_kernel::lanes + lane);
}

void MembraneBody::pack_numbers(const MembraneTriangle& triangle, const std::array<std::size_t, 3>& order, double* to) {
    const auto put = [&to](double value) {
        *to = value;
        to += membrane_kernel::lanes;
    };
    for (const std::size_t a : order) {
        put(triangle.gradient[a].x());
        put(triangle.gradient[a].y());
    }
    put(triangle.volume);
    for (Eigen::Index row = 0; row < 3; ++row) {
        for (Eigen::Index column = row; column < 3; ++column) {
            put(triangle.stiffness(row, column));
        }
    }
    put(triangle.rest);
}

/// Rows are short, so from one column to the next.
int MembraneBody::slot_right_of_diagonal(int row, int column) const {
    int slot = pattern_.diagonal[at(row)];
    while (pattern_.column[at(slot)] != column) {
        ++slot;
    }
    return slot;
}

void MembraneBody::pack_places(const std::array<int, 3>& rows, int* to) const {
    const auto put = [&to](int value) {
        *to = value;
        to += membrane_kernel::lanes;
    };
    for (const int row : rows) {
        put(row);
    }
    for (std::size_t b = 0; b < 3; ++b) {
        for (std::size_t a = 0; a <= b; ++a) {
            const bool moving = moves_[at(rows[a])] != 0 && moves_[at(rows[b])] != 0;
            put(9 * (moving ? slot_right_of_diagonal(rows[a], rows[b]) : pattern_.blocks()));
        }
    }
}

void MembraneBody::weigh() {
    mass_.inertia.assign(node_of_.size(), 0.0);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        for (const int node : sheet_->mesh.triangles[t]) {
            mass_.inertia[at(row_of_[at(node)])] += model_->density * triangles_[t].volume / 3.0;
        }
    }
    const double share = 1.0 - model_->buoyancy_density / model_->density;
    mass_.weight = mass_.inertia;
    for (double& weight : mass_.weight) {
        weight *= share;
    }
}

double MembraneBody::springs_on_support(const std::vector<Vec3>& position) const {
    double sum = 0.0;
    for (const NodeSpring& spring : springs_) {
        sum -= spring.on_support ? pull_of(spring, lift_, position[at(node_of_[at(spring.node)])]).force.z() : 0.0;
    }
    return sum;
}

membrane_kernel::Task MembraneBody::task(const std::vector<double>& position, std::vector<double>& force) const {
    force.assign(3 * node_of_.size() + 1, 0.0);
    membrane_kernel::Task task;
    task.data = data_.data();
    task.index = index_.data();
    task.groups = groups_;
    task.position = position.data();
    task.force = force.data();
    return task;
}

void MembraneBody::forces(const std::vector<double>& position, std::vector<double>& force) {
    kernel_->assemble(task(position, force));
    for (const NodeSpring& spring : springs_) {
        const std::size_t row = at(spring.node);
        Eigen::Map<Vec3>(force.data() + 3 * row) +=
            pull_of(spring, lift_, Eigen::Map<const Vec3>(position.data() + 3 * row)).force;
    }
}

void MembraneBody::forces_and_stiffness(const std::vector<double>& position, Mode mode, double scale,
                                        std::vector<double>& force, BlockValues& stiffness) {
    clear_upper(pattern_, stiffness);
    membrane_kernel::Task task = this->task(position, force);
    task.mode = mode == Mode::consistent ? membrane_kernel::Mode::consistent : membrane_kernel::Mode::definite;
    task.scale = scale;
    task.stiffness = stiffness.data();
    kernel_->assemble(task);
    for (const NodeSpring& spring : springs_) {
        const int row = spring.node;
        const SpringPull pull = pull_of(spring, lift_, Eigen::Map<const Vec3>(position.data() + 3 * at(row)));
        Eigen::Map<Vec3>(force.data() + 3 * at(row)) += pull.force;
        if (moves_[at(row)] != 0) {
            add_block(stiffness, pattern_.diagonal[at(row)], scale * pull.stiffness);
        }
    }
}

}  // namespace rhexis
