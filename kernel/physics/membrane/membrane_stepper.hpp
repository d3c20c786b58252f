// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: backward Euler of a membrane whose sheet changes as it tears.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "base/result.hpp"
#include "flow/membrane.hpp"
#include "flow/step_outcome.hpp"
#include "physics/membrane/membrane_body.hpp"
#include "physics/membrane/membrane_solve.hpp"
#include "physics/membrane/sheet_contact.hpp"
#include "physics/membrane/sheet_grip.hpp"
#include "physics/membrane/sheet_layers.hpp"
#include "physics/solve/implicit_step.hpp"

namespace rhexis {

class MembraneStepper {
public:
    /// The model must outlive this. instruction_set: as of ImplicitSolid. Fails on a model that check_membrane refuses.
    static Result<MembraneStepper> create(const MembraneModel& model, std::string_view instruction_set = {},
                                          const MembraneSolve& solve = {});

    /// One step of dt [s]. external: force per node [uN], or empty. The sheet, tips and what was torn are taken over.
    ImplicitReport step(const MembraneState& state, std::span<const Vec3> external, double dt,
                        const ImplicitSettings& settings, const CouplingFunction& coupling, MembraneState& next);

    /// What a step is to be made of.
    struct Task {
        const WorldModel& world;
        int membrane;  ///< the world's number of this one
        const MembraneState& state;
        std::span<const ToolState> tools;
        double dt;  ///< [s]
    };

    /// A step with the state's loads, in contact, in as many substeps as the instruments near it are fast; redone in
    /// smaller ones where numbers run away or come nowhere near to balance. False where numbers run away in the
    /// smallest too: next is then the state at rest where it was. Appends to `contacts`.
    bool advance(const Task& task, MembraneState& next, MembraneStepReport& report, ContactSet& contacts,
                 int& rollbacks);

    /// Forgets what is kept of earlier steps, the order of elimination too.
    void drop_caches() { step_.reset(); }

private:
    /// Of a step: how the worst of its substeps ended.
    enum class Balance { good, rough, not_finite };
    MembraneStepper(const MembraneModel& model, const linear_kernel::Kernel& kernel, const MembraneSolve& solve)
        : model_(&model), kernel_(&kernel), solve_(solve) {}
    void follow(const MembraneState& state);
    void load(const WorldModel& world, const MembraneState& state);
    Balance run(const Task& task, int divisions, MembraneState& next, MembraneStepReport& report, ContactSet& contacts);
    [[nodiscard]] double finest_force() const;
    ImplicitReport substep(const Task& task, int i, int divisions, const MembraneState& from, MembraneState& next,
                           ContactSet& contacts);

    const MembraneModel* model_;
    const linear_kernel::Kernel* kernel_;
    MembraneSolve solve_;
    std::optional<ImplicitStep> step_;
    MembraneBody* body_ = nullptr;  ///< of step_
    int solves_ = 0;                ///< with the sheet of body_
    NodeMotion motion_;
    // scratch
    MembraneState between_;
    std::vector<Vec3> external_;
    Vec3 gravity_ = Vec3::Zero();
    SheetContacts touching_;
    SheetGrips held_;
    SheetLayers layers_;
    std::vector<ToolState> tools_;  ///< where they are in a substep
    PartnerPoses poses_;
    std::vector<RigidUnknown> no_bodies_;
};

}  // namespace rhexis
