// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane_stepper.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace rhexis {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Forces of a scene are some 1,000 uN.
const ImplicitSettings scene_settings{
    .tolerance = 1e-4, .max_newton = 6, .newton_tolerance = 1e-3, .force_tolerance = 0.5};

}  // namespace

Result<MembraneStepper> MembraneStepper::create(const MembraneModel& model, std::string_view instruction_set) {
    if (Status status = check_membrane(model); !status) {
        return status.error();
    }
    const linear_kernel::Kernel* const kernel = linear_kernel::choose(instruction_set);
    if (kernel == nullptr) {
        return Error{"unknown or missing instruction set \"" + std::string(instruction_set) + "\"", "instruction_set",
                     "\"\", \"baseline\", \"avx2\" or \"avx512\", as the machine has"};
    }
    return MembraneStepper(model, *kernel);
}

/// Takes over the state's sheet.
void MembraneStepper::follow(const MembraneState& state) {
    if (step_ && body_->sheet() == state.sheet) {
        return;
    }
    std::unique_ptr<MembraneBody> body = std::make_unique<MembraneBody>(*model_, state.sheet, step_ ? body_ : nullptr);
    body_ = body.get();
    step_.emplace(std::move(body), *kernel_);
}

ImplicitReport MembraneStepper::step(const MembraneState& state, std::span<const Vec3> external, double dt,
                                     const ImplicitSettings& settings, const CouplingFunction& coupling,
                                     MembraneState& next) {
    follow(state);
    const ImplicitReport report = step_->step(state.position, state.velocity, Vec3::Zero(), external, dt, settings,
                                              coupling, no_bodies_, motion_);
    next = state;
    next.position = motion_.position;
    next.velocity = motion_.velocity;
    return report;
}

bool MembraneStepper::run(const MembraneState& state, double dt, int divisions, MembraneState& next,
                          MembraneStepReport& report) {
    external_.clear();
    if (!state.loads.empty()) {
        external_.assign(state.position.size(), Vec3::Zero());
    }
    for (const SheetLoad& load : state.loads) {
        for (const int node : load.nodes) {
            external_[at(node)] += load.total / static_cast<double>(load.nodes.size());
        }
    }
    report = MembraneStepReport{};
    report.substeps = divisions;
    next = state;
    for (int i = 0; i < divisions; ++i) {
        std::swap(between_, next);
        const ImplicitReport one = step(between_, external_, dt / divisions, scene_settings, {}, next);
        report.newton_iterations += one.newton_iterations;
        report.linear_iterations += one.linear_iterations;
        report.force = one.force;
        if (!std::isfinite(one.newton_residual) || !std::isfinite(one.force)) {
            return false;
        }
    }
    return true;
}

bool MembraneStepper::advance(const MembraneState& state, double dt, MembraneState& next, MembraneStepReport& report,
                              int& rollbacks) {
    for (const int divisions : {1, 4, 16}) {
        if (run(state, dt, divisions, next, report)) {
            return true;
        }
        ++rollbacks;
        drop_caches();
    }
    next = state;
    next.velocity.assign(next.velocity.size(), Vec3::Zero());
    return false;
}

}  // namespace rhexis
