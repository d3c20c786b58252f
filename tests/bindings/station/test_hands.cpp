// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/hands.hpp"

#include <doctest/doctest.h>

#include "desk_scene.hpp"

using namespace rhexis;
using namespace rhexis::station;

TEST_SUITE("hands") {
    TEST_CASE("an instrument is taken up outside its wound, and a cursor that has met it leads it in") {
        DeskScene scene;
        scene.press("E");
        CHECK(scene.hand(leading).instrument == 0);
        scene.advance(0.01);
        CHECK_FALSE(scene.hand(leading).inside);
        CHECK(scene.hand(leading).tip.y() < -6.0);
        // far away: nothing moves, and the clock stands
        scene.take({EventKind::pointer, "", 0.0, 0.3, 0.3});
        CHECK(scene.hands.waits());
        const Cursor over = scene.around.sight.cursor_on(scene.hand(leading).tip, false);
        scene.take({EventKind::pointer, "", 0.0, over.x() + 0.2 / 14.6, over.y()});  // within 0.3 mm
        CHECK_FALSE(scene.hands.waits());
        const Vec3 before = scene.hand(leading).tip;
        for (int i = 1; i <= 60; ++i) {
            scene.take({EventKind::pointer, "", 0.0, over.x() + 0.2 / 14.6, over.y() + 0.1 * i / 14.6});
            scene.advance(0.01);
        }
        CHECK(scene.hand(leading).inside);
        CHECK(scene.hand(leading).tip.x() == doctest::Approx(before.x()).epsilon(0.05));
        CHECK(scene.hand(leading).tip.y() > -2.0);
    }

    TEST_CASE("the way in runs through the tunnel: its height is the wound's") {
        DeskScene scene;
        scene.press("E");
        scene.press("F");
        scene.take({EventKind::pointer, "", 0.0, 0.0, 0.0});
        scene.press("F");
        double lowest = 10.0;
        double highest_inside = -10.0;
        for (int i = 0; i < 250; ++i) {
            scene.take({EventKind::pointer, "", 0.0, 0.0, 0.001 * i});
            scene.advance(0.01);
            if (!scene.hand(leading).inside) {
                lowest = std::min(lowest, scene.hand(leading).tip.z());
            } else {
                highest_inside = std::max(highest_inside, scene.hand(leading).tip.z());
            }
        }
        CHECK(lowest >= 1.5 - 1e-9);
        CHECK(highest_inside == doctest::Approx(1.5).epsilon(0.02));
    }

    TEST_CASE("a panel takes what is clicked, and nothing that is not there") {
        DeskScene scene;
        const auto click = [&](const char* name, double value) {
            scene.take({EventKind::control, name, value, 0.0, 0.0});
        };
        click("take_instrument", 2.0);
        CHECK(scene.hand(leading).instrument == 2);
        for (const double none : {-1.0, 4.0, 5.0, 900.0}) {  // 4: the microscope, which no hand holds
            click("take_instrument", none);
            CHECK(scene.hand(leading).instrument == 2);
        }
        click("swap", 1.0);
        click("take_instrument", 2.0);  // the leading hand has it
        CHECK(scene.hand(other).instrument == -1);
        click("choose_request", 1.0);
        click("request", 1.0);
        click("choose_dial", 0.0);
        click("dial.turn", -2.0);
        const std::vector<Command> commands = scene.hands.take_commands();
        REQUIRE(commands.size() == 2);
        CHECK(commands[0].name == "help");
        CHECK(commands[1].value == 60.0);
    }

    TEST_CASE("a key gets another use while the station runs; what it holds it lets go of") {
        DeskScene scene;
        scene.press("E");
        scene.take(key("PageUp", 1.0));
        scene.take({EventKind::bind, "key.PageUp", 0.0, 0.0, 0.0, "next_instrument"});
        const double before = scene.hand(leading).tip.z();
        scene.advance(0.1);
        CHECK(scene.hand(leading).tip.z() == before);
        scene.press("PageUp");
        CHECK(scene.hand(leading).instrument == 1);
        scene.take({EventKind::bind, "key.PageUp"});
        scene.press("PageUp");
        CHECK(scene.hand(leading).instrument == 1);
        scene.take({EventKind::bind, "key.PageUp", 0.0, 0.0, 0.0, "swop"});
        CHECK(scene.hands.state().word.find("swap") != std::string::npos);
    }

    TEST_CASE("while the clock stands the cursor moves nothing") {
        DeskScene scene;
        scene.press("E");
        scene.press("F");
        scene.press("P");
        const Vec3 before = scene.hand(leading).wanted;
        const Cursor over = scene.around.sight.cursor_on(scene.hand(leading).tip, false);
        scene.take({EventKind::pointer, "", 0.0, over.x(), over.y()});
        scene.take({EventKind::pointer, "", 0.0, over.x() + 0.2, over.y()});
        scene.take({EventKind::wheel, "", -5.0});
        CHECK(scene.hand(leading).wanted == before);
        scene.press("P");
        CHECK(scene.hands.waits());  // the hand has to meet it again
    }

    TEST_CASE("a stick that is stuck half way counts as let go; one that is held or pushed all the way does not") {
        DeskScene scene(true);
        const auto rises_in_a_second = [&] {
            const double before = scene.hand(leading).tip.z();
            scene.advance(1.0);
            return scene.hand(leading).tip.z() - before;
        };
        scene.take({EventKind::press, "pad.a", 1.0});
        scene.take({EventKind::axis, "pad.righty", -0.6});
        CHECK(rises_in_a_second() > 0.1);
        scene.take({EventKind::axis, "pad.righty", -0.61});
        CHECK(rises_in_a_second() > 0.1);
        scene.advance(1.1);
        CHECK(scene.hands.state().word.find("stuck") != std::string::npos);
        CHECK(rises_in_a_second() == 0.0);
        scene.take({EventKind::axis, "pad.righty", -0.5});
        CHECK(rises_in_a_second() > 0.1);
        scene.take({EventKind::axis, "pad.righty", -1.0});
        scene.advance(3.0);
        CHECK(rises_in_a_second() > 0.1);
    }

    TEST_CASE("it stays in the hand as long as it is in the eye") {
        DeskScene scene;
        scene.press("E");
        scene.press("F");
        scene.advance(0.01);
        scene.hands.state().hands[leading].wanted = Vec3(0.0, 0.0, 1.0);
        scene.advance(0.5);
        REQUIRE(scene.hand(leading).inside == false);  // it went over the cornea: nobody let it in
        scene.hands.state().hands[leading].inside = true;
        scene.press("Q");
        CHECK(scene.hand(leading).instrument == 0);
        CHECK_FALSE(scene.hands.state().word.empty());
        scene.hands.state().hands[leading].inside = false;
        scene.press("Q");
        CHECK(scene.hand(leading).instrument == -1);
    }

    TEST_CASE("two hands hold two instruments, each through its own wound") {
        DeskScene scene;
        scene.press("E");
        scene.press("Tab");
        scene.press("E");
        scene.advance(0.01);
        CHECK(scene.hand(leading).instrument == 0);
        CHECK(scene.hand(other).instrument == 1);
        CHECK(scene.sample(0).pose.position.y() < -6.0);
        CHECK(scene.sample(1).pose.position.x() < -6.0);
        CHECK(scene.sample(2).present == false);
    }

    TEST_CASE("jaws spring open, a plunger stays") {
        DeskScene scene;
        scene.hands.state().hands[leading].instrument = 2;
        scene.hands.state().hands[leading].jaw = 1.0;
        scene.take({EventKind::button, "left", 1.0, 0.0, 0.0});
        scene.advance(0.5);
        CHECK(scene.sample(2).jaw == 0.0);
        scene.take({EventKind::button, "left", 0.0, 0.0, 0.0});
        scene.advance(0.5);
        CHECK(scene.sample(2).jaw == 1.0);
        scene.hands.state().hands[leading] = HandState{};
        scene.hands.state().hands[leading].instrument = 3;
        scene.take({EventKind::button, "left", 1.0, 0.0, 0.0});
        scene.advance(1.0);
        scene.take({EventKind::button, "left", 0.0, 0.0, 0.0});
        scene.advance(1.0);
        CHECK(scene.sample(3).jaw == doctest::Approx(0.3));
        scene.take({EventKind::button, "right", 1.0, 0.0, 0.0});
        scene.advance(0.5);
        CHECK(scene.sample(3).jaw == doctest::Approx(0.15));
    }

    TEST_CASE("the pedal goes to its positions, and up when the keyboard is lost") {
        DeskScene scene;
        scene.press("E");
        scene.press("2");
        scene.advance(0.1);
        CHECK(scene.sample(0).pedal == doctest::Approx(0.8));
        scene.advance(0.4);
        CHECK(scene.sample(0).pedal == 2.0);
        scene.take(key("Space", 1.0));
        scene.advance(0.1);
        CHECK(scene.sample(0).pedal == doctest::Approx(2.4));
        scene.take({EventKind::focus, "", 0.0, 0.0, 0.0});
        CHECK(scene.hands.state().paused);
        CHECK(scene.sample(0).pedal == 0.0);
        scene.press("P");
        scene.advance(0.5);
        CHECK(scene.sample(0).pedal == 0.0);  // the key that was down counts no more
    }

    TEST_CASE("a pedal's axis: nothing, irrigation, then travel within each position") {
        DeskScene scene;
        const Tuning& tuning = scene.mapping.tuning();
        CHECK(pedal_of(0.0, tuning) == 0.0);
        CHECK(pedal_of(0.079, tuning) == 0.0);
        CHECK(pedal_of(0.2, tuning) == 1.0);
        CHECK(pedal_of(0.495, tuning) == doctest::Approx(1.5));
        CHECK(pedal_of(0.83, tuning) == doctest::Approx(2.5));
        CHECK(pedal_of(1.0, tuning) == 3.0);
        scene.press("E");
        scene.take({EventKind::axis, "pedal.0", 1.0, 0.0, 0.0});
        scene.advance(0.5);
        CHECK(scene.sample(0).pedal == 3.0);
        scene.take({EventKind::device, "pedal", 0.0, 0.0, 0.0});  // unplugged
        CHECK(scene.sample(0).pedal == 0.0);
        CHECK(scene.hands.waits());
    }

    TEST_CASE("a stick is slow near its middle and still within its dead zone") {
        DeskScene scene(true);
        scene.take({EventKind::press, "pad.a", 1.0, 0.0, 0.0});
        scene.advance(0.01);
        const Vec3 start = scene.hand(leading).tip;
        scene.take({EventKind::axis, "pad.leftx", 0.1, 0.0, 0.0});
        scene.advance(0.2);
        CHECK((scene.hand(leading).tip - start).norm() < 1e-9);
        scene.take({EventKind::axis, "pad.leftx", 0.56, 0.0, 0.0});  // half of what is beyond the dead zone
        scene.advance(0.1);
        CHECK(scene.hand(leading).tip.x() - start.x() == doctest::Approx(0.25 * 12.0 * 0.1));
        CHECK_FALSE(scene.hands.waits());  // what is pushed need not be met
    }

    TEST_CASE("dials and requests become commands of whoever operates") {
        DeskScene scene;
        scene.press("+");
        scene.press("+");
        scene.press("G");
        scene.press("Return");
        const std::vector<Command> commands = scene.hands.take_commands();
        REQUIRE(commands.size() == 2);
        CHECK(commands[0].kind == CommandKind::request);
        CHECK(commands[0].name == "help");
        CHECK(commands[1].kind == CommandKind::adjust);
        CHECK(commands[1].name == "machine.vacuum_mmhg");
        CHECK(commands[1].value == 100.0);
        CHECK(scene.hands.take_commands().empty());
    }

    TEST_CASE("the microscope is sent as long as its key is down") {
        DeskScene scene;
        CHECK_FALSE(scene.sample(4).present);
        scene.take(key("Right", 1.0));
        CHECK(scene.sample(4).present);
        CHECK(scene.sample(4).pose.position.x() == doctest::Approx(0.04));
        scene.take(key("Right", 0.0));
        CHECK_FALSE(scene.sample(4).present);
    }
}
