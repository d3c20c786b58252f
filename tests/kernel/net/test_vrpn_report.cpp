// SPDX-License-Identifier: GPL-3.0-or-later
#include "net/vrpn_report.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace rhexis;
using namespace rhexis::vrpn;

TEST_SUITE("vrpn report") {
    TEST_CASE("what is told is read again: lengths in metres on the wire, quaternions with w last") {
        const Quat turned = Quat(Eigen::AngleAxisd(0.7, Vec3(1.0, -2.0, 0.5).normalized()));
        const PoseReport pose = read_pose(payload_of(PoseReport{7, Vec3(1.5, -20.25, 300.0), turned})).value();
        CHECK(pose.sensor == 7);
        CHECK((pose.position - Vec3(1.5, -20.25, 300.0)).norm() < 1e-12);
        CHECK(pose.turned.angularDistance(turned) < 1e-7);
        const WireBytes bytes = payload_of(PoseReport{7, Vec3(1000.0, 0.0, 0.0), turned});
        CHECK(bytes.size() == 64);
        WireReader reader(bytes);
        static_cast<void>(reader.u32());
        static_cast<void>(reader.u32());
        CHECK(reader.f64() == 1.0);
        static_cast<void>(reader.f64());
        static_cast<void>(reader.f64());
        CHECK(reader.f64() == turned.x());
        static_cast<void>(reader.f64());
        static_cast<void>(reader.f64());
        CHECK(reader.f64() == turned.w());
        const VelocityReport velocity =
            read_velocity(payload_of(VelocityReport{0, Vec3(10.0, 0.0, -1.0), turned, 0.01})).value();
        CHECK((velocity.velocity - Vec3(10.0, 0.0, -1.0)).norm() < 1e-12);
        CHECK(velocity.interval_s == 0.01);
        CHECK(read_button(payload_of(ButtonReport{3, true})).value().down);
        CHECK(read_buttons(buttons_payload({true, false, true})).value() == std::vector<bool>{true, false, true});
        CHECK(read_buttons(buttons_payload({})).value().empty());
        CHECK(read_analog(analog_payload({0.25, -3.0})).value() == std::vector<double>{0.25, -3.0});
        CHECK(read_analog(analog_payload(std::vector<double>(most_channels, 1.0))).ok());
        const TextReport text = read_text(payload_of(TextReport{Severity::warning, 4, "a lamp is off"})).value();
        CHECK(text.severity == Severity::warning);
        CHECK(text.level == 4);
        CHECK(text.text == "a lamp is off");
    }

    TEST_CASE("payloads of another size, and numbers that cannot be, are refused") {
        WireBytes pose = payload_of(PoseReport{});
        pose.push_back(0);
        CHECK(read_pose(pose).error().text() == "VRPN: a pose of 65 bytes (64)");
        CHECK_FALSE(read_pose({}).ok());
        CHECK_FALSE(read_pose(payload_of(PoseReport{-1, Vec3::Zero(), Quat::Identity()})).ok());
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double infinite = std::numeric_limits<double>::infinity();
        CHECK_FALSE(read_pose(payload_of(PoseReport{0, Vec3(nan, 0.0, 0.0), Quat::Identity()})).ok());
        CHECK_FALSE(read_pose(payload_of(PoseReport{0, Vec3(0.0, infinite, 0.0), Quat::Identity()})).ok());
        CHECK_FALSE(read_pose(payload_of(PoseReport{0, Vec3::Zero(), Quat(0.0, 0.0, 0.0, 0.0)})).ok());
        CHECK_FALSE(read_pose(payload_of(PoseReport{0, Vec3::Zero(), Quat(nan, 0.0, 0.0, 0.0)})).ok());
        CHECK_FALSE(read_velocity(payload_of(VelocityReport{0, Vec3::Zero(), Quat::Identity(), -1.0})).ok());
        CHECK_FALSE(read_velocity(payload_of(VelocityReport{0, Vec3::Zero(), Quat::Identity(), nan})).ok());
        CHECK_FALSE(read_button(payload_of(ButtonReport{-1, true})).ok());
        CHECK_FALSE(read_button(payload_of(ButtonReport{most_buttons, true})).ok());
        const auto counted = [](double count, std::size_t channels) {
            WireBytes bytes;
            append_f64(count, bytes);
            bytes.resize(8 + 8 * channels, 0);
            return read_analog(bytes);
        };
        CHECK(counted(2.0, 2).ok());
        for (const double count : {3.0, 1.0, 1.5, -1.0, 129.0, 1e300, nan}) {
            CHECK_FALSE(counted(count, 2).ok());
        }
        CHECK_FALSE(counted(129.0, 129).ok());
        CHECK_FALSE(read_analog(analog_payload({infinite})).ok());
        WireBytes buttons = buttons_payload({true});
        buttons[0] = 0x80;
        CHECK_FALSE(read_buttons(buttons).ok());
        WireBytes text = payload_of(TextReport{});
        text[3] = 3;
        CHECK_FALSE(read_text(text).ok());
    }
}
