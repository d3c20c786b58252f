// SPDX-License-Identifier: GPL-3.0-or-later
// What may stand between a virtual surgeon's hands and the simulation: a tracking system, say.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "session/trial.hpp"

namespace rhexis {

/// How hands came through.
struct LinkFigures {
    std::string name;  ///< of what they came through
    std::int64_t steps = 0;
    std::int64_t stood = 0;    ///< steps in which the clock would have stood
    std::int64_t present = 0;  ///< samples of instruments in a hand
    std::int64_t unseen = 0;   ///< of those, told as absent
    double rms_mm = 0.0;       ///< of a tip from where the hand had it then, delay and all
    double farthest_mm = 0.0;
};

class SampleLink {
public:
    SampleLink() = default;
    SampleLink(const SampleLink&) = delete;
    SampleLink& operator=(const SampleLink&) = delete;
    virtual ~SampleLink() = default;
    /// Before the first step: the instruments of the scene, in its order, and the length of a step [s]. The error says
    /// which instrument it does not know.
    virtual Status begin(const std::vector<std::string>& instruments, double step_s) = 0;
    /// What the simulation is given in a step, of what hands did in it: one sample of each instrument either way.
    virtual Result<std::vector<DeviceSample>> through(std::span<const DeviceSample> hands) = 0;
    /// Of all steps so far.
    [[nodiscard]] virtual LinkFigures figures() const = 0;
};

/// Compares what a hand did and what came of it, step by step.
class LinkTally {
public:
    /// One sample of each instrument either way; instruments that `tracked` is false for are not compared.
    void add(std::span<const DeviceSample> hands, std::span<const DeviceSample> seen, const std::vector<bool>& tracked);
    void stood() { figures_.stood += 1; }
    [[nodiscard]] LinkFigures figures(std::string name) const;

private:
    LinkFigures figures_{};
    double squares_ = 0.0;
};

/// Each instrument lies a little beside where the hand has it, always the same way: how much of a difference between
/// two attempts is chance.
class MovedSamples final : public SampleLink {
public:
    /// So far [mm], each instrument in a direction drawn by this seed.
    MovedSamples(double distance_mm, std::uint64_t seed) : distance_mm_(distance_mm), seed_(seed) {}

    Status begin(const std::vector<std::string>& instruments, double step_s) override;
    Result<std::vector<DeviceSample>> through(std::span<const DeviceSample> hands) override;
    [[nodiscard]] LinkFigures figures() const override;

private:
    double distance_mm_;
    std::uint64_t seed_;
    std::vector<Vec3> by_{};     ///< instrument
    std::vector<bool> moved_{};  ///< by instrument
    LinkTally tally_{};
};

/// Whoever operates, seen through a link.
class LinkedOperator final : public Operator {
public:
    /// Both outlive it; the link has begun.
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
