// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/report_drawing.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace rhexis::tracking {
namespace {

std::string svg(double width, double height, const std::string& label, const std::string& content) {
    return "<svg viewBox=\"0 0 " + fixed_text(width, 0) + " " + fixed_text(height, 0) +
           "\" role=\"img\" aria-label=\"" + escaped(label) + "\">\n" + content + "</svg>\n";
}

std::string text_at(double x, double y, const std::string& text) {
    return "<text x=\"" + fixed_text(x, 1) + "\" y=\"" + fixed_text(y, 1) + "\">" + escaped(text) + "</text>\n";
}

std::string rectangle(const Vec2& at, const Vec2& size, const std::string& look) {
    return "<rect x=\"" + fixed_text(at.x(), 1) + "\" y=\"" + fixed_text(at.y(), 1) + "\" width=\"" +
           fixed_text(size.x(), 1) + "\" height=\"" + fixed_text(size.y(), 1) + "\" " + look + "/>\n";
}

/// A camera, the middle of its view and the view's left and right ends, from above [mm].
struct ViewFromAbove {
    std::string name;
    Vec2 at;
    std::array<Vec2, 2> ends;
};

/// As far as the rig's middle.
ViewFromAbove view_from_above(const Camera& camera, const Vec3& middle) {
    const double depth = std::max(1.0, camera.pose.to_body(middle).z());
    ViewFromAbove view{camera.name, camera.pose.position.head<2>(), {}};
    const std::array<double, 2> columns{0.0, static_cast<double>(camera.width)};
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec2 direction = undistorted(camera.lens, {columns[i], camera.lens.cy});
        const Vec3 end = camera.pose.to_world(depth * Vec3(direction.x(), direction.y(), 1.0));
        view.ends[i] = end.head<2>();
    }
    return view;
}

/// The point nearest to all optical axes; the cameras' mean where they are parallel.
Vec3 middle_of_views(const std::vector<Camera>& cameras) {
    Mat3 across = 1e-6 * Mat3::Identity();  // so that parallel axes still have a point: the mean
    Vec3 moment = Vec3::Zero();
    for (const Camera& camera : cameras) {
        const Vec3 along = camera.pose.orientation * Vec3::UnitZ();
        const Mat3 plane = Mat3::Identity() - along * along.transpose();
        across += plane;
        moment += plane * camera.pose.position + 1e-6 / static_cast<double>(cameras.size()) * camera.pose.position;
    }
    return across.inverse() * moment;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

std::string fixed_text(double value, int decimals) {
    if (!std::isfinite(value)) {
        return "-";
    }
    std::array<char, 400> buffer{};  // the greatest double has 309 digits before the point
    const std::to_chars_result written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                                       std::chars_format::fixed, std::clamp(decimals, 0, 20));
    return {buffer.data(), written.ptr};
}

std::string page_style() {
    return R"(
:root { --ink:#1d2630; --soft:#52606d; --line:#d6dde4; --paper:#fff; --back:#f2f5f8; --accent:#1f5f8b;
  --good:#1e7d4f; --bad:#b3261e; }
html { font:16px/1.5 system-ui,"Liberation Sans",Arial,sans-serif; color:var(--ink); background:var(--back); }
body { margin:0 auto; max-width:60rem; padding:1.5rem; }
header,section { background:var(--paper); border:1px solid var(--line); border-radius:10px; padding:1rem 1.5rem;
  margin-bottom:1.25rem; }
h1 { font-size:1.7rem; margin:0; } h2 { font-size:1.2rem; margin:0 0 .75rem; }
.soft { color:var(--soft); } .good { color:var(--good); } .bad { color:var(--bad); font-weight:600; }
table { border-collapse:collapse; width:100%; font-variant-numeric:tabular-nums; }
th,td { text-align:left; padding:.4rem .6rem; border-bottom:1px solid var(--line); }
th { color:var(--soft); font-size:.85rem; }
svg { width:100%; height:auto; display:block; } svg text { font-size:13px; fill:var(--ink); }
.maps { display:grid; grid-template-columns:repeat(auto-fill,minmax(14rem,1fr)); gap:1rem; }
)";
}

std::string residual_bars(const WandCalibration& wand, double goal_px) {
    constexpr double line = 26.0;
    constexpr double left = 150.0;
    constexpr double length = 420.0;
    double most = goal_px;
    for (const WandCamera& camera : wand.cameras) {
        most = std::max(most, camera.residual_px);
    }
    const double scale = most > 0.0 ? length / most : 0.0;
    std::string content;
    const std::size_t count = std::min(wand.cameras.size(), wand.rig.cameras.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double y = line * static_cast<double>(i);
        const double residual = wand.cameras[i].residual_px;
        content += text_at(0.0, y + 17.0, wand.rig.cameras[i].name);
        content += rectangle({left, y + 4.0}, {scale * residual, line - 8.0},
                             residual <= goal_px ? "fill=\"#1e7d4f\"" : "fill=\"#b3261e\"");
        content += text_at(left + scale * residual + 6.0, y + 17.0, fixed_text(residual, 3) + " px");
    }
    const double height = line * static_cast<double>(count);
    content += rectangle({left + scale * goal_px, 0.0}, {1.5, height}, "fill=\"#1d2630\"");
    content += text_at(left + scale * goal_px - 30.0, height + 16.0, "goal " + fixed_text(goal_px, 3) + " px");
    return svg(660.0, height + 24.0, "Residual of each camera", content);
}

std::string coverage_map(const Camera& camera, const Coverage& coverage) {
    constexpr double cell = 30.0;
    const int most = coverage.points.empty() ? 0 : *std::max_element(coverage.points.begin(), coverage.points.end());
    std::string content;
    for (std::size_t i = 0; i < coverage.points.size(); ++i) {
        const auto index = static_cast<int>(i);
        const double dark = most > 0 ? 0.15 + 0.85 * coverage.points[i] / most : 0.0;
        content += rectangle({cell * (index % coverage.columns) + 1.0, cell * (index / coverage.columns) + 1.0},
                             {cell - 2.0, cell - 2.0},
                             coverage.points[i] > 0 ? "fill=\"#1f5f8b\" fill-opacity=\"" + fixed_text(dark, 2) + "\""
                                                    : "fill=\"none\" stroke=\"#b3261e\"");
    }
    const double height = cell * coverage.rows;
    content += text_at(0.0, height + 17.0, camera.name + ": " + fixed_text(100.0 * coverage.share(), 0) + " %");
    return svg(cell * coverage.columns, height + 24.0, "Coverage of " + camera.name, content);
}

std::string rig_from_above(const Rig& rig) {
    constexpr double side = 560.0;
    constexpr double margin = 70.0;
    if (rig.cameras.empty()) {
        return "<p>No cameras.</p>\n";
    }
    const Vec3 middle = middle_of_views(rig.cameras);
    std::vector<ViewFromAbove> views;
    double reach = 1.0;
    for (const Camera& camera : rig.cameras) {
        views.push_back(view_from_above(camera, middle));
        for (const Vec2& at : {views.back().at, views.back().ends[0], views.back().ends[1]}) {
            reach = std::max(reach, (at - middle.head<2>()).cwiseAbs().maxCoeff());
        }
    }
    const double scale = (0.5 * side - margin) / reach;
    const auto on_page = [&](const Vec2& at) {
        return Vec2(0.5 * side + scale * (at.x() - middle.x()), 0.5 * side - scale * (at.y() - middle.y()));
    };
    std::string content;
    for (const ViewFromAbove& view : views) {
        content += "<polygon points=\"";
        for (const Vec2& at : {view.at, view.ends[0], view.ends[1]}) {
            const Vec2 page = on_page(at);
            content += fixed_text(page.x(), 1) + "," + fixed_text(page.y(), 1) + " ";
        }
        content += "\" fill=\"#1f5f8b\" fill-opacity=\"0.1\" stroke=\"#1f5f8b\" stroke-opacity=\"0.5\"/>\n";
    }
    for (const ViewFromAbove& view : views) {
        const Vec2 page = on_page(view.at);
        content += rectangle(page - Vec2(5.0, 5.0), {10.0, 10.0}, "fill=\"#1d2630\"");
        content += text_at(page.x() + 8.0, page.y() - 6.0, view.name);
    }
    content += rectangle({margin, side - 24.0}, {100.0 * scale, 3.0}, "fill=\"#52606d\"");
    content += text_at(margin, side - 30.0, "100 mm");
    return svg(side, side, "Cameras from above, with what they see", content);
}

}  // namespace rhexis::tracking
