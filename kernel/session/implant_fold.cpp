// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/implant_fold.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/clock.hpp"
#include "base/index.hpp"
#include "base/numbers.hpp"
#include "physics/shell/shell_energy.hpp"
#include "physics/shell/shell_motion.hpp"
#include "session/build_world.hpp"
#include "session/denormals.hpp"

namespace rhexis {
namespace {

constexpr double step_s = 0.02;
constexpr double viscosity = 1.0;      // of what lubricates the cartridge [Pa s]
constexpr double suction_reach = 0.7;  // of the optic's radius

/// The implant as a device folds it.
std::shared_ptr<const WorldModel> folding_world(const WorldModel& world, const ImplantShape& shape,
                                                const FoldingDevice& device) {
    std::shared_ptr<WorldModel> own = std::make_shared<WorldModel>();
    own->shells = world.shells;
    own->shells[0].drag = disc_drag(viscosity, 0.5 * shape.optic_diameter);
    own->tools = device.tools();
    return own;
}

std::vector<int> nodes_within(const std::vector<Vec3>& nodes, double radius) {
    std::vector<int> within;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (nodes[n].norm() < radius) {
            within.push_back(static_cast<int>(n));
        }
    }
    return within;
}

}  // namespace

SceneDescription folding_scene(const std::map<std::string, double>& settings) {
    SceneDescription scene;
    scene.tissues = {"implant"};
    scene.instruments = {injector_name};
    scene.settings = settings;
    return scene;
}

struct ImplantFold::Parts {
    Session session;
    ImplantShape shape;
    FoldingDevice device;
    std::shared_ptr<const WorldModel> world;
    std::vector<int> held;  ///< nodes that suction holds
    ShellStepper stepper;
    ShellContacts contacts;
    ShellLedger ledger;
    ShellState state;
    std::vector<ToolState> tools;
    FoldProgress now;
    int step_in_stage = 0;

    Parts(Session built, const ImplantShape& lens, FoldingDevice made, std::shared_ptr<const WorldModel> model,
          ShellStepper own_stepper)
        : session(std::move(built)),
          shape(lens),
          device(std::move(made)),
          world(std::move(model)),
          held(nodes_within(world->shells[0].mesh.nodes, 0.5 * suction_reach * lens.optic_diameter)),
          stepper(std::move(own_stepper)),
          contacts(world->shells[0]),
          ledger(world->shells[0]),
          state(device.laid_out(rest_state(world->shells[0]))),
          tools(device.tools().size()) {
        skip_stages();
    }

    [[nodiscard]] int steps_of_stage() const {
        return static_cast<int>(std::lround(folding_stages()[at(now.stage)].duration / step_s));
    }
    void skip_stages();
    void move_tools(const FoldingPose& pose);
    Status solve(const FoldingPose& pose);
};

/// To the next that the device goes through, or the end.
void ImplantFold::Parts::skip_stages() {
    while (now.stage < static_cast<int>(folding_stages().size()) && !device.has(now.stage)) {
        ++now.stage;
    }
}

void ImplantFold::Parts::move_tools(const FoldingPose& pose) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        tools[i].previous_pose = tools[i].present ? tools[i].pose : pose.jaw[i];
        tools[i].pose = pose.jaw[i];
        tools[i].present = pose.present[i];
    }
}

Status ImplantFold::Parts::solve(const FoldingPose& pose) {
    move_tools(pose);
    const TubeModel wings = device.wings(pose.radius);
    ShellPartners partners;
    partners.tubes = {&wings, 1};
    partners.tools = device.tools();
    partners.tool_states = tools;
    state.loads.clear();
    if (pose.suction > 0.0) {
        state.loads.push_back({held, Vec3(0.0, 0.0, -pose.suction)});
    }
    ShellState next;
    ShellStepReport report;
    int rollbacks = 0;
    const Vec3 weightless = Vec3::Zero();
    const ShellMotion motion =
        move_shell(stepper, contacts, {state, partners, weightless, step_s}, next, report, rollbacks);
    if (motion == ShellMotion::failed) {
        return Error{
            std::string("a step of the folding has no solution: ").append(folding_stages()[at(now.stage)].name),
            "implant", "a wider bore, or a thinner lens"};
    }
    now.rough += motion == ShellMotion::rough ? 1 : 0;
    now.deepest = std::max(now.deepest, contacts.deepest());
    state = std::move(next);
    return success();
}

ImplantFold::ImplantFold(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
ImplantFold::~ImplantFold() = default;
ImplantFold::ImplantFold(ImplantFold&&) noexcept = default;

Result<ImplantFold> ImplantFold::create(const SceneDescription& scene) {
    Result<Session> session = Session::create(scene, 1);
    if (!session) {
        return session.error();
    }
    const std::map<std::string, double> settings = all_settings(scene);
    const ImplantShape shape = implant_shape(settings);
    const InjectorShape cartridge = injector_shape(settings);
    const WorldModel& world = session.value().world();
    const double least = smallest_bore(shape, world.shells[0], cartridge.tucked);
    if (cartridge.chamber < least) {
        return Error{std::string("cartridge.bore_mm is ")
                         .append(short_number(cartridge.chamber))
                         .append(", too small for the implant"),
                     "", std::string("at least ").append(short_number(least)).append(" for this lens")};
    }
    FoldingDevice device(shape, cartridge);
    std::shared_ptr<const WorldModel> own = folding_world(world, shape, device);
    Result<ShellStepper> stepper = ShellStepper::create(own->shells[0]);
    if (!stepper) {
        return stepper.error();
    }
    return ImplantFold(std::make_unique<Parts>(std::move(session).value(), shape, std::move(device), std::move(own),
                                               std::move(stepper).value()));
}

bool ImplantFold::done() const { return parts_->now.stage >= static_cast<int>(folding_stages().size()); }

Status ImplantFold::step() {
    Parts& p = *parts_;
    const FlushDenormals flush;
    const double start = thread_cpu_seconds();
    if (p.step_in_stage == 0) {
        p.now.deepest = 0.0;
        p.now.rough = 0;
    }
    ++p.step_in_stage;
    Status status = p.solve(p.device.pose(p.now.stage, static_cast<double>(p.step_in_stage) / p.steps_of_stage()));
    p.now.cpu_s += thread_cpu_seconds() - start;
    ++p.now.steps;
    p.now.time += step_s;
    if (p.step_in_stage == p.steps_of_stage()) {
        ++p.now.stage;
        p.skip_stages();
        p.step_in_stage = 0;
    }
    return status;
}

FoldProgress ImplantFold::progress() const {
    FoldProgress progress = parts_->now;
    double whole = 0.0;
    for (int stage = 0; stage < static_cast<int>(folding_stages().size()); ++stage) {
        whole += parts_->device.has(stage) ? folding_stages()[at(stage)].duration : 0.0;
    }
    progress.share = progress.time / whole;
    const ShellEnergy energy = parts_->ledger.energy(parts_->state);
    progress.elastic = energy.elastic;
    progress.branch = energy.branch;
    progress.kinetic = energy.kinetic;
    progress.contact = parts_->contacts.work().stored;
    return progress;
}

Frame ImplantFold::frame() const {
    Frame frame;
    frame.model = parts_->world;
    frame.shells = {parts_->state};
    frame.tools = parts_->tools;
    frame.time_s = parts_->now.time;
    return frame;
}

Result<PreparedState> ImplantFold::result() const {
    const Parts& p = *parts_;
    const Cartridge& cartridge = *p.session.world().tools[0].cartridge;
    Snapshot snapshot = p.session.copy_state();
    snapshot.world.shells[0] = p.device.laid_in(cartridge, p.state);
    if (Status status = check_laid_in(cartridge, p.world->shells[0], snapshot.world.shells[0]); !status) {
        return status.error();
    }
    return PreparedState{header_of(p.session), std::move(snapshot)};
}

}  // namespace rhexis
