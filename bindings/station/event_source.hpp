// SPDX-License-Identifier: GPL-3.0-or-later
// Where a person's events come from, and to which step each belongs: this is the station's clock.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/output_file.hpp"
#include "base/result.hpp"
#include "station/desk.hpp"
#include "station/user_event.hpp"
#include "trial/attempt_facts.hpp"

namespace rhexis::station {

class EventSource {
public:
    virtual ~EventSource() = default;
    /// Events of the step after `step` others, which is due now; more than once where the clock waits. hands, around:
    /// as they are.
    virtual Result<std::vector<UserEvent>> take(std::uint64_t step, bool waits, const Hands& hands,
                                                const Surroundings& around, const Session& session) = 0;
    /// Nothing comes any more, so that waiting is in vain.
    [[nodiscard]] virtual bool over() const { return false; }
    /// Simulated seconds per second of the clock, of late.
    [[nodiscard]] virtual double slowed() const { return 1.0; }
    /// How it kept to the wall clock; none: there is none.
    [[nodiscard]] virtual std::optional<Pace> pace() const { return std::nullopt; }
    /// Number of the last posted event that was given.
    [[nodiscard]] virtual std::uint64_t last_number() const { return 0; }
};

/// The wall clock: a step each time that one is due. What runs late by more than a moment is not caught up.
class WallClock final : public EventSource {
public:
    /// looks_every_s: for events, while the clock stands.
    WallClock(Desk& desk, double step_s, double looks_every_s = 0.05)
        : desk_(desk), step_s_(step_s), looks_every_s_(looks_every_s) {}
    Result<std::vector<UserEvent>> take(std::uint64_t step, bool waits, const Hands& hands, const Surroundings& around,
                                        const Session& session) override;
    [[nodiscard]] double slowed() const override { return slowed_; }
    [[nodiscard]] std::uint64_t last_number() const override { return number_; }
    [[nodiscard]] std::optional<Pace> pace() const override;
    /// The moment that the last step stands for, or, while the clock stands, of the last look [s].
    [[nodiscard]] double now_s() const { return now_s_; }

private:
    void note(double late_s, double lost_s);
    [[nodiscard]] bool was_away(double now) const;

    Desk& desk_;
    double step_s_;
    double looks_every_s_;
    std::vector<float> late_steps_{};  ///< of each step, left out those of seconds with steal
    std::vector<float> this_second_{};
    double second_began_s_ = 0.0;
    double stolen_before_s_ = 0.0;
    int steal_s_ = 0;
    double lost_s_ = 0.0;
    double lost_this_second_s_ = 0.0;
    double now_s_ = 0.0;
    double due_s_ = 0.0;       ///< of the next step; 0: as soon as it is asked for
    double left_s_ = 0.0;      ///< when the clock was asked last; 0: not yet
    double left_cpu_s_ = 0.0;  ///< of the process, by then
    double slowed_ = 1.0;
    std::uint64_t number_ = 0;
};

/// An attempt's events, and to what they belong.
struct EventFile {
    nlohmann::json header = nlohmann::json::object();  ///< "curriculum", "seed", "set", "mapping"
    struct Line {
        std::uint64_t step = 0;
        UserEvent event;
    };
    std::vector<Line> lines;
};

/// The error names the line.
Result<EventFile> read_events(const std::string& path);

class EventWriter {
public:
    static Result<EventWriter> create(const std::string& path, const nlohmann::json& header);
    Status add(std::uint64_t step, const UserEvent& event);
    Status finish() { return file_.finish(); }

private:
    explicit EventWriter(OutputFile file) : file_(std::move(file)) {}
    OutputFile file_;
};

/// No clock: each event has its step.
class Steps final : public EventSource {
public:
    explicit Steps(EventFile file) : file_(std::move(file)) {}
    Result<std::vector<UserEvent>> take(std::uint64_t step, bool waits, const Hands& hands, const Surroundings& around,
                                        const Session& session) override;
    [[nodiscard]] bool over() const override { return next_ >= file_.lines.size(); }

private:
    EventFile file_;
    std::size_t next_ = 0;
};

}  // namespace rhexis::station
