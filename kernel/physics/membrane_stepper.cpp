// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/membrane_stepper.hpp"

#include <string>
#include <utility>

namespace rhexis {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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
    std::unique_ptr<MembraneBody> body =
        std::make_unique<MembraneBody>(*model_, state.sheet, step_ ? body_ : nullptr);
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

std::vector<double> MembraneStepper::by_rows(const MembraneState& state) const {
    std::vector<double> x(3 * state.position.size() + 1, 0.0);
    for (std::size_t node = 0; node < state.position.size(); ++node) {
        Eigen::Map<Vec3>(x.data() + 3 * at(body_->row_of()[node])) = state.position[node];
    }
    return x;
}

double MembraneStepper::energy(const MembraneState& state) {
    follow(state);
    return body_->energy(by_rows(state));
}

std::vector<Vec3> MembraneStepper::forces(const MembraneState& state) {
    follow(state);
    std::vector<double> force;
    body_->forces(by_rows(state), force);
    std::vector<Vec3> result(state.position.size());
    for (std::size_t node = 0; node < result.size(); ++node) {
        result[node] = Eigen::Map<const Vec3>(force.data() + 3 * at(body_->row_of()[node]));
    }
    return result;
}

}  // namespace rhexis
