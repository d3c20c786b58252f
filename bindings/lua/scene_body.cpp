// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/scene_body.hpp"

namespace rhexis::lua {
namespace {

const char* describe(StepFailure failure) {
    switch (failure) {
        case StepFailure::not_finite:
            return "numbers ran away";
        case StepFailure::not_converged:
            return "the solver did not converge";
        case StepFailure::inverted:
            return "elements turned inside out";
        default:
            return "no failure";
    }
}

}  // namespace

DeviceSample& SceneBody::order(int tool) {
    const auto count = static_cast<std::size_t>(tool) + 1;
    while (orders_.size() < count) {
        const int index = static_cast<int>(orders_.size());
        const ToolState& now = tools()[orders_.size()];
        orders_.push_back({index, now.present, now.pose, now.jaw, now.pedal});
    }
    return orders_[static_cast<std::size_t>(tool)];
}

Status SceneBody::step() {
    if (!model().tools.empty()) {
        order(static_cast<int>(model().tools.size()) - 1);  // every tool has its order
    }
    Result<StepOutcome> outcome = advance(orders_);
    if (!outcome) {
        return outcome.error();
    }
    outcome_ = std::move(outcome).value();
    note_elements();
    if (outcome_.failure != StepFailure::none) {
        return Error{"step " + std::to_string(steps()) + " could not be solved: " + describe(outcome_.failure) +
                         "; nothing moved in it",
                     "", ""};
    }
    return success();
}

Status SceneBody::restore(const Snapshot& snapshot) {
    Status status = put_back(snapshot);
    if (status) {
        orders_.clear();  // the tools stay where the snapshot has them until they are moved
        note_elements();
    }
    return status;
}

void SceneBody::note_elements() {
    bool same = present_.size() == state().solids.size();
    for (std::size_t k = 0; same && k < present_.size(); ++k) {
        same = present_[k] == state().solids[k].present;
    }
    if (same) {
        return;
    }
    ++revision_;
    present_.clear();
    for (const SolidState& solid : state().solids) {
        present_.push_back(solid.present);
    }
}

}  // namespace rhexis::lua
