// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: one step of one solid and of the bag that holds it, by either way.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "base/profile.hpp"
#include "base/threads.hpp"
#include "flow/step_outcome.hpp"
#include "physics/contact/contact_candidates.hpp"
#include "physics/contact/explicit_contact.hpp"
#include "physics/fluid/mouth.hpp"
#include "physics/physics.hpp"
#include "physics/solid/explicit_solid.hpp"
#include "physics/solid/implicit_solid.hpp"
#include "physics/solid/solid_energy.hpp"

namespace rhexis {

/// What a step starts from; all of it outlives the step.
struct StepTask {
    const WorldModel& model;
    const WorldState& state;
    std::span<const ToolState> tools;
    std::span<const MouthProbe> probes;  ///< per tool
    double dt = 0.0;                     ///< [s]
};

/// Sets what instruments at these poses do to the wall of the bag.
void load_bag(const StepTask& task, std::span<const Pose> tools, BagState& bag);

/// What one try gave.
struct StepTry {
    SolidState solid;
    std::vector<BagState> bags;
    ContactCandidates candidates;
    std::vector<SuctionGrip> grips;
    SolidStepReport report;
    StepFailure failure = StepFailure::none;
};

class SolidStepper {
public:
    /// before: of the same solid with fewer splits, whose choice between the two ways and whose lanes go on to hold; or
    /// null.
    static Result<SolidStepper> create(const WorldModel& model, int solid, const PhysicsSettings& settings,
                                       ThreadPool& pool, const SolidStepper* before);

    /// Finds what can touch what during the step; before its tries.
    void look_for_contacts(const StepTask& task);

    /// One try of the whole step. divisions: 1, 2, 4, ... times as many substeps as usual.
    void run(const StepTask& task, bool explicit_way, int divisions, StepTry& result);

    /// The cheaper way for steps of dt, or the one that the model asks for.
    [[nodiscard]] bool prefers_explicit(double dt) const;
    /// False for elements that only one way can step: a step that fails has no other way to try.
    [[nodiscard]] bool has_both_ways() const { return solid_model_->formulation != Formulation::nodal_pressure; }

    [[nodiscard]] const ContactSurface& surface() const { return surface_; }
    void drop_caches();

private:
    SolidStepper(const WorldModel& model, int solid, const PhysicsSettings& settings, ThreadPool& pool);
    Status make_explicit();
    Status make_implicit();
    void run_explicit(const StepTask& task, int divisions, StepTry& result);
    void run_implicit(const StepTask& task, int divisions, StepTry& result);
    void judge(const StepTask& task, StepTry& result);

    const WorldModel* model_;
    const SolidModel* solid_model_;
    int solid_;
    PhysicsSettings settings_;
    ThreadPool* pool_;
    ContactSurface surface_;
    SolidEnergy energy_;
    std::unique_ptr<SolidModel> stand_in_;         ///< of the explicit way where it cannot step the elements
    std::shared_ptr<const LaneAssignment> lanes_;  ///< of the mesh before it came apart
    std::optional<ExplicitSolid> explicit_;
    std::optional<ImplicitSolid> implicit_;
    ExplicitContact explicit_contact_;
    ContactCandidates candidates_;    ///< scratch of one step
    std::vector<PiecePair> pairs_;    ///< scratch of one step
    std::vector<SuctionGrip> grips_;  ///< scratch of one step
    double rest_step_ = 0.0;          ///< explicit stability limit at rest, unsplit [s]; 0: not yet known
};

}  // namespace rhexis
