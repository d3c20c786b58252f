// SPDX-License-Identifier: GPL-3.0-or-later
// The physics stage: one step of everything that moves. Reads one state and the tools, writes the next.
#pragma once

#include <memory>
#include <span>

#include "base/profile.hpp"
#include "base/result.hpp"
#include "flow/contact.hpp"
#include "flow/mesh_edit.hpp"
#include "flow/step_outcome.hpp"
#include "flow/tool.hpp"
#include "flow/world.hpp"
#include "physics/membrane/membrane_solve.hpp"
#include "physics/shell/shell_contact_settings.hpp"

namespace rhexis {

struct PhysicsSettings {
    int threads = 1;              ///< results do not depend on it
    std::string instruction_set;  ///< "" chooses the best; "baseline", "avx2", "avx512": same bits, other speed
    double tolerance = 1e-4;      ///< residual at which an implicit step is done, as a share of all forces on the solid
    int max_newton = 16;          ///< Newton iterations of an implicit step
    MembraneSolve membranes;
    ShellContactSettings shell_contact;
    bool elastic_energy = false;  ///< fills elastic_energy of the reports, at some 3 % of a step
};

/// Owns the caches that solvers keep of a constant model; holds no state of its own that matters: after
/// drop_caches() a step gives the same bits as in a new Physics.
class Physics {
public:
    /// Fails on a model that cannot be stepped (element number, field and range in the error).
    /// before: of the same instruments; what was prepared for them is taken over.
    static Result<Physics> create(std::shared_ptr<const WorldModel> model, const PhysicsSettings& settings,
                                  const Physics* before = nullptr);
    ~Physics();
    Physics(Physics&&) noexcept;
    Physics& operator=(Physics&&) noexcept;

    /// One step of dt [s]. `next` and `contacts` are overwritten. A step that ends non-finite, unconverged or inverted
    /// is redone in smaller steps or by the safer way; the outcome says so.
    StepOutcome advance(const WorldState& state, std::span<const ToolState> tools, double dt, WorldState& next,
                        ContactSet& contacts, Profile& profile);

    /// Forgets everything that depends on earlier steps (at checkpoints and after restoring a snapshot).
    void drop_caches();

private:
    struct Solvers;
    explicit Physics(std::unique_ptr<Solvers> solvers);
    std::unique_ptr<Solvers> solvers_;
};

}  // namespace rhexis
