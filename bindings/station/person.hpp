// SPDX-License-Identifier: GPL-3.0-or-later
// A person operates: events of a step make what hands and foot do in it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "station/desk.hpp"
#include "station/event_source.hpp"
#include "station/hands.hpp"
#include "station/instructor.hpp"
#include "station/theatre.hpp"
#include "trial/attempt.hpp"

namespace rhexis::station {

/// A tracking system, among devices that a person operates with.
inline constexpr const char* tracked_device = "vrpn";

struct PersonOptions {
    Mapping mapping;
    std::string device;              ///< "mouse", "gamepad", tracked_device
    std::string root;                ///< folder of scripts/
    std::uint64_t show_every = 1;    ///< steps per picture
    bool wait_for_pictures = false;  ///< each is drawn before the next step: stepped
    bool has_ghost = false;          ///< there is an expert's way to show
    bool warns = false;              ///< from the beginning, of what is about to go wrong
    std::string title{};             ///< of the exercise
    bool sounds = false;             ///< there is a loudspeaker to tell
};

class Person final : public Guest {
public:
    /// writer: null, the events are not kept; theatre: null, there is no monitor. Everything outlives the person.
    Person(PersonOptions options, EventSource& source, Desk& desk, EventWriter* writer, Theatre* theatre = nullptr)
        : options_(std::move(options)), source_(source), desk_(desk), writer_(writer), theatre_(theatre) {}

    void meet(ExerciseHost& host) override { host_ = &host; }
    [[nodiscard]] std::string name() const override { return "person"; }
    [[nodiscard]] std::string device() const override { return options_.device; }
    [[nodiscard]] std::optional<Pace> pace() const override;
    std::optional<std::uint64_t> goes_back() override { return std::exchange(back_, std::nullopt); }

    Status begin(Timeline& timeline) override;
    Result<OperatorStep> operate(Timeline& timeline) override;
    Status look(Moment& moment) override;
    Status ended(Timeline& timeline) override;

private:
    /// To the trainee.
    struct Said {
        double time_s = 0.0;
        std::string text;
    };

    Result<bool> take_events(const Session& session);
    void heed_wishes(const Session& session);
    void go_back(const Session& session, std::uint64_t step);
    void note_aids(double dt);
    Status warn();
    void show(const Session& session, bool waits);
    void sound(const Session& session);
    Status show_theatre(const Session& session, bool ended);

    PersonOptions options_;
    EventSource& source_;
    Desk& desk_;
    EventWriter* writer_;
    Theatre* theatre_;
    ExerciseHost* host_ = nullptr;
    Instructor instructor_;
    std::optional<PanelReader> panel_;
    TheatreMoment moment_;
    std::vector<std::string> warnings_;  ///< that show now
    std::optional<HoldScript> holds_;
    std::shared_ptr<const Stand> stand_;
    std::optional<Hands> hands_;
    std::optional<Surroundings> around_;
    std::vector<Said> said_;
    bool exam_ = false;                  ///< aids are refused
    std::uint64_t made_ = 0;             ///< steps, those that were gone back over too: to which events belong
    std::uint64_t kept_step_ = 0;        ///< the moment to go back to
    std::optional<std::uint64_t> back_;  ///< wanted now
    std::vector<Command> aids_;          ///< to be told with the next step
    double guided_s_ = 0.0;              ///< not yet told
    double slowed_s_ = 0.0;              ///< not yet told
    double theatre_due_s_ = 0.0;         ///< of the wall clock, when the monitor is shown the next moment
    double score_due_s_ = 0.0;           ///< likewise, with the points so far
};

/// A camera as zoom and light are turned; what the eyepiece shows stays as wide.
Camera adjusted(Camera camera, const HandsState& hands);

/// As they are now.
Surroundings surroundings_of(const Session& session, const HandsState& hands);

}  // namespace rhexis::station
