// SPDX-License-Identifier: GPL-3.0-or-later
#include "attempts.hpp"
#include "records/comparison.hpp"
#include "records/csv.hpp"

using namespace rhexis::records;
using namespace rhexis::records::test;
using doctest::Approx;

namespace {

Rating by(const std::string& rater, const Attempt& attempt, std::optional<int> t5, std::optional<int> t9) {
    return {attempt.id, rater, "2026-03-02T10:00:00Z", "", {{"T5", t5, ""}, {"T9", t9, ""}, {"G1", std::nullopt, ""}}};
}

const nlohmann::json& row(const nlohmann::json& data, const std::string& item) {
    for (const nlohmann::json& one : data["rows"]) {
        if (one["item"] == item) {
            return one;
        }
    }
    FAIL("no row " << item);
    return data;
}

}  // namespace

TEST_SUITE("comparison of judges") {
    TEST_CASE("simulator against the mean of the raters, item by item and in total") {
        const std::vector<Attempt> attempts = {finished("A", 0.0), finished("B", 0.5), finished("C", 1.0),
                                               finished("D", 0.7)};  // D is rated by nobody
        const std::vector<Rating> ratings = {by("R1", attempts[0], 1, 2), by("R1", attempts[1], 3, 3),
                                             by("R1", attempts[2], 5, 4), by("R2", attempts[0], 2, 2),
                                             by("R2", attempts[1], 4, 3), by("R2", attempts[2], 5, std::nullopt)};
        const nlohmann::json data = compare_judges(attempts, ratings);
        CHECK(data["attempts"] == 3);
        CHECK(data["raters"] == nlohmann::json({"R1", "R2"}));
        // T5: simulator 1, 3, 5; raters 1.5, 3.5, 5
        CHECK(row(data, "T5")["simulator"]["limits"]["n"] == 3);
        CHECK(row(data, "T5")["simulator"]["limits"]["bias"].get<double>() == Approx(-1.0 / 3.0));
        CHECK(row(data, "T5")["raters"]["icc"]["n"] == 3);
        CHECK(row(data, "T5")["raters"]["icc"]["single"].get<double>() == Approx(0.9));
        // T9: R2 left one out, so that raters are compared over two attempts, and the simulator still over three
        CHECK(row(data, "T9")["raters"]["icc"]["n"] == 2);
        CHECK(row(data, "T9")["simulator"]["limits"]["n"] == 3);
        // total: C over T5 alone, which all have scored
        const nlohmann::json& total = row(data, "total");
        CHECK(total["simulator"]["limits"]["n"] == 3);
        CHECK(total["simulator"]["points"][2][0].get<double>() == Approx(100.0));
        CHECK(total["simulator"]["points"][0][1].get<double>() == Approx(20.0 - 20.0 * (1.5 + 2.0) / 2.0));
        CHECK(data["rows"].back() == total);
    }

    TEST_CASE("who rated little is left out of the correlation among raters") {
        const std::vector<Attempt> attempts = {finished("A", 0.0), finished("B", 0.5), finished("C", 1.0)};
        std::vector<Rating> ratings = {by("R1", attempts[0], 1, 2), by("R1", attempts[1], 3, 3),
                                       by("R1", attempts[2], 5, 4), by("R2", attempts[0], 2, 2),
                                       by("R2", attempts[1], 4, 3), by("R2", attempts[2], 5, 4)};
        const nlohmann::json two = compare_judges(attempts, ratings);
        CHECK(two["left_out"].empty());
        ratings.push_back(by("R3", attempts[0], 1, 1));
        const nlohmann::json three = compare_judges(attempts, ratings);
        CHECK(three["left_out"] == nlohmann::json({"R3"}));
        CHECK(row(three, "T5")["raters"]["icc"] == row(two, "T5")["raters"]["icc"]);
        CHECK(row(three, "T5")["raters"]["pairs"].size() == 3);
    }

    TEST_CASE("too few raters, constant items and items that nobody scored say so") {
        const std::vector<Attempt> attempts = {finished("A", 0.0), finished("B", 0.5)};
        const nlohmann::json one = compare_judges(attempts, {by("R1", attempts[0], 1, 4), by("R1", attempts[1], 3, 4)});
        CHECK(row(one, "T5")["raters"]["icc"]["why"] == "too few raters: two at least");
        CHECK(row(one, "T5")["raters"]["pairs"].empty());
        const nlohmann::json two = compare_judges(attempts, {by("R1", attempts[0], 1, 4), by("R1", attempts[1], 3, 4),
                                                             by("R2", attempts[0], 2, 4), by("R2", attempts[1], 3, 4)});
        CHECK(row(two, "T9")["raters"]["icc"]["why"] == "all scores are the same");
        CHECK(compare_judges(attempts, {})["attempts"] == 0);
    }

    TEST_CASE("tables quote what must be quoted and tell units in their names") {
        Attempt attempt = finished("P07", 0.5);
        attempt.settings = R"({"patient.age":"80"})";
        attempt.error = "=cmd()";
        attempt.events = {{12.5, "tear", "radial run-out", "critical", true, 3.25}};
        std::map<std::string, std::string> files = csv_of({attempt}, {by("R1", attempt, 4, std::nullopt)});
        CHECK(files.size() == 5);
        CHECK(files["attempts.csv"].find(R"("{""patient.age"":""80""}")") != std::string::npos);
        CHECK(files["attempts.csv"].find(",'=cmd(),") != std::string::npos);
        CHECK(files["attempts.csv"].find(",18364758544493064720,") != std::string::npos);
        CHECK(files["events.csv"] == "attempt,t_s,step,event,severity,recovered,t_recover_s\n" + attempt.id +
                                         ",12.5,tear,radial run-out,critical,1,3.25\n");
        CHECK(files["items.csv"].find(",T9,Groove,3,radial\n") != std::string::npos);
        CHECK(files["measures.csv"].find(",T5.gap,Gap,,mm,\n") != std::string::npos);
        CHECK(files["ratings.csv"].find(",R1,2026-03-02T10:00:00Z,T9,,\n") != std::string::npos);
    }
}
