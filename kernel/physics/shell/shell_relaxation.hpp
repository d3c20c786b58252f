// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: what a viscoelastic shell's step does about its branch: before it the stiffness and natural shapes of
// the triangles, after it the branch's deformation (energy/zener.hpp).
#pragma once

#include <optional>
#include <vector>

#include "energy/zener.hpp"
#include "flow/shell.hpp"

namespace rhexis {

class ShellBody;

class ShellRelaxationStep {
public:
    /// The model must pass check_shell.
    explicit ShellRelaxationStep(const ShellModel& model);

    /// Before a step of dt [s] from positions by the body's rows. branch: at its start.
    void begin(const std::vector<double>& branch, double dt, const std::vector<double>& position, ShellBody& body);

    /// After it: the branch at the end. result may be what begin was given.
    void finish(const std::vector<double>& branch, const std::vector<double>& position, ShellBody& body,
                std::vector<double>& result);

private:
    double share_ = 0.0;
    std::optional<double> time_;  ///< [s]; none: elastic
    // scratch
    ZenerStep step_;
    std::vector<double> start_;  ///< deformation
    std::vector<double> end_;
    std::vector<double> natural_;
};

}  // namespace rhexis
