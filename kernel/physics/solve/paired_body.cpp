// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solve/paired_body.hpp"

#include <algorithm>
#include <utility>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "math/cholesky.hpp"

namespace rhexis {
namespace {

/// Pairs of rows that have a block, each once.
class Pairs {
public:
    void add(int a, int b) {
        rows_.push_back(a);
        rows_.push_back(b);
        first_.push_back(static_cast<int>(rows_.size()));
    }
    [[nodiscard]] BlockPattern pattern(int rows) const { return block_pattern(rows, first_, rows_); }
    [[nodiscard]] BlockPattern pattern(const std::vector<int>& row_of) const {
        std::vector<int> renumbered;
        for (const int row : rows_) {
            renumbered.push_back(row_of[at(row)]);
        }
        return block_pattern(static_cast<int>(row_of.size()), first_, renumbered);
    }

private:
    std::vector<int> first_{0};
    std::vector<int> rows_;
};

}  // namespace

PairedBody::PairedBody(std::unique_ptr<ElasticBody> first, std::unique_ptr<ElasticBody> second,
                       std::span<const std::array<int, 2>> ties)
    : ElasticBody(0.0, 0.0) {
    parts_[0].body = std::move(first);
    parts_[1].body = std::move(second);
    number_rows(ties);
    weigh();
}

void PairedBody::number_rows(std::span<const std::array<int, 2>> ties) {
    const int before = parts_[0].body->rows();
    const int rows = before + parts_[1].body->rows();
    Pairs pairs;
    for (std::size_t k = 0; k < 2; ++k) {
        const BlockPattern& own = parts_[k].body->pattern();
        const int offset = k == 0 ? 0 : before;
        for (int i = 0; i < own.rows(); ++i) {
            for (int slot = own.diagonal[at(i)]; slot < own.first[at(i) + 1]; ++slot) {
                pairs.add(offset + i, offset + own.column[at(slot)]);
            }
        }
    }
    for (const std::array<int, 2>& tie : ties) {
        pairs.add(parts_[0].body->row_of()[at(tie[0])], before + parts_[1].body->row_of()[at(tie[1])]);
    }
    const std::vector<int> order = elimination_order(pairs.pattern(rows));
    std::vector<int> row_of(order.size());
    for (int i = 0; i < rows; ++i) {
        row_of[at(order[at(i)])] = i;
    }
    pattern_ = pairs.pattern(row_of);
    node_of_.resize(at(rows));
    row_of_.resize(at(rows));
    for (std::size_t k = 0; k < 2; ++k) {
        Part& part = parts_[k];
        const int offset = k == 0 ? 0 : before;
        for (int i = 0; i < part.body->rows(); ++i) {
            part.row.push_back(row_of[at(offset + i)]);
            const int node = offset + part.body->node_of()[at(i)];
            node_of_[at(part.row.back())] = node;
            row_of_[at(node)] = part.row.back();
        }
        const BlockPattern& own = part.body->pattern();
        for (int i = 0; i < own.rows(); ++i) {
            for (int slot = own.diagonal[at(i)]; slot < own.first[at(i) + 1]; ++slot) {
                const int a = part.row[at(i)];
                const int b = part.row[at(own.column[at(slot)])];
                part.moves.push_back({slot, pattern_.slot(std::min(a, b), std::max(a, b)), a > b});
            }
        }
        part.stiffness = zero_values(own);
    }
}

/// Damping of the mass is a drag of each row.
void PairedBody::weigh() {
    const std::size_t rows = node_of_.size();
    moves_.resize(rows);
    mass_.inertia.resize(rows);
    mass_.weight.resize(rows);
    drag_.assign(rows, 0.0);
    for (const Part& part : parts_) {
        const ElasticBody& body = *part.body;
        RHEXIS_ASSERT(body.damping_stiffness() == 0.0);
        for (std::size_t i = 0; i < part.row.size(); ++i) {
            const std::size_t row = at(part.row[i]);
            moves_[row] = body.moves()[i];
            mass_.inertia[row] = body.mass().inertia[i];
            mass_.weight[row] = body.mass().weight[i];
            drag_[row] = body.damping_mass() * body.mass().inertia[i];
            drag_[row] += body.row_drag().empty() ? 0.0 : body.row_drag()[i];
        }
    }
}

/// The numbers of a part's rows out of those of all.
void PairedBody::take(const std::vector<double>& all, const Part& part, std::vector<double>& own) {
    own.assign(3 * part.row.size() + 1, 0.0);
    for (std::size_t i = 0; i < part.row.size(); ++i) {
        Eigen::Map<Vec3>(own.data() + 3 * i) = Eigen::Map<const Vec3>(all.data() + 3 * at(part.row[i]));
    }
}

void PairedBody::put_forces(std::vector<double>& force) const {
    force.assign(3 * node_of_.size() + 1, 0.0);
    for (const Part& part : parts_) {
        for (std::size_t i = 0; i < part.row.size(); ++i) {
            Eigen::Map<Vec3>(force.data() + 3 * at(part.row[i])) = Eigen::Map<const Vec3>(part.force.data() + 3 * i);
        }
    }
}

void PairedBody::forces(const std::vector<double>& position, std::vector<double>& force) {
    for (Part& part : parts_) {
        take(position, part, part.position);
        part.body->forces(part.position, part.force);
    }
    put_forces(force);
}

void PairedBody::forces_and_stiffness(const std::vector<double>& position, elastic_kernel::Mode mode, double scale,
                                      std::vector<double>& force, BlockValues& stiffness) {
    clear_upper(pattern_, stiffness);
    for (Part& part : parts_) {
        take(position, part, part.position);
        part.body->forces_and_stiffness(part.position, mode, scale, part.force, part.stiffness);
        for (const Move& move : part.moves) {
            const Eigen::Map<const Mat3> own(part.stiffness.data() + 9 * at(move.from));
            Eigen::Map<Mat3> to(stiffness.data() + 9 * at(move.to));
            if (move.turned) {
                to = own.transpose();
            } else {
                to = own;
            }
        }
    }
    put_forces(force);
}

void PairedBody::predict(const std::vector<double>& position, const std::vector<double>& step) {
    std::vector<double> own_step;
    for (Part& part : parts_) {
        take(position, part, part.position);
        take(step, part, own_step);
        part.body->predict(part.position, own_step);
    }
}

void PairedBody::forget_prediction() {
    for (Part& part : parts_) {
        part.body->forget_prediction();
    }
}

}  // namespace rhexis
