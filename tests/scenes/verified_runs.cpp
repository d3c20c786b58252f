// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/verified_runs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "eye/implant.hpp"
#include "physics/contact/tool_shape.hpp"
#include "scenes/bag_injection.hpp"
#include "scenes/capsule_scene.hpp"
#include "scenes/injection.hpp"
#include "session/build_world.hpp"
#include "session/implant_fold.hpp"
#include "tools/rhexis_tools.hpp"

namespace rhexis::scenes {
namespace {

constexpr double pushed_at = 5.0;        // [mm/s]
constexpr double injection_step = 0.02;  // [s]
constexpr double around_turns = 1.1;     // of a travel of ends: turns that are not even within a step

/// Takes what was found in the steps of a run.
class Tally {
public:
    Tally(std::string name, std::size_t triangles) {
        run_.name = std::move(name);
        run_.triangles = static_cast<int>(triangles);
        run_.free_to.assign(depths_tried.size(), 0);
    }
    void start_at(int pierced) { run_.pierced_at_start = pierced; }
    /// find: of one step.
    template <class Find>
    void add(const Find& find) {
        const double start = thread_cpu_seconds();
        const StepFinding found = find();
        run_.cpu_s += thread_cpu_seconds() - start;
        for (std::size_t i = found.level; i < depths_tried.size(); ++i) {
            ++run_.free_to[i];
        }
        if (found.crossing > 0 && run_.first_crossing < 0) {
            run_.first_crossing = run_.steps;
        }
        run_.worst_step = found.of_thickness > run_.worst.of_thickness ? run_.steps : run_.worst_step;
        run_.worst.add(found);
        ++run_.steps;
    }
    [[nodiscard]] const VerifiedRun& run() const { return run_; }

private:
    VerifiedRun run_;
};

MovingSolid tube_of(const TubeModel& tube, const ToolState& carrier, double farthest) {
    MovingSolid solid;
    solid.distance = [tube, carrier](double share, const Vec3& place) {
        return tube_distance(tube, tube.pose.to_body(pose_within(carrier, share).to_body(place))).distance;
    };
    const Quat turn = carrier.pose.orientation * carrier.previous_pose.orientation.conjugate();
    solid.travel = around_turns * ((carrier.pose.position - carrier.previous_pose.position).norm() +
                                   2.0 * turn.vec().norm() * farthest);
    return solid;
}

MovingSolid tool_of(const ToolModel& tool, const ToolState& state) {
    MovingSolid solid;
    solid.distance = [&tool, state](double share, const Vec3& place) {
        return tool_distance(tool, pose_within(state, share).to_body(place)).distance;
    };
    solid.travel = around_turns * travel(tool, state);
    return solid;
}

std::map<std::string, double> settings_of(const InjectionRun& run) {
    return {{"implant.triangles", run.triangles},
            {"cartridge.tucked", run.tucked ? 1.0 : 0.0},
            {"cartridge.nozzle_mm", run.nozzle}};
}

ShellState folded_by(const std::map<std::string, double>& settings) {
    ImplantFold fold = std::move(ImplantFold::create(folding_scene(settings))).value();
    while (!fold.done() && fold.step()) {
    }
    return std::move(fold.result()).value().snapshot.world.shells[0];
}

/// The end of the tear that was torn last, in the sheet at rest; as the flap's hand of docs/accuracy.md goes.
class RoundHand {
public:
    explicit RoundHand(CapsuleScene& scene) : scene_(&scene) {}
    void tear(double arc) {
        scene_->put(0, above(from, 2.24, 0.01), 1.0);
        scene_->lead(0, above(from, 2.24, 0.02), 1.0, 0.0);
        for (double angle = from; angle < from + arc; angle += stride) {
            scene_->lead(0, above(angle, circle, height), speed, 0.0);
        }
    }

private:
    static constexpr double from = 0.2;     // where the flap is taken [rad]
    static constexpr double circle = 1.7;   // on which it is led round [mm]
    static constexpr double height = 0.2;   // over the lens [mm]
    static constexpr double stride = 0.08;  // [rad]
    static constexpr double speed = 1.5;    // [mm/s]
    [[nodiscard]] Vec3 above(double angle, double radius, double z) const {
        return scene_->front(radius * std::cos(angle), radius * std::sin(angle)) + z * Vec3::UnitZ();
    }
    CapsuleScene* scene_;
};

}  // namespace

std::vector<VerifiedRun> verify_injection(const InjectionRun& run) {
    const std::map<std::string, double> settings = settings_of(run);
    const std::map<std::string, double> all = all_settings(folding_scene(settings));
    const ShellModel model = free_implant(implant_shape(all));
    const ToolModel tool = injector(injector_shape(all));
    Injection injection(model, tool, folded_by(settings));
    const Skin skin = shell_skin(model);
    std::vector<Tally> tallies{{"injected implant, itself", skin.triangles.size()},
                               {"injected implant, bore", skin.triangles.size()},
                               {"injected implant, plunger", skin.triangles.size()}};
    std::vector<Vec3> from = skin_places(model, injection.state);
    tallies[0].start_at(pierced_at_start({skin, from, from}));
    const int pushing = static_cast<int>(tool.cartridge->stroke / pushed_at / injection_step) + 1;
    const int steps = pushing + static_cast<int>(run.unfolding / injection_step);
    for (int i = 1; i <= steps; ++i) {
        injection.step(std::min(1.0, static_cast<double>(i) / pushing), injection_step);
        std::vector<Vec3> to = skin_places(model, injection.state);
        const MovingSkin moving{skin, from, to};
        const ShellPartners partners = injection.partners();
        tallies[0].add([&] { return verify_itself(moving); });
        tallies[1].add([&] { return verify_solid(moving, tube_of(partners.tubes[0], partners.tube_states[0], 0.0)); });
        tallies[2].add([&] { return verify_solid(moving, tool_of(partners.tools[0], partners.tool_states[0])); });
        from = std::move(to);
    }
    return {tallies[0].run(), tallies[1].run(), tallies[2].run()};
}

std::vector<VerifiedRun> verify_bag_injection(double implant, double bag, double unfolding) {
    BagInjection scene({.bag = bag, .implant = implant, .unfolding = unfolding});
    const ShellModel& shell = scene.model->shells[0];
    const Skin skin = shell_skin(shell);
    const TubeModel& bore = scene.model->tools[0].cartridge->bore;
    std::vector<Tally> tallies{{"implant in the bag, itself", skin.triangles.size()},
                               {"implant in the bag, nozzle", skin.triangles.size()},
                               {"implant in the bag, bag", skin.triangles.size()},
                               {"bag, itself", 0}};
    // the implant comes into the eye with the injector in the first step
    for (int i = 0; i < scene.steps(); ++i) {
        scene.step();
        if (scene.before.shells[0].loaded) {
            continue;
        }
        const std::vector<Vec3> from = skin_places(shell, scene.before.shells[0]);
        const std::vector<Vec3> to = skin_places(shell, scene.state.shells[0]);
        const MembraneState& sheet = scene.before.membranes[0];
        const Skin bag_skin = sheet_skin(*sheet.sheet);
        const MovingSkin moving{skin, from, to};
        const MovingSkin moving_bag{bag_skin, sheet.position, scene.state.membranes[0].position};
        if (tallies[0].run().steps == 0) {
            tallies[0].start_at(pierced_at_start(moving));
            tallies[2].start_at(pierced_at_start(moving, moving_bag));
            tallies[3].start_at(pierced_at_start(moving_bag));
        }
        tallies[0].add([&] { return verify_itself(moving); });
        tallies[1].add([&] { return verify_solid(moving, tube_of(bore, scene.hand, 0.0)); });
        tallies[2].add([&] { return verify_pair(moving, moving_bag); });
        tallies[3].add([&] { return verify_itself(moving_bag); });
    }
    return {tallies[0].run(), tallies[1].run(), tallies[2].run(), tallies[3].run()};
}

std::vector<VerifiedRun> verify_tear(int triangles, double arc) {
    CapsuleScene scene(68.0, {.triangles = triangles}, {capsulorhexis_forceps()});
    scene.open_flap(1.0, 2.6, 0.9);
    const std::size_t count = scene.model().sheet->mesh.triangles.size();
    std::vector<Tally> tallies{{"torn capsule, itself", count}, {"torn capsule, its layers' distance", count}};
    const double layer_distance = scene.model().layer_distance;
    scene.watch = [&](const MembraneState& before, const MembraneState& after) {
        for (std::size_t i = 0; i < 2; ++i) {
            const Skin skin = sheet_skin(*before.sheet, i == 0 ? 0.0 : layer_distance);
            const MovingSkin moving{skin, before.position, after.position};
            if (tallies[i].run().steps == 0) {
                tallies[i].start_at(pierced_at_start(moving));
            }
            tallies[i].add([&] { return verify_itself(moving); });
        }
    };
    RoundHand(scene).tear(arc);
    return {tallies[0].run(), tallies[1].run()};
}

}  // namespace rhexis::scenes
