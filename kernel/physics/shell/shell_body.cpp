// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_body.hpp"

#include <algorithm>
#include <numeric>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "math/cholesky.hpp"
#include "math/rotation.hpp"

namespace rhexis {
namespace {

using elastic_kernel::Mode;
using shell_kernel::data_length;
using shell_kernel::index_length;
using shell_kernel::lanes;

BlockPattern pattern_by(const TriMesh& mesh, std::span<const std::array<int, 2>> links, const std::vector<int>& rank_of,
                        int rows_each) {
    std::vector<int> first{0};
    std::vector<int> rows;
    const auto add = [&](std::span<const int> nodes) {
        for (const int node : nodes) {
            for (int k = 0; k < rows_each; ++k) {
                rows.push_back(rows_each * rank_of[at(node)] + k);
            }
        }
        first.push_back(static_cast<int>(rows.size()));
    };
    for (const std::array<int, 3>& triangle : mesh.triangles) {
        add(triangle);
    }
    for (const std::array<int, 2>& link : links) {
        add(link);
    }
    return block_pattern(rows_each * static_cast<int>(mesh.nodes.size()), first, rows);
}

/// Corners of a triangle by ascending rank, so that pairs of them are in the upper triangle of the matrix.
std::array<int, 3> by_rank(const std::array<int, 3>& corner, const std::vector<int>& rank_of) {
    std::array<int, 3> local{0, 1, 2};
    std::sort(local.begin(), local.end(),
              [&](int a, int b) { return rank_of[at(corner[at(a)])] < rank_of[at(corner[at(b)])]; });
    return local;
}

/// The numbers of a triangle as the kernel reads them; stiff: else without any stiffness, to fill up a group.
constexpr int stiffness_place = 21;  // of the first number that stiffness multiplies
static_assert(shell_kernel::natural_length == shell_deformation_length);

void fill_data(const ShellTriangle& triangle, const std::array<int, 3>& local, bool stiff, double* to) {
    const PlaneCorners gradient = corner_gradients(triangle.corner);
    const auto put = [&to](double value) {
        *to = value;
        to += lanes;
    };
    for (const PlaneCorners* const of : {&triangle.corner, &gradient}) {
        for (const int a : local) {
            put((*of)[at(a)].x());
            put((*of)[at(a)].y());
        }
    }
    for (int i = 0; i < 9; ++i) {
        put(triangle.frame(i / 3, i % 3));
    }
    const double share = stiff ? 1.0 : 0.0;
    for (const Mat9* const of : {&triangle.membrane, &triangle.bending}) {
        for (int i = 0; i < 9; ++i) {
            for (int j = 0; j <= i; ++j) {
                put(share * (*of)(3 * local[at(i / 3)] + i % 3, 3 * local[at(j / 3)] + j % 3));
            }
        }
    }
    put(share * triangle.tension(0, 0));
    put(share * triangle.tension(0, 1));
    put(share * triangle.tension(2, 2));
    for (const int a : local) {
        for (int i = 0; i < 5; ++i) {
            put(triangle.natural[5 * a + i]);
        }
    }
}

}  // namespace

ShellBody::ShellBody(const ShellModel& model, const shell_kernel::Kernel& kernel, ShellTriangleMaker maker,
                     std::span<const std::array<int, 2>> links)
    : ElasticBody(model.damping_mass, model.damping_stiffness), model_(&model), kernel_(&kernel) {
    number_rows(links);
    hold();
    weigh();
    fill_groups(maker);
    reference_.assign(model.mesh.nodes.size(), Quat::Identity());
    rotation_.resize(9 * model.mesh.nodes.size());
    buffer_.resize(at(lanes * shell_kernel::buffer_length));
}

void ShellBody::number_rows(std::span<const std::array<int, 2>> links) {
    const TriMesh& mesh = model_->mesh;
    const int nodes = static_cast<int>(mesh.nodes.size());
    std::vector<int> same(at(nodes));
    std::iota(same.begin(), same.end(), 0);
    const std::vector<int> order = elimination_order(pattern_by(mesh, links, same, 1));
    node_of_.resize(2 * at(nodes));
    row_of_.resize(2 * at(nodes));
    std::vector<int> rank_of(at(nodes));
    for (int rank = 0; rank < nodes; ++rank) {
        const int node = order[at(rank)];
        rank_of[at(node)] = rank;
        for (int k = 0; k < 2; ++k) {
            node_of_[at(2 * rank + k)] = 2 * node + k;
            row_of_[at(2 * node + k)] = 2 * rank + k;
        }
    }
    pattern_ = pattern_by(mesh, links, rank_of, 2);
}

void ShellBody::hold() {
    free_.assign(3 * node_of_.size(), 1);
    for (const ShellHold& hold : model_->holds) {
        for (int i = 0; i < 6; ++i) {
            free_[6 * at(rank(hold.node)) + at(i)] = hold.held[at(i)] ? 0 : 1;
        }
    }
    moves_.resize(node_of_.size());
    for (std::size_t row = 0; row < moves_.size(); ++row) {
        moves_[row] = (free_[3 * row] | free_[3 * row + 1] | free_[3 * row + 2]) != 0 ? 1 : 0;
    }
    for (int i = 0; i < pattern_.rows(); ++i) {
        for (int slot = pattern_.diagonal[at(i)]; slot < pattern_.first[at(i) + 1]; ++slot) {
            for (int c = 0; c < 3; ++c) {
                for (int r = 0; r < 3; ++r) {
                    if (free_[at(3 * i + r)] == 0 || free_[at(3 * pattern_.column[at(slot)] + c)] == 0) {
                        held_entries_.push_back(9 * slot + 3 * c + r);
                    }
                }
            }
        }
    }
}

/// A third of each triangle at its corners; they resist turning as the plate's own thickness does, about every axis.
void ShellBody::weigh() {
    const TriMesh& mesh = model_->mesh;
    mass_.inertia.assign(node_of_.size(), 0.0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::array<int, 3>& n = mesh.triangles[t];
        const double h = model_->thickness[t];
        const double third = model_->material.density * h / 3.0 *
                             triangle_area(mesh.nodes[at(n[0])], mesh.nodes[at(n[1])], mesh.nodes[at(n[2])]);
        for (const int node : n) {
            mass_.inertia[at(2 * rank(node))] += third;
            mass_.inertia[at(2 * rank(node) + 1)] += third * h * h / 12.0;
        }
    }
    const double weight = 1.0 - model_->fluid_density / model_->material.density;
    drag();
    mass_.weight = mass_.inertia;
    for (std::size_t row = 0; row < mass_.weight.size(); row += 2) {
        mass_.weight[row] *= weight;
        mass_.weight[row + 1] = 0.0;
    }
}

/// Of fluid at rest on movements, a third of each triangle at its corners.
void ShellBody::drag() {
    if (model_->drag == 0.0) {
        return;
    }
    const TriMesh& mesh = model_->mesh;
    drag_.assign(node_of_.size(), 0.0);
    for (const std::array<int, 3>& n : mesh.triangles) {
        const double third =
            model_->drag / 3.0 * triangle_area(mesh.nodes[at(n[0])], mesh.nodes[at(n[1])], mesh.nodes[at(n[2])]);
        for (const int node : n) {
            drag_[at(2 * rank(node))] += third;
        }
    }
}

void ShellBody::fill_groups(ShellTriangleMaker maker) {
    const TriMesh& mesh = model_->mesh;
    const int count = static_cast<int>(mesh.triangles.size());
    const int groups = (count + lanes - 1) / lanes;
    data_.resize(at(groups * lanes * data_length));
    index_.resize(at(groups * lanes * index_length));
    std::vector<int> rank_of(mesh.nodes.size());
    for (std::size_t n = 0; n < rank_of.size(); ++n) {
        rank_of[n] = rank(static_cast<int>(n));
    }
    for (int i = 0; i < groups * lanes; ++i) {
        const int t = std::min(i, count - 1);
        const std::array<int, 3>& corner = mesh.triangles[at(t)];
        const std::array<int, 3> local = by_rank(corner, rank_of);
        const ShellTriangle triangle =
            maker({mesh.nodes[at(corner[0])], mesh.nodes[at(corner[1])], mesh.nodes[at(corner[2])]},
                  model_->thickness[at(t)], model_->material.young_modulus, model_->material.poisson_ratio);
        if (i < count) {
            local_.push_back(local);
        }
        fill_data(triangle, local, i < count, data_.data() + at(i / lanes * lanes * data_length + i % lanes));
        int* to = index_.data() + at(i / lanes * lanes * index_length + i % lanes);
        for (const int a : local) {
            *to = rank_of[at(corner[at(a)])];
            to += lanes;
        }
        for (int a = 0; a < 6; ++a) {
            for (int b = a; b < 6; ++b, to += lanes) {
                const int row = 2 * rank_of[at(corner[at(local[at(a / 2)])])] + a % 2;
                const int column = 2 * rank_of[at(corner[at(local[at(b / 2)])])] + b % 2;
                *to = 9 * (i < count ? pattern_.slot(row, column) : pattern_.blocks());
                if (i < count && (row % 2 == 1 || column % 2 == 1)) {
                    turned_blocks_.push_back({*to / 9, row % 2 == 1 ? row / 2 : -1, column % 2 == 1 ? column / 2 : -1});
                }
            }
        }
    }
    const auto by_slot = [](const TurnedBlock& a, const TurnedBlock& b) { return a.slot < b.slot; };
    const auto same = [](const TurnedBlock& a, const TurnedBlock& b) { return a.slot == b.slot; };
    std::sort(turned_blocks_.begin(), turned_blocks_.end(), by_slot);
    turned_blocks_.erase(std::unique(turned_blocks_.begin(), turned_blocks_.end(), same), turned_blocks_.end());
}

void ShellBody::set_reference(std::span<const Quat> rotation) {
    RHEXIS_ASSERT(rotation.size() == reference_.size());
    for (std::size_t n = 0; n < rotation.size(); ++n) {
        reference_[at(rank(static_cast<int>(n)))] = rotation[n];
    }
}

void ShellBody::turn(const std::vector<double>& position) {
    turned_ = false;
    for (std::size_t k = 0; k < reference_.size(); ++k) {
        const Vec3 z(position[6 * k + 3], position[6 * k + 4], position[6 * k + 5]);
        Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> own(rotation_.data() + 9 * k);
        own = reference_[k].toRotationMatrix();
        if (z != Vec3::Zero()) {
            turned_ = true;
            own = (cayley(z) * own).eval();
        }
    }
}

shell_kernel::Task ShellBody::task_at(const std::vector<double>& position) {
    turn(position);
    shell_kernel::Task task;
    task.data = data_.data();
    task.index = index_.data();
    task.groups = static_cast<int>(data_.size()) / (lanes * data_length);
    task.position = position.data();
    task.rotation = rotation_.data();
    task.buffer = buffer_.data();
    return task;
}

void ShellBody::run(shell_kernel::Mode mode, const std::vector<double>& position, double scale,
                    std::vector<double>& force, BlockValues* stiffness) {
    shell_kernel::Task task = task_at(position);
    force.assign(3 * node_of_.size() + 1, 0.0);
    task.mode = mode;
    task.scale = scale;
    task.force = force.data();
    task.stiffness = stiffness != nullptr ? stiffness->data() : nullptr;
    task.predicted = predicting_ ? predicted_.data() : nullptr;
    kernel_->assemble(task);
}

namespace {

/// Place of a corner's first number in 15 numbers of a triangle by groups.
std::size_t in_groups(std::size_t triangle, int corner, int length, int first) {
    const std::size_t group = triangle / lanes;
    return at(lanes) * (group * at(length) + at(first + 5 * corner)) + triangle % lanes;
}

}  // namespace

void ShellBody::deformation(const std::vector<double>& position, std::vector<double>& result) {
    shell_kernel::Task task = task_at(position);
    deformation_.resize(at(task.groups * lanes * shell_kernel::natural_length));
    task.mode = shell_kernel::Mode::deformation;
    task.deformation = deformation_.data();
    kernel_->assemble(task);
    result.resize(at(shell_deformation_length) * local_.size());
    for (std::size_t t = 0; t < local_.size(); ++t) {
        for (int a = 0; a < 3; ++a) {
            const double* const from = deformation_.data() + in_groups(t, a, shell_kernel::natural_length, 0);
            double* const to = result.data() + at(shell_deformation_length) * t + at(5 * local_[t][at(a)]);
            for (int i = 0; i < 5; ++i) {
                to[i] = from[lanes * i];
            }
        }
    }
}

/// From what they were made as, so that the bits do not depend on what they were before.
void ShellBody::set_natural(double stiffness, const std::vector<double>& natural) {
    RHEXIS_ASSERT(natural.size() == at(shell_deformation_length) * local_.size());
    if (elastic_.empty()) {
        elastic_ = data_;
    }
    for (std::size_t i = 0; stiffness != stiffness_ && i < data_.size(); ++i) {
        const int place = static_cast<int>(i) / lanes % data_length;
        if (place >= stiffness_place && place < shell_kernel::natural_place) {
            data_[i] = stiffness * elastic_[i];
        }
    }
    stiffness_ = stiffness;
    for (std::size_t t = 0; t < local_.size(); ++t) {
        for (int a = 0; a < 3; ++a) {
            const double* const from = natural.data() + at(shell_deformation_length) * t + at(5 * local_[t][at(a)]);
            double* const to = data_.data() + in_groups(t, a, data_length, shell_kernel::natural_place);
            for (int i = 0; i < 5; ++i) {
                to[lanes * i] = from[i];
            }
        }
    }
}

void ShellBody::predict(const std::vector<double>& position, const std::vector<double>& step) {
    shell_kernel::Task task = task_at(position);
    predicted_.resize(at(task.groups * lanes * shell_kernel::predicted_length));
    spins_ = step;
    for (std::size_t k = 0; turned_ && k < reference_.size(); ++k) {
        const Vec3 z(position[6 * k + 3], position[6 * k + 4], position[6 * k + 5]);
        Eigen::Map<Vec3> turn(spins_.data() + 6 * k + 3);
        turn = (spin_of_turn(z) * turn).eval();
    }
    task.mode = shell_kernel::Mode::predict;
    task.predicted = predicted_.data();
    task.step = spins_.data();
    kernel_->assemble(task);
    predicting_ = true;
}

/// From moments per spin to moments per turn.
void ShellBody::forces_to_turns(const std::vector<double>& position, std::vector<double>& force) const {
    for (std::size_t k = 0; turned_ && k < reference_.size(); ++k) {
        const Vec3 z(position[6 * k + 3], position[6 * k + 4], position[6 * k + 5]);
        Eigen::Map<Vec3> moment(force.data() + 6 * k + 3);
        moment = (spin_of_turn(z).transpose() * moment).eval();
    }
}

/// The same of the stiffness, whose upper triangle is there. With T = spin_of_turn, s = 1 + |z|^2 / 4 and m the moment
/// per spin, the turn z adds the symmetric part of d(T' m)/dz: -(T' m z' + z m' T) / (4 s). force: per turn.
void ShellBody::to_turns(const std::vector<double>& position, const std::vector<double>& force, double scale,
                         BlockValues& stiffness) {
    rate_.resize(reference_.size());
    for (std::size_t k = 0; k < rate_.size(); ++k) {
        rate_[k] = spin_of_turn(Vec3(position[6 * k + 3], position[6 * k + 4], position[6 * k + 5]));
    }
    for (const TurnedBlock& turned : turned_blocks_) {
        Eigen::Map<Mat3> block(stiffness.data() + 9 * at(turned.slot));
        if (turned.row >= 0) {
            block = (rate_[at(turned.row)].transpose() * block).eval();
        }
        if (turned.column >= 0) {
            block = (block * rate_[at(turned.column)]).eval();
        }
        if (turned.row >= 0 && turned.row == turned.column) {
            const std::size_t k = at(turned.row);
            const Vec3 z(position[6 * k + 3], position[6 * k + 4], position[6 * k + 5]);
            const Vec3 moment = -Eigen::Map<const Vec3>(force.data() + 6 * k + 3);
            const double share = -0.25 * scale / (1.0 + 0.25 * z.squaredNorm());
            block += share * (moment * z.transpose() + z * moment.transpose());
        }
    }
}

void ShellBody::forces_everywhere(const std::vector<double>& position, std::vector<double>& force) {
    run(shell_kernel::Mode::forces, position, 1.0, force, nullptr);
    forces_to_turns(position, force);
}

void ShellBody::forces(const std::vector<double>& position, std::vector<double>& force) {
    forces_everywhere(position, force);
    for (std::size_t i = 0; i < free_.size(); ++i) {
        force[i] = free_[i] != 0 ? force[i] : 0.0;
    }
}

void ShellBody::forces_and_stiffness(const std::vector<double>& position, Mode mode, double scale,
                                     std::vector<double>& force, BlockValues& stiffness) {
    clear_upper(pattern_, stiffness);
    const bool consistent = mode == Mode::consistent;
    run(consistent ? shell_kernel::Mode::consistent : shell_kernel::Mode::definite, position, scale, force, &stiffness);
    forces_to_turns(position, force);
    if (turned_) {
        to_turns(position, force, consistent ? scale : 0.0, stiffness);
    }
    for (const int entry : held_entries_) {
        stiffness[at(entry)] = 0.0;
    }
    for (std::size_t i = 0; i < free_.size(); ++i) {
        force[i] = free_[i] != 0 ? force[i] : 0.0;
    }
}

}  // namespace rhexis
