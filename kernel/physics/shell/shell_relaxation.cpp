// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/shell/shell_relaxation.hpp"

#include "base/assert.hpp"
#include "physics/shell/shell_body.hpp"

namespace rhexis {

ShellRelaxationStep::ShellRelaxationStep(const ShellModel& model) {
    if (model.relaxation) {
        share_ = model.relaxation->branch_share;
        time_ = relaxation_time(*model.relaxation, model.temperature);
    }
}

void ShellRelaxationStep::begin(const std::vector<double>& branch, double dt, const std::vector<double>& position,
                                ShellBody& body) {
    if (!time_) {
        return;
    }
    step_ = zener_step(share_, *time_, dt);
    body.deformation(position, start_);
    RHEXIS_ASSERT(branch.size() == start_.size());
    natural_.resize(start_.size());
    for (std::size_t i = 0; i < natural_.size(); ++i) {
        natural_[i] = step_.natural(start_[i], branch[i]);
    }
    body.set_natural(step_.stiffness(), natural_);
}

void ShellRelaxationStep::finish(const std::vector<double>& branch, const std::vector<double>& position,
                                 ShellBody& body, std::vector<double>& result) {
    if (!time_) {
        return;
    }
    body.deformation(position, end_);
    result.resize(end_.size());
    for (std::size_t i = 0; i < end_.size(); ++i) {
        result[i] = step_.second_at_end(branch[i], start_[i], end_[i]);
    }
}

}  // namespace rhexis
