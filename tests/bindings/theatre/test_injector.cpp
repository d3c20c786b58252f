// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <map>
#include <string>

#include "station/injector.hpp"

using namespace rhexis;
using namespace rhexis::station;

namespace {

constexpr double dt = 0.01;

std::vector<Injection> known() {
    const nlohmann::json listing = nlohmann::json::parse(R"([
        {"id": "bottle", "title": "The bottle runs empty", "head": [], "microscope": [],
         "settings": [{"name": "height", "to": 0, "over_s": 1}, {"name": "open", "to": 0, "over_s": 0}]},
        {"id": "cough", "title": "A cough", "settings": [], "microscope": [],
         "head": [[0, 0, 0, 0], [0.1, 1, 0, 0], [0.3, 0, 0, 0]]},
        {"id": "moves", "title": "The head", "settings": [], "microscope": [], "head": [[0, 0, 0, 0], [0.5, 1, -1, 0]]},
        {"id": "push", "title": "A push", "settings": [], "head": [], "microscope": [2, 1, 0]}])");
    return injections_of(listing, true);
}

/// Steps, and does what is commanded. How often something was told.
int advance(Injector& injector, std::map<std::string, double>& settings, int steps) {
    int told = 0;
    for (int i = 0; i < steps; ++i) {
        for (const Command& command : injector.advance(dt, settings)) {
            told += command.kind == CommandKind::aid ? 1 : 0;
            if (command.kind == CommandKind::inject) {
                settings[command.name] = command.value;
            }
        }
    }
    return told;
}

}  // namespace

TEST_CASE("settings go where they are to go, one after the other, and back when it is put right") {
    Injector injector(known());
    std::map<std::string, double> settings = {{"height", 80.0}, {"open", 1.0}};
    REQUIRE(injector.begin("bottle").ok());
    CHECK(advance(injector, settings, 51) == 1);
    CHECK(settings["height"] == doctest::Approx(40.0));
    CHECK(settings["open"] == 1.0);
    CHECK(advance(injector, settings, 60) == 0);
    CHECK(settings["height"] == 0.0);
    CHECK(settings["open"] == 0.0);
    settings["open"] = 1.0;  // whoever operates has opened it again: it stays so
    advance(injector, settings, 50);
    CHECK(settings["open"] == 1.0);
    CHECK(injector.runs("bottle"));
    injector.end("bottle");
    advance(injector, settings, 1);
    CHECK(settings["height"] == 80.0);
    CHECK_FALSE(injector.runs("bottle"));
}

TEST_CASE("what is begun and put right before the next step changes nothing, and is told") {
    Injector injector(known());
    std::map<std::string, double> settings = {{"height", 80.0}, {"open", 1.0}};
    REQUIRE(injector.begin("bottle").ok());
    injector.end("bottle");
    CHECK(advance(injector, settings, 10) == 1);
    CHECK(settings["height"] == 80.0);
}

TEST_CASE("a head that moves goes its way without a jump, passes or stays, and comes back") {
    Injector injector(known());
    std::map<std::string, double> settings;
    REQUIRE(injector.begin("cough").ok());
    double farthest = 0.0;
    double longest = 0.0;
    Vec3 before = injector.head();
    for (int i = 0; i < 60; ++i) {
        advance(injector, settings, 1);
        farthest = std::max(farthest, injector.head().x());
        longest = std::max(longest, (injector.head() - before).norm());
        before = injector.head();
    }
    CHECK(farthest == doctest::Approx(1.0));
    CHECK(longest < 0.2);
    CHECK(injector.head().norm() == 0.0);
    CHECK_FALSE(injector.runs("cough"));  // it is over by itself
    REQUIRE(injector.begin("moves").ok());
    advance(injector, settings, 200);
    CHECK(injector.head().x() == doctest::Approx(1.0));
    CHECK(injector.runs("moves"));
    injector.end("moves");
    advance(injector, settings, 100);
    CHECK(injector.head().norm() == 0.0);
}

TEST_CASE("a push is told once, and only where there is a microscope") {
    Injector injector(known());
    std::map<std::string, double> settings;
    REQUIRE(injector.begin("push").ok());
    CHECK(injector.take_push()->x() == 2.0);
    CHECK_FALSE(injector.take_push().has_value());
    advance(injector, settings, 1);
    CHECK_FALSE(injector.runs("push"));
    nlohmann::json listing = nlohmann::json::parse(
        R"([{"id": "push", "title": "A push", "settings": [], "head": [], "microscope": [2, 1, 0]}])");
    CHECK(injections_of(listing, false).empty());
}

TEST_CASE("what the scene does not know is refused, with what it knows") {
    Injector injector(known());
    const Status begun = injector.begin("quake");
    REQUIRE_FALSE(begun.ok());
    CHECK(begun.error().text().find("quake") != std::string::npos);
    CHECK(begun.error().text().find("cough") != std::string::npos);
    injector.end("quake");  // nothing to put right
    std::map<std::string, double> settings;
    CHECK(injector.advance(dt, settings).empty());
}
