// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt at an exercise for tests: by its virtual surgeon, or by a hand that the test leads from place to place.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "lua/exercise_host.hpp"
#include "math/rotation.hpp"
#include "session/session.hpp"

namespace rhexis::test {

class Attempt {
public:
    explicit Attempt(const std::string& surgeon = "none", std::uint64_t seed = 1,
                     std::map<std::string, std::string> set = {}, const std::string& curriculum = "groove") {
        ExerciseOptions options;
        options.curriculum = curriculum;
        options.surgeon = surgeon;
        options.seed = seed;
        options.set = std::move(set);
        options.root = std::filesystem::current_path().string();
        Result<ExerciseHost> host = ExerciseHost::load(options);
        REQUIRE_MESSAGE(host.ok(), (host ? std::string() : host.error().text()));
        host_ = std::make_unique<ExerciseHost>(std::move(host).value());
        Result<Session> session = Session::create(host_->scene(), seed);
        REQUIRE_MESSAGE(session.ok(), (session ? std::string() : session.error().text()));
        session_ = std::make_unique<Session>(std::move(session).value());
        REQUIRE(host_->start(session_->schema(), session_->scene().instruments).ok());
    }

    /// One step with these samples; without, the virtual surgeon's. False once the exercise is over.
    bool step(std::vector<DeviceSample> samples = {}) {
        Result<std::vector<Command>> commands = host_->observe(session_->observation());
        REQUIRE_MESSAGE(commands.ok(), (commands ? std::string() : commands.error().text()));
        if (host_->finished()) {
            return false;
        }
        if (host_->has_surgeon()) {
            Result<OperatorStep> own = host_->operate(session_->percept());
            REQUIRE_MESSAGE(own.ok(), (own ? std::string() : own.error().text()));
            samples = std::move(own.value().samples);
            for (DeviceSample& sample : samples) {
                sample.pedal = std::min(sample.pedal, most_pedal_);
            }
        }
        const StepOutcome outcome = session_->step(samples, commands.value());
        REQUIRE(outcome.failure == StepFailure::none);
        rollbacks_ += outcome.rollbacks;
        return true;
    }

    /// A foot that goes no further, whatever the virtual surgeon wants.
    void limit_pedal(double most) { most_pedal_ = most; }

    void run(double seconds) {
        const double end = session_->time_s() + seconds;
        while (session_->time_s() < end - 1e-9 && step()) {
        }
    }

    /// Moves the tip of the first instrument in a straight line at an even speed [mm/s]; its shaft passes the wound.
    void move(const Vec3& place, double speed, double pedal) {
        const Vec3 from = tip_;
        const int steps = std::max(1, static_cast<int>(std::lround((place - from).norm() / speed / dt())));
        for (int i = 1; i <= steps; ++i) {
            tip_ = from + (place - from) * (static_cast<double>(i) / steps);
            if (!step({sample(pedal)})) {
                return;
            }
        }
    }

    void hold(double seconds, double pedal) {
        for (double t = 0.0; t < seconds; t += dt()) {
            if (!step({sample(pedal)})) {
                return;
            }
        }
    }

    /// Puts the tip into the eye at once, at a place where nothing is.
    void appear(const Vec3& place) { tip_ = place; }

    /// A step without an instrument in the eye.
    void withdraw() {
        DeviceSample gone;
        step({gone});
        step({gone});
    }

    [[nodiscard]] double measure(const std::string& name) const {
        const ObservationSchema& schema = session_->schema();
        for (std::size_t i = 0; i < schema.size(); ++i) {
            if (schema[i].name == name) {
                return session_->observation().values[i];
            }
        }
        FAIL("no measure " << name);
        return 0.0;
    }

    [[nodiscard]] nlohmann::json result() {
        Result<nlohmann::json> found = host_->result();
        REQUIRE(found.ok());
        return found.value();
    }

    /// How an event ended, or "" when it was not raised.
    [[nodiscard]] std::string outcome(const std::string& event) {
        const nlohmann::json found = result();
        for (const nlohmann::json& raised : found.at("events")) {
            if (raised.at("id") == event) {
                return raised.at("outcome");
            }
        }
        return {};
    }

    [[nodiscard]] Session& session() { return *session_; }
    [[nodiscard]] ExerciseHost& host() { return *host_; }
    [[nodiscard]] int rollbacks() const { return rollbacks_; }
    [[nodiscard]] double dt() const { return session_->scene().step_s; }

private:
    [[nodiscard]] DeviceSample sample(double pedal) const {
        DeviceSample sample;
        sample.present = true;
        sample.pose.position = tip_;
        const Vec3 shaft = session_->eye().anatomy.incision - tip_;
        sample.pose.orientation = turn_of_z(shaft);
        sample.pedal = pedal;
        return sample;
    }

    std::unique_ptr<ExerciseHost> host_;
    std::unique_ptr<Session> session_;
    Vec3 tip_ = Vec3::Zero();
    double most_pedal_ = 3.0;
    int rollbacks_ = 0;
};

}  // namespace rhexis::test
