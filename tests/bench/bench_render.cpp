// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_render.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

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

/// What of a scene changes from picture to picture, at 30 a second.
struct Motion {
    bool lens = false;        ///< all of it sways by 0.02 mm, as under a tip that sculpts
    bool microscope = false;  ///< at 2 mm/s
};

/// Instruments go to and fro by 0.6 mm, at 1.8 mm/s where they are fastest.
void move_on(Frame& frame, Camera& camera, const Motion& motion) {
    constexpr double period_s = 2.1;
    const double before_s = frame.time_s;
    frame.time_s += 1.0 / 30.0;
    const auto swings = [&](double reach_mm) {
        const double rate = 2.0 * std::numbers::pi / period_s;
        return reach_mm * (std::sin(rate * frame.time_s) - std::sin(rate * before_s));
    };
    for (ToolState& tool : frame.tools) {
        tool.pose.position.x() += swings(0.6);
    }
    for (SolidState& solid : frame.solids) {
        for (Vec3& node : solid.position) {
            node.x() += motion.lens ? swings(0.02) : 0.0;
        }
    }
    if (motion.microscope) {
        const Vec3 way(swings(0.66), 0.0, 0.0);
        camera.eye += way;
        camera.target += way;
    }
}

/// The lens part alone: instruments' depth and signed faces, until the last pixel is there.
Cost lens_cost(const Frame& frame, const Camera& camera, int repeats) {
    Result<GlContext> context = GlContext::create();
    const GlContext::Use use(context.value());
    DepthPass pass(width, height, false);
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

/// Median CPU time of a picture and of each of its passes, the first few left out: light is kept from then on.
nlohmann::json moving_costs(Renderer& renderer, Frame frame, Camera camera, const Motion& motion, int repeats) {
    constexpr int first = 3;
    std::map<std::string, std::vector<double>> passes;
    std::vector<double> pictures;
    for (int picture = -first; picture < 10 * repeats; ++picture) {
        move_on(frame, camera, motion);
        const double start = process_cpu_seconds();
        static_cast<void>(renderer.draw(frame, camera));
        if (picture >= 0) {
            pictures.push_back(1e3 * (process_cpu_seconds() - start));
        }
    }
    for (int picture = 0; picture < 5 * repeats; ++picture) {
        move_on(frame, camera, motion);
        for (const PassCost& cost : renderer.costs(frame, camera)) {
            passes[cost.pass].push_back(cost.cpu_ms);
        }
    }
    const auto median = [](std::vector<double>& times) {
        std::sort(times.begin(), times.end());
        return times[times.size() / 2];
    };
    nlohmann::json costs = nlohmann::json::object();
    for (auto& [pass, times] : passes) {
        costs[pass] = median(times);
    }
    return {{"kept_light_cpu_ms", median(pictures)}, {"passes_ms", costs}};
}

nlohmann::json picture_row(const std::string& name, const Frame& frame, const Camera& camera, const Motion& motion,
                           const BenchOptions& options) {
    const Cost lens = lens_cost(frame, camera, options.repeats);
    Renderer renderer = std::move(Renderer::create(width, height)).value();
    const Cost picture = cost_of(options.repeats, [&] { static_cast<void>(renderer.draw(frame, camera)); });
    Renderer keeping = std::move(Renderer::create(width, height, Light::kept)).value();
    nlohmann::json row{{"name", "render/" + name},           {"elements", frame.model->solids[0].coarse.tets.size()},
                       {"pixels", width * height},           {"lens_cpu_ms", lens.least_ms},
                       {"picture_cpu_ms", picture.least_ms}, {"spread", std::max(lens.spread, picture.spread)}};
    row.update(moving_costs(keeping, frame, camera, motion, options.repeats));
    if (motion.microscope) {  // as a window draws it
        Renderer coarse = std::move(Renderer::create(width / 2, height / 2, Light::kept)).value();
        row["half_size_cpu_ms"] = moving_costs(coarse, frame, camera, motion, options.repeats)["kept_light_cpu_ms"];
    }
    if (!options.quick && !motion.lens && !motion.microscope) {
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
    const auto add = [&](const std::string& name, const Frame& frame, const Camera& camera, const Motion& motion) {
        rows.push_back(picture_row(name, frame, camera, motion, options));
    };
    const Frame whole = patient_frame(3.0);
    add("whole lens", whole, microscope_camera(whole), {});
    const Frame groove = sculpted_frame(3.0, 0.2, false);
    add("groove", groove, microscope_camera(groove), {});
    const Frame sculpting = sculpted_frame(3.0, 0.2, true);
    const Camera through = microscope_camera_through(sculpting);
    add("groove and instrument", sculpting, microscope_camera(sculpting), {});
    add("through the microscope", sculpting, through, {});
    add("and the lens sways", sculpting, through, {true, false});
    add("and the microscope moves", sculpting, through, {true, true});
    return rows;
}

}  // namespace

std::vector<BenchCase> render_cases() {
    return {{"render",
             "CPU ms of the lens part and of a whole picture at 640 x 480, drawn anew and with kept light while "
             "instruments, lens and microscope move, and the error of the optical depth",
             run_render}};
}

}  // namespace rhexis::bench
