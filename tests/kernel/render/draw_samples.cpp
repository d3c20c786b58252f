// SPDX-License-Identifier: GPL-3.0-or-later
// draw_samples FOLDER [WIDTH HEIGHT]: writes pictures of eyes and bare bodies to look at, and says what each cost.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "base/clock.hpp"
#include "render/image_file.hpp"
#include "render/renderer.hpp"
#include "render/tool_shape.hpp"
#include "scenes/capsule_pictures.hpp"
#include "scenes/capsule_scene.hpp"
#include "scenes/implant_pictures.hpp"
#include "tools/instruments.hpp"
#include "tools/rhexis_tools.hpp"

using namespace rhexis;
using namespace rhexis::testing;

namespace {

struct Sample {
    const char* name;
    Frame frame;
    Camera camera;
};

/// A bar that sags by hand.
Frame bare_bar() {
    Frame frame = frame_of(bar(24, 6, 6, 0.25), Vec3::Zero(), false);
    for (Vec3& node : frame.solids[0].position) {
        node.z() -= 0.03 * node.x() * node.x();
    }
    return frame;
}

Frame bare_ball() {
    const Frame made = frame_of(ball(2.0, 3000), Vec3(0.2, 0.3, 0.6), true);
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>(*made.model);
    model->planes.push_back({Vec3(0.0, 0.0, -2.0), Vec3::UnitZ(), 0.3});
    model->tools.push_back(make_tool("probe").value());
    Frame frame = frame_of(std::shared_ptr<const WorldModel>(std::move(model)));
    frame.tools[0].present = true;
    frame.tools[0].pose = hand_pose(Vec3(0.0, -0.6, 1.8), 1.0);
    return frame;
}

/// Instruments with a shape, those too that nothing is touched with yet.
std::vector<std::string> shaped_instruments() {
    std::vector<std::string> names = {"chopper", "iris_hook"};
    for (const std::string& name : tool_names()) {
        if (shape_of_instrument(name)) {
            names.push_back(name);
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// One of them from above, or from its side where its end is bent; jaws half open.
Frame instrument(const std::string& name) {
    const Result<ToolModel> known = make_tool(name);
    std::shared_ptr<WorldModel> model = std::make_shared<WorldModel>();
    model->tools.push_back(known.ok() ? known.value() : ToolModel{});
    const ToolModel& tool = model->tools.front();
    const bool straight = known.ok() && tool.parts.back().b.z() > 50.0;
    model->tools.front().name = name;
    Frame frame;
    ToolState state;
    state.present = true;
    state.jaw = 0.5;
    state.pose.position = Vec3(0.0, 3.0, 0.0);
    state.pose.orientation = straight ? Quat(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitX()))
                                      : Quat(Eigen::AngleAxisd(0.9, Vec3::UnitY()));
    frame.tools.push_back(state);
    frame.model = std::move(model);
    return frame;
}

/// A capsulorhexis under way, by the mechanics: forceps have led a flap a third of the way round.
Frame capsulorhexis(double trypan_blue) {
    scenes::CapsuleScene scene(Patient{}.age, {}, {capsulorhexis_forceps()});
    const auto above = [&scene](double radius, double angle, double height) {
        return Vec3(scene.front(radius * std::cos(angle), radius * std::sin(angle)) + height * Vec3::UnitZ());
    };
    scene.open_flap(1.0, 2.6, 0.9);
    scene.put(0, above(2.2, 0.2, 0.05), 1.0);
    scene.lead(0, above(2.2, 0.2, 0.06), 1.0, 0.0);
    for (int i = 0; i <= 32; ++i) {
        scene.lead(0, above(1.7, 0.2 + 0.08 * i, 0.2), 1.5, 0.0);
    }
    Frame frame = capsule_frame(3.0, trypan_blue);
    frame.membranes[0] = scene.sheet();
    frame.tools[0] = scene.tool(0);
    return frame;
}

std::vector<Sample> samples() {
    std::vector<Sample> all;
    const auto eye = [&all](const char* name, Frame frame) {
        const Camera camera = microscope_camera(frame);
        all.push_back({name, std::move(frame), camera});
    };
    eye("whole_no3", patient_frame(3.0));
    eye("groove_no3", sculpted_frame(3.0, 0.6, false));
    eye("middle_no3", sculpted_frame(3.0, -0.4, false));
    eye("deep_no3", sculpted_frame(3.0, -1.2, false));
    eye("sculpt_no3", sculpted_frame(3.0, 0.2, true));
    eye("sculpt_no5", sculpted_frame(5.0, -0.6, true));
    eye("deep_no4", sculpted_frame(4.0, -1.4, false));
    eye("levered", levered_frame(0.45));
    all.back().camera.field_mm = 10.0;
    eye("whole_no6_small", patient_frame(6.0, 5.0));
    Camera near = microscope_camera(all[4].frame);
    near.field_mm = 8.0;
    all.push_back({"near_no3", all[4].frame, near});
    Camera far = microscope_camera(all[4].frame);
    far.field_mm = 24.0;
    all.push_back({"far_no3", all[4].frame, far});
    for (const auto& [name, stain] : {std::pair{"capsule_flap", 0.0}, std::pair{"capsule_blue", 1.0}}) {
        eye(name, capsulorhexis(stain));
        all.back().camera.field_mm = 10.0;
    }
    for (const auto& [name, force] : {std::pair{"implant_flat", 0.0}, std::pair{"implant_folded", 3e4}}) {
        Frame frame = implant_frame();
        if (force > 0.0) {
            fold(frame, force);
        }
        eye(name, frame);
        all.back().camera.field_mm = 10.0;
        frame.eye = nullptr;
        eye(force > 0.0 ? "implant_bare_folded" : "implant_bare", frame);
    }
    all.push_back({"bare_bar", bare_bar(), Camera()});
    all.back().camera = microscope_camera(all.back().frame);
    all.push_back({"bare_ball", bare_ball(), Camera()});
    all.back().camera = microscope_camera(all.back().frame);
    return all;
}

/// Pictures of one size, so many in a row.
Image sheet_of(const std::vector<Image>& images, std::size_t in_a_row) {
    const int width = images[0].width;
    const int height = images[0].height;
    Image sheet{
        static_cast<int>(in_a_row) * width, height * static_cast<int>((images.size() + in_a_row - 1) / in_a_row), {}};
    sheet.rgb.assign(3 * static_cast<std::size_t>(sheet.width) * sheet.height, 0);
    for (std::size_t i = 0; i < images.size(); ++i) {
        for (int y = 0; y < height; ++y) {
            const std::size_t row = (i / in_a_row) * height + y;
            std::copy_n(&images[i].rgb[3 * static_cast<std::size_t>(y) * width], 3 * width,
                        &sheet.rgb[3 * (row * sheet.width + (i % in_a_row) * width)]);
        }
    }
    return sheet;
}

/// All instruments beside each other, and their names in the order of the picture.
Status write_instruments(const std::string& folder) {
    Result<Renderer> renderer = Renderer::create(120, 190);
    if (!renderer.ok()) {
        return renderer.error();
    }
    Camera camera;
    camera.field_mm = 9.0;
    std::vector<Image> all;
    for (const std::string& name : shaped_instruments()) {
        std::printf("%s ", name.c_str());
        all.push_back(renderer.value().draw(instrument(name), camera));
    }
    std::printf("\n");
    return write_png(sheet_of(all, 7), folder + "/instruments.png");
}

Status write_sample(Renderer& renderer, const Sample& sample, const std::string& folder, std::vector<Image>& all) {
    renderer.draw(sample.frame, sample.camera);
    const double start = process_cpu_seconds();
    renderer.optical_depth(sample.frame, sample.camera);
    const double lens = process_cpu_seconds();
    const Image image = renderer.draw(sample.frame, sample.camera);
    const double end = process_cpu_seconds();
    std::printf("%-16s lens %6.1f ms, picture %6.1f ms of CPU\n", sample.name, 1e3 * (lens - start),
                1e3 * (end - lens));
    all.push_back(image);
    return write_png(image, folder + "/" + sample.name + ".png");
}

}  // namespace

int main(int count, char** words) {
    const std::string folder = count > 1 ? words[1] : ".";
    std::filesystem::create_directories(folder);
    const double start = wall_seconds();
    Result<Renderer> renderer =
        Renderer::create(count > 3 ? std::atoi(words[2]) : 640, count > 3 ? std::atoi(words[3]) : 480);
    if (!renderer.ok()) {
        std::fprintf(stderr, "%s\n", renderer.error().text().c_str());
        return 1;
    }
    std::printf("renderer in %.2f s\n", wall_seconds() - start);
    std::vector<Image> all;
    for (const Sample& sample : samples()) {
        if (const Status status = write_sample(renderer.value(), sample, folder, all); !status.ok()) {
            std::fprintf(stderr, "%s\n", status.error().text().c_str());
            return 1;
        }
    }
    return write_png(sheet_of(all, 2), folder + "/sheet.png").ok() && write_instruments(folder).ok() ? 0 : 1;
}
