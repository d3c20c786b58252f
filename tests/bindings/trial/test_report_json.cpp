// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include "base/base64.hpp"
#include "base/near_names.hpp"
#include "trial/report_json.hpp"
#include "trial/series.hpp"

using namespace rhexis;
using nlohmann::json;

namespace {

ReportInput example() {
    ReportInput input;
    input.identity = {{"id", "groove"}, {"version", 1}, {"sha256", "00"}, {"secret", "not for the report"}};
    input.surgeon = "expert";
    input.seed = 7;
    input.duration_s = 12.5;
    input.result = {{"completed", true},
                    {"steps", json::array({{{"id", "sculpt"}}})},
                    {"events", json::array()},
                    {"osacss", {{"total", 13}, {"max", 15}, {"scaled", 0.8333}}},
                    {"measures", {{"T9.depth", 81.2}}}};
    input.pictures = {{"frames/01-start.png", "start", "Before the first step.", 0.0}};
    input.log = {{LogLevel::warning, 1.0, "sample refused"}};
    input.simulated = json::array();
    input.performance = {{"steps", 1250}};
    return input;
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
    }

    TEST_CASE("an exercise that failed is not completed and says why") {
        ReportInput input = example();
        input.script_error = "curriculum.lua:3: no";
        const json report = make_report(input);
        CHECK(report["completed"] == false);
        CHECK(report["error"] == "curriculum.lua:3: no");
        input.result = nullptr;
        CHECK(make_report(input)["events"] == json::array());
        CHECK(make_report(input)["osacss"].is_null());
    }

    TEST_CASE("the score line gives total, maximum and scaled score, or says that there is none") {
        CHECK(score_line(make_report(example())) == "OSACSS 13 of 15 (scaled 0.83; not clinically validated)");
        ReportInput input = example();
        input.result["osacss"] = nullptr;
        CHECK(score_line(make_report(input)).find("no score") == 0);
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
