// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibrium of a thin shell under loads: Newton's method at a given load, or along a path of equilibria through limit
// points [Crisfield1981]. Linear systems by a factor in double precision: a shell's are too ill-conditioned for less.
#pragma once

#include <memory>

#include "base/result.hpp"
#include "energy/shell_triangle.hpp"
#include "flow/shell.hpp"

namespace rhexis {

struct ShellStaticSettings {
    double tolerance = 1e-7;  ///< norm of what does not balance, over that of all forces, held freedoms too
    int max_iterations = 30;  ///< of Newton's method
    double most_turn = 0.5;   ///< of any node in one iteration [rad]
    bool predict = true;      ///< tangents with the stress that the last iteration predicted, else with the true one
};

struct ShellStaticReport {
    bool converged = false;
    int iterations = 0;
    double residual = 0.0;    ///< as of the tolerance
    int negative_pivots = 0;  ///< negative eigenvalues of the last tangent: 0 where the equilibrium is stable
};

/// Where a path of equilibria has come to, under `factor` times a load.
struct ShellPath {
    ShellState state;
    double factor = 0.0;
    std::vector<Vec3> way;  ///< by which it came there, by nodes; empty at the start
};

class ShellStatics {
public:
    /// The model must outlive this. Fails on one that check_shell refuses.
    static Result<ShellStatics> create(const ShellModel& model, ShellTriangleMaker maker = shell_triangle);
    ~ShellStatics();
    ShellStatics(ShellStatics&&) noexcept;
    ShellStatics& operator=(ShellStatics&&) noexcept;

    /// Equilibrium under factor times the load, from the state given; where it does not converge the state is left as
    /// it was. Velocities are not looked at.
    ShellStaticReport equilibrate(const ShellLoad& load, double factor, const ShellStaticSettings& settings,
                                  ShellState& state);

    /// The same by as many intermediate loads as it takes, from equilibrium under `from`: at first one step, tried with
    /// tangents of either stress and halved where Newton's method fails with both. The report is of the last, with all
    /// iterations.
    ShellStaticReport load_to(const ShellLoad& load, double from, double to, const ShellStaticSettings& settings,
                              ShellState& state);

    /// The next equilibrium on the path: all movements together go `arc` [mm], root of the sum of squares; the load
    /// follows from that. Where it does not converge the path is left as it was. The first step is to greater loads.
    ShellStaticReport follow(const ShellLoad& load, double arc, const ShellStaticSettings& settings, ShellPath& path);

    /// Negative eigenvalues of the tangent at a state.
    int negative_pivots(const ShellState& state);

    /// What the held freedoms of a node bear: force and moment of the shell on what holds it [uN, uN mm].
    Vec6 reaction(const ShellState& state, int node);

private:
    struct Parts;
    explicit ShellStatics(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
