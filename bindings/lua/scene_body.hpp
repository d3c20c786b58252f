// SPDX-License-Identifier: GPL-3.0-or-later
// What a script's scene is behind its handle: a bare world that the script filled itself, or a session in an eye.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/result.hpp"
#include "flow/device_sample.hpp"
#include "flow/frame.hpp"
#include "flow/step_outcome.hpp"
#include "flow/world.hpp"
#include "session/session.hpp"

namespace rhexis::lua {

class SceneBody {
public:
    SceneBody() = default;
    virtual ~SceneBody() = default;
    SceneBody(const SceneBody&) = delete;
    SceneBody& operator=(const SceneBody&) = delete;

    [[nodiscard]] virtual const WorldModel& model() const = 0;
    [[nodiscard]] virtual const WorldState& state() const = 0;
    [[nodiscard]] virtual std::span<const ToolState> tools() const = 0;
    [[nodiscard]] virtual const ContactSet& contacts() const = 0;
    [[nodiscard]] virtual std::uint64_t steps() const = 0;
    [[nodiscard]] virtual double step_s() const = 0;
    [[nodiscard]] virtual std::uint64_t state_hash() const = 0;
    virtual Frame frame() = 0;
    virtual Snapshot snapshot() = 0;

    /// One step; an unsolved one leaves the positions as they were and is the error.
    Status step();
    Status restore(const Snapshot& snapshot);
    /// How the last step went.
    [[nodiscard]] const StepOutcome& outcome() const { return outcome_; }
    /// What tool i is to do in the next step; index of WorldModel::tools.
    DeviceSample& order(int tool);
    /// Changes whenever elements of any solid appear or go.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    /// The session behind an eye's scene, null for a bare one.
    virtual Session* session() { return nullptr; }

protected:
    virtual Result<StepOutcome> advance(std::span<const DeviceSample> samples) = 0;
    virtual Status put_back(const Snapshot& snapshot) = 0;
    void note_elements();

private:
    std::vector<DeviceSample> orders_;
    StepOutcome outcome_;
    std::uint64_t revision_ = 0;
    std::vector<std::vector<std::uint8_t>> present_;  // as of revision_
};

}  // namespace rhexis::lua
