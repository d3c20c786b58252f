// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/fingers.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "desk_scene.hpp"

using namespace rhexis;
using namespace rhexis::station;

namespace {

/// What is wanted of the instruments at a time: the tip of the phaco goes round in the eye.
std::vector<DeviceSample> wanted(DeskScene& scene, double time_s) {
    std::vector<DeviceSample> samples(scene.stand.instruments.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].instrument = static_cast<int>(i);
    }
    DeviceSample& phaco = samples[0];
    phaco.present = true;
    const Vec3 outside(0.0, -7.0, 2.5);
    const Vec3 circle(2.0 * std::sin(2.0 * time_s), -2.0 * std::cos(2.0 * time_s), 1.0 - 0.3 * std::sin(time_s));
    phaco.pose.position = time_s < 1.0 ? Vec3(outside + time_s * (Vec3(0.0, -2.0, 1.2) - outside)) : Vec3(circle);
    const Result<Quat> held = scene.holds.orientation("phaco", Vec3(0.0, -5.0, 1.5), phaco.pose.position, 30.0);
    phaco.pose.orientation = held.value();
    phaco.pedal = time_s < 2.0 ? 1.0 : 1.5 - 0.5 * std::cos(time_s - 2.0);
    return samples;
}

}  // namespace

TEST_SUITE("fingers") {
    TEST_CASE("what they press makes the hands do what is wanted, with a mouse as with a pad") {
        for (const bool pad : {false, true}) {
            CAPTURE(pad);
            DeskScene scene(pad);
            Fingers fingers(pad ? Style::pad : Style::mouse, 640, 480);
            double worst_mm = 0.0;
            double worst_pedal = 0.0;
            double worst_roll = 0.0;
            for (int step = 0; step < 600; ++step) {
                const double time_s = 0.01 * step;
                const std::vector<DeviceSample> samples = wanted(scene, time_s);
                for (const UserEvent& event :
                     fingers.reach(scene.hands, scene.stand, samples, {}, scene.around, 0.01)) {
                    // through the text that a file holds
                    const Result<UserEvent> again = event_from(to_json(event));
                    REQUIRE(again.ok());
                    scene.take(again.value());
                }
                REQUIRE_FALSE(scene.hands.waits());
                scene.advance(0.01);
                if (time_s > 1.5) {
                    const DeviceSample now = scene.sample(0);
                    worst_mm = std::max(worst_mm, (now.pose.position - samples[0].pose.position).norm());
                    worst_pedal = std::max(worst_pedal, std::abs(now.pedal - samples[0].pedal));
                    worst_roll =
                        std::max(worst_roll, now.pose.orientation.angularDistance(samples[0].pose.orientation));
                }
            }
            CHECK(scene.hand(leading).instrument == 0);
            CHECK(worst_mm < 0.01);  // a fifth of half a pixel of 0.03 mm, and of a notch of 0.05
            CHECK(worst_pedal < 0.05);
            CHECK(worst_roll < 0.05);
        }
    }

    TEST_CASE("requests are chosen and made") {
        DeskScene scene;
        Fingers fingers(Style::mouse, 640, 480);
        const std::vector<Command> asked = {{CommandKind::request, "help", 0.0, ""}};
        for (const UserEvent& event :
             fingers.reach(scene.hands, scene.stand, std::vector<DeviceSample>(5), asked, scene.around, 0.01)) {
            scene.take(event);
        }
        const std::vector<Command> commands = scene.hands.take_commands();
        REQUIRE(commands.size() == 1);
        CHECK(commands[0].name == "help");
    }
}
