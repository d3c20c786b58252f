// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <limits>

#include "math/rotation.hpp"
#include "tracking/calibration/calibration_report.hpp"
#include "tracking/calibration/report_drawing.hpp"

namespace rhexis::tracking {
namespace {

CalibrationReport good_report() {
    CalibrationReport report;
    report.title = "Ring of three";
    for (int i = 0; i < 3; ++i) {
        Camera camera;
        camera.name = "camera-" + std::to_string(i + 1);
        camera.width = 1280;
        camera.height = 1024;
        camera.lens = {1667, 1667, 640, 512, 0, 0, 0, 0, 0};
        camera.pose.position = Vec3(300.0 * std::cos(2.1 * i), 300.0 * std::sin(2.1 * i), 340.0);
        camera.pose.orientation = turn_of_z(-camera.pose.position);
        report.wand.rig.cameras.push_back(camera);
        report.wand.cameras.push_back({500, 0.03 + 0.005 * i, 0.02});
        report.coverage.push_back({2, 2, {3, 1, 4, 2}});
    }
    report.wand.residual_px = 0.035;
    report.wand.scale_sigma = 1e-4;
    report.wand.seconds = 0.4;
    report.wand.frames_used = 590;
    report.wand.frames_dropped = 10;
    return report;
}

int count_of(const std::string& text, const std::string& what) {
    int count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
        ++count;
    }
    return count;
}

}  // namespace

TEST_CASE("a good calibration is told to be one, with figures beside their goals") {
    const std::string page = calibration_page(good_report());
    CHECK(page.find("All goals are met.") != std::string::npos);
    CHECK(count_of(page, "\">met</td>") == 5);
    CHECK(count_of(page, "missed") == 0);
    CHECK(page.find("<td>0.035 px</td><td>at most 0.05 px</td>") != std::string::npos);
    CHECK(page.find("<td>0.0100 %</td><td>at most 0.02 %</td>") != std::string::npos);
    CHECK(count_of(page, "<svg") == 5);  // bars, three maps, the rig
    CHECK(count_of(page, "<svg") == count_of(page, "</svg>"));
    CHECK(count_of(page, "<polygon") == 3);
}

TEST_CASE("the page needs no other file") {
    const std::string page = calibration_page(good_report());
    for (const char* foreign : {"http", "src=", "href", "url(", "<script"}) {
        CHECK(page.find(foreign) == std::string::npos);
    }
}

TEST_CASE("each figure that misses its goal has a sentence that says what to do, and it alone") {
    CHECK(calibration_advice(good_report()).empty());
    const auto only = [](const CalibrationReport& report, const char* what) {
        const std::vector<std::string> advice = calibration_advice(report);
        return advice.size() == 1 && advice[0].find(what) != std::string::npos;
    };
    CalibrationReport report = good_report();
    report.wand.residual_px = 0.2;
    CHECK(only(report, "(\"camera-3\")"));
    report.wand.residual_px = std::numeric_limits<double>::quiet_NaN();
    CHECK(only(report, "The residual is too great"));
    report = good_report();
    report.wand.scale_sigma = 3e-4;
    CHECK(only(report, "Measure the distance"));
    report = good_report();
    report.wand.seconds = 3.0;
    CHECK(only(report, "Take fewer frames"));
    report = good_report();
    report.wand.frames_dropped = 300;
    CHECK(only(report, "Many frames did not fit"));
    report = good_report();
    report.coverage[1].points = {0, 0, 5, 0};
    CHECK(only(report, "saw no wand"));
    CHECK(count_of(calibration_page(report), "missed") == 1);
}

TEST_CASE("lenses that were measured are on the page, with what to do about each that is not good enough") {
    Rig rig = good_report().wand.rig;
    CHECK(lens_advice(rig).empty());
    CHECK(calibration_page(good_report()).find("by a board") == std::string::npos);
    for (int i = 0; i < 3; ++i) {
        rig.lenses.push_back({24, i, 2, 0.03, 0.5, {2, 2, {3, 1, 4, 2}}});
    }
    CHECK(lens_advice(rig).empty());
    const std::string page = lens_page("Ring of three", rig);
    CHECK(page.find("All goals are met.") != std::string::npos);
    CHECK(page.find("Where the cameras stand is still to be found") != std::string::npos);
    CHECK(page.find("<td>camera-3</td><td>24</td><td>2</td><td>2</td><td>0.030</td><td>1667.0 &plusmn; 0.50</td>") !=
          std::string::npos);
    CHECK(count_of(page, "<svg") == 3);
    CalibrationReport whole = good_report();
    whole.wand.rig = rig;
    CHECK(calibration_page(whole).find("by a board") != std::string::npos);

    const auto only = [&rig](LensFigures changed, const char* what) {
        std::swap(rig.lenses[1], changed);
        const std::vector<std::string> advice = lens_advice(rig);
        std::swap(rig.lenses[1], changed);
        return advice.size() == 1 && advice[0].find(what) != std::string::npos &&
               advice[0].find("\"camera-2\"") != std::string::npos;
    };
    LensFigures worse = rig.lenses[1];
    worse.residual_px = 0.3;
    CHECK(only(worse, "the board is flat"));
    worse = rig.lenses[1];
    worse.coverage.points = {0, 0, 5, 0};
    CHECK(only(worse, "saw no board"));
    worse = rig.lenses[1];
    worse.views = 9;
    CHECK(only(worse, "Take 12 or more"));
    worse = rig.lenses[1];
    worse.focal_sigma_px = 5.0;
    CHECK(only(worse, "Slant the board"));
}

TEST_CASE("names that look like marks are shown as they are") {
    CalibrationReport report = good_report();
    report.title = "<script>alert('1')</script> & \"more\"";
    report.wand.rig.cameras[0].name = "<b>left</b>";
    const std::string page = calibration_page(report);
    CHECK(page.find("<script") == std::string::npos);
    CHECK(page.find("<b>") == std::string::npos);
    CHECK(page.find("&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt; &amp; &quot;more&quot;") != std::string::npos);
    CHECK(page.find("&lt;b&gt;left&lt;/b&gt;") != std::string::npos);
}

TEST_CASE("an empty report is still a page") {
    const std::string page = calibration_page({});
    CHECK(page.find("No cameras.") != std::string::npos);
    CHECK(page.find("</html>") != std::string::npos);
}

TEST_CASE("coverage counts spots where they fall, and not those outside the image") {
    const Rig rig{good_report().wand.rig};
    const std::vector<WandFrame> frames{{{{1, {{0, 0}, {1279, 1023}, {-3, 5}}}}}, {{{1, {{10, 10}}}, {9, {{1, 1}}}}}};
    const std::vector<Coverage> coverage = wand_coverage(rig, frames);
    REQUIRE(coverage.size() == 3);
    CHECK(coverage[0].share() == 0.0);
    CHECK(coverage[1].points.front() == 2);
    CHECK(coverage[1].points.back() == 1);
    CHECK(coverage[1].share() == doctest::Approx(2.0 / 48.0));
}

}  // namespace rhexis::tracking
