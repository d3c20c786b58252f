// SPDX-License-Identifier: GPL-3.0-or-later
#include "attempts.hpp"
#include "records/gates.hpp"
#include "records/history.hpp"
#include "records/pseudonym.hpp"

using namespace rhexis;
using namespace rhexis::records;
using namespace rhexis::records::test;
using doctest::Approx;
using nlohmann::json;

TEST_SUITE("gates") {
    TEST_CASE("two passes in a row open a gate, one and one do not") {
        std::vector<Attempt> attempts;
        for (const double scaled : {0.3, 0.8, 0.5, 0.75, 0.9, 0.2}) {
            attempts.push_back(finished("P07", scaled));
        }
        const Course course = course_of(attempts, "groove", Gate{});
        CHECK(course.first() == 0.3);
        CHECK(course.peak() == 0.9);
        CHECK(course.passed == std::vector<bool>{false, true, false, true, true, false});
        CHECK(course.open_after == 5);
        CHECK(course.time_to_gate_s == Approx(300.0));
        CHECK(course.in_a_row == 0);
        CHECK(course_of(attempts, "another", Gate{}).attempts.empty());
        CHECK(course_of({attempts[1], attempts[2], attempts[3]}, "groove", Gate{}).open_after == 0);
    }

    TEST_CASE("the best is the best that was completed") {
        std::vector<Attempt> attempts = {finished("P07", 0.3), finished("P07", 1.0)};
        attempts[1].completed = false;
        CHECK(course_of(attempts, "groove", Gate{}).peak() == 0.3);
        CHECK_FALSE(course_of({attempts[1]}, "groove", Gate{}).peak().has_value());
    }

    TEST_CASE("no pass: not completed, an error of the script, a critical error left") {
        Attempt attempt = finished("P07", 0.75);
        CHECK(passes(attempt, Gate{}));
        attempt.events = {{1.0, "tear", "run-out", "critical", true, 2.0}, {1.0, "tear", "touch", "minor", false, {}}};
        CHECK(passes(attempt, Gate{}));
        attempt.events[0].recovered = false;
        CHECK_FALSE(passes(attempt, Gate{}));
        CHECK(why_no_pass(attempt, Gate{}) == "a critical error was not put right");
        Gate lenient;
        lenient.no_critical_error_left = false;
        CHECK(passes(attempt, lenient));
        attempt = finished("P07", 0.9);
        attempt.completed = false;
        CHECK_FALSE(passes(attempt, Gate{}));
        CHECK(why_no_pass(attempt, Gate{}) == "not completed");
        attempt = finished("P07", 0.9);
        attempt.error = "groove/curriculum.lua:3: ...";
        CHECK_FALSE(passes(attempt, Gate{}));
        CHECK(why_no_pass(attempt, Gate{}) == "an error of the exercise's script ended it");
        CHECK(why_no_pass(finished("P07", 0.3), Gate{}) == "below the pass mark");
        CHECK(why_no_pass(finished("P07", 0.9), Gate{}).empty());
    }

    TEST_CASE("no pass: begun in the middle, or in another mode, where the gate says so") {
        Attempt attempt = finished("P07", 0.9);
        attempt.begun_at = "half_way";
        attempt.mode = "teaching";
        CHECK_FALSE(passes(attempt, Gate{}));
        CHECK(why_no_pass(attempt, Gate{}) == "it began at a later moment");
        const Result<Gates> gates =
            gates_from({{"usual", {{"from_the_beginning", false}}}, {"exercises", {{"groove", {{"mode", "exam"}}}}}},
                       "gates.json");
        REQUIRE(gates.ok());
        CHECK(passes(attempt, gates.value().usual));
        CHECK_FALSE(passes(attempt, gates.value().of("groove")));
        CHECK(why_no_pass(attempt, gates.value().of("groove")) == "in another mode than the gate asks for");
        attempt.mode = "exam";
        CHECK(passes(attempt, gates.value().of("groove")));
        CHECK_FALSE(gates_from({{"usual", {{"mode", "exams"}}}}, "gates.json").ok());
    }

    TEST_CASE("gates are data, each with its reason, and mistakes in them are named") {
        const json groove = {{"pass", 0.6}, {"reason", "between a and d"}, {"tells_apart", false}};
        const Result<Gates> gates = gates_from(
            {{"note", "of ours"}, {"usual", {{"pass", 0.25}, {"in_a_row", 3}}}, {"exercises", {{"groove", groove}}}},
            "gates.json");
        REQUIRE(gates.ok());
        CHECK(gates.value().of("groove").pass == 0.6);
        CHECK(gates.value().of("groove").in_a_row == 3);
        CHECK(gates.value().of("groove").reason == "between a and d");
        CHECK_FALSE(gates.value().of("groove").tells_apart);
        CHECK(gates.value().of("iol_injection").pass == 0.25);
        CHECK(gates.value().of("iol_injection").tells_apart);
        const auto mistake = [&](const json& usual) {
            return gates_from({{"usual", usual}}, "gates.json").error().text();
        };
        CHECK(mistake({{"pass", "independent"}}).find("what is pass = \"independent\"?") != std::string::npos);
        CHECK(gates_from({{"exercise", {{"groove", groove}}}}, "gates.json").error().text().find("exercises") !=
              std::string::npos);
        CHECK(gates_from({{"exercises", 7}}, "gates.json").error().text().find("by their names") != std::string::npos);
        CHECK(mistake({{"pass", 1.5}}).find("0 to 1") != std::string::npos);
        CHECK(mistake({{"in_a_row", 0}}).find("1 to 20") != std::string::npos);
        CHECK(mistake({{"in_row", 2}}).find("in_a_row") != std::string::npos);
        CHECK(mistake("independent").find("an object") != std::string::npos);
        CHECK_FALSE(gates_from(json::array(), "gates.json").ok());
    }

    TEST_CASE("a report is given the trainee's earlier attempts and the last ones of the cohort") {
        const rhexis::test::Folder folder;
        Store store = open(folder / "records.db");
        for (const auto& [trainee, scaled, date] :
             {std::tuple("P07", 0.2, "2026-03-01T09:00:00Z"), std::tuple("P08", 0.1, "2026-03-01T10:00:00Z"),
              std::tuple("P08", 0.4, "2026-03-02T10:00:00Z"), std::tuple("P09", 0.8, "2026-03-02T11:00:00Z")}) {
            Attempt attempt = finished(trainee, scaled, date);
            attempt.trainee.cohort = "2026";
            REQUIRE(store.finish(attempt).ok());
        }
        Attempt broken_off = finished("P09", 1.0, "2026-03-03T09:00:00Z");
        broken_off.trainee.cohort = "2026";
        broken_off.completed = false;
        REQUIRE(store.finish(broken_off).ok());
        Attempt now = begun("P07");
        now.trainee.cohort = "2026";
        const json comparison = comparison_for(store, now, Gates{}).value();
        REQUIRE(comparison["history"].size() == 1);
        CHECK(comparison["history"][0]["score"].get<double>() == Approx(3.6));
        CHECK(comparison["history"][0]["items"]["T5"].get<double>() == Approx(1.8));
        CHECK(comparison["history"][0]["completed"] == true);
        CHECK(comparison["pass"].get<double>() == Approx(Gate{}.pass));
        // P08 last had 52 %, P09 84 %: what was broken off does not count
        CHECK(comparison["cohort"]["group"] == "2026");
        CHECK(comparison["cohort"]["n"] == 2);
        CHECK(comparison["cohort"]["mean"].get<double>() == Approx(68.0));
        CHECK(comparison["cohort"]["sd"].get<double>() == Approx(16.0 * std::sqrt(2.0)));
        CHECK(comparison["cohort"]["items"]["T9"].get<double>() == Approx((2.6 + 4.2) / 2.0));
        now.trainee = {"P10", "2027", ""};
        CHECK(comparison_for(store, now, Gates{}).value().empty());
        for (const char* name : {"d-101", "d-102"}) {
            Attempt attempt = finished(name, 0.9);
            attempt.trainee.cohort = reference_cohort;
            REQUIRE(store.finish(attempt).ok());
        }
        CHECK(comparison_for(store, now, Gates{}).value()["cohort"]["group"] == "reference");
    }

    TEST_CASE("pseudonyms: short plain words, no addresses") {
        for (const char* good : {"P07", "d-101", "a_b.c", "0"}) {
            CHECK(check_pseudonym(good, "--trainee").ok());
        }
        for (const char* bad : {"", "jo@clinic.org", "Jo Smith", "-x", ".x", "../x", "a'b", "\xc3\xa9",
                                "12345678901234567890123456789012345678901"}) {
            CHECK_FALSE(check_pseudonym(bad, "--trainee").ok());
        }
        CHECK(check_pseudonym("jo@clinic.org", "--trainee").error().what.find("e-mail") != std::string::npos);
    }
}
