// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "base/base64.hpp"
#include "base/near_names.hpp"
#include "trial/report_json.hpp"
#include "trial/series.hpp"

using namespace rhexis;
using nlohmann::json;

namespace {

AttemptFacts example() {
    AttemptFacts facts;
    facts.identity = {{"id", "groove"}, {"version", 1}, {"sha256", "00"}, {"secret", "not for the report"}};
    facts.surgeon = "expert";
    facts.seed = 7;
    facts.duration_s = 12.5;
    facts.findings = {{"completed", true},
                      {"steps", json::array({{{"id", "sculpt"}}})},
                      {"events", json::array()},
                      {"osacss", {{"total", 13}, {"max", 15}, {"scaled", 0.8333}}},
                      {"measures", {{"T9.depth", 81.2}}}};
    facts.pictures = {{"frames/01-start.png", "start", "Before the first step.", 0.0}};
    facts.log = {{LogLevel::warning, 1.0, "sample refused"}};
    facts.simulated = {{"lens", 1200, 0.5}};
    facts.performance.steps = 1250;
    facts.performance.checkpoints = {2, 0.5, 20.0};
    facts.performance.live = Pace{0.25, 0.0, 1, 20.0};
    return facts;
}

}  // namespace

TEST_SUITE("report") {
    TEST_CASE("report.json has every field of schema 1") {
        const json report = make_report(example());
        CHECK(report["schema"] == 1);
        CHECK(report["curriculum"] == json{{"id", "groove"}, {"version", 1}, {"sha256", "00"}});
        for (const char* key :
             {"surgeon", "set", "seed", "patient", "completed", "duration_s", "steps", "events", "osacss", "measures",
              "simulated", "performance", "pictures", "video", "log", "state_hash", "start", "opening_mm"}) {
            CAPTURE(key);
            CHECK(report.contains(key));
        }
        for (const char* key : {"age", "nuclear_grade", "cortical_opacity", "pupil_mm", "side", "tetrahedra"}) {
            CHECK(report["patient"].contains(key));
        }
        CHECK(report["log"][0] == json{{"level", "warning"}, {"time_s", 1.0}, {"text", "sample refused"}});
        CHECK_FALSE(report.contains("error"));
        CHECK(report["simulated"][0] == json{{"part", "lens"}, {"elements", 1200}, {"cpu_s", 0.5}});
        CHECK(report["performance"]["steps"] == 1250);
        CHECK(report["performance"]["checkpoints"]["worst_writing_ms"] == 20.0);
        CHECK(report["performance"]["live"]["late_p99_9_steps"] == 0.25);
    }

    TEST_CASE("an exercise that failed is not completed and says why") {
        AttemptFacts facts = example();
        facts.script_error = "curriculum.lua:3: no";
        const json report = make_report(facts);
        CHECK(report["completed"] == false);
        CHECK(report["error"] == "curriculum.lua:3: no");
        facts.findings = nullptr;
        CHECK(make_report(facts)["events"] == json::array());
        CHECK(make_report(facts)["osacss"].is_null());
    }

    TEST_CASE("the score line gives total, maximum and scaled score, or says that there is none") {
        CHECK(score_line(make_report(example())) == "OSACSS 13 of 15 (scaled 0.83; not clinically validated)");
        AttemptFacts facts = example();
        facts.findings["osacss"] = nullptr;
        CHECK(score_line(make_report(facts)).find("no score") == 0);
    }

    TEST_CASE("a series keeps first and evenly spread rows, whatever the length of the run") {
        Series series({{"a.x_mm", "mm", "x"}});
        for (int i = 0; i < 20000; ++i) {
            series.add({0.01 * i, {i % 3 == 0 ? std::nan("") : 0.5 * i}});
        }
        const json out = series.json();
        const std::size_t count = out["time_s"].size();
        CHECK(count <= 1200);
        CHECK(count >= 600);
        CHECK(out["measures"]["a.x_mm"]["values"].size() == count);
        CHECK(out["time_s"][0] == 0.0);
        CHECK(out["measures"]["a.x_mm"]["values"][0].is_null());
        const double gap = out["time_s"][1].get<double>();
        CHECK(out["time_s"][count - 1].get<double>() == doctest::Approx(gap * static_cast<double>(count - 1)));
    }

    TEST_CASE("base64 is that of RFC 4648") {
        CHECK(base64("").empty());
        CHECK(base64("f") == "Zg==");
        CHECK(base64("fo") == "Zm8=");
        CHECK(base64("foobar") == "Zm9vYmFy");
        CHECK(base64(std::string("\xff\xfe\x00", 3)) == "//4A");
    }

    TEST_CASE("near names come nearest first, and far ones not at all") {
        const std::vector<std::string> names{"groove", "rhexis", "grooves", "chop"};
        CHECK(near_names("grove", names) == std::vector<std::string>{"groove"});
        CHECK(near_names("groovs", names) == std::vector<std::string>{"groove", "grooves"});
        CHECK(near_names("xyz", names).empty());
        CHECK(edit_distance("ab", "ba") == 1);
        CHECK(suggestion("zzz", names) == "one of groove, rhexis, grooves, chop");
    }
}
