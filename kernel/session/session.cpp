// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "input/step_input.hpp"
#include "observe/observer.hpp"
#include "physics/physics.hpp"
#include "physics/shell/shell_carry.hpp"
#include "session/build_world.hpp"
#include "session/denormals.hpp"
#include "session/recording.hpp"
#include "session/scene_check.hpp"
#include "session/settings.hpp"
#include "session/snapshot_check.hpp"
#include "session/state_hash.hpp"
#include "tools/advance_tool.hpp"
#include "tools/microscope.hpp"
#include "topology/come_apart.hpp"
#include "topology/crumble.hpp"
#include "topology/remove.hpp"
#include "topology/segments.hpp"
#include "topology/tear.hpp"

namespace rhexis {

struct Session::Parts {
    // Constant while the session lives.
    SceneDescription scene;
    std::uint64_t seed = 0;
    EyeModel eye;  ///< its anatomy as chamber and instruments have moved it
    EyeAnatomy rest_anatomy;
    std::shared_ptr<const WorldModel> base_world;  ///< before anything came apart
    PhysicsSettings physics_settings;
    std::uint64_t checkpoint_steps = 500;

    // State. The model has the nodes that the state's splits made.
    std::shared_ptr<const WorldModel> world;
    WorldState state;
    std::vector<ToolState> tools;
    std::map<std::string, double> settings;
    std::vector<double> observer_memory;
    std::uint64_t step = 0;

    // What the last step left for others to read.
    ContactSet contacts;
    Observation observation;
    std::uint64_t hash = 0;
    Log log;
    Profile profile;

    // Stages that keep caches or scratch.
    Physics physics;
    Observer observer;
    WorldState next;
    std::vector<std::optional<DeviceSample>> samples;  ///< per instrument: what it is to do in this step
    std::vector<char> was_refused;                     ///< likewise; so that a broken device fills no log

    Parts(const SceneDescription& description, std::uint64_t session_seed, BuiltWorld built,
          const PhysicsSettings& settings, Physics made_physics);

    void obey(std::span<const Command> commands);
    void read_input(std::span<const DeviceSample> given);
    void leave(int tool);
    [[nodiscard]] DeviceSample in_eye(DeviceSample sample) const;
    void move_tools();
    void move_microscope();
    StepOutcome advance_physics();
    void change_topology(const StepOutcome& outcome);
    bool take_apart(int solid, const std::vector<BrokenFace>& broken);
    void crumble_pieces(int solid);
    void cut_into_segments();
    void follow_model();
    void observe();

    void set(const Command& command);
    void refuse(int instrument, const std::string& why);
    void keep_state_of_failed_step(StepFailure failure);
    [[nodiscard]] ObserveInput observe_input() const { return {eye, *world, state, tools, contacts, scene.step_s}; }
    void look_without_remembering();
    void note(LogLevel level, std::string text) { log.push_back({level, state.time_s, std::move(text)}); }
};

namespace {

/// Whether pieces have come apart is looked at this often while tissue is removed: a look costs a tenth of a step.
constexpr std::uint64_t steps_between_looks = 10;

/// The model of a state in which nodes have been split.
std::shared_ptr<const WorldModel> with_splits(const WorldModel& base, const WorldState& state) {
    std::shared_ptr<WorldModel> world = std::make_shared<WorldModel>(base);
    for (std::size_t i = 0; i < world->solids.size(); ++i) {
        world->solids[i] = split_model(base.solids[i], state.solids[i].splits);
    }
    return world;
}

ObservedTissues tissues_of(const SceneDescription& scene) {
    return {has_tissue(scene, "lens"), has_tissue(scene, "bag"), has_tissue(scene, "iris"),
            has_tissue(scene, "cornea")};
}

/// What shows of the eye's surfaces now.
EyeAnatomy moved_anatomy(EyeAnatomy anatomy, const WorldState& state) {
    if (state.iris) {
        anatomy.iris_z = state.iris->z;
        anatomy.pupil_radius = state.iris->pupil_radius;
    }
    if (state.chamber) {
        anatomy.wound_burn = burn_share(state.chamber->wound);
    }
    if (state.wounds) {
        const Wound& main = state.wounds->wounds[main_wound];
        const Wound& side = state.wounds->wounds[side_port];
        anatomy.incision = main.cut ? main.inner : anatomy.incision;
        anatomy.incision_width = main.cut ? main.width : 0.0;
        anatomy.side_port = side.inner;
        anatomy.side_port_width = side.cut ? side.width : 0.0;
    }
    return anatomy;
}

ToolSettings tool_settings(const std::map<std::string, double>& settings) {
    ToolSettings limits;
    limits.power_limit = settings.at("phaco.power_limit");
    limits.pulse_hz = settings.at("phaco.pulse_hz");
    limits.duty = settings.at("phaco.duty");
    limits.infusion = settings.at("machine.infusion") >= 0.5;
    limits.bottle_height = 10.0 * settings.at("machine.bottle_cm");
    limits.pump_flow = mm3_s_per_ml_min * settings.at("machine.flow_ml_min");
    limits.vacuum_limit = pascal_per_mmhg * settings.at("machine.vacuum_mmhg");
    limits.cut_rate = settings.at("cutter.cuts_per_min") / fastest_cutter;
    limits.cutter_flow = mm3_s_per_ml_min * settings.at("cutter.flow_ml_min");
    limits.cutter_vacuum = pascal_per_mmhg * settings.at("cutter.vacuum_mmhg");
    limits.ia_flow = mm3_s_per_ml_min * settings.at("ia.flow_ml_min");
    limits.ia_vacuum = pascal_per_mmhg * settings.at("ia.vacuum_mmhg");
    limits.cut_first = settings.at("cutter.cut_first") >= 0.5;
    return limits;
}

const char* describe(StepFailure failure) {
    switch (failure) {
        case StepFailure::not_finite:
            return "numbers ran away";
        case StepFailure::not_converged:
            return "the solver did not converge";
        case StepFailure::inverted:
            return "elements turned inside out";
        case StepFailure::none:
            break;
    }
    return "no failure";
}

}  // namespace

Session::Parts::Parts(const SceneDescription& description, std::uint64_t session_seed, BuiltWorld built,
                      const PhysicsSettings& wanted, Physics made_physics)
    : scene(description),
      seed(session_seed),
      eye(std::move(built.eye)),
      rest_anatomy(eye.anatomy),
      base_world(std::move(built.world)),
      physics_settings(wanted),
      checkpoint_steps(static_cast<std::uint64_t>(std::lround(checkpoint_interval_s / scene.step_s))),
      world(base_world),
      state(rest_state(*world)),
      tools(world->tools.size()),
      settings(all_settings(scene)),
      physics(std::move(made_physics)),
      observer(*world, tissues_of(scene), scene.step_s),
      samples(scene.instruments.size()),
      was_refused(scene.instruments.size(), 0) {
    if (injects(scene)) {
        state.shells[0].loaded = true;  // until it is laid into its injector it lies flat beside the eye
    }
    if (state.wounds) {
        eye.anatomy = moved_anatomy(rest_anatomy, state);
    }
    cut_into_segments();
    observer_memory.assign(observer.memory_size(), 0.0);
    look_without_remembering();
    hash = hash_state(state, tools, settings, observer_memory, step, seed);
}

void Session::Parts::set(const Command& command) {
    const Status status = check_setting(command.name, command.value);
    if (!status) {
        note(LogLevel::warning, "command refused: " + status.error().text());
    } else if (!find_setting(command.name)->live) {
        note(LogLevel::warning, "command refused: " + command.name + " can only be set before the first step");
    } else {
        settings[command.name] = command.value;
    }
}

void Session::Parts::obey(std::span<const Command> commands) {
    for (const Command& command : commands) {
        if (command.kind == CommandKind::set || command.kind == CommandKind::adjust ||
            command.kind == CommandKind::inject) {
            set(command);
        } else if (command.kind == CommandKind::say) {
            note(LogLevel::info, command.text);
        }
    }
}

void Session::Parts::refuse(int instrument, const std::string& why) {
    const bool known = instrument >= 0 && instrument < static_cast<int>(samples.size());
    if (!known || was_refused[instrument] == 0) {
        note(LogLevel::warning, "sample refused, the instrument stays as it was: " + why);
    }
    if (known) {
        was_refused[instrument] = 1;
    }
}

void Session::Parts::read_input(std::span<const DeviceSample> given) {
    StepInput input = read_samples(given, static_cast<int>(samples.size()));
    samples = std::move(input.samples);
    for (const RefusedSample& refused : input.refused) {
        refuse(refused.instrument, refused.why);
    }
}

/// Hands and devices are in the room; what they hold is simulated in the eye's frame, which rolls.
DeviceSample Session::Parts::in_eye(DeviceSample sample) const {
    if (state.globe) {
        sample.pose = to_eye(*world->globe, *state.globe, sample.pose);
    }
    return sample;
}

/// An implant that still lies in an injector leaves the eye with it.
void Session::Parts::leave(int tool) {
    const ToolModel& model = world->tools[tool];
    for (ShellState& shell : state.shells) {
        if (model.cartridge && !shell.loaded && lies_in(model.cartridge->bore, tools[tool].pose, shell)) {
            shell = taken_along(shell, tools[tool].pose);
            note(LogLevel::info, model.name + " leaves the eye, and what lies in it with it");
        }
    }
}

void Session::Parts::move_tools() {
    const ToolSettings limits = tool_settings(settings);
    for (int i = 0; i < static_cast<int>(tools.size()); ++i) {
        if (!samples[i]) {
            tools[i] = hold_tool(tools[i]);
            continue;
        }
        ToolStep step_of_tool = next_tool(world->tools[i], tools[i], in_eye(*samples[i]), scene.step_s, limits);
        if (tools[i].present && !step_of_tool.state.present) {
            leave(i);
        }
        tools[i] = step_of_tool.state;
        if (step_of_tool.rejected.empty()) {
            was_refused[i] = 0;
        } else {
            refuse(i, step_of_tool.rejected);
        }
    }
}

/// Its sample is the last one.
void Session::Parts::move_microscope() {
    if (!state.microscope || !samples.back()) {
        return;
    }
    const MicroscopeStep moved = next_microscope(*state.microscope, *samples.back(), scene.step_s);
    state.microscope = moved.state;
    if (moved.rejected.empty()) {
        was_refused.back() = 0;
    } else {
        refuse(static_cast<int>(samples.size()) - 1, moved.rejected);
    }
}

/// Nothing moves in a step that no way of solving could save; the exercise goes on from where it was.
void Session::Parts::keep_state_of_failed_step(StepFailure failure) {
    note(LogLevel::error, std::string("the step could not be solved (") + describe(failure) + "); nothing moved in it");
    next = state;
    for (SolidState& solid : next.solids) {
        std::fill(solid.velocity.begin(), solid.velocity.end(), Vec3(Vec3::Zero()));
    }
    for (MembraneState& membrane : next.membranes) {
        std::fill(membrane.velocity.begin(), membrane.velocity.end(), Vec3(Vec3::Zero()));
    }
    for (ShellState& shell : next.shells) {
        stop(shell);
    }
    for (BagState& bag : next.bags) {
        bag.velocity.setZero();
        bag.angular_velocity.setZero();
    }
    contacts.clear();
}

StepOutcome Session::Parts::advance_physics() {
    if (step % checkpoint_steps == 0) {
        physics.drop_caches();  // by count, recording or not: going on from a checkpoint equals running through
    }
    if (state.wounds) {
        state.wounds->source = pascal_per_mmhg * settings.at("suprachoroidal.pressure_mmhg");
    }
    StepOutcome outcome = physics.advance(state, tools, scene.step_s, next, contacts, profile);
    for (const std::string& line : outcome.notes) {
        note(LogLevel::warning, line);
    }
    if (outcome.failure != StepFailure::none) {
        keep_state_of_failed_step(outcome.failure);
    }
    std::swap(state, next);
    ++step;
    state.time_s = static_cast<double>(step) * scene.step_s;
    eye.anatomy = moved_anatomy(rest_anatomy, state);
    return outcome;
}

/// Splits what holds together no more. True: the model has new nodes.
bool Session::Parts::take_apart(int solid, const std::vector<BrokenFace>& broken) {
    const SolidModel& model = world->solids[solid];
    const MeshEdit edit = come_apart(model, state.solids[solid], solid, broken);
    if (edit.empty()) {
        return false;
    }
    apply_splits(edit, state.solids[solid]);
    for (BagState& bag : state.bags) {
        for (std::size_t i = 0; !bag.adherent.empty() && i < edit.splits.size(); ++i) {
            bag.adherent.push_back(std::uint8_t(bag.adherent[edit.splits[i].node]));
        }
    }
    const int nodes = static_cast<int>(model.coarse.nodes.size());
    std::erase_if(state.memory, [&](const ContactMemory& m) { return m.solid == solid && m.vertex >= nodes; });
    return !edit.splits.empty();
}

void Session::Parts::crumble_pieces(int solid) {
    const SolidModel& model = world->solids[solid];
    SolidState& body = state.solids[solid];
    const Crumbs crumbs = crumble(model, body, solid, pieces_of(model, body), debris_volume);
    if (!crumbs.edit.empty()) {
        apply(crumbs.edit, model, body);
        state.debris.insert(state.debris.end(), crumbs.debris.begin(), crumbs.debris.end());
    }
}

/// Before the first step.
void Session::Parts::cut_into_segments() {
    const int segments = static_cast<int>(settings.at("nucleus.segments"));
    if (segments == 0 || world->solids.empty()) {
        return;
    }
    if (take_apart(0, segment_faces(world->solids[0], segments))) {
        follow_model();
    }
    const double width = settings.at("nucleus.trench_mm");
    if (width > 0.0) {
        const MeshEdit trenches = trench(world->solids[0], state.solids[0], 0, segments, width);
        state.removed_mass += edit_mass(trenches, world->solids[0], state.solids[0]);
        apply(trenches, world->solids[0], state.solids[0]);
    }
}

/// After the state's splits changed.
void Session::Parts::follow_model() {
    world = with_splits(*base_world, state);
    Result<Physics> made = Physics::create(world, physics_settings, &physics);
    RHEXIS_ASSERT(made.ok());
    physics = std::move(made).value();
    observer.follow(*world);
}

void Session::Parts::change_topology(const StepOutcome& outcome) {
    if (world->solids.empty() && world->membranes.empty()) {
        return;
    }
    const ProfileScope scope(profile, "topology");
    for (std::size_t i = 0; outcome.failure == StepFailure::none && i < outcome.membranes.size(); ++i) {
        carry_out(world->membranes[i], outcome.membranes[i], state.membranes[i]);
    }
    bool split = false;
    for (int i = 0; i < static_cast<int>(world->solids.size()); ++i) {
        const MeshEdit edit = spent_elements(world->solids[i], state.solids[i], i);
        if (!edit.empty()) {
            apply(edit, world->solids[i], state.solids[i]);
        }
        const bool cracked = outcome.failure == StepFailure::none && !outcome.solids[i].broken.empty();
        if (state.removed_mass > 0.0 && step % steps_between_looks == 0) {
            crumble_pieces(i);
        }
        if (cracked || (state.removed_mass > 0.0 && step % steps_between_looks == 0)) {
            split = take_apart(i, cracked ? outcome.solids[i].broken : std::vector<BrokenFace>{}) || split;
        }
    }
    if (split) {
        follow_model();
    }
}

void Session::Parts::observe() {
    const ProfileScope scope(profile, "observe");
    observer.observe(observe_input(), observer_memory, observation);
    hash = hash_state(state, tools, settings, observer_memory, step, seed);
}

void Session::Parts::look_without_remembering() {
    std::vector<double> memory = observer_memory;
    observer.observe(observe_input(), memory, observation);
}

Session::Session(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Result<Session> Session::create(const SceneDescription& scene, std::uint64_t seed) {
    const FlushDenormals flush;  // helper threads inherit it when they start
    const Status status = check_scene(scene);
    if (!status) {
        return status.error();
    }
    Result<BuiltWorld> built = build_world(scene);
    if (!built) {
        return built.error();
    }
    PhysicsSettings settings;
    settings.threads = scene.threads;
    settings.instruction_set = scene.instruction_set;
    Result<Physics> physics = Physics::create(built.value().world, settings);
    if (!physics) {
        return physics.error();
    }
    return Session(
        std::make_unique<Parts>(scene, seed, std::move(built).value(), settings, std::move(physics).value()));
}

StepOutcome Session::step(std::span<const DeviceSample> samples, std::span<const Command> commands) {
    const FlushDenormals flush;
    parts_->obey(commands);
    parts_->read_input(samples);
    parts_->move_tools();
    parts_->move_microscope();
    StepOutcome outcome = parts_->advance_physics();
    parts_->change_topology(outcome);
    parts_->observe();
    return outcome;
}

const SceneDescription& Session::scene() const { return parts_->scene; }
const EyeModel& Session::eye() const { return parts_->eye; }
const WorldModel& Session::world() const { return *parts_->world; }
const WorldState& Session::state() const { return parts_->state; }
std::span<const ToolState> Session::tools() const { return parts_->tools; }
const std::map<std::string, double>& Session::settings() const { return parts_->settings; }
const ContactSet& Session::contacts() const { return parts_->contacts; }
const ObservationSchema& Session::schema() const { return parts_->observer.schema(); }
const Observation& Session::observation() const { return parts_->observation; }
Percept Session::percept() const { return parts_->observer.percept(parts_->observe_input(), observation()); }
std::uint64_t Session::state_hash() const { return parts_->hash; }
std::uint64_t Session::step_count() const { return parts_->step; }
double Session::time_s() const { return parts_->state.time_s; }
const Profile& Session::profile() const { return parts_->profile; }
const Log& Session::log() const { return parts_->log; }

Frame Session::frame() const {
    const Parts& p = *parts_;
    EyeAnatomy anatomy = p.eye.anatomy;
    if (p.state.iris) {
        anatomy.iris_z = p.state.iris->z;
        anatomy.pupil_radius = p.state.iris->pupil_radius;
    }
    std::vector<Debris> loose = p.state.debris;
    if (p.state.beads) {
        const double radius = p.world->beads->radius;
        for (const Bead& bead : p.state.beads->beads) {
            loose.push_back({bead.position, Vec3::Zero(), 4.0 / 3.0 * std::numbers::pi * radius * radius * radius});
        }
    }
    return {p.world,
            std::make_shared<const EyeAnatomy>(anatomy),
            p.state.solids,
            p.state.membranes,
            p.state.shells,
            p.state.bags,
            p.tools,
            p.state.capsule,
            p.state.iris,
            loose,
            p.state.microscope,
            p.state.time_s,
            p.state.vitreous,
            p.state.wounds,
            p.state.globe,
            p.state.prolapse,
            p.state.hydrodissection,
            p.state.cortex,
            p.state.retained,
            p.state.lids};
}

Snapshot Session::snapshot() const {
    parts_->physics.drop_caches();
    return copy_state();
}

Snapshot Session::copy_state() const {
    const Parts& p = *parts_;
    return {p.state, p.tools, p.settings, p.observer_memory, p.step};
}

Status Session::restore(const Snapshot& snapshot) {
    Parts& p = *parts_;
    Status fits = check_splits(snapshot, *p.base_world);
    if (!fits) {
        return fits;
    }
    std::shared_ptr<const WorldModel> world = with_splits(*p.base_world, snapshot.world);
    fits = check_fit(snapshot, *world, p.observer.memory_size());
    if (!fits) {
        return fits;
    }
    const FlushDenormals flush;
    p.state = snapshot.world;
    p.eye.anatomy = moved_anatomy(p.rest_anatomy, p.state);
    p.tools = snapshot.tools;
    p.settings = snapshot.settings;
    p.observer_memory = snapshot.observer_memory;
    p.step = snapshot.step;
    p.contacts.clear();
    p.follow_model();
    p.look_without_remembering();
    p.hash = hash_state(p.state, p.tools, p.settings, p.observer_memory, p.step, p.seed);
    return success();
}

}  // namespace rhexis
