// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane/membrane_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/index.hpp"
#include "physics/contact/tool_shape.hpp"

namespace rhexis {
namespace {

constexpr int new_order_pays = 30;  // linear solves between two tears: then a new order has fewer entries. Proposal
constexpr double rest_share = 0.1;  // of the force tolerance: what is no farther out of balance is left as it is

/// Forces of a scene are some 1,000 to 20,000 uN. Tears end within 0.02 mm of where they end at 2 uN and 1e-6.
ImplicitSettings scene_settings(const MembraneSolve& solve, bool predict) {
    return {.tolerance = 1e-2,
            .max_newton = solve.max_newton,
            .newton_tolerance = 1e-3,
            .force_tolerance = solve.force_tolerance,
            .rest_tolerance = rest_share * solve.force_tolerance,
            .predict = predict,
            .new_factors = solve.new_factors,
            .seldom_again = true,
            .most_travel = 0.2};
}

constexpr double share_of_weight = 0.1;     // residual force that leaves a sheet at rest, at most
constexpr int finest = 16;                  // of one that is made again: so many times the substeps
constexpr double farthest = 0.1;            // that an instrument near the sheet goes in a substep [mm],
constexpr double farthest_of_radius = 0.5;  // and that of the radius of its thinnest end
constexpr int most_substeps = 20;
/// A substep that leaves more than both out of balance, of its forces and at all, is no state of the sheet: the lens
/// that it lies on would be thrown about by it.
constexpr double rough_residual = 0.1;
constexpr double rough_force = 1e3;  // [uN]

Box box_of(const std::vector<Vec3>& nodes) {
    Box box;
    for (const Vec3& node : nodes) {
        box.add(node, 0.0);
    }
    return box;
}

/// As many as the fastest of what instruments have near the sheet needs: not their handles, which go far when they
/// turn.
int substeps_for(const MembraneStepper::Task& task) {
    const Box sheet = box_of(task.state.position);
    double parts = 1.0;
    for (std::size_t k = 0; k < task.tools.size(); ++k) {
        if (!task.tools[k].present) {
            continue;
        }
        const ToolModel& model = task.world.tools[k];
        const double travel = travel_near(model, task.tools[k], sheet);
        const double wanted = travel / std::min(farthest, farthest_of_radius * thinnest(model));
        if (wanted > parts && comes_near(model, task.tools[k], travel, task.state.position)) {
            parts = wanted;
        }
    }
    return std::min(static_cast<int>(std::ceil(parts)), most_substeps);
}

/// Slowly enough to be a state of rest at any time: what it is pushed by, less what holds it.
void move_support(const MembraneModel& model, double force, double dt, SupportState& support) {
    if (!model.support || model.support->stiffness == 0.0) {
        return;
    }
    // the sheet's own answer is that of the step before, the spring's that of this one
    const SupportModel& own = *model.support;
    const double speed =
        (support.push - own.stiffness * (support.lift - own.slack_lift) + force) / (own.damping + dt * own.stiffness);
    support.lift += dt * speed;
}

/// What lies on the support goes with it: a contact dents it by less than that moves in a step, and would be lost.
void carry(const MembraneModel& model, double lift, MembraneState& state) {
    for (const SheetTouch& touch : state.touches) {
        if (touch.partner == ContactPartner::support && touch.triangle < 0 &&
            !is_fixed(model, *state.sheet, touch.node)) {
            state.position[at(touch.node)].z() += lift;
        }
    }
}

}  // namespace

Result<MembraneStepper> MembraneStepper::create(const MembraneModel& model, std::string_view instruction_set,
                                                const MembraneSolve& solve) {
    if (Status status = check_membrane(model); !status) {
        return status.error();
    }
    const linear_kernel::Kernel* const kernel = linear_kernel::choose(instruction_set);
    if (kernel == nullptr) {
        return Error{"unknown or missing instruction set \"" + std::string(instruction_set) + "\"", "instruction_set",
                     "\"\", \"baseline\", \"avx2\" or \"avx512\", as the machine has"};
    }
    return MembraneStepper(model, *kernel, solve);
}

/// Takes over the state's sheet. One that tears often keeps its order of elimination.
void MembraneStepper::follow(const MembraneState& state) {
    if (step_ && body_->sheet() == state.sheet) {
        return;
    }
    if (step_) {
        step_->follow(body_->follow(state.sheet, solves_ < new_order_pays));
    } else {
        std::unique_ptr<MembraneBody> body =
            std::make_unique<MembraneBody>(*model_, state.sheet, *membrane_kernel::choose(kernel_->name));
        body_ = body.get();
        step_.emplace(std::move(body), *kernel_);
    }
    solves_ = 0;
}

ImplicitReport MembraneStepper::step(const MembraneState& state, std::span<const Vec3> external, double dt,
                                     const ImplicitSettings& settings, const CouplingFunction& coupling,
                                     MembraneState& next) {
    follow(state);
    body_->follow_support(state.support.lift);
    const ImplicitReport report =
        step_->step(state.position, state.velocity, gravity_, external, dt, settings, coupling, no_bodies_, motion_);
    solves_ += report.newton_iterations;
    next = state;
    next.position = motion_.position;
    next.velocity = motion_.velocity;
    return report;
}

void MembraneStepper::load(const WorldModel& world, const MembraneState& state) {
    gravity_ = world.gravity;
    external_.clear();
    if (!state.loads.empty()) {
        external_.assign(state.position.size(), Vec3::Zero());
    }
    for (const SheetLoad& load : state.loads) {
        for (const int node : load.nodes) {
            external_[at(node)] += load.total / static_cast<double>(load.nodes.size());
        }
    }
}

/// The weight of a light sheet that hangs free is not taken for nothing. What has no weight does not ask.
double MembraneStepper::finest_force() const {
    double squares = 0.0;
    for (const double weight : body_->mass().weight) {
        squares += weight * weight;
    }
    return squares > 0.0 ? share_of_weight * gravity_.norm() * std::sqrt(squares) : std::numeric_limits<double>::max();
}

/// Substep i of a step: the instruments go on along their way.
ImplicitReport MembraneStepper::substep(const Task& task, int i, int divisions, const MembraneState& from,
                                        MembraneState& next, ContactSet& contacts) {
    const double dt = task.dt / divisions;
    tools_.clear();
    for (const ToolState& tool : task.tools) {
        tools_.push_back(
            part_of_step(tool, static_cast<double>(i) / divisions, static_cast<double>(i + 1) / divisions));
    }
    touching_.look(task.world, task.membrane, from, tools_, dt);
    held_.look(task.world, task.membrane, from, touching_.stiffness());
    layers_.look(*model_, from, touching_.stiffness(), dt);
    place_tools(tools_, 1.0, poses_);
    touching_.place(poses_);
    CouplingFunction coupling;
    if (!touching_.empty() || !held_.empty() || !layers_.empty()) {
        coupling = [this](const std::vector<Vec3>& position, std::span<const RigidUnknown>,
                          std::vector<ContactTerm>& terms, std::vector<RigidTerm>&) {
            touching_.terms(position, terms);
            held_.terms(position, poses_, terms);
            layers_.terms(position, terms);
        };
    }
    follow(from);
    ImplicitSettings settings = scene_settings(solve_, model_->damping_stiffness == 0.0);
    settings.force_tolerance = std::min(settings.force_tolerance, finest_force());
    settings.rest_tolerance = std::min(settings.rest_tolerance, finest_force());
    const ImplicitReport report = step(from, external_, dt, settings, coupling, next);
    touching_.settle(next.position, poses_, dt);
    touching_.report(task.dt, contacts);
    next.touches = touching_.touches();
    layers_.remember(next.touches);
    held_.settle(next.position, poses_, dt);
    held_.report(task.dt, contacts);
    next.grips = held_.kept();
    const double on_support = touching_.impulse_on_support() / dt + layers_.force_on_support(next.position) +
                              body_->springs_on_support(next.position);
    move_support(*model_, on_support, dt, next.support);
    carry(*model_, next.support.lift - from.support.lift, next);
    return report;
}

MembraneStepper::Balance MembraneStepper::run(const Task& task, int divisions, MembraneState& next,
                                              MembraneStepReport& report, ContactSet& contacts) {
    Balance worst = Balance::good;
    report = MembraneStepReport{};
    report.substeps = divisions;
    next = task.state;
    report.out = take_hold(task.world, task.tools, next);
    for (int i = 0; i < divisions; ++i) {
        std::swap(between_, next);
        const ImplicitReport one = substep(task, i, divisions, between_, next, contacts);
        report.newton_iterations += one.newton_iterations;
        report.linear_iterations += one.linear_iterations;
        report.force = one.force;
        if (!std::isfinite(one.newton_residual) || !std::isfinite(one.force)) {
            return Balance::not_finite;
        }
        if (one.newton_residual > rough_residual && one.force > rough_force) {
            worst = Balance::rough;
        }
    }
    return worst;
}

bool MembraneStepper::advance(const Task& task, MembraneState& next, MembraneStepReport& report, ContactSet& contacts,
                              int& rollbacks) {
    load(task.world, task.state);
    const std::size_t before = contacts.size();
    const int least = substeps_for(task);
    for (const int finer : {1, 4, finest}) {
        const Balance balance = run(task, least * finer, next, report, contacts);
        if (balance == Balance::good || (balance == Balance::rough && finer == finest)) {
            return true;
        }
        contacts.resize(before);
        ++rollbacks;
        if (balance == Balance::not_finite) {
            drop_caches();
        }
    }
    next = task.state;
    next.velocity.assign(next.velocity.size(), Vec3::Zero());
    return false;
}

}  // namespace rhexis
