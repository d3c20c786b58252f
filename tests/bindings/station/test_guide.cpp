// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/guide.hpp"

#include <doctest/doctest.h>

#include "desk_scene.hpp"
#include "station/menu.hpp"

using namespace rhexis;
using namespace rhexis::station;

namespace {

Words english() {
    Result<Words> words = Words::load(".", "en", {});
    REQUIRE(words.ok());
    return std::move(words).value();
}

}  // namespace

TEST_SUITE("guide") {
    TEST_CASE("hands are led from the stand into the eye, each line once, with the keys of the mapping") {
        DeskScene scene;
        const Words words = english();
        Guide guide;
        const auto says = [&] { return guide.next(scene.hands.state(), scene.stand, words).value_or(""); };
        CHECK(says() == "Take an instrument: E");
        scene.press("E");
        CHECK(says().starts_with("The clock waits for your hand"));
        scene.take({EventKind::pointer, "", 0.0, 0.0, 0.0});
        scene.press("F");
        CHECK(says().starts_with("Go in through the wound"));
        for (int i = 1; i <= 60; ++i) {
            scene.take({EventKind::pointer, "", 0.0, 0.0, 0.1 * i / 14.6});
            scene.advance(0.01);
        }
        CHECK(scene.hand(leading).inside);
        CHECK(says() == "Deeper and higher: the wheel");
        scene.take({EventKind::wheel, "", -6.0});
        scene.advance(0.1);
        CHECK(says() == "Irrigation on: 1; aspiration: 2");
        scene.press("1");
        scene.advance(0.5);
        CHECK(says().empty());  // a phaco probe has nothing to squeeze
        scene.press("P");
        CHECK(says().empty());
        scene.press("P");
        CHECK(says().starts_with("The clock waits for your hand"));
    }

    TEST_CASE("what is put on another key is said with that key") {
        DeskScene scene;
        const Words words = english();
        scene.take({EventKind::bind, "key.E"});
        scene.take({EventKind::bind, "key.T", 0.0, 0.0, 0.0, "next_instrument"});
        Guide guide;
        CHECK(guide.next(scene.hands.state(), scene.stand, words) == "Take an instrument: T");
    }

    TEST_CASE("the menu has every exercise and patient, in the language where it has texts in it") {
        const Menu menu = collect_menu(".", "no/runs", "fr", {"navigation", "cortex", "groove"});
        REQUIRE(menu.exercises.size() >= 22);
        CHECK(menu.exercises[0].name == "navigation");
        CHECK(menu.exercises[1].name == "cortex");
        CHECK(menu.exercises[2].lesson);
        CHECK(menu.exercises[3].name == "capsulorhexis");
        CHECK_FALSE(menu.exercises[3].lesson);
        CHECK(menu.patients.size() >= 3);
        bool french = false;
        for (const MenuExercise& exercise : menu.exercises) {
            CAPTURE(exercise.name);
            CHECK_FALSE(exercise.title.empty());
            CHECK_FALSE(exercise.objectives.empty());
            CHECK(exercise.last.empty());
            french = french || (exercise.name == "cortex" && exercise.title.find("cortex") != std::string::npos &&
                                exercise.objectives[0].starts_with("Saisir"));
        }
        CHECK(french);
    }
}
