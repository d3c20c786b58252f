// SPDX-License-Identifier: GPL-3.0-or-later
// A session as a script's scene: the eye of a patient, with measures, driven by hand.
#pragma once

#include <vector>

#include "flow/command.hpp"
#include "lua/scene_body.hpp"

namespace rhexis::lua {

class EyeScene final : public SceneBody {
public:
    explicit EyeScene(Session session);

    /// Read by the session at the start of the next step.
    void command(Command command) { commands_.push_back(std::move(command)); }

    [[nodiscard]] const WorldModel& model() const override { return session_.world(); }
    [[nodiscard]] const WorldState& state() const override { return session_.state(); }
    [[nodiscard]] std::span<const ToolState> tools() const override { return session_.tools(); }
    [[nodiscard]] const ContactSet& contacts() const override { return session_.contacts(); }
    [[nodiscard]] std::uint64_t steps() const override { return session_.step_count(); }
    [[nodiscard]] double step_s() const override { return session_.scene().step_s; }
    [[nodiscard]] std::uint64_t state_hash() const override { return session_.state_hash(); }
    Frame frame() override { return session_.frame(); }
    Snapshot snapshot() override { return session_.snapshot(); }
    Session* session() override { return &session_; }

private:
    Result<StepOutcome> advance(std::span<const DeviceSample> samples) override;
    Status put_back(const Snapshot& snapshot) override { return session_.restore(snapshot); }

    Session session_;
    std::vector<Command> commands_;
};

}  // namespace rhexis::lua
