// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/tool_shape.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "render/tool_mesh.hpp"
#include "tools/instruments.hpp"

using namespace rhexis;

namespace {

std::string fault_of(const std::string& text) {
    const Result<ToolShape> shape = read_tool_shape(text, "demo.json");
    return shape.ok() ? "" : shape.error().text();
}

std::string with(const std::string& part) {
    return R"({"parts": [{"wire": [[0,0,0],[0,0,1]], "radius": [0.1, 0.1]}, )" + part + "]}";
}

/// Least distance of what is drawn from the end that touches.
double nearest_to_end(const ToolMesh& mesh, const ToolModel& tool) {
    const RoundedCone& end = tool.parts.front();
    double nearest = 1e9;
    for (const ToolMesh::Part& part : mesh.parts) {
        for (const ToolMesh::Vertex& corner : part.corners) {
            nearest = std::min(nearest, std::abs((corner.place - end.a).norm() - end.radius_a));
        }
    }
    return nearest;
}

double distance_to(const RoundedCone& cone, const Vec3& place) {
    const Vec3 along = cone.b - cone.a;
    const double share =
        along.squaredNorm() > 0.0 ? std::clamp((place - cone.a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
    return (place - cone.a - share * along).norm() - std::max(cone.radius_a, cone.radius_b);
}

/// Of the two arms of forceps.
double gap_of_tips(const ToolMesh& mesh, double jaw) {
    ToolState state;
    state.jaw = jaw;
    double left = 1e9;
    double right = -1e9;
    for (const ToolMesh::Part& part : mesh.parts) {
        const Pose pose = pose_of(part, state);
        for (const ToolMesh::Vertex& corner : part.corners) {
            const Vec3 place = pose.to_world(corner.place);
            if (part.hinge && place.y() > -0.2) {
                (part.hinge->open_rad < 0.0 ? left : right) =
                    part.hinge->open_rad < 0.0 ? std::min(left, place.x()) : std::max(right, place.x());
            }
        }
    }
    return left - right;
}

}  // namespace

TEST_CASE("every file of a shape can be read, and is of an instrument that there is, or will be") {
    const std::vector<std::string> known = tool_names();
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator("assets/instruments")) {
        ++files;
        const std::string name = entry.path().stem().string();
        const std::optional<ToolShape> shape = shape_of_instrument(name);
        REQUIRE_MESSAGE(shape.has_value(), name);
        const bool is_drawn = !tool_mesh(*shape).parts.empty() || shape->with_own_parts;
        CHECK_MESSAGE(is_drawn, name);
        const bool later = name == "chopper" || name == "iris_hook";
        const bool is_known = later || std::find(known.begin(), known.end(), name) != known.end();
        CHECK_MESSAGE(is_known, name);
    }
    CHECK(files >= 20);
    CHECK_FALSE(shape_of_instrument("no_such_thing").has_value());
}

TEST_CASE("what is drawn is where the instrument touches, within what is looked at, and its normals are unit") {
    for (const std::string& name : tool_names()) {
        const ToolModel tool = make_tool(name).value();
        const ToolMesh mesh = tool_mesh(tool);
        CHECK_MESSAGE(nearest_to_end(mesh, tool) < 0.2, name);
        for (const ToolMesh::Part& part : mesh.parts) {
            CHECK(part.corners.size() % 3 == 0);
            for (const ToolMesh::Vertex& corner : part.corners) {
                CHECK(std::abs(corner.normal.norm() - 1.0) < 1e-6);
                double outside = 1e9;
                for (const RoundedCone& cone : mesh.bounds) {
                    outside = std::min(outside, distance_to(cone, corner.place));
                }
                CHECK_MESSAGE(outside < 1e-9, name);
            }
        }
    }
}

TEST_CASE("jaws part as they open") {
    for (const char* name : {"forceps", "lens_forceps"}) {
        const ToolMesh mesh = tool_mesh(make_tool(name).value());
        CHECK(gap_of_tips(mesh, 0.0) < 0.15);
        CHECK(gap_of_tips(mesh, 1.0) > gap_of_tips(mesh, 0.5) + 0.4);
        CHECK(gap_of_tips(mesh, 1.0) == doctest::Approx(1.3).epsilon(0.15));
    }
}

TEST_CASE("a mistake in a shape is told with its part, its field and what is allowed") {
    CHECK(fault_of("no JSON").find("JSON object with parts") != std::string::npos);
    CHECK(fault_of(with("7")).find("part 2") != std::string::npos);
    CHECK(fault_of(with("{}")).find("a wire, a plate, or an own_part") != std::string::npos);
    CHECK(fault_of(with(R"({"wire": [[0,0,0]], "radius": [1]})")).find("2 points or more") != std::string::npos);
    CHECK(fault_of(with(R"({"wire": [[0,0,0],[0,1]], "radius": [1,1]})")).find("points of 3 numbers") !=
          std::string::npos);
    CHECK(fault_of(with(R"({"wire": [[0,0,0],[0,0,1e9]], "radius": [1,1]})")).find("-200") != std::string::npos);
    CHECK(fault_of(with(R"({"wire": [[0,0,0],[0,0,1]], "radius": [1]})")).find("one for each point") !=
          std::string::npos);
    CHECK(fault_of(with(R"({"wire": [[0,0,0],[0,0,1]], "radius": [1,-1]})")).find("radius is -1") != std::string::npos);
    CHECK(fault_of(with(R"({"plate": [[0,0],[1,0],[0,1]], "finish": "stele"})")).find("steel") != std::string::npos);
    CHECK(
        fault_of(with(R"({"plate": [[0,0],[1,0],[0,1]], "opens": {"about": [0,0,0]}})")).find("about, axis and deg") !=
        std::string::npos);
    CHECK(fault_of(with(R"({"plate": [[0,0],[1,0],[0,1]]})")).empty());
}
