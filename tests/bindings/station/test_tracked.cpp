// SPDX-License-Identifier: GPL-3.0-or-later
// Hands that a tracking system sees.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "desk_scene.hpp"
#include "station/asked.hpp"
#include "station/tracked_link.hpp"

using namespace rhexis;
using namespace rhexis::station;

namespace {

UserEvent runs() { return {EventKind::tracking, "", 1.0}; }
UserEvent stands(const std::string& why, const std::string& of) {
    return {EventKind::tracking, why, 0.0, 0.0, 0.0, of};
}
UserEvent seen(const std::string& name, const Vec3& at, double jaw = 0.0) {
    UserEvent event{EventKind::tracked, name, 1.0};
    event.sample.pose = {at, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX()))};
    event.sample.jaw = jaw;
    return event;
}

struct TrackedScene : DeskScene {
    TrackedScene() { hands.track(); }
};

std::string refused(const std::string& text) {
    const std::string path = (std::filesystem::temp_directory_path() / "rhexis_test_registration.json").string();
    std::ofstream(path) << text;
    const Result<Pose> pose = read_registration(path);
    std::filesystem::remove(path);
    return pose ? "" : pose.error().text();
}

}  // namespace

TEST_SUITE("tracked hands of the station") {
    TEST_CASE("the clock stands until tracking says that it may go on, and says why") {
        TrackedScene scene;
        CHECK(scene.hands.waits());
        scene.take(stands("%s is lost", "phaco"));
        CHECK(scene.hands.waits());
        CHECK(text_of(scene.hands.state().tracked->why) == "phaco is lost");
        scene.take(runs());
        CHECK_FALSE(scene.hands.waits());
    }

    TEST_CASE("samples are what is seen, with the pedal; what is put away is not there") {
        TrackedScene scene;
        scene.take(runs());
        scene.take(seen("phaco", Vec3(0.0, -2.0, 1.0)));
        scene.take(seen("forceps", Vec3(-3.0, 0.0, 1.0), 0.25));
        scene.take({EventKind::tracked, "pedal", 2.5});
        scene.take(seen("nothing", Vec3(1.0, 1.0, 1.0)));
        scene.advance(0.05);
        CHECK(scene.sample(0).present);
        CHECK(scene.sample(0).pose.position == Vec3(0.0, -2.0, 1.0));
        CHECK(scene.sample(0).pose.orientation.coeffs() == Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())).coeffs());
        CHECK(scene.sample(0).pedal == 2.5);
        CHECK(scene.sample(2).jaw == 0.25);
        CHECK_FALSE(scene.sample(1).present);
        CHECK(scene.hand(leading).instrument == 0);
        CHECK(scene.hand(other).instrument == 2);
        CHECK(scene.hand(leading).inside);
        scene.take({EventKind::tracked, "phaco", 0.0});
        CHECK_FALSE(scene.sample(0).present);
        CHECK(scene.hand(leading).instrument == -1);
        // a third has no hand to be shown in, and is there all the same
        scene.take(seen("phaco", Vec3(0.0, -2.0, 1.0)));
        scene.take(seen("injector", Vec3(0.0, -9.0, 3.0)));
        CHECK(scene.sample(3).present);
    }

    TEST_CASE("keys and cursor move no tracked hand, but pause, dials and the microscope as ever") {
        TrackedScene scene;
        scene.take(runs());
        scene.take(seen("phaco", Vec3(0.0, -2.0, 1.0)));
        for (const char* name : {"E", "Q", "Tab", "F"}) {
            scene.press(name);
        }
        scene.take({EventKind::pointer, "", 0.0, 0.2, 0.1});
        scene.take({EventKind::wheel, "", 3.0});
        scene.take(key("W", 1.0));
        scene.advance(0.1);
        CHECK_FALSE(scene.hands.waits());
        CHECK(scene.sample(0).pose.position == Vec3(0.0, -2.0, 1.0));
        CHECK(scene.hand(leading).instrument == 0);
        CHECK_FALSE(scene.hands.state().cursor_moves);
        scene.take(key("Right", 1.0));
        CHECK(scene.sample(4).present);
        CHECK(scene.sample(4).pose.position.x() > 0.0);
        scene.press("+");
        CHECK(scene.hands.state().dials[0] > 80.0);
    }

    TEST_CASE("while the clock stands instruments stay where they are held, and it shows where they are seen") {
        TrackedScene scene;
        scene.take(runs());
        scene.take(seen("phaco", Vec3(0.0, -2.0, 1.0)));
        scene.press("P");
        CHECK(scene.hands.state().paused);
        scene.take(seen("phaco", Vec3(0.0, 0.0, 1.0)));
        scene.take(runs());
        CHECK(scene.hands.waits());
        CHECK(scene.sample(0).pose.position == Vec3(0.0, -2.0, 1.0));
        scene.press("P");
        CHECK(scene.hands.waits());  // what is held has to be met again
        scene.take(seen("phaco", Vec3(0.0, 0.5, 1.0)));
        CHECK(scene.sample(0).pose.position == Vec3(0.0, -2.0, 1.0));
        REQUIRE(scene.hands.state().tracked->seen[0]);
        CHECK(scene.hands.state().tracked->seen[0]->position == Vec3(0.0, 0.5, 1.0));
        scene.take(runs());
        CHECK_FALSE(scene.hands.waits());
    }

    TEST_CASE("where the head moves under the hands what they hold is shifted, and stays shifted") {
        TrackedScene scene;
        scene.take(runs());
        scene.take(seen("phaco", Vec3(0.0, -2.0, 1.0)));
        scene.hands.shift(Vec3(1.0, 0.0, 0.0));
        CHECK(scene.sample(0).pose.position == Vec3(1.0, -2.0, 1.0));
        scene.take(seen("phaco", Vec3(0.0, -1.5, 1.0)));
        CHECK(scene.sample(0).pose.position == Vec3(1.0, -1.5, 1.0));
        CHECK(scene.hand(leading).tip == Vec3(1.0, -1.5, 1.0));
    }

    TEST_CASE("what a tracking system asks of the staff is asked, and dials that it turns are turned") {
        TrackedScene scene;
        scene.take(runs());
        const auto asked = [&scene](const std::string& text) {
            scene.hands.state().word.clear();
            scene.take({EventKind::asked, text});
            return scene.hands.take_commands();
        };
        std::vector<Command> commands = asked("help");
        REQUIRE(commands.size() == 1);
        CHECK(commands[0].kind == CommandKind::request);
        CHECK(commands[0].name == "help");
        CHECK(words_of(commands[0]) == "help");
        REQUIRE(asked("Bottle down").size() == 1);
        commands = asked("machine.vacuum_mmhg=120.5");
        REQUIRE(commands.size() == 1);
        CHECK(commands[0].kind == CommandKind::adjust);
        CHECK(commands[0].value == 120.5);
        CHECK(words_of(commands[0]) == "machine.vacuum_mmhg=120.5");
        for (const auto& [text, word] :
             {std::pair("botle_down", "the exercise has no request 'botle_down' (did you mean bottle_down?)"),
              std::pair("", "the exercise has no request '' (one of bottle_down, help)"),
              std::pair("machine.vacum_mmhg=1",
                        "the machine has no dial 'machine.vacum_mmhg' (did you mean machine.vacuum_mmhg?)"),
              std::pair("machine.vacuum_mmhg=651", "the staff was asked for machine.vacuum_mmhg = 651 (0 to 650)"),
              std::pair("machine.vacuum_mmhg=nan", "the staff was asked for machine.vacuum_mmhg = nan (0 to 650)"),
              std::pair("machine.vacuum_mmhg=1x", "the staff was asked for machine.vacuum_mmhg = 1x (0 to 650)")}) {
            CHECK(asked(text).empty());
            CHECK(scene.hands.state().word == word);
        }
        CHECK(scene.hands.state().dials[0] == 120.5);
    }

    TEST_CASE("what tracking tells is written and read again, bit for bit") {
        for (const UserEvent& event :
             {seen("phaco", Vec3(0.1, -1.0 / 3.0, 2e-17), 0.7), runs(), stands("%s is lost", "phaco"),
              UserEvent{EventKind::tracked, "pedal", 1.7}, UserEvent{EventKind::asked, "machine.bottle_cm=60"}}) {
            const Result<UserEvent> read = event_from(nlohmann::json::parse(to_json(event).dump()));
            REQUIRE(read.ok());
            CHECK(to_json(read.value()) == to_json(event));
            CHECK(read.value().sample.pose.position == event.sample.pose.position);
            CHECK(read.value().sample.pose.orientation.coeffs() == event.sample.pose.orientation.coeffs());
        }
        const auto complaint = [](const char* text) {
            const Result<UserEvent> read = event_from(nlohmann::json::parse(text));
            return read ? std::string() : read.error().text();
        };
        CHECK(complaint(R"({"event":"tracked","name":"phaco","position_mm":[1,2]})") ==
              "the event's position_mm is [1,2] (3 numbers, -1000 to 1000)");
        CHECK(complaint(R"({"event":"tracked","name":"phaco","jaw":1e9})").find("jaw") != std::string::npos);
    }

    TEST_CASE("addresses of tracking systems are read as they are said") {
        CHECK(is_tracked("vrpn://1.2.3.4"));
        CHECK(is_tracked("vrpn+tcp://1.2.3.4"));
        CHECK_FALSE(is_tracked("mouse"));
        const Result<vrpn::ServerPlace> asked = tracking_place("vrpn://localhost:4000");
        REQUIRE(asked.ok());
        CHECK(asked.value().address == NetAddress{"127.0.0.1", 4000});
        CHECK(asked.value().asks_by_datagram);
        for (const char* text : {"vrpn+tcp://10.0.0.2", "vrpn://tcp://10.0.0.2"}) {
            const Result<vrpn::ServerPlace> place = tracking_place(text);
            REQUIRE(place.ok());
            CHECK(place.value().address == NetAddress{"10.0.0.2", vrpn::port});
            CHECK_FALSE(place.value().asks_by_datagram);
        }
        CHECK_FALSE(tracking_place("vrpn://").ok());
        CHECK_FALSE(tracking_place("vrpn://here:99999").ok());
    }

    TEST_CASE("a registration is a place and a turn, and what is none is told by its field") {
        CHECK(refused(R"({"position_mm": [1, 2, 3], "orientation_xyzw": [0, 0, 0.6, 0.8]})").empty());
        CHECK(refused("[]").find("position_mm is missing (3 numbers)") != std::string::npos);
        CHECK(refused(R"({"position_mm": [1, 2, "x"], "orientation_xyzw": [0, 0, 0, 1]})").find("position_mm is") !=
              std::string::npos);
        CHECK(refused(R"({"position_mm": [1, 2, 3], "orientation_xyzw": [0, 0, 0, 3]})").find("length 3") !=
              std::string::npos);
    }
}
