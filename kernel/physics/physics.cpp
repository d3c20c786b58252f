// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/physics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "physics/bag_motion.hpp"
#include "physics/sculpt.hpp"
#include "physics/solid_stepper.hpp"
#include "physics/world_check.hpp"

namespace rhexis {

namespace {

constexpr int bag_substeps = 64;  ///< of a bag that holds nothing

/// A way to run a step, and the next one to try when it fails.
struct Plan {
    bool explicit_way = false;
    int divisions = 1;
};

std::vector<Plan> plans(bool explicit_way, bool both_ways) {
    std::vector<Plan> list{{explicit_way, 1}, {explicit_way, 2}, {explicit_way, 4}, {explicit_way, 8}};
    if (both_ways) {
        list.push_back({!explicit_way, 1});
    }
    return list;
}

const char* describe(StepFailure failure) {
    switch (failure) {
        case StepFailure::none:
            return "good";
        case StepFailure::not_finite:
            return "not finite";
        case StepFailure::not_converged:
            return "not converged";
        case StepFailure::inverted:
            return "inverted";
    }
    return "";
}

std::string note(const SolidModel& solid, StepFailure failure, const Plan& plan) {
    return solid.name + ": step " + describe(failure) + ", redone " + (plan.explicit_way ? "explicit" : "implicit") +
           (plan.divisions > 1 ? " in steps " + std::to_string(plan.divisions) + " times smaller" : "");
}

}  // namespace

struct Physics::Solvers {
    std::shared_ptr<const WorldModel> model;
    PhysicsSettings settings;
    ThreadPool pool;
    std::vector<SolidStepper> steppers;
    std::vector<SculptZone> zones;  ///< per tool
    StepTry result;                 ///< scratch
    StepTry better;

    Solvers(std::shared_ptr<const WorldModel> world, const PhysicsSettings& wanted)
        : model(std::move(world)), settings(wanted), pool(wanted.threads) {}

    void step_solid(const StepTask& task, int solid, StepOutcome& outcome);
    void keep(const StepTask& task, int solid, WorldState& next, ContactSet& contacts) const;
};

/// Leaves in `result` the first try that is good, or the last that only inverted something, or the state as it was.
void Physics::Solvers::step_solid(const StepTask& task, int solid, StepOutcome& outcome) {
    SolidStepper& stepper = steppers[solid];
    bool usable = false;
    StepFailure failure = StepFailure::none;
    for (const Plan& plan : plans(stepper.prefers_explicit(task.dt), stepper.has_both_ways())) {
        if (failure != StepFailure::none) {
            ++outcome.rollbacks;
            outcome.notes.push_back(note(model->solids[solid], failure, plan));
        }
        stepper.run(task, plan.explicit_way, plan.divisions, result);
        failure = result.failure;
        if (failure == StepFailure::none) {
            return;
        }
        if (failure == StepFailure::inverted) {
            // what a finer step inverts as well is crushed, not jumped over: it will turn back when it is let go
            const bool again = usable;
            std::swap(result, better);  // the last is the finest
            usable = true;
            if (again) {
                break;
            }
        }
    }
    if (usable) {
        std::swap(result, better);
        outcome.notes.push_back(model->solids[solid].name + ": " + std::to_string(result.report.inverted) +
                                " tetrahedra stay inverted");
        return;
    }
    outcome.failure = failure;
    result.solid = task.state.solids[solid];
    result.bags = task.state.bags;
    result.candidates.clear();
}

void Physics::Solvers::keep(const StepTask& task, int solid, WorldState& next, ContactSet& contacts) const {
    const ContactSurface& surface = steppers[solid].surface();
    next.solids[solid] = result.solid;
    if (solid == 0) {
        next.bags = result.bags;
    }
    report_contacts(result.candidates, surface, solid, task.dt, contacts);
    remember_contacts(result.candidates, surface, solid, next.memory);
}

Physics::Physics(std::unique_ptr<Solvers> solvers) : solvers_(std::move(solvers)) {}
Physics::~Physics() = default;
Physics::Physics(Physics&&) noexcept = default;
Physics& Physics::operator=(Physics&&) noexcept = default;

Result<Physics> Physics::create(std::shared_ptr<const WorldModel> model, const PhysicsSettings& settings) {
    if (Status status = check_world(*model, settings); !status) {
        return status.error();
    }
    std::unique_ptr<Solvers> solvers = std::make_unique<Solvers>(model, settings);
    for (int solid = 0; solid < static_cast<int>(model->solids.size()); ++solid) {
        Result<SolidStepper> stepper = SolidStepper::create(*model, solid, settings, solvers->pool);
        if (!stepper) {
            return stepper.error();
        }
        solvers->steppers.push_back(std::move(stepper).value());
    }
    for (const ToolModel& tool : model->tools) {
        solvers->zones.push_back(sculpt_zone(tool));
    }
    return Physics(std::move(solvers));
}

StepOutcome Physics::advance(const WorldState& state, std::span<const ToolState> tools, double dt, WorldState& next,
                             ContactSet& contacts, Profile& profile) {
    Solvers& s = *solvers_;
    RHEXIS_ASSERT(tools.size() == s.model->tools.size() && dt > 0.0);
    StepOutcome outcome;
    next = state;
    next.memory.clear();
    contacts.clear();
    const StepTask task{*s.model, state, tools, dt};
    for (int solid = 0; solid < static_cast<int>(s.steppers.size()); ++solid) {
        const ProfileScope scope(profile, s.model->solids[solid].name.c_str());
        s.step_solid(task, solid, outcome);
        s.keep(task, solid, next, contacts);
        outcome.solids.push_back(s.result.report);
    }
    if (s.steppers.empty()) {
        for (std::size_t b = 0; b < next.bags.size(); ++b) {
            for (int i = 0; i < bag_substeps; ++i) {
                accelerate_bag(s.model->bags[b], dt / bag_substeps, next.bags[b]);
                move_bag(dt / bag_substeps, next.bags[b]);
            }
        }
    }
    const ProfileScope scope(profile, "sculpt");
    for (std::size_t i = 0; i < tools.size(); ++i) {
        sculpt(*s.model, static_cast<int>(i), tools[i], s.zones[i], dt, next);
    }
    next.time_s = state.time_s + dt;
    return outcome;
}

void Physics::drop_caches() {
    for (SolidStepper& stepper : solvers_->steppers) {
        stepper.drop_caches();
    }
}

}  // namespace rhexis
