// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/calibration_report.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "tracking/calibration/report_drawing.hpp"

namespace rhexis::tracking {
namespace {

double dropped_share(const WandCalibration& wand) {
    const int all = wand.frames_used + wand.frames_dropped;
    return all > 0 ? static_cast<double>(wand.frames_dropped) / all : 0.0;
}

double least_coverage(const CalibrationReport& report) {
    double least = 1.0;
    for (const Coverage& coverage : report.coverage) {
        least = std::min(least, coverage.share());
    }
    return least;
}

std::string percent(double share, int decimals) { return fixed_text(100.0 * share, decimals) + " %"; }

/// A line of the table: what, how much, the goal.
struct Figure {
    std::string name;
    std::string value;
    std::string goal;
    bool met;
};

std::vector<Figure> figures_of(const CalibrationReport& report) {
    const WandCalibration& wand = report.wand;
    const CalibrationGoals& goals = report.goals;
    std::vector<Figure> figures{
        {"Residual, root mean square", fixed_text(wand.residual_px, 3) + " px",
         "at most " + short_number(goals.residual_px) + " px", wand.residual_px <= goals.residual_px},
        {"Scale, standard deviation", percent(wand.scale_sigma, 4),
         "at most " + short_number(100.0 * goals.scale_sigma) + " %", wand.scale_sigma <= goals.scale_sigma},
        {"Time to solve", fixed_text(wand.seconds, 2) + " s", "at most " + short_number(goals.seconds) + " s",
         wand.seconds <= goals.seconds},
        {"Frames left out",
         percent(dropped_share(wand), 1) + " of " + std::to_string(wand.frames_used + wand.frames_dropped),
         "at most " + percent(goals.dropped_frames, 0), dropped_share(wand) <= goals.dropped_frames}};
    if (!report.coverage.empty()) {
        figures.push_back({"Image covered, least of all cameras", percent(least_coverage(report), 0),
                           "at least " + percent(goals.coverage, 0), least_coverage(report) >= goals.coverage});
    }
    return figures;
}

std::string figure_table(const CalibrationReport& report) {
    std::string html = "<table><tr><th>Figure</th><th>Measured</th><th>Goal</th><th></th></tr>\n";
    for (const Figure& figure : figures_of(report)) {
        html += "<tr><td>" + escaped(figure.name) + "</td><td>" + escaped(figure.value) + "</td><td>" +
                escaped(figure.goal) + "</td><td class=\"" + (figure.met ? "good\">met" : "bad\">missed") +
                "</td></tr>\n";
    }
    return html + "</table>\n";
}

std::string camera_table(const CalibrationReport& report) {
    std::string html =
        "<table><tr><th>Camera</th><th>Views</th><th>Residual [px]</th><th>Place, sigma [mm]</th></tr>\n";
    for (std::size_t i = 0; i < report.wand.rig.cameras.size() && i < report.wand.cameras.size(); ++i) {
        const WandCamera& camera = report.wand.cameras[i];
        html += "<tr><td>" + escaped(report.wand.rig.cameras[i].name) + "</td><td>" + std::to_string(camera.views) +
                "</td><td>" + fixed_text(camera.residual_px, 3) + "</td><td>" +
                fixed_text(camera.position_sigma_mm, 3) + "</td></tr>\n";
    }
    return html + "</table>\n";
}

std::string advice_list(const CalibrationReport& report) {
    const std::vector<std::string> advice = calibration_advice(report);
    if (advice.empty()) {
        return "<p class=\"good\">All goals are met.</p>\n";
    }
    std::string html = "<ol>\n";
    for (const std::string& sentence : advice) {
        html += "<li>" + escaped(sentence) + "</li>\n";
    }
    return html + "</ol>\n";
}

std::string section(const std::string& heading, const std::string& content) {
    return "<section><h2>" + escaped(heading) + "</h2>\n" + content + "</section>\n";
}

std::string coverage_section(const CalibrationReport& report) {
    std::string html = "<div class=\"maps\">\n";
    for (std::size_t i = 0; i < report.coverage.size() && i < report.wand.rig.cameras.size(); ++i) {
        html += coverage_map(report.wand.rig.cameras[i], report.coverage[i]);
    }
    return html +
           "</div>\n<p class=\"soft\">Darker cells have more of the wand's spots; outlined ones have none.</p>\n";
}

}  // namespace

std::vector<Coverage> wand_coverage(const Rig& rig, std::span<const WandFrame> frames) {
    std::vector<std::vector<Vec2>> spots(rig.cameras.size());
    for (const WandFrame& frame : frames) {
        for (const WandView& view : frame.views) {
            if (view.camera >= 0 && static_cast<std::size_t>(view.camera) < spots.size()) {
                std::vector<Vec2>& all = spots[static_cast<std::size_t>(view.camera)];
                all.insert(all.end(), view.spots.begin(), view.spots.end());
            }
        }
    }
    std::vector<Coverage> coverage;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        coverage.push_back(coverage_of(spots[i], rig.cameras[i].width, rig.cameras[i].height));
    }
    return coverage;
}

std::vector<std::string> calibration_advice(const CalibrationReport& report) {
    const WandCalibration& wand = report.wand;
    const CalibrationGoals& goals = report.goals;
    std::vector<std::string> advice;
    if (!(wand.residual_px <= goals.residual_px)) {
        const auto worst = std::max_element(
            wand.cameras.begin(), wand.cameras.end(),
            [](const WandCamera& one, const WandCamera& other) { return one.residual_px < other.residual_px; });
        const auto at = static_cast<std::size_t>(worst - wand.cameras.begin());
        const std::string name = at < wand.rig.cameras.size() ? " (\"" + wand.rig.cameras[at].name + "\")" : "";
        advice.push_back("The residual is too great. Calibrate the lens of the camera with the longest bar" + name +
                         " anew, look to its focus and exposure, and wave the wand more slowly.");
    }
    if (!(wand.scale_sigma <= goals.scale_sigma)) {
        advice.emplace_back(
            "The scale is too uncertain. Measure the distance between the wand's spheres more exactly, or take a "
            "longer "
            "wand.");
    }
    if (!(wand.seconds <= goals.seconds)) {
        advice.emplace_back("Solving took too long. Take fewer frames; some 600, spread over the space, are enough.");
    }
    if (!(dropped_share(wand) <= goals.dropped_frames)) {
        advice.emplace_back(
            "Many frames did not fit. Remove what else shines in the images, keep hands off the spheres, and see that "
            "all cameras are exposed together.");
    }
    if (!report.coverage.empty() && !(least_coverage(report) >= goals.coverage)) {
        advice.emplace_back(
            "Parts of an image saw no wand. Wave it where the outlined cells of the maps are, near the rims as well.");
    }
    return advice;
}

std::string calibration_page(const CalibrationReport& report) {
    std::string html = "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>" +
                       escaped(report.title) + "</title>\n<style>" + page_style() +
                       "</style></head><body>\n<header><h1>" + escaped(report.title) +
                       "</h1>\n<p class=\"soft\">Calibration of " + std::to_string(report.wand.rig.cameras.size()) +
                       " cameras from " + std::to_string(report.wand.frames_used) + " frames of a wand</p></header>\n";
    html += section("Figures and goals", figure_table(report));
    html += section("What to do", advice_list(report));
    html +=
        section("Residual of each camera", residual_bars(report.wand, report.goals.residual_px) + camera_table(report));
    if (!report.coverage.empty()) {
        html += section("Where each image saw the wand", coverage_section(report));
    }
    html += section("The rig from above", rig_from_above(report.wand.rig));
    return html + "</body></html>\n";
}

}  // namespace rhexis::tracking
