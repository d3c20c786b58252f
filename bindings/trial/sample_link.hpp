// SPDX-License-Identifier: GPL-3.0-or-later
// What may stand between a virtual surgeon's hands and the simulation: a tracking system, say.
#pragma once

#include <span>
#include <vector>

#include "session/trial.hpp"

namespace rhexis {

class SampleLink {
public:
    virtual ~SampleLink() = default;
    /// Before the first step: the instruments of the scene, in its order, and the length of a step [s]. The error says
    /// which instrument it does not know.
    virtual Status begin(const std::vector<std::string>& instruments, double step_s) = 0;
    /// What the simulation is given in a step, of what hands did in it: one sample of each instrument either way.
    virtual Result<std::vector<DeviceSample>> through(std::span<const DeviceSample> hands) = 0;
};

/// Whoever operates, seen through a link.
class LinkedOperator final : public Operator {
public:
    /// Both outlive it.
    LinkedOperator(Operator& inner, SampleLink& link) : inner_(inner), link_(link) {}

    Status begin(Timeline& timeline) override;
    Result<OperatorStep> operate(Timeline& timeline) override;
    Status stepped(const Session& session, const StepOutcome& outcome) override {
        return inner_.stepped(session, outcome);
    }

private:
    Operator& inner_;
    SampleLink& link_;
    std::vector<DeviceSample> hands_{};  ///< as they are, by instrument
};

}  // namespace rhexis
