// SPDX-License-Identifier: GPL-3.0-or-later
// Backward Euler of a thin shell: the step of ImplicitStep over movements and turns. The turns of a step count from its
// start, so that rotations of any size add up as rotations do. A shell that relaxes does so exactly for a deformation
// that goes evenly over the step. A membrane that it lies in, such as the capsular bag, is solved for with it: it is so
// light beside the springs of contact that steps in turn would throw it about.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "flow/membrane.hpp"
#include "flow/shell.hpp"
#include "physics/shell/shell_body.hpp"
#include "physics/shell/shell_contact.hpp"
#include "physics/shell/shell_relaxation.hpp"
#include "physics/solve/implicit_step.hpp"

namespace rhexis {

/// A membrane whose step is solved together with that of a shell that touches it.
struct ShellWall {
    const MembraneModel& model;
    const MembraneState& state;
    MembraneState& next;  ///< its positions and velocities are set; may be state
    /// What else touches it, at an iterate: terms of its own nodes. Or none.
    std::function<void(const std::vector<Vec3>& position, std::vector<ContactTerm>& terms)> touching;
};

class ShellStepper {
public:
    /// The model must outlive this. instruction_set: "" for the best of this machine, or "baseline", "avx2", "avx512":
    /// same bits, other speed. Fails on one that the machine lacks and on a model that check_shell refuses.
    static Result<ShellStepper> create(const ShellModel& model, std::string_view instruction_set = {});

    /// One step of dt [s]. gravity [mm/s^2]. next may be state. contacts: that looked from this state, or none; then it
    /// touches nothing and forgets what it touched. wall: as these contacts met it, or none. guess: velocity and spin
    /// of each node with which the search of a step that is predicted begins instead of the state's; or empty.
    ImplicitReport step(const ShellState& state, const ShellLoad& load, const Vec3& gravity, double dt,
                        const ImplicitSettings& settings, ShellState& next, ShellContacts* contacts = nullptr,
                        const ShellWall* wall = nullptr, std::vector<Vec3> guess = {});

    /// Force and moment of the shell on each of the model's holds at the end of the last step [uN, uN mm]; in freedoms
    /// that are not held, zero. A step must have been made.
    std::vector<Vec6> hold_forces();

    /// Forgets the kept factor and what touched.
    void drop_caches();
    /// Forgets the kept factor only.
    void drop_factor() { step_->drop_caches(); }

private:
    ShellStepper(const ShellModel& model, const linear_kernel::Kernel& linear, const shell_kernel::Kernel& shell);
    void build(const ShellWall* wall);
    void tie(const ShellContacts* contacts, const ShellWall* wall);
    void lay_out(const ShellWall& wall);
    [[nodiscard]] CouplingFunction coupling(ShellContacts* contacts, const ShellWall* wall);
    const std::vector<double>& rows_of(const std::vector<Vec3>& points);
    void lay_out(const ShellState& state, const ShellLoad& load, const Vec3& gravity);

    const ShellModel* model_;
    const linear_kernel::Kernel* linear_;
    const shell_kernel::Kernel* shell_;
    std::vector<std::array<int, 2>> links_;            ///< of nodes, in the pattern beside the mesh's
    std::vector<std::array<int, 2>> ties_;             ///< likewise, to those of the wall
    std::shared_ptr<const MembraneSheet> wall_sheet_;  ///< of the wall in step_; null: it has none
    std::optional<ImplicitStep> step_;
    ShellBody* body_ = nullptr;  ///< in step_
    ShellRelaxationStep relaxation_;
    // scratch, by points: movement and turn of each node
    std::vector<Vec3> position_;
    std::vector<Vec3> velocity_;
    std::vector<Vec3> external_;
    std::vector<Vec3> wall_position_;
    NodeMotion motion_;
    std::vector<RigidUnknown> no_bodies_;
    std::vector<double> rows_;
    std::vector<double> forces_;
};

}  // namespace rhexis
