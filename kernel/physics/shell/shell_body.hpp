// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: mass, elastic forces and stiffness of a thin shell, by pairs of rows: its nodes in the order of
// elimination, for each the row of its movement, then the row of its turn.
//
// To a solver the body has twice as many points as the shell has nodes: point 2 n is where node n is, point 2 n + 1 the
// turn z of node n since a reference that the solver sets: Q = cayley(z) Q_ref. Nothing is singular before |z| is
// infinite, half a turn.
#pragma once

#include <span>

#include "energy/shell_triangle.hpp"
#include "flow/shell.hpp"
#include "physics/shell/shell_kernel.hpp"
#include "physics/solve/elastic_body.hpp"

namespace rhexis {

class ShellBody final : public ElasticBody {
public:
    /// The model must outlive this and pass check_shell. links: pairs of nodes that contact may tie, though no triangle
    /// does: they are in the pattern too.
    ShellBody(const ShellModel& model, const shell_kernel::Kernel& kernel, ShellTriangleMaker maker = shell_triangle,
              std::span<const std::array<int, 2>> links = {});

    /// Turns count from here; by nodes.
    void set_reference(std::span<const Quat> rotation);

    /// Of every triangle at positions, 15 numbers each, corners and triangles in the mesh's order.
    void deformation(const std::vector<double>& position, std::vector<double>& result);

    /// Stiffness is from now on `stiffness` times that of the model's material, and free of stress is each triangle in
    /// its natural deformation, numbers as those of deformation().
    void set_natural(double stiffness, const std::vector<double>& natural);

    /// [uN], [uN mm]; rows of freedoms that are held get none.
    void forces(const std::vector<double>& position, std::vector<double>& force) override;
    void forces_and_stiffness(const std::vector<double>& position, elastic_kernel::Mode mode, double scale,
                              std::vector<double>& force, BlockValues& stiffness) override;

    /// The forces of the shell on what holds it are the negatives of what this leaves in held rows.
    void forces_everywhere(const std::vector<double>& position, std::vector<double>& force);

    /// Newton's method in large steps converges by it where the true stress, great wherever a step along a straight
    /// line has stretched what it should have turned, throws it off [Magisano2017].
    void predict(const std::vector<double>& position, const std::vector<double>& step) override;
    void forget_prediction() override { predicting_ = false; }

    /// Per number of a row vector: 1, or 0 where the freedom is held.
    [[nodiscard]] const std::vector<std::uint8_t>& free() const { return free_; }
    [[nodiscard]] int rank(int node) const { return row_of()[2 * static_cast<std::size_t>(node)] / 2; }

private:
    void number_rows(std::span<const std::array<int, 2>> links);
    void hold();
    void weigh();
    void drag();
    void fill_groups(ShellTriangleMaker maker);
    void turn(const std::vector<double>& position);
    [[nodiscard]] shell_kernel::Task task_at(const std::vector<double>& position);
    void run(shell_kernel::Mode mode, const std::vector<double>& position, double scale, std::vector<double>& force,
             BlockValues* stiffness);
    void to_turns(const std::vector<double>& position, const std::vector<double>& force, double scale,
                  BlockValues& stiffness);
    void forces_to_turns(const std::vector<double>& position, std::vector<double>& force) const;

    /// A block of the stiffness that turns have a part in: not those that links alone have.
    struct TurnedBlock {
        int slot = 0;
        int row = -1;     ///< rank of the node whose turn it is by; -1: a movement
        int column = -1;  ///< likewise
    };

    const ShellModel* model_;
    const shell_kernel::Kernel* kernel_;
    std::vector<double> data_;               ///< of the kernel, by groups
    std::vector<double> elastic_;            ///< the same as it was made; empty until the stiffness changes
    double stiffness_ = 1.0;                 ///< of data_, over that of elastic_
    std::vector<std::array<int, 3>> local_;  ///< per triangle: its corners as the kernel takes them
    std::vector<double> deformation_;        ///< by groups
    std::vector<int> index_;                 ///< likewise
    std::vector<Quat> reference_;            ///< by ranks
    std::vector<double> rotation_;           ///< 9 per rank, by rows
    std::vector<std::uint8_t> free_;
    std::vector<int> held_entries_;           ///< of the stiffness, to be cleared
    std::vector<TurnedBlock> turned_blocks_;  ///< by slots
    std::vector<Mat3> rate_;                  ///< spin per turn, by ranks: scratch
    std::vector<double> buffer_;
    std::vector<double> predicted_;
    std::vector<double> spins_;  ///< a step, in movements and spins
    bool predicting_ = false;
    bool turned_ = false;  ///< any z is not zero
};

}  // namespace rhexis
