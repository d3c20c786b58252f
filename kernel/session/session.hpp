// SPDX-License-Identifier: GPL-3.0-or-later
// A session: one scene being operated on. Owns everything; several sessions live side by side in one process.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/log.hpp"
#include "base/profile.hpp"
#include "base/result.hpp"
#include "flow/command.hpp"
#include "flow/contact.hpp"
#include "flow/device_sample.hpp"
#include "flow/frame.hpp"
#include "flow/observation.hpp"
#include "flow/percept.hpp"
#include "flow/scene.hpp"
#include "flow/step_outcome.hpp"
#include "flow/world.hpp"

namespace rhexis {

/// Everything needed to go on from a moment: restoring it and stepping gives the same hashes.
struct Snapshot {
    WorldState world;
    std::vector<ToolState> tools;
    std::map<std::string, double> settings;
    std::vector<double> observer_memory;
    std::uint64_t step = 0;
};

class Session {
public:
    /// Checks every field of the description against its range; names the field, the value and the range.
    static Result<Session> create(const SceneDescription& scene, std::uint64_t seed);
    ~Session();
    Session(Session&&) noexcept;
    Session& operator=(Session&&) noexcept;

    /// The map of the program: commands, input, tools, physics, topology, observe, in this order.
    StepOutcome step(std::span<const DeviceSample> samples, std::span<const Command> commands);

    [[nodiscard]] const SceneDescription& scene() const;
    [[nodiscard]] const EyeModel& eye() const;
    [[nodiscard]] const WorldModel& world() const;
    [[nodiscard]] const WorldState& state() const;
    [[nodiscard]] std::span<const ToolState> tools() const;
    /// All of them, by name, as they are now.
    [[nodiscard]] const std::map<std::string, double>& settings() const;
    [[nodiscard]] const ContactSet& contacts() const;
    [[nodiscard]] const ObservationSchema& schema() const;
    [[nodiscard]] const Observation& observation() const;
    [[nodiscard]] Percept percept() const;
    [[nodiscard]] Frame frame() const;
    [[nodiscard]] std::uint64_t state_hash() const;
    [[nodiscard]] std::uint64_t step_count() const;
    [[nodiscard]] double time_s() const;
    [[nodiscard]] const Profile& profile() const;
    [[nodiscard]] const Log& log() const;

    /// For checkpoints: this session goes on as one that is restored from it does.
    [[nodiscard]] Snapshot snapshot() const;
    /// The same for others: this session goes on as if nobody had asked.
    [[nodiscard]] Snapshot copy_state() const;
    /// Fails when the snapshot does not fit the scene.
    Status restore(const Snapshot& snapshot);

private:
    struct Parts;
    explicit Session(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
