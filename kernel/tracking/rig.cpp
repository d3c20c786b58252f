// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/rig.hpp"

#include <array>
#include <cmath>

#include "base/numbers.hpp"
#include "base/output_file.hpp"
#include "tracking/json_fields.hpp"

namespace rhexis::tracking {
namespace {

using Json = nlohmann::json;

constexpr std::size_t fewest_cameras = 2;
constexpr std::size_t most_cameras = 16;
constexpr std::size_t fewest_markers = 3;
constexpr std::size_t most_markers = 8;
constexpr int largest_side = 16384;      ///< [pixels]
constexpr double farthest_mm = 1e5;      ///< that anything of a rig is from its origin
constexpr double largest_body_mm = 500;  ///< from its origin to a marker or its tip

struct LensField {
    const char* name;
    double Lens::*value;
};
constexpr std::array<LensField, 9> lens_fields{{{"fx", &Lens::fx},
                                                {"fy", &Lens::fy},
                                                {"cx", &Lens::cx},
                                                {"cy", &Lens::cy},
                                                {"k1", &Lens::k1},
                                                {"k2", &Lens::k2},
                                                {"p1", &Lens::p1},
                                                {"p2", &Lens::p2},
                                                {"k3", &Lens::k3}}};

Json json_of(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

Result<Camera> camera_of(const Json& json, const std::string& where) {
    Fields fields(json, where);
    Camera camera;
    camera.name = fields.text("name");
    camera.width = fields.whole("width", 16, largest_side);
    camera.height = fields.whole("height", 16, largest_side);
    for (const LensField& field : lens_fields) {
        const bool focal = field.value == &Lens::fx || field.value == &Lens::fy;
        camera.lens.*field.value = focal ? fields.number(field.name, 1.0, 1e6) : fields.number(field.name, -1e5, 1e5);
    }
    camera.pose.position = fields.numbers("position_mm", 3, farthest_mm);
    const VecX turned = fields.numbers("orientation_xyzw", 4, 1.0 + 1e-6);
    if (!(std::abs(turned.norm() - 1.0) < 1e-3)) {
        fields.refuse("orientation_xyzw", "a unit quaternion");
    } else {
        camera.pose.orientation = Quat(turned[3], turned[0], turned[1], turned[2]).normalized();
    }
    if (const Status status = fields.status(); !status) {
        return status.error();
    }
    return camera;
}

Result<MarkerBody> body_of(const Json& json, const std::string& where) {
    Fields fields(json, where);
    MarkerBody body;
    body.name = fields.text("name");
    body.radius_mm = fields.number("radius_mm", 0.5, 20.0);
    body.markers = fields.points("markers_mm", largest_body_mm);
    if (body.markers.size() < fewest_markers || body.markers.size() > most_markers) {
        fields.refuse("markers_mm", std::to_string(fewest_markers) + " to " + std::to_string(most_markers) + " points");
    }
    body.tip.position = fields.numbers("tip_mm", 3, largest_body_mm);
    const Vec3 axis = fields.numbers("axis", 3, 1e3);
    const Vec3 side = fields.numbers("side", 3, 1e3);
    if (!(axis.norm() > 1e-6)) {
        fields.refuse("axis", "a direction, from the tip to the hand");
    } else if (!(side.cross(axis).norm() > 1e-6 * axis.norm())) {
        fields.refuse("side", "a direction across the axis");
    } else {
        Mat3 turned;
        turned.col(2) = axis.normalized();
        turned.col(1) = axis.cross(side).normalized();
        turned.col(0) = turned.col(1).cross(turned.col(2));
        body.tip.orientation = Quat(turned);
    }
    if (const Status status = fields.status(); !status) {
        return status.error();
    }
    return body;
}

Result<LensFigures> lens_figures_of(const Json& json, const std::string& where) {
    constexpr int most = 1000000000;
    Fields fields(json, where);
    fields.only({"views", "left_out", "without", "residual_px", "focal_sigma_px", "coverage"});
    LensFigures figures;
    figures.views = fields.whole("views", 0, most);
    figures.left_out = fields.whole("left_out", 0, most);
    figures.without = fields.whole("without", 0, most);
    figures.residual_px = fields.number("residual_px", 0.0, 1e5);
    figures.focal_sigma_px = fields.number("focal_sigma_px", 0.0, 1e6);
    const VecX cells = fields.numbers("coverage", figures.coverage.columns * figures.coverage.rows, most);
    for (const double points : cells) {
        figures.coverage.points.push_back(static_cast<int>(points));
    }
    if (const Status status = fields.status(); !status) {
        return status.error();
    }
    return figures;
}

Json json_of(const LensFigures& figures) {
    return {{"views", figures.views},
            {"left_out", figures.left_out},
            {"without", figures.without},
            {"residual_px", figures.residual_px},
            {"focal_sigma_px", figures.focal_sigma_px},
            {"coverage", figures.coverage.points}};
}

/// Of all cameras; where one lacks them there are none.
Status read_lens_figures(const Json& cameras, const std::string& path, Rig& rig) {
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const auto lens = cameras[i].find("lens");
        if (lens == cameras[i].end()) {
            continue;
        }
        Result<LensFigures> figures = lens_figures_of(*lens, path + ", camera " + std::to_string(i + 1) + ", \"lens\"");
        if (!figures) {
            return figures.error();
        }
        rig.lenses.push_back(std::move(figures).value());
    }
    if (rig.lenses.size() < cameras.size()) {
        rig.lenses.clear();
    }
    return success();
}

Status check_cameras(const std::vector<Camera>& cameras, const std::string& path) {
    if (cameras.size() < fewest_cameras || cameras.size() > most_cameras) {
        return Error{std::to_string(cameras.size()) + " cameras", path, range_text(fewest_cameras, most_cameras)};
    }
    for (std::size_t i = 1; i < cameras.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (cameras[i].name == cameras[j].name) {
                return Error{"two cameras are named \"" + cameras[i].name + "\"", path, "each has its own name"};
            }
        }
    }
    return success();
}

}  // namespace

Result<Rig> read_rig(const std::string& path) {
    const Result<Json> json = read_json_object(path);
    if (!json) {
        return json.error();
    }
    const auto list = json.value().find("cameras");
    if (list == json.value().end() || !list->is_array()) {
        return Error{"\"cameras\" is not a list", path, "one entry for each camera"};
    }
    Rig rig;
    for (std::size_t i = 0; i < list->size(); ++i) {
        Result<Camera> camera = camera_of((*list)[i], path + ", camera " + std::to_string(i + 1));
        if (!camera) {
            return camera.error();
        }
        rig.cameras.push_back(std::move(camera).value());
    }
    if (const Status status = check_cameras(rig.cameras, path); !status) {
        return status.error();
    }
    if (const Status status = read_lens_figures(*list, path, rig); !status) {
        return status.error();
    }
    rig.calibrated = json.value().value("calibrated", Json(false)) == Json(true);
    return rig;
}

Status write_rig(const Rig& rig, const std::string& path) {
    Json cameras = Json::array();
    for (std::size_t i = 0; i < rig.cameras.size(); ++i) {
        const Camera& camera = rig.cameras[i];
        const Quat& turned = camera.pose.orientation;
        Json entry{{"name", camera.name},
                   {"width", camera.width},
                   {"height", camera.height},
                   {"position_mm", json_of(camera.pose.position)},
                   {"orientation_xyzw", {turned.x(), turned.y(), turned.z(), turned.w()}}};
        for (const LensField& field : lens_fields) {
            entry[field.name] = camera.lens.*field.value;
        }
        if (rig.lenses.size() == rig.cameras.size()) {
            entry["lens"] = json_of(rig.lenses[i]);
        }
        cameras.push_back(std::move(entry));
    }
    return write_file(path, Json{{"calibrated", rig.calibrated}, {"cameras", cameras}}.dump(1) + "\n");
}

Result<MarkerBody> read_marker_body(const std::string& path) {
    const Result<Json> json = read_json_object(path);
    return json ? body_of(json.value(), path) : Result<MarkerBody>(json.error());
}

Result<MarkerBody> marker_body_of(const std::string& text, const std::string& where) {
    const Json json = Json::parse(text, nullptr, false);
    return json.is_object() ? body_of(json, where)
                            : Result<MarkerBody>(Error{"this is no marker body", where, "a JSON object"});
}

Status write_marker_body(const MarkerBody& body, const std::string& path) {
    Json markers = Json::array();
    for (const Vec3& marker : body.markers) {
        markers.push_back(json_of(marker));
    }
    return write_file(path, Json{{"name", body.name},
                                 {"radius_mm", body.radius_mm},
                                 {"markers_mm", markers},
                                 {"tip_mm", json_of(body.tip.position)},
                                 {"axis", json_of(body.tip.orientation * Vec3::UnitZ())},
                                 {"side", json_of(body.tip.orientation * Vec3::UnitX())}}
                                    .dump(1) +
                                "\n");
}

}  // namespace rhexis::tracking
