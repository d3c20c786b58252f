// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/solid_stepper.hpp"

#include <algorithm>
#include <cmath>

#include "physics/anatomy/bag_contents.hpp"
#include "physics/anatomy/bag_motion.hpp"
#include "physics/anatomy/capsule_wall.hpp"
#include "physics/contact/implicit_contact.hpp"
#include "physics/contact/tool_shape.hpp"
#include "physics/fluid/fluid_step.hpp"

namespace rhexis {

namespace {

constexpr double explicit_safety = 0.8;  ///< of the stability limit
constexpr int max_substeps = 100000;

// Cost per tetrahedron, measured on the default patient in contact: an explicit substep, and an implicit step with its
// iterations. Only their ratio matters.
constexpr double explicit_cost = 16e-9;
constexpr double implicit_cost = 1.0e-6;

constexpr double linear_tolerance = 0.03;  ///< of the linear solves within Newton iterations
constexpr double newton_tolerance =
    1e-7;                            ///< relative residual that ends a step when there are no forces to compare with
constexpr double acceptable = 10.0;  ///< times the tolerance: a residual force above it has a step redone
constexpr double largest_advance = 0.5;  ///< of a tool within a substep, in radii of its thinnest end
constexpr double sound_share = 0.4;      ///< a tetrahedron with less of it left may invert

/// Force per coarse node; empty if there is none.
std::vector<Vec3> node_forces(const StepTask& task, int solid) {
    const WorldState& state = task.state;
    std::vector<Vec3> forces;
    add_drag(task.model, state, solid, task.tools, task.probes, forces);
    for (const NodeLoad& load : state.loads) {
        if (load.solid != solid || load.nodes.empty()) {
            continue;
        }
        forces.resize(state.solids[solid].position.size(), Vec3::Zero());
        for (int node : load.nodes) {
            forces[node] += load.total / static_cast<double>(load.nodes.size());
        }
    }
    return forces;
}

/// Substeps that keep tools from passing through what they could meet.
int substeps_for_tools(const StepTask& task, const ContactCandidates& candidates) {
    std::vector<std::uint8_t> near(task.tools.size(), 0);
    for (const ContactCandidate& candidate : candidates) {
        if (candidate.partner == ContactPartner::tool) {
            near[candidate.index] = 1;
        }
    }
    double count = 1.0;
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (near[i] != 0) {
            const ToolModel& tool = task.model.tools[i];
            count = std::max(count, std::ceil(travel(tool, task.tools[i]) / (largest_advance * thinnest(tool))));
        }
    }
    return static_cast<int>(std::min<double>(count, max_substeps));
}

/// Sizes of weight, loads and contact forces, summed [uN].
double all_forces(const StepTask& task, int solid, const ContactCandidates& candidates) {
    const SolidModel& model = task.model.solids[solid];
    const double displaced = model.buoyancy_density * mesh_volume(model.coarse);
    double sum = task.model.gravity.norm() * std::abs(remaining_mass(model, task.state.solids[solid]) - displaced);
    for (const NodeLoad& load : task.state.loads) {
        sum += load.solid == solid ? load.total.norm() : 0.0;
    }
    for (const ContactCandidate& candidate : candidates) {
        sum += candidate.force.norm();
    }
    return sum;
}

bool all_finite(const SolidState& state, const std::vector<BagState>& bags) {
    double sum = 0.0;
    for (std::size_t i = 0; i < state.position.size(); ++i) {
        sum += state.position[i].squaredNorm() + state.velocity[i].squaredNorm();
    }
    for (const BagState& bag : bags) {
        sum += bag.pose.position.squaredNorm() + bag.velocity.squaredNorm() +
               bag.pose.orientation.coeffs().squaredNorm() + bag.angular_velocity.squaredNorm();
    }
    return std::isfinite(sum);
}

std::vector<RigidUnknown> as_unknowns(const std::vector<BagState>& bags) {
    std::vector<RigidUnknown> unknowns;
    for (const BagState& bag : bags) {
        RigidUnknown unknown;
        unknown.pose = bag.pose;
        unknown.velocity << bag.velocity, bag.angular_velocity;
        unknowns.push_back(unknown);
    }
    return unknowns;
}

void take_unknowns(const std::vector<RigidUnknown>& unknowns, std::vector<BagState>& bags, PartnerPoses& poses) {
    for (std::size_t i = 0; i < bags.size(); ++i) {
        bags[i].pose = unknowns[i].pose;
        bags[i].velocity = unknowns[i].velocity.head<3>();
        bags[i].angular_velocity = unknowns[i].velocity.tail<3>();
        poses.bags[i] = bags[i].pose;
    }
}

void set_bag_poses(const std::vector<BagState>& bags, PartnerPoses& poses) {
    poses.bags.resize(bags.size());
    for (std::size_t i = 0; i < bags.size(); ++i) {
        poses.bags[i] = bags[i].pose;
    }
}

}  // namespace

void load_bag(const StepTask& task, std::span<const Pose> tools, BagState& bag) {
    if (task.state.capsule) {
        bag.load = capsule_load(task.model, *task.state.capsule, bag.pose, task.tools, tools);
        if (task.state.cortex || task.state.hydrodissection) {
            bag.load += contents_load(task.model, task.state, bag.pose);
        }
    }
}

SolidStepper::SolidStepper(const WorldModel& model, int solid, const PhysicsSettings& settings, ThreadPool& pool)
    : model_(&model),
      solid_model_(&model.solids[solid]),
      solid_(solid),
      settings_(settings),
      pool_(&pool),
      surface_(model.solids[solid]),
      energy_(model.solids[solid]) {}

Result<SolidStepper> SolidStepper::create(const WorldModel& model, int solid, const PhysicsSettings& settings,
                                          ThreadPool& pool, const SolidStepper* before) {
    SolidStepper stepper(model, solid, settings, pool);
    stepper.rest_step_ = before != nullptr ? before->rest_step_ : 0.0;
    stepper.lanes_ = before != nullptr
                         ? before->lanes_
                         : std::make_shared<LaneAssignment>(ExplicitSolid::assign(model.solids[solid].coarse));
    const Advance asked = model.solids[solid].advance;
    const bool stands_in = model.solids[solid].formulation == Formulation::edge_smoothed;
    if (asked == Advance::explicit_ || (asked == Advance::automatic && !stands_in)) {
        if (Status status = stepper.make_explicit(); !status) {
            return status.error();
        }
    }
    if (asked == Advance::implicit || (asked == Advance::automatic)) {
        if (Status status = stepper.make_implicit(); !status) {
            return status.error();
        }
    }
    return stepper;
}

/// A body whose elements no explicit step knows gets, where its implicit steps fail, those that come nearest.
Status SolidStepper::make_explicit() {
    const SolidModel* model = solid_model_;
    if (model->formulation == Formulation::edge_smoothed && model->advance != Advance::explicit_) {
        stand_in_ = std::make_unique<SolidModel>(*model);
        stand_in_->formulation = Formulation::nodal_pressure;
        model = stand_in_.get();
    }
    Result<ExplicitSolid> made = ExplicitSolid::create(*model, settings_.instruction_set, lanes_.get());
    if (!made) {
        return made.error();
    }
    explicit_.emplace(std::move(made).value());
    if (rest_step_ == 0.0 && !solid_model_->coarse.tets.empty()) {
        explicit_->load(rest_state(*solid_model_));
        rest_step_ = explicit_->stable_step();
    }
    return success();
}

Status SolidStepper::make_implicit() {
    Result<ImplicitSolid> made = ImplicitSolid::create(*solid_model_, *pool_, settings_.instruction_set);
    if (!made) {
        return made.error();
    }
    implicit_.emplace(std::move(made).value());
    return success();
}

bool SolidStepper::prefers_explicit(double dt) const {
    if (solid_model_->advance != Advance::automatic) {
        return solid_model_->advance == Advance::explicit_;
    }
    if (solid_model_->formulation == Formulation::edge_smoothed) {
        return false;
    }
    return rest_step_ > 0.0 && std::ceil(dt / (explicit_safety * rest_step_)) * explicit_cost < implicit_cost;
}

void SolidStepper::drop_caches() {
    if (implicit_) {
        implicit_->drop_caches();
    }
}

void SolidStepper::look_for_contacts(const StepTask& task) {
    surface_.update(*solid_model_, task.state.solids[solid_]);
    find_candidates(task.model, solid_, task.state, task.tools, task.dt, surface_, candidates_);
    find_piece_pairs(surface_, task.state.solids[solid_].position, pairs_);
    if (solid_ == 0) {
        find_grips(task.model, task.state, task.tools, task.probes, grips_);
    }
}

void SolidStepper::run(const StepTask& task, bool explicit_way, int divisions, StepTry& result) {
    result.candidates = candidates_;
    result.grips = grips_;
    result.report = SolidStepReport{};
    result.report.explicit_used = explicit_way;
    result.failure = StepFailure::none;
    result.bags = task.state.bags;
    result.solid = task.state.solids[solid_];
    // A way that only a fallback needs is made when it is first needed; the model has been checked by then.
    const Status ready =
        explicit_way ? (explicit_ ? success() : make_explicit()) : (implicit_ ? success() : make_implicit());
    if (!ready) {
        result.failure = StepFailure::not_converged;
        return;
    }
    if (explicit_way) {
        run_explicit(task, divisions, result);
    } else {
        run_implicit(task, divisions, result);
    }
    judge(task, result);
}

void SolidStepper::run_explicit(const StepTask& task, int divisions, StepTry& result) {
    explicit_->load(result.solid);
    const double limit = explicit_->stable_step();
    const double substeps = std::ceil(task.dt / (explicit_safety * limit)) * divisions;
    if (!(substeps <= max_substeps)) {
        result.failure = StepFailure::not_converged;
        return;
    }
    const int count = std::max(1, static_cast<int>(substeps));
    const double dt = task.dt / count;
    const std::vector<Vec3> loads = node_forces(task, solid_);
    PartnerPoses before;
    PartnerPoses after;
    place_tools(task.tools, 0.0, after);
    set_bag_poses(result.bags, before);
    before.tools = after.tools;
    explicit_contact_.begin(task.model, before, result.candidates, pairs_, result.grips, *explicit_);
    for (int i = 1; i <= count; ++i) {
        std::swap(before.tools, after.tools);
        place_tools(task.tools, static_cast<double>(i) / count, after);
        explicit_->predict(dt, task.model.gravity, loads);
        for (std::size_t b = 0; b < result.bags.size(); ++b) {
            load_bag(task, after.tools, result.bags[b]);
            accelerate_bag(task.model.bags[b], dt, result.bags[b]);
        }
        set_bag_poses(result.bags, before);
        after.bags = before.bags;
        explicit_contact_.resolve(dt, before, after, result.bags);
        explicit_->move(dt);
        for (BagState& bag : result.bags) {
            move_bag(dt, bag);
        }
    }
    explicit_->store(result.solid);
    result.report.substeps = count;
    result.report.stable_step_s = limit;
}

void SolidStepper::run_implicit(const StepTask& task, int divisions, StepTry& result) {
    const int count = divisions * substeps_for_tools(task, result.candidates);
    const double dt = task.dt / count;
    set_springs(dt, remaining_mass(*solid_model_, result.solid), result.candidates);
    const std::vector<Vec3> loads = node_forces(task, solid_);
    ImplicitSettings settings;
    settings.tolerance = settings_.max_newton > 1 ? linear_tolerance : settings_.tolerance;
    settings.max_newton = settings_.max_newton * (divisions > 1 ? 2 : 1);
    settings.newton_tolerance = newton_tolerance;
    settings.foretell = true;
    settings.force_tolerance = settings_.tolerance * all_forces(task, solid_, result.candidates);
    PartnerPoses poses;
    set_bag_poses(result.bags, poses);
    SolidState from;
    const CouplingFunction coupling = [&](const std::vector<Vec3>& position, std::span<const RigidUnknown> bodies,
                                          std::vector<ContactTerm>& contacts, std::vector<RigidTerm>& rigid) {
        rigid.resize(bodies.size());
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            poses.bags[b] = bodies[b].pose;
            rigid[b] = bag_term(task.model.bags[b], result.bags[b], bodies[b].pose, bodies[b].velocity, dt);
        }
        contact_terms(task.model, result.candidates, position, poses, divisions == 1, contacts);
    };
    for (int i = 1; i <= count && result.failure == StepFailure::none; ++i) {
        place_tools(task.tools, static_cast<double>(i) / count, poses);
        carry_over(result.candidates);
        std::swap(from, result.solid);
        std::vector<RigidUnknown> bodies = as_unknowns(result.bags);
        const ImplicitReport report =
            implicit_->step(from, task.model.gravity, loads, dt, settings, coupling, bodies, result.solid);
        take_unknowns(bodies, result.bags, poses);
        settle_contacts(task.model, result.solid.position, poses, dt, result.candidates);
        result.report.newton_iterations += report.newton_iterations;
        result.report.solver_iterations += report.linear_iterations;
        result.report.residual = std::max(result.report.residual, report.newton_residual);
        if (!report.converged && !(report.force <= acceptable * settings.force_tolerance)) {
            result.failure = StepFailure::not_converged;
        }
    }
    result.report.substeps = count;
    result.report.stable_step_s = rest_step_;
}

void SolidStepper::judge(const StepTask& task, StepTry& result) {
    if (!all_finite(result.solid, result.bags)) {
        result.failure = StepFailure::not_finite;
        return;
    }
    result.report.kinetic_energy = energy_.kinetic(*solid_model_, result.solid);
    if (settings_.elastic_energy) {
        result.report.elastic_energy = energy_.elastic(*solid_model_, result.solid);
    }
    result.report.inverted = energy_.inverted(*solid_model_, result.solid, 0.0);
    if (result.failure == StepFailure::none && result.report.inverted > 0 &&
        energy_.inverted(*solid_model_, result.solid, sound_share) >
            energy_.inverted(*solid_model_, task.state.solids[solid_], sound_share)) {
        result.failure = StepFailure::inverted;
    }
}

}  // namespace rhexis
