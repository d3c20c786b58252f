// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/physics.hpp"
#include "physics/anatomy/lids_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"
#include "physics/anatomy/bag_motion.hpp"
#include "physics/anatomy/capsule_wall.hpp"
#include "physics/anatomy/globe_roll.hpp"
#include "physics/anatomy/zonule_loss.hpp"
#include "physics/fluid/aspiration.hpp"
#include "physics/fluid/bead_motion.hpp"
#include "physics/fluid/debris_motion.hpp"
#include "physics/fluid/fluid_step.hpp"
#include "physics/fluid/viscoelastic_fill.hpp"
#include "physics/membrane/membrane_stepper.hpp"
#include "physics/membrane/puncture.hpp"
#include "physics/membrane/rim_rupture.hpp"
#include "physics/membrane/tear_tip.hpp"
#include "physics/shell/shell_carry.hpp"
#include "physics/shell/shell_motion.hpp"
#include "physics/shell/shell_tools.hpp"
#include "physics/solid/crack.hpp"
#include "physics/solid/sculpt.hpp"
#include "physics/solid/solid_stepper.hpp"
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
    std::vector<MembraneStepper> membranes;
    std::vector<ShellStepper> shells;
    std::vector<ShellContacts> shell_contacts;
    ShellTools shell_tools;
    std::vector<CrackFinder> cracks;  ///< per solid
    std::vector<SculptZone> zones;    ///< per tool
    std::vector<MouthProbe> probes;   ///< per tool
    WorldState started;               ///< scratch: the state with the fluid at the end of the step
    StepTry result;                   ///< scratch
    StepTry better;

    Solvers(std::shared_ptr<const WorldModel> world, const PhysicsSettings& wanted)
        : model(std::move(world)), settings(wanted), pool(wanted.threads), shell_tools(model->tools) {}

    [[nodiscard]] bool has_fluid() const { return model->chamber || model->capsule || model->iris; }
    void step_solid(const StepTask& task, int solid, StepOutcome& outcome);
    void keep(const StepTask& task, int solid, WorldState& next, ContactSet& contacts) const;
    void step_membrane(const StepTask& task, int membrane, WorldState& next, ContactSet& contacts,
                       StepOutcome& outcome);
    void report_shell(const StepTask& task, const ShellContacts& own, ContactSet& contacts) const;
    [[nodiscard]] int brought_by(const StepTask& task, std::size_t shell) const;
    [[nodiscard]] ShellState taken_out(const StepTask& task, std::size_t shell) const;
    [[nodiscard]] bool goes_with_shell(const StepTask& task, std::size_t membrane) const;
    [[nodiscard]] int carried_by(const StepTask& task, std::size_t shell) const;
    ShellMotion step_shell(const StepTask& task, std::size_t shell, WorldState& next, ContactSet& contacts,
                           StepOutcome& outcome);
    bool take_along(const StepTask& task, std::size_t shell, WorldState& next, ContactSet& contacts,
                    StepOutcome& outcome);
    void step_shells(const StepTask& task, WorldState& next, ContactSet& contacts, StepOutcome& outcome,
                     Profile& profile);
};

/// Leaves in `result` the first try that is good, or the last that only inverted something, or the state as it was.
void Physics::Solvers::step_solid(const StepTask& task, int solid, StepOutcome& outcome) {
    SolidStepper& stepper = steppers[solid];
    stepper.look_for_contacts(task);
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
    result.grips.clear();
}

void Physics::Solvers::keep(const StepTask& task, int solid, WorldState& next, ContactSet& contacts) const {
    next.solids[solid] = result.solid;
    if (solid == 0) {
        next.bags = result.bags;
        break_adhesion(result.candidates, next.bags);
    }
    report_contacts(result.candidates, solid, task.dt, contacts);
    report_grips(result.grips, task.tools, solid, task.dt, contacts);
    remember_contacts(result.candidates, solid, next.memory);
}

void Physics::Solvers::step_membrane(const StepTask& task, int membrane, WorldState& next, ContactSet& contacts,
                                     StepOutcome& outcome) {
    const std::size_t index = static_cast<std::size_t>(membrane);
    const MembraneModel& own = model->membranes[index];
    MembraneStepReport& report = outcome.membranes[index];
    report = {};
    const int before = outcome.rollbacks;
    if (!membranes[index].advance({*model, membrane, task.state.membranes[index], task.tools, task.dt},
                                  next.membranes[index], report, contacts, outcome.rollbacks)) {
        outcome.failure = StepFailure::not_finite;
        return;
    }
    if (outcome.rollbacks > before) {
        outcome.notes.push_back(own.name + ": step far from balance, redone in steps " +
                                std::to_string(report.substeps) + " times smaller");
    }
    report.tears = propose_tears(own, next.membranes[index]);
    report.notches = propose_notches(own, next.membranes[index]);
    report.punctures = propose_punctures(*model, membrane, next.membranes[index], task.tools, contacts);
    report.cuts = propose_cuts(*model, membrane, next.membranes[index], task.tools, contacts);
}

/// The injector with which a shell that lies in it comes into the eye in this step; or -1.
int Physics::Solvers::brought_by(const StepTask& task, std::size_t shell) const {
    for (std::size_t i = 0; task.state.shells[shell].loaded && i < task.tools.size(); ++i) {
        if (model->tools[i].kind == ToolKind::injector && task.tools[i].present) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

ShellState Physics::Solvers::taken_out(const StepTask& task, std::size_t shell) const {
    const int injector = brought_by(task, shell);
    if (injector < 0) {
        return task.state.shells[shell];
    }
    ShellState out = moved(task.state.shells[shell], task.tools[static_cast<std::size_t>(injector)].previous_pose);
    out.loaded = false;
    return out;
}

/// One per instrument, with the force that it bears in all.
void Physics::Solvers::report_shell(const StepTask& task, const ShellContacts& own, ContactSet& contacts) const {
    for (int i = 0; i < static_cast<int>(task.tools.size()); ++i) {
        Contact contact;
        contact.solid = -1;
        contact.nodes = {-1, -1, -1};
        contact.partner_index = i;
        contact.point = task.tools[i].pose.position;
        contact.force = own.force_of(ContactPartner::tool, i) + own.force_of(ContactPartner::jaws, i);
        if (task.tools[i].present && !contact.force.isZero()) {
            contacts.push_back(contact);
        }
    }
}

/// Whether the step of a membrane is that of the shell that may touch it: not while that is shut in.
bool Physics::Solvers::goes_with_shell(const StepTask& task, std::size_t membrane) const {
    if (membrane != 0 || shells.empty() || (task.state.shells[0].loaded && brought_by(task, 0) < 0)) {
        return false;
    }
    const ShellState shell = taken_out(task, 0);
    for (std::size_t i = 0; i < task.tools.size(); ++i) {
        if (task.tools[i].present && model->tools[i].cartridge &&
            is_shut_in(model->tools[i].cartridge->bore, task.tools[i].previous_pose, shell)) {
            return false;
        }
    }
    return true;
}

/// The injector in which the greater part of a shell lies; or -1.
int Physics::Solvers::carried_by(const StepTask& task, std::size_t shell) const {
    for (std::size_t i = 0; i < task.tools.size(); ++i) {
        if (task.tools[i].present && model->tools[i].cartridge &&
            lies_in(model->tools[i].cartridge->bore, task.tools[i].previous_pose, taken_out(task, shell))) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

/// Where a step cannot be solved: what lies in an injector goes with it as it is, and its wall goes by itself.
bool Physics::Solvers::take_along(const StepTask& task, std::size_t shell, WorldState& next, ContactSet& contacts,
                                  StepOutcome& outcome) {
    const int tool = carried_by(task, shell);
    if (tool < 0) {
        return false;
    }
    const ToolState& carrier = task.tools[at(tool)];
    next.shells[shell] = moved(taken_along(taken_out(task, shell), carrier.previous_pose), carrier.pose);
    next.shells[shell].loaded = false;
    if (!membranes.empty() && goes_with_shell(task, 0)) {
        step_membrane(task, 0, next, contacts, outcome);
    }
    outcome.notes.push_back(model->shells[shell].name + ": does not come to balance, goes as it is with " +
                            model->tools[at(tool)].name);
    return true;
}

ShellMotion Physics::Solvers::step_shell(const StepTask& task, std::size_t shell, WorldState& next,
                                         ContactSet& contacts, StepOutcome& outcome) {
    ShellStepReport& report = outcome.shells.emplace_back();
    const int before = outcome.rollbacks;
    const ShellState state = taken_out(task, shell);
    if (state.loaded) {
        return ShellMotion::balanced;
    }
    ShellPartners partners;
    partners.planes = model->planes;
    partners.domes = model->domes;
    partners.tools = shell_tools.tools();
    partners.tool_states = shell_tools.states();
    partners.tubes = shell_tools.tubes();
    partners.tube_states = shell_tools.tube_states();
    partners.tube_tools = shell_tools.tube_tools();
    ShellTask own{state, partners, model->gravity, task.dt, {}};
    if (!membranes.empty() && goes_with_shell(task, 0)) {
        own.wall.emplace(WallTask{*model, 0, task.state.membranes[0], task.tools, next.membranes[0], contacts});
    }
    const ShellMotion motion =
        move_shell(shells[shell], shell_contacts[shell], own, next.shells[shell], report, outcome.rollbacks);
    report_shell(task, shell_contacts[shell], contacts);
    if (own.wall) {
        outcome.membranes[0].substeps = report.substeps;
        outcome.membranes[0].tears = propose_tears(model->membranes[0], next.membranes[0]);
        outcome.membranes[0].notches = propose_notches(model->membranes[0], next.membranes[0]);
    }
    if (motion != ShellMotion::failed && outcome.rollbacks > before) {
        outcome.notes.push_back(model->shells[shell].name + ": step redone in steps " +
                                std::to_string(report.substeps) + " times smaller" +
                                (motion == ShellMotion::rough ? ", which do not balance either" : ""));
    }
    return motion;
}

/// All of them, again where a plunger pressed harder than a hand, or a step could not be solved while one moved.
void Physics::Solvers::step_shells(const StepTask& task, WorldState& next, ContactSet& contacts, StepOutcome& outcome,
                                   Profile& profile) {
    shell_tools.place(task.tools, task.state.plungers, task.dt);
    const StepOutcome before = outcome;
    const std::size_t met = contacts.size();
    std::vector<Vec3> forces;
    std::vector<std::size_t> failed;
    for (;;) {
        forces.assign(task.tools.size(), Vec3::Zero());
        failed.clear();
        double residual = 0.0;
        for (std::size_t shell = 0; shell < shells.size(); ++shell) {
            const ProfileScope scope(profile, model->shells[shell].name.c_str());
            if (step_shell(task, shell, next, contacts, outcome) == ShellMotion::failed) {
                failed.push_back(shell);
            }
            residual = std::max(residual, outcome.shells.back().residual);
            for (int i = 0; !next.shells[shell].loaded && i < static_cast<int>(forces.size()); ++i) {
                forces[i] += shell_contacts[shell].force_of(ContactPartner::tool, i);
            }
        }
        if (failed.empty() ? shell_tools.stands(forces, residual) : shell_tools.held_still()) {
            break;
        }
        const int thrown = outcome.rollbacks + 1;
        outcome = before;
        outcome.rollbacks = thrown;
        contacts.resize(met);
    }
    next.plungers.assign(shell_tools.plungers().begin(), shell_tools.plungers().end());
    for (const std::size_t shell : failed) {
        if (!take_along(task, shell, next, contacts, outcome)) {
            outcome.failure = StepFailure::not_finite;
        }
    }
}

Physics::Physics(std::unique_ptr<Solvers> solvers) : solvers_(std::move(solvers)) {}
Physics::~Physics() = default;
Physics::Physics(Physics&&) noexcept = default;
Physics& Physics::operator=(Physics&&) noexcept = default;

Result<Physics> Physics::create(std::shared_ptr<const WorldModel> model, const PhysicsSettings& settings,
                                const Physics* before) {
    if (Status status = check_world(*model, settings); !status) {
        return status.error();
    }
    std::unique_ptr<Solvers> solvers = std::make_unique<Solvers>(model, settings);
    for (int solid = 0; solid < static_cast<int>(model->solids.size()); ++solid) {
        const SolidStepper* of_before = before != nullptr ? &before->solvers_->steppers[at(solid)] : nullptr;
        Result<SolidStepper> stepper = SolidStepper::create(*model, solid, settings, solvers->pool, of_before);
        if (!stepper) {
            return stepper.error();
        }
        solvers->steppers.push_back(std::move(stepper).value());
        solvers->cracks.emplace_back(model->solids[solid]);
    }
    for (const MembraneModel& membrane : model->membranes) {
        Result<MembraneStepper> stepper =
            MembraneStepper::create(membrane, settings.instruction_set, settings.membranes);
        if (!stepper) {
            return stepper.error();
        }
        solvers->membranes.push_back(std::move(stepper).value());
    }
    for (const ShellModel& shell : model->shells) {
        Result<ShellStepper> stepper = ShellStepper::create(shell, settings.instruction_set);
        if (!stepper) {
            return stepper.error();
        }
        solvers->shells.push_back(std::move(stepper).value());
        solvers->shell_contacts.emplace_back(shell, settings.shell_contact);
    }
    if (before != nullptr) {
        RHEXIS_ASSERT(before->solvers_->zones.size() == model->tools.size());
        solvers->zones = before->solvers_->zones;
        solvers->probes = before->solvers_->probes;
        return Physics(std::move(solvers));
    }
    for (const ToolModel& tool : model->tools) {
        solvers->zones.push_back(sculpt_zone(tool));
        solvers->probes.push_back(mouth_probe(tool));
    }
    return Physics(std::move(solvers));
}

StepOutcome Physics::advance(const WorldState& state, std::span<const ToolState> tools, double dt, WorldState& next,
                             ContactSet& contacts, Profile& profile) {
    Solvers& s = *solvers_;
    RHEXIS_ASSERT(tools.size() == s.model->tools.size() && dt > 0.0);
    StepOutcome outcome;
    s.started = state;
    s.started.tips.resize(tools.size());  // a script may have added a tool
    s.started.plungers.resize(tools.size());
    if (s.model->globe) {
        roll_globe(*s.model, tools, dt, s.started);
    }
    if (s.has_fluid()) {
        const ProfileScope scope(profile, "chamber");
        step_fluid(*s.model, tools, s.probes, dt, s.started);
    }
    fill_chamber(*s.model, tools, dt, s.started);
    next = s.started;
    next.memory.clear();
    contacts.clear();
    const StepTask task{*s.model, s.started, tools, s.probes, dt};
    for (int solid = 0; solid < static_cast<int>(s.steppers.size()); ++solid) {
        const ProfileScope scope(profile, s.model->solids[solid].name.c_str());
        s.step_solid(task, solid, outcome);
        s.keep(task, solid, next, contacts);
        outcome.solids.push_back(s.result.report);
        s.cracks[solid].find(s.model->solids[solid], next.solids[solid], s.steppers[solid].surface(), contacts, solid,
                             outcome.solids.back().broken);
    }
    outcome.membranes.resize(s.membranes.size());
    for (int membrane = 0; membrane < static_cast<int>(s.membranes.size()); ++membrane) {
        if (s.goes_with_shell(task, static_cast<std::size_t>(membrane))) {
            continue;
        }
        const ProfileScope scope(profile, s.model->membranes[membrane].name.c_str());
        s.step_membrane(task, membrane, next, contacts, outcome);
    }
    if (!s.shells.empty()) {
        s.step_shells(task, next, contacts, outcome, profile);
    }
    if (s.steppers.empty()) {
        PartnerPoses poses;
        place_tools(tools, 1.0, poses);
        for (std::size_t b = 0; b < next.bags.size(); ++b) {
            for (int i = 0; i < bag_substeps; ++i) {
                load_bag(task, poses.tools, next.bags[b]);
                accelerate_bag(s.model->bags[b], dt / bag_substeps, next.bags[b]);
                move_bag(dt / bag_substeps, next.bags[b]);
            }
        }
    }
    for (std::size_t b = 0; b < next.bags.size(); ++b) {
        if (next.bags[b].zonules) {
            tend_zonules(s.model->bags[b], s.model->tools, tools, dt, next.bags[b]);
        }
    }
    if (next.capsule) {
        const ProfileScope scope(profile, "capsule");
        strain_capsule(*s.model, tools, s.probes, dt, next);
    }
    if (!next.debris.empty()) {
        const ProfileScope scope(profile, "debris");
        move_debris(*s.model, tools, s.probes, dt, next);
    }
    if (next.lids) {
        move_lids(*s.model, tools, dt, *next.lids);
    }
    if (next.beads) {
        move_beads(*s.model, tools, dt, *next.beads);
    }
    if (!next.solids.empty()) {
        const ProfileScope scope(profile, "sculpt");
        for (std::size_t i = 0; i < tools.size(); ++i) {
            const int tool = static_cast<int>(i);
            const double spare = sculpt(*s.model, tool, tools[i], s.zones[i], dt, next);
            aspirate(*s.model, tool, tools[i], s.probes[i], spare, dt, next);
        }
    }
    next.time_s = state.time_s + dt;
    return outcome;
}

void Physics::drop_caches() {
    for (SolidStepper& stepper : solvers_->steppers) {
        stepper.drop_caches();
    }
    for (MembraneStepper& stepper : solvers_->membranes) {
        stepper.drop_caches();
    }
    for (ShellStepper& stepper : solvers_->shells) {
        stepper.drop_caches();
    }
}

}  // namespace rhexis
