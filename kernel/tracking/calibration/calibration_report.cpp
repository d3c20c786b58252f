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

std::string advice_list(const std::vector<std::string>& advice) {
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

std::string coverage_maps(const Rig& rig, const std::vector<Coverage>& coverage, const char* of) {
    std::string html = "<div class=\"maps\">\n";
    for (std::size_t i = 0; i < coverage.size() && i < rig.cameras.size(); ++i) {
        html += coverage_map(rig.cameras[i], coverage[i]);
    }
    return html + "</div>\n<p class=\"soft\">Darker cells have more " + of + "; outlined ones have none.</p>\n";
}

bool lenses_are_told(const Rig& rig) { return !rig.lenses.empty() && rig.lenses.size() == rig.cameras.size(); }

std::string lens_table(const Rig& rig) {
    std::string html =
        "<table><tr><th>Camera</th><th>Views of the board</th><th>Left out</th><th>Images without it</th>"
        "<th>Residual [px]</th><th>Focal length, with sigma [px]</th><th>Image covered</th></tr>\n";
    for (std::size_t i = 0; i < rig.lenses.size(); ++i) {
        const LensFigures& lens = rig.lenses[i];
        html += "<tr><td>" + escaped(rig.cameras[i].name) + "</td><td>" + std::to_string(lens.views) + "</td><td>" +
                std::to_string(lens.left_out) + "</td><td>" + std::to_string(lens.without) + "</td><td>" +
                fixed_text(lens.residual_px, 3) + "</td><td>" + fixed_text(rig.cameras[i].lens.fx, 1) + " &plusmn; " +
                fixed_text(lens.focal_sigma_px, 2) + "</td><td>" + percent(lens.coverage.share(), 0) + "</td></tr>\n";
    }
    return html + "</table>\n";
}

std::string lens_sections(const Rig& rig) {
    if (!lenses_are_told(rig)) {
        return "";
    }
    std::vector<Coverage> coverage;
    for (const LensFigures& lens : rig.lenses) {
        coverage.push_back(lens.coverage);
    }
    return section("Lenses, by a board", lens_table(rig)) +
           section("Where each image saw the board", coverage_maps(rig, coverage, "of the board's points"));
}

std::string page_of(const std::string& title, const std::string& about, const std::string& sections) {
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>" + escaped(title) +
           "</title>\n<style>" + page_style() + "</style></head><body>\n<header><h1>" + escaped(title) +
           "</h1>\n<p class=\"soft\">" + escaped(about) + "</p></header>\n" + sections + "</body></html>\n";
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

std::vector<std::string> lens_advice(const Rig& rig, const CalibrationGoals& goals) {
    std::vector<std::string> advice;
    if (!lenses_are_told(rig)) {
        return advice;
    }
    for (std::size_t i = 0; i < rig.lenses.size(); ++i) {
        const LensFigures& lens = rig.lenses[i];
        const std::string name = "\"" + rig.cameras[i].name + "\"";
        if (!(lens.residual_px <= goals.lens_residual_px)) {
            advice.push_back("The board's points do not fit the lens of " + name +
                             " well. See that the board is flat and its spacing as it was told, hold it still, and "
                             "look to the focus.");
        }
        if (!(lens.coverage.share() >= goals.lens_coverage)) {
            advice.push_back("Parts of the image of " + name +
                             " saw no board. Show it where the outlined cells of its map are, up to the rims.");
        }
        if (lens.views < goals.lens_views) {
            advice.push_back(name + " has few views of the board. Take " + std::to_string(goals.lens_views) +
                             " or more, near and far.");
        }
        if (!(lens.focal_sigma_px <= goals.lens_focal_sigma * rig.cameras[i].lens.fx)) {
            advice.push_back("The focal length of " + name +
                             " is uncertain. Slant the board by 20 to 40 degrees, to different sides.");
        }
    }
    return advice;
}

std::string lens_page(const std::string& title, const Rig& rig, const CalibrationGoals& goals) {
    return page_of(title,
                   "Lenses of " + std::to_string(rig.cameras.size()) +
                       " cameras from images of a board. Where the cameras stand is still to be found, by a wand.",
                   section("What to do", advice_list(lens_advice(rig, goals))) + lens_sections(rig));
}

std::string calibration_page(const CalibrationReport& report) {
    const Rig& rig = report.wand.rig;
    std::vector<std::string> advice = calibration_advice(report);
    const std::vector<std::string> of_lenses = lens_advice(rig, report.goals);
    advice.insert(advice.end(), of_lenses.begin(), of_lenses.end());
    std::string html = section("Figures and goals", figure_table(report));
    html += section("What to do", advice_list(advice));
    html +=
        section("Residual of each camera", residual_bars(report.wand, report.goals.residual_px) + camera_table(report));
    if (!report.coverage.empty()) {
        html += section("Where each image saw the wand", coverage_maps(rig, report.coverage, "of the wand's spots"));
    }
    html += lens_sections(rig) + section("The rig from above", rig_from_above(rig));
    return page_of(report.title,
                   "Calibration of " + std::to_string(rig.cameras.size()) + " cameras from " +
                       std::to_string(report.wand.frames_used) + " frames of a wand",
                   html);
}

}  // namespace rhexis::tracking
