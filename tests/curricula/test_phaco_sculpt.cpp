// SPDX-License-Identifier: GPL-3.0-or-later
// The cross: what it observes and scores, its second hand, and how it answers bad settings.
#include <doctest/doctest.h>

#include "attempt.hpp"

using namespace rhexis;
using rhexis::test::Attempt;

TEST_CASE("the cross scores what it simulates, of both instruments") {
    Attempt attempt("none", 1, {{"patient.tetrahedra", "800"}}, "phaco_sculpt");
    attempt.run(0.05);
    const nlohmann::json result = attempt.result();
    std::string items;
    for (const nlohmann::json& item : result.at("osacss").at("items")) {
        items += item.at("id").get<std::string>() + " ";
    }
    CHECK(items == "T7 T8 T9 T10 G3 G4 G5 G6 ");
    CHECK(attempt.measure("spatula.present") == 0.0);
    CHECK(attempt.session().eye().anatomy.side_port_width == doctest::Approx(1.0));
}

TEST_CASE("an exercise with one instrument has no side port") {
    Attempt attempt("none", 1, {{"patient.tetrahedra", "800"}});
    CHECK(attempt.session().eye().anatomy.side_port_width == 0.0);
    for (const Landmark& mark : attempt.session().percept().landmarks) {
        CHECK((mark.name != "side_port" || !mark.visible));
    }
}

TEST_CASE("habits of the surgeon are checked: name, value, and that somebody operates") {
    const auto load = [](const std::string& surgeon, const std::string& key, const std::string& value) {
        ExerciseOptions options;
        options.curriculum = "phaco_sculpt";
        options.surgeon = surgeon;
        options.set = {{key, value}};
        options.root = std::filesystem::current_path().string();
        const Result<ExerciseHost> host = ExerciseHost::load(options);
        return host ? std::string() : host.error().text();
    };
    CHECK(load("a", "surgeon.recovery", "0").empty());
    CHECK(load("a", "surgeon.recovery", "1").empty());
    CHECK(load("a", "surgeon.recovery", "2").find("must be 0 or 1") != std::string::npos);
    CHECK(load("a", "surgeon.recovry", "0").find("did you mean recovery") != std::string::npos);
    CHECK(load("none", "surgeon.recovery", "0").find("nobody operates") != std::string::npos);
}
