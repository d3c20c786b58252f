// SPDX-License-Identifier: GPL-3.0-or-later
// Scripted reports of a tracking system, and what the simulation is given of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "base/rng.hpp"
#include "input/step_input.hpp"
#include "input/tracked_hands.hpp"

using namespace rhexis;

namespace {

constexpr std::int64_t ahead_us = 1'790'000'000'000'000;
constexpr std::int64_t step_us = 10'000;

Quat about_y(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec3::UnitY())); }

/// A phaco tip that goes to and fro at up to 12 mm/s and turns, a spatula that stands still with a trembling of
/// nothing.
Pose phaco_at(double t) { return {Vec3(4.0 * std::sin(3.0 * t), -3.0, 1.0), about_y(0.2 * std::sin(2.0 * t))}; }
Pose spatula_at(double) { return {Vec3(-4.0, 0.0, 1.0), Quat::Identity()}; }

struct Scene {
    TrackedHands hands{TrackedModel{{"phaco", "spatula", "microscope"}, Pose{}}};
    std::int64_t t_us = 0;
    std::int64_t sender_us = ahead_us;  ///< its clock less ours
    std::function<std::int64_t()> way_us = [] { return std::int64_t{300}; };
    std::function<Pose(double)> phaco = phaco_at;
    bool phaco_seen = true;
    bool spatula_seen = true;
    std::vector<bool> inside{};
    double farthest_mm = 0.0;  ///< that the phaco tip was given to go in one step
    std::optional<Pose> given{};

    void tell(const std::string& device, decltype(DeviceReport::what) what) {
        hands.take({device, t_us + sender_us, std::move(what)}, t_us + way_us());
    }
    void tell_pose(const std::string& device, const Pose& pose) {
        tell(device, PoseReport{0, pose.position, pose.orientation});
    }
    /// One step of 10 ms: reports, then the look.
    TrackingState step() {
        const double t = 1e-6 * static_cast<double>(t_us);
        if (phaco_seen) {
            tell_pose("phaco", phaco(t));
        }
        if (spatula_seen) {
            tell_pose("spatula", spatula_at(t));
        }
        t_us += step_us;
        hands.look(t_us, inside);
        const DeviceSample& sample = hands.samples()[0];
        if (given && sample.present) {
            farthest_mm = std::max(farthest_mm, (sample.pose.position - given->position).norm());
        }
        given = sample.present ? std::optional<Pose>(sample.pose) : std::nullopt;
        return hands.state();
    }
    void run(double seconds) {
        for (int i = 0; i < static_cast<int>(100.0 * seconds + 0.5); ++i) {
            step();
        }
    }
    /// Steps until it is so, at most for these seconds; how many were needed.
    int steps_until(TrackingState state, double seconds) {
        int steps = 0;
        while (hands.state() != state && steps < static_cast<int>(100.0 * seconds)) {
            step();
            ++steps;
        }
        return steps;
    }
    [[nodiscard]] const DeviceSample& sample(std::size_t i) const { return hands.samples()[i]; }
    /// How far the phaco tip of the samples is from where the hand was `delay` before the step [mm].
    [[nodiscard]] double off_mm(std::int64_t delay_us) const {
        const double t = 1e-6 * static_cast<double>(t_us - delay_us);
        return (sample(0).pose.position - phaco(t).position).norm();
    }
};

Scene running() {
    Scene scene;
    scene.run(1.0);
    REQUIRE(scene.hands.state() == TrackingState::running);
    return scene;
}

}  // namespace

TEST_SUITE("tracked hands") {
    TEST_CASE("the devices are those of the instruments, and the pedal") {
        const Scene scene;
        CHECK(scene.hands.devices() == std::vector<std::string>{"phaco", "spatula", "microscope", "pedal"});
        CHECK(scene.hands.state() == TrackingState::waiting);
    }

    TEST_CASE("a step shows hands as they were a stated moment ago, between two poses where none is of that moment") {
        Scene scene = running();
        CHECK(scene.hands.delay_us() == least_delay_us);
        CHECK(scene.sample(0).present);
        CHECK(scene.sample(1).present);
        CHECK_FALSE(scene.sample(2).present);
        for (int i = 0; i < 200; ++i) {
            scene.step();
            // poses lie 0.3 ms off: the fastest way is taken for the offset of the clocks. A chord of 10 ms is off by
            // an eighth of its square times the acceleration, 36 mm/s^2
            CHECK(scene.off_mm(least_delay_us + 300) < 36.0 * 1e-4 / 8.0 + 1e-6);
        }
        // who moves evenly is shown exactly
        scene.phaco = [](double t) { return Pose{Vec3(-3.0 + 2.0 * (t - 3.0), -3.0, 1.0), Quat::Identity()}; };
        Scene even;
        even.phaco = scene.phaco;
        even.run(1.0);
        CHECK(even.off_mm(least_delay_us + 300) < 1e-9);
    }

    TEST_CASE("where poses come late now and then the delay grows, and what is given stays smooth") {
        Rng rng(3);
        Scene scene;
        scene.way_us = [&rng] { return 300 + (rng.uniform() < 0.2 ? 30'000 : 0); };
        scene.run(3.0);
        REQUIRE(scene.hands.state() == TrackingState::running);
        CHECK(scene.hands.delay_us() > 40'000);
        CHECK(scene.hands.delay_us() <= most_delay_us);
        scene.farthest_mm = 0.0;
        scene.run(5.0);
        CHECK(scene.hands.state() == TrackingState::running);
        CHECK(scene.farthest_mm < 1.2 * 0.12);  // at 12 mm/s, and as the delay changes
        CHECK(scene.off_mm(scene.hands.delay_us() + 300) < 0.02);
    }

    TEST_CASE("poses are told in the frame of the tracked head, and jaws, buttons and pedal as they are") {
        Scene scene;
        scene.hands =
            TrackedHands({{"phaco", "spatula", "microscope"},
                          {Vec3(100.0, 0.0, 0.0), Quat(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ()))}});
        scene.phaco = [](double) { return Pose{Vec3(1.0, 2.0, 3.0), Quat::Identity()}; };
        scene.tell("spatula", ButtonReport{0, false});
        scene.tell("phaco", std::vector<bool>{true});
        scene.tell("phaco", std::vector<double>{0.25, 7.0});
        scene.tell("pedal", std::vector<double>{2.5});
        scene.tell("spatula", std::vector<double>{std::nan("")});
        scene.tell("nobody", std::vector<double>{1.0});
        scene.run(1.0);
        REQUIRE(scene.hands.state() == TrackingState::running);
        CHECK((scene.sample(0).pose.position - Vec3(98.0, 1.0, 3.0)).norm() < 1e-9);
        CHECK(scene.sample(0).pose.orientation.angularDistance(
                  Quat(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ()))) < 1e-7);
        CHECK(scene.sample(0).jaw == 0.25);
        CHECK_FALSE(scene.sample(1).present);  // seen, but its button says that it is put away
        REQUIRE(scene.hands.pedal());
        CHECK(*scene.hands.pedal() == 2.5);
        CHECK(checked_sample(scene.sample(0), 3).ok());
    }

    TEST_CASE("an instrument that is not seen for 0.2 s makes the clock stand; for 0.15 s it does not") {
        for (const int unseen_ms : {150, 260}) {
            Scene scene = running();
            scene.tell("phaco", std::vector<bool>{true});
            scene.run(0.5);
            scene.phaco_seen = false;
            scene.run(1e-3 * unseen_ms);
            scene.phaco_seen = true;
            bool stood = scene.hands.state() != TrackingState::running;
            if (stood) {
                CHECK(text_of(scene.hands.why()).find("phaco is") == 0);
            }
            scene.farthest_mm = 0.0;
            for (int i = 0; i < 30; ++i) {
                stood = stood || scene.step() != TrackingState::running;
            }
            CHECK(stood == (unseen_ms > 200));
            CHECK(scene.farthest_mm < 0.5);
            CHECK(scene.sample(1).present);
        }
    }

    TEST_CASE("an instrument without a button is put away where it is no longer seen outside, and lost inside") {
        for (const bool inside : {false, true}) {
            Scene scene = running();
            scene.inside = {inside, false};
            scene.phaco_seen = false;
            scene.run(0.5);
            CHECK((scene.hands.state() == TrackingState::running) == !inside);
            CHECK(scene.sample(0).present == inside);
        }
    }

    TEST_CASE("a leap is not passed on, and one that lasts makes the clock stand") {
        for (const bool lasts : {false, true}) {
            Scene scene = running();
            const std::int64_t from = scene.t_us;
            scene.phaco = [from, lasts](double t) {
                Pose pose = phaco_at(t);
                const double since_us = 1e6 * t - static_cast<double>(from);
                pose.position.z() += since_us > 0.0 && (lasts || since_us < 60'000.0) ? 20.0 : 0.0;
                return pose;
            };
            scene.farthest_mm = 0.0;
            bool stood = false;
            for (int i = 0; i < 100; ++i) {
                stood = scene.step() != TrackingState::running || stood;
                CHECK(scene.sample(0).pose.position.z() < 1.5);
            }
            CHECK(stood == lasts);
            CHECK(scene.farthest_mm < 0.6);
            if (lasts) {
                CHECK(text_of(scene.hands.why()) == "bring phaco to where it is shown");
            }
        }
    }

    TEST_CASE("after a stop it goes on when the hand has met the instrument, and not by a leap") {
        Scene scene = running();
        const std::vector<DeviceSample> all_held = scene.hands.samples();
        const Pose held = all_held[0].pose;
        Vec3 off(2.0, 0.0, 0.0);
        Quat turned = Quat::Identity();
        scene.phaco = [&](double) { return Pose{held.position + off, turned * held.orientation}; };
        scene.run(0.1);
        scene.hands.hold(all_held);
        CHECK(scene.hands.state() == TrackingState::standing);
        scene.run(0.5);
        CHECK(scene.hands.state() == TrackingState::standing);
        CHECK(scene.sample(0).pose.position == held.position);
        REQUIRE(scene.hands.seen()[0]);
        CHECK((scene.hands.seen()[0]->position - held.position - off).norm() < 1e-9);
        off = Vec3(0.55, 0.0, 0.0);
        scene.run(0.5);
        CHECK(scene.hands.state() == TrackingState::standing);
        off = Vec3(0.45, 0.0, 0.0);
        turned = about_y(6.0 * std::numbers::pi / 180.0);
        scene.run(0.5);
        CHECK(scene.hands.state() == TrackingState::standing);
        turned = about_y(4.0 * std::numbers::pi / 180.0);
        scene.farthest_mm = 0.0;
        scene.run(0.5);
        CHECK(scene.hands.state() == TrackingState::running);
        CHECK(scene.hands.why() == Standstill{});
        CHECK(scene.farthest_mm < 1.001 * drawn_mm_s * 0.01);
        CHECK((scene.sample(0).pose.position - held.position - off).norm() < 1e-9);
    }

    TEST_CASE("both instruments have to be met, one that was put away meanwhile has not") {
        Scene scene = running();
        std::vector<DeviceSample> held = scene.hands.samples();
        held[1].pose.position.x() += 3.0;
        scene.phaco = [&](double) { return held[0].pose; };
        scene.hands.hold(held, {});
        scene.run(0.5);
        CHECK(scene.hands.state() == TrackingState::standing);
        CHECK(text_of(scene.hands.why()) == "bring spatula to where it is shown");
        scene.tell("spatula", std::vector<bool>{false});
        scene.run(0.1);
        CHECK(scene.hands.state() == TrackingState::running);
        CHECK_FALSE(scene.sample(1).present);
    }

    TEST_CASE("a lost link makes the clock stand; a server with another clock is no trouble") {
        Scene scene = running();
        const Pose held = scene.sample(0).pose;
        scene.hands.link("it has closed the connection");
        scene.step();
        CHECK(scene.hands.state() == TrackingState::standing);
        CHECK(text_of(scene.hands.why()) == "the link is lost: it has closed the connection");
        scene.phaco_seen = scene.spatula_seen = false;
        scene.run(2.0);
        scene.hands.link("");
        scene.sender_us -= 3'600'000'000;
        scene.phaco_seen = scene.spatula_seen = true;
        scene.phaco = [&](double t) { return Pose{held.position + Vec3(0.0, 4.0 - t, 0.0), held.orientation}; };
        scene.farthest_mm = 0.0;
        CHECK(scene.steps_until(TrackingState::running, 2.0) < 150);
        scene.run(0.2);
        CHECK(scene.hands.state() == TrackingState::running);
        CHECK(scene.farthest_mm < 0.12);
    }

    TEST_CASE("before there ever was a link it waits, and says for what") {
        Scene scene;
        scene.hands.link("no VRPN server has answered yet");
        scene.phaco_seen = scene.spatula_seen = false;
        scene.run(0.1);
        CHECK(scene.hands.state() == TrackingState::waiting);
        CHECK(text_of(scene.hands.why()) == "no link yet: no VRPN server has answered yet");
        scene.hands.link("");
        scene.run(0.1);
        CHECK(text_of(scene.hands.why()) == "no pose has come yet");
        scene.phaco_seen = true;
        CHECK(scene.steps_until(TrackingState::running, 1.0) < 30);
    }

    TEST_CASE("a clock that is set, forward or back, stops for the hand to be met and is told; nothing leaps") {
        for (const std::int64_t set_us : {-5'000'000, 5'000'000}) {
            Scene scene = running();
            const Pose held = phaco_at(1e-6 * static_cast<double>(scene.t_us));
            scene.phaco = [&](double) { return held; };
            scene.run(0.3);
            scene.farthest_mm = 0.0;
            scene.sender_us += set_us;
            scene.step();
            CHECK(scene.hands.clocks_set() == 1);
            CHECK(text_of(scene.hands.why()) == "the clock of the tracking system was set");
            CHECK(scene.steps_until(TrackingState::running, 1.0) < 30);
            scene.run(0.5);
            CHECK(scene.hands.state() == TrackingState::running);
            CHECK(scene.hands.clocks_set() == 1);
            CHECK(scene.farthest_mm < 1e-6);
        }
    }

    TEST_CASE("what the tracking system complains of is told; a mere remark is not") {
        Scene scene = running();
        scene.tell("phaco", TextReport{Severity::normal, 0, "ready"});
        scene.step();
        CHECK(scene.hands.state() == TrackingState::running);
        scene.tell("phaco", TextReport{Severity::error, 0, "camera 3 was moved"});
        scene.step();
        CHECK(scene.hands.state() == TrackingState::standing);
        CHECK(text_of(scene.hands.why()) == "the tracking system says: camera 3 was moved");
    }

    TEST_CASE("a computer that was busy for a moment makes up for it evenly") {
        Scene scene = running();
        const Pose held = scene.sample(0).pose;
        const std::int64_t from = scene.t_us;
        scene.phaco = [&](double t) {
            return Pose{held.position + Vec3(0.0, 10.0 * (t - 1e-6 * static_cast<double>(from)), 0.0),
                        held.orientation};
        };
        scene.run(0.1);
        const Pose before = scene.sample(0).pose;
        for (int i = 0; i < 20; ++i) {  // 0.2 s without a look
            scene.tell_pose("phaco", scene.phaco(1e-6 * static_cast<double>(scene.t_us)));
            scene.tell_pose("spatula", spatula_at(0.0));
            scene.t_us += step_us;
        }
        scene.given = before;
        scene.farthest_mm = 0.0;
        scene.run(0.5);
        CHECK(scene.hands.state() == TrackingState::running);
        CHECK(scene.farthest_mm < 0.21);  // its own 0.1 mm a step, and as much to make up
        CHECK(scene.off_mm(least_delay_us + 300) < 1e-6);
    }

    TEST_CASE("what is out of reach is put away") {
        Scene scene = running();
        scene.phaco_seen = false;
        scene.run(0.3);
        scene.phaco = [](double) { return Pose{Vec3(0.0, -400.0, 0.0), Quat::Identity()}; };
        scene.phaco_seen = true;
        scene.run(0.3);
        CHECK_FALSE(scene.sample(0).present);
        CHECK(scene.hands.state() == TrackingState::running);
    }

    TEST_CASE("what is asked of the staff comes with the step of its moment, once, and waits while the clock stands") {
        Scene scene = running();
        scene.tell("staff", TextReport{Severity::normal, 0, "bottle_down"});
        const std::int64_t asked_us = scene.t_us;
        int steps = 0;
        std::vector<std::string> asked;
        for (; asked.empty() && steps < 20; ++steps) {
            scene.step();
            asked = scene.hands.take_asked();
        }
        CHECK(asked == std::vector<std::string>{"bottle_down"});
        CHECK(scene.t_us - asked_us >= scene.hands.delay_us());
        CHECK(scene.t_us - asked_us <= scene.hands.delay_us() + 2 * step_us);
        scene.run(0.5);
        CHECK(scene.hands.take_asked().empty());

        // a severe text of this device is no fault of the tracking system
        scene.tell("staff", TextReport{Severity::error, 0, "help"});
        scene.hands.link("a cable");
        scene.run(0.3);
        CHECK(scene.hands.state() == TrackingState::standing);
        CHECK(scene.hands.take_asked().empty());
        scene.hands.link("");
        scene.phaco = [held = scene.sample(0).pose](double) { return held; };
        scene.steps_until(TrackingState::running, 5.0);
        REQUIRE(scene.hands.state() == TrackingState::running);
        CHECK(scene.hands.take_asked() == std::vector<std::string>{"help"});

        for (int i = 0; i < 1000; ++i) {
            scene.tell("staff", TextReport{Severity::normal, 0, "help"});
        }
        scene.run(0.5);
        CHECK(scene.hands.take_asked().size() == 64);
    }
}
