// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_render.hpp"

#include <algorithm>

#include "base/clock.hpp"
#include "render/depth_pass.hpp"
#include "render/gl_context.hpp"
#include "render/renderer.hpp"
#include "scenes/exact_depth.hpp"
#include "scenes/pictures.hpp"

namespace rhexis::bench {
namespace {

using namespace rhexis::testing;

constexpr int width = 640;
constexpr int height = 480;

/// CPU time of all threads of the process, the raster threads included, of one call: the least and the median.
struct Cost {
    double least_ms = 0.0;
    double spread = 0.0;
};

Cost cost_of(int repeats, const std::function<void()>& work) {
    work();
    std::vector<double> times;
    for (int i = 0; i < std::max(3, 3 * repeats); ++i) {
        const double start = process_cpu_seconds();
        work();
        times.push_back(1e3 * (process_cpu_seconds() - start));
    }
    std::sort(times.begin(), times.end());
    return {times.front(), times[times.size() / 2] / times.front() - 1.0};
}

/// What of a scene changes from picture to picture under a still microscope.
void move_on(Frame& frame) {
    frame.time_s += 1.0 / 30.0;
    for (ToolState& tool : frame.tools) {
        tool.pose.position.x() += 0.002;
    }
}

/// The lens part alone: instruments' depth and signed faces, until the last pixel is there.
Cost lens_cost(const Frame& frame, const Camera& camera, int repeats) {
    Result<GlContext> context = GlContext::create();
    const GlContext::Use use(context.value());
    DepthPass pass(width, height);
    std::vector<ToolMesh> tools;
    for (const ToolModel& tool : frame.model->tools) {
        tools.push_back(tool_mesh(tool));
    }
    const View view = view_through_cornea(camera, width, height, *frame.eye);
    return cost_of(repeats, [&] {
        pass.draw(frame, tools, view, whole(view), whole(view));
        glFinish();
    });
}

/// Median CPU time of each pass while instruments move, the first few pictures left out: light is kept from then on.
nlohmann::json pass_costs(Renderer& renderer, Frame frame, const Camera& camera, int repeats) {
    std::vector<std::pair<std::string, std::vector<double>>> passes;
    for (int picture = -3; picture < 5 * repeats; ++picture) {
        move_on(frame);
        for (const PassCost& cost : renderer.costs(frame, camera)) {
            if (picture < 0) {
                continue;
            }
            auto pass =
                std::find_if(passes.begin(), passes.end(), [&](const auto& one) { return one.first == cost.pass; });
            if (pass == passes.end()) {
                pass = passes.insert(passes.end(), {cost.pass, {}});
            }
            pass->second.push_back(cost.cpu_ms);
        }
    }
    nlohmann::json costs = nlohmann::json::object();
    for (auto& [pass, times] : passes) {
        std::sort(times.begin(), times.end());
        costs[pass] = times[times.size() / 2];
    }
    return costs;
}

nlohmann::json picture_row(const std::string& name, const Frame& frame, const Camera& camera,
                           const BenchOptions& options) {
    const Cost lens = lens_cost(frame, camera, options.repeats);
    Renderer renderer = std::move(Renderer::create(width, height)).value();
    const Cost picture = cost_of(options.repeats, [&] { static_cast<void>(renderer.draw(frame, camera)); });
    Renderer keeping = std::move(Renderer::create(width, height, Light::kept)).value();
    Frame moving = frame;
    const Cost kept = cost_of(options.repeats, [&] {
        move_on(moving);
        static_cast<void>(keeping.draw(moving, camera));
    });
    nlohmann::json row{{"name", "render/" + name},
                       {"elements", frame.model->solids[0].coarse.tets.size()},
                       {"pixels", width * height},
                       {"lens_cpu_ms", lens.least_ms},
                       {"picture_cpu_ms", picture.least_ms},
                       {"kept_light_cpu_ms", kept.least_ms},
                       {"passes_ms", pass_costs(keeping, frame, camera, options.repeats)},
                       {"spread", std::max(lens.spread, picture.spread)}};
    if (!options.quick) {
        const View view = view_through_cornea(camera, width, height, *frame.eye);
        const ExactDepth exact = exact_depth(frame, view);
        const DepthError error = compare(renderer.optical_depth(frame, camera), exact);
        row["error"] = error.rms;
        row["error_kind"] = "optical depth, RMS over all pixels, silhouettes included";
        row["error_max"] = error.largest;
    }
    return row;
}

nlohmann::json run_render(const BenchOptions& options) {
    if (const Result<Renderer> renderer = Renderer::create(16, 16); !renderer.ok()) {
        return nlohmann::json::array({{{"name", "render"}, {"skipped", renderer.error().text()}}});
    }
    nlohmann::json rows = nlohmann::json::array();
    const auto add = [&](const std::string& name, const Frame& frame) {
        rows.push_back(picture_row(name, frame, microscope_camera(frame), options));
    };
    add("whole lens", patient_frame(3.0));
    add("groove", sculpted_frame(3.0, 0.2, false));
    const Frame sculpting = sculpted_frame(3.0, 0.2, true);
    add("groove and instrument", sculpting);
    rows.push_back(picture_row("through the microscope", sculpting, microscope_camera_through(sculpting), options));
    return rows;
}

}  // namespace

std::vector<BenchCase> render_cases() {
    return {
        {"render",
         "CPU ms of the lens part and of a whole picture at 640 x 480, drawn anew and with kept light under a still "
         "microscope, and the error of the optical depth",
         run_render}};
}

}  // namespace rhexis::bench
