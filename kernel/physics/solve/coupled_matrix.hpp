// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the matrix of an implicit step, a solid's nodes and the rigid bodies that contacts tie to them.
//
//   [ A  C ] [ solid ]      A: sparse 3x3 blocks; C: 3x6 blocks at the touched nodes; B: dense, 6 rows per body
//   [ C' B ] [ rigid ]
#pragma once

#include <span>
#include <vector>

#include "math/block_matrix.hpp"
#include "math/linear_kernel.hpp"
#include "physics/solve/contact_term.hpp"

namespace rhexis {

using Mat36 = Eigen::Matrix<double, 3, 6>;

/// The movement of a body that a point at `arm` from its centre sees: J (db, dtheta) = db + dtheta x arm.
Mat36 rigid_jacobian(const Vec3& arm);

class CoupledMatrix {
public:
    /// The pattern must outlive this.
    CoupledMatrix(const BlockPattern& pattern, const linear_kernel::Kernel& kernel);

    /// Takes over another pattern, in the memory that is there; without contacts, the solid's values to be filled.
    void follow(const BlockPattern& pattern);

    /// Numbers in a vector: three per row, then six per body.
    [[nodiscard]] std::size_t size() const { return 3 * nodes_ + static_cast<std::size_t>(rigid_.rows()); }
    [[nodiscard]] std::size_t solid_size() const { return 3 * nodes_; }
    [[nodiscard]] const BlockPattern& pattern() const { return *pattern_; }

    /// The solid's part, to be filled by the caller after clear().
    [[nodiscard]] BlockValues& solid() { return solid_; }
    [[nodiscard]] const BlockValues& solid() const { return solid_; }
    [[nodiscard]] MatX& rigid() { return rigid_; }
    [[nodiscard]] const MatX& rigid() const { return rigid_; }

    /// Forgets contacts and sets the number of bodies; the solid's values stay.
    void clear_coupling(int bodies);
    /// Adds scale times the stiffness of a contact, whose nodes are rows here. Rows with moves[i] == 0 are held.
    void add(const ContactTerm& contact, double scale, std::span<const std::uint8_t> moves);

    void multiply(std::span<const double> x, std::span<double> y) const;
    /// The same of linear_kernel::many vectors side by side.
    void multiply_many(std::span<const double> x, std::span<double> y) const;
    [[nodiscard]] const linear_kernel::Kernel& kernel() const { return *kernel_; }
    /// A with every link between nodes that share no element moved to the diagonal: no less than A, and in its pattern.
    [[nodiscard]] BlockValues solid_within_pattern() const;
    [[nodiscard]] bool has_links() const { return !links_.empty(); }
    /// The columns of C, dense.
    [[nodiscard]] MatX coupling() const;

private:
    struct Tie {
        int node;
        int body;
        Mat36 block;
    };
    struct Link {  ///< nodes that share a contact but no element
        int a;
        int b;
        Mat3 block;
        Mat3 bound;  ///< of a: with that of b, on their diagonals, no less than the blocks of both
    };
    void add_shares(const ContactTerm& contact, const Mat3& stiffness, std::span<const std::uint8_t> moves);
    void add_pair(int a, int b, const Mat3& block, const Mat3& bound);
    void add_tie(int node, int body, const Mat36& block);
    template <int vectors>
    void add_coupling(std::span<const double> x, std::span<double> y) const;
    [[nodiscard]] linear_kernel::Blocks blocks() const;

    const BlockPattern* pattern_;
    const linear_kernel::Kernel* kernel_;
    std::size_t nodes_;
    BlockValues solid_;
    MatX rigid_;
    std::vector<Tie> ties_;
    std::vector<int> tie_of_;  ///< per body and node: index into ties_, or -1
    std::vector<Link> links_;
};

}  // namespace rhexis
