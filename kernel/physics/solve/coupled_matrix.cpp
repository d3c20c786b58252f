// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solve/coupled_matrix.hpp"

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "base/index.hpp"

namespace rhexis {
Mat36 rigid_jacobian(const Vec3& arm) {
    Mat36 result;
    result << 1.0, 0.0, 0.0, 0.0, arm.z(), -arm.y(),  //
        0.0, 1.0, 0.0, -arm.z(), 0.0, arm.x(),        //
        0.0, 0.0, 1.0, arm.y(), -arm.x(), 0.0;
    return result;
}

CoupledMatrix::CoupledMatrix(const BlockPattern& pattern, const linear_kernel::Kernel& kernel)
    : pattern_(&pattern), kernel_(&kernel), nodes_(at(pattern.rows())), solid_(zero_values(pattern)) {}

void CoupledMatrix::follow(const BlockPattern& pattern) {
    pattern_ = &pattern;
    nodes_ = at(pattern.rows());
    solid_.resize(values_of(pattern));
    rigid_.resize(0, 0);
    ties_.clear();
    tie_of_.clear();
    links_.clear();
}

void CoupledMatrix::clear_coupling(int bodies) {
    rigid_ = MatX::Zero(6 * bodies, 6 * bodies);
    links_.clear();
    if (tie_of_.size() != at(bodies) * nodes_) {
        tie_of_.assign(at(bodies) * nodes_, -1);
    } else {
        for (const Tie& tie : ties_) {
            tie_of_[at(tie.body) * nodes_ + at(tie.node)] = -1;
        }
    }
    ties_.clear();
}

void CoupledMatrix::add_pair(int a, int b, const Mat3& block, const Mat3& bound) {
    const int slot = pattern_->slot(a, b);
    if (slot >= 0) {
        add_block(solid_, slot, block);
    } else {
        links_.push_back({a, b, block, bound});
    }
}

void CoupledMatrix::add_tie(int node, int body, const Mat36& block) {
    int& index = tie_of_[at(body) * nodes_ + at(node)];
    if (index < 0) {
        index = static_cast<int>(ties_.size());
        ties_.push_back({node, body, Mat36::Zero()});
    }
    ties_[at(index)].block += block;
}

void CoupledMatrix::add(const ContactTerm& contact, double scale, std::span<const std::uint8_t> moves) {
    const Mat3 stiffness = scale * contact.stiffness;
    RHEXIS_ASSERT(6 * (contact.body + 1) <= rigid_.rows());
    const Mat36 jacobian = rigid_jacobian(contact.arm);
    if (contact.body >= 0) {
        rigid_.block<6, 6>(6 * contact.body, 6 * contact.body) += jacobian.transpose() * stiffness * jacobian;
    }
    for (std::size_t a = 0; a < 3; ++a) {
        const int node = contact.nodes[a];
        if (node < 0 || moves[at(node)] == 0) {
            continue;
        }
        for (std::size_t b = 0; b < 3; ++b) {
            const int other = contact.nodes[b];
            if (other >= 0 && moves[at(other)] != 0) {
                const double weight = contact.weights[a] * contact.weights[b];
                add_pair(node, other, weight * stiffness, std::abs(weight) * stiffness);
            }
        }
        if (contact.body >= 0) {
            add_tie(node, contact.body, -contact.weights[a] * (stiffness * jacobian));
        }
    }
    add_shares(contact, stiffness, moves);
}

/// Of what is in `more`, among itself and with the nodes.
void CoupledMatrix::add_shares(const ContactTerm& contact, const Mat3& stiffness, std::span<const std::uint8_t> moves) {
    RHEXIS_ASSERT(contact.more.empty() || contact.body < 0);
    for (const ContactShare& own : contact.more) {
        if (moves[at(own.node)] == 0) {
            continue;
        }
        const Mat3 pulled = own.share.transpose() * stiffness;
        const Mat3 alone = pulled * own.share;
        for (std::size_t k = 0; k < 3; ++k) {
            const int node = contact.nodes[k];
            if (node >= 0 && moves[at(node)] != 0) {
                const double weight = std::abs(contact.weights[k]);
                add_pair(own.node, node, contact.weights[k] * pulled, weight * alone);
                add_pair(node, own.node, contact.weights[k] * pulled.transpose(), weight * stiffness);
            }
        }
        for (const ContactShare& with : contact.more) {
            if (moves[at(with.node)] != 0) {
                add_pair(own.node, with.node, pulled * with.share, alone);
            }
        }
    }
}

linear_kernel::Blocks CoupledMatrix::blocks() const {
    return {pattern_->rows(), pattern_->first.data(), pattern_->column.data(), solid_.data()};
}

/// y += of links and ties, and the bodies' own; vectors side by side are columns' rows.
template <int vectors>
void CoupledMatrix::add_coupling(std::span<const double> x, std::span<double> y) const {
    using Columns = Eigen::Matrix<double, vectors, Eigen::Dynamic>;
    const Eigen::Index n = static_cast<Eigen::Index>(size());
    const Eigen::Map<const Columns> in(x.data(), vectors, n);
    Eigen::Map<Columns> out(y.data(), vectors, n);
    for (const Link& link : links_) {
        out.template middleCols<3>(3 * link.a) += in.template middleCols<3>(3 * link.b) * link.block.transpose();
    }
    out.rightCols(rigid_.rows()) = in.rightCols(rigid_.rows()) * rigid_;
    const Eigen::Index first = n - rigid_.rows();
    for (const Tie& tie : ties_) {
        const Eigen::Index body = first + 6 * tie.body;
        out.template middleCols<3>(3 * tie.node) += in.template middleCols<6>(body) * tie.block.transpose();
        out.template middleCols<6>(body) += in.template middleCols<3>(3 * tie.node) * tie.block;
    }
}

void CoupledMatrix::multiply(std::span<const double> x, std::span<double> y) const {
    kernel_->multiply(blocks(), x.data(), y.data());
    add_coupling<1>(x, y);
}

void CoupledMatrix::multiply_many(std::span<const double> x, std::span<double> y) const {
    kernel_->multiply_many(blocks(), x.data(), y.data());
    add_coupling<linear_kernel::many>(x, y);
}

BlockValues CoupledMatrix::solid_within_pattern() const {
    BlockValues result = solid_;
    for (const Link& link : links_) {
        add_block(result, pattern_->diagonal[at(link.a)], link.bound);
    }
    return result;
}

MatX CoupledMatrix::coupling() const {
    MatX result = MatX::Zero(static_cast<Eigen::Index>(solid_size()), rigid_.rows());
    for (const Tie& tie : ties_) {
        result.block<3, 6>(3 * tie.node, 6 * tie.body) += tie.block;
    }
    return result;
}

}  // namespace rhexis
