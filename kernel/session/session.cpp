// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "input/sample_check.hpp"
#include "observe/observer.hpp"
#include "physics/physics.hpp"
#include "session/build_world.hpp"
#include "session/denormals.hpp"
#include "session/recording.hpp"
#include "session/scene_check.hpp"
#include "session/settings.hpp"
#include "session/snapshot_check.hpp"
#include "session/state_hash.hpp"
#include "tools/advance_tool.hpp"
#include "topology/remove.hpp"

namespace rhexis {

struct Session::Parts {
    // Constant while the session lives.
    SceneDescription scene;
    std::uint64_t seed = 0;
    EyeModel eye;
    std::shared_ptr<const WorldModel> world;
    std::shared_ptr<const EyeAnatomy> anatomy;
    std::uint64_t checkpoint_steps = 500;

    // State.
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
    std::vector<char> was_refused;                     ///< so that a broken device fills no log

    Parts(const SceneDescription& description, std::uint64_t session_seed, BuiltWorld built, Physics made_physics);

    void obey(std::span<const Command> commands);
    void read_input(std::span<const DeviceSample> given);
    void move_tools();
    StepOutcome advance_physics();
    void remove_spent_tissue();
    void observe();

    void set(const Command& command);
    void take_sample(const DeviceSample& sample);
    void refuse(int instrument, const std::string& why);
    void keep_state_of_failed_step(StepFailure failure);
    [[nodiscard]] ObserveInput observe_input() const { return {eye, *world, state, tools, contacts, scene.step_s}; }
    void look_without_remembering();
    void note(LogLevel level, std::string text) { log.push_back({level, state.time_s, std::move(text)}); }
};

namespace {

ObservedTissues tissues_of(const SceneDescription& scene) {
    return {has_tissue(scene, "lens"), has_tissue(scene, "bag"), has_tissue(scene, "iris"),
            has_tissue(scene, "cornea")};
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
                      Physics made_physics)
    : scene(description),
      seed(session_seed),
      eye(std::move(built.eye)),
      world(std::move(built.world)),
      anatomy(std::make_shared<const EyeAnatomy>(eye.anatomy)),
      checkpoint_steps(static_cast<std::uint64_t>(std::lround(checkpoint_interval_s / scene.step_s))),
      state(rest_state(*world)),
      tools(world->tools.size()),
      settings(all_settings(scene)),
      physics(std::move(made_physics)),
      observer(*world, tissues_of(scene), scene.step_s),
      samples(world->tools.size()),
      was_refused(world->tools.size(), 0) {
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
        if (command.kind == CommandKind::set) {
            set(command);
        } else if (command.kind == CommandKind::say) {
            note(LogLevel::info, command.text);
        }
    }
}

void Session::Parts::refuse(int instrument, const std::string& why) {
    const bool known = instrument >= 0 && instrument < static_cast<int>(tools.size());
    if (!known || was_refused[instrument] == 0) {
        note(LogLevel::warning, "sample refused, the instrument stays as it was: " + why);
    }
    if (known) {
        was_refused[instrument] = 1;
    }
}

void Session::Parts::take_sample(const DeviceSample& sample) {
    const Result<DeviceSample> checked = checked_sample(sample, static_cast<int>(tools.size()));
    if (checked) {
        samples[sample.instrument] = checked.value();
    } else {
        refuse(sample.instrument, checked.error().text());
    }
}

void Session::Parts::read_input(std::span<const DeviceSample> given) {
    std::fill(samples.begin(), samples.end(), std::nullopt);
    for (const DeviceSample& sample : given) {
        take_sample(sample);
    }
}

void Session::Parts::move_tools() {
    ToolSettings limits;
    limits.power_limit = settings.at("phaco.power_limit");
    for (int i = 0; i < static_cast<int>(tools.size()); ++i) {
        if (!samples[i]) {
            tools[i] = hold_tool(tools[i]);
            continue;
        }
        ToolStep step_of_tool = next_tool(world->tools[i], tools[i], *samples[i], scene.step_s, limits);
        tools[i] = step_of_tool.state;
        if (step_of_tool.rejected.empty()) {
            was_refused[i] = 0;
        } else {
            refuse(i, step_of_tool.rejected);
        }
    }
}

/// Nothing moves in a step that no way of solving could save; the exercise goes on from where it was.
void Session::Parts::keep_state_of_failed_step(StepFailure failure) {
    note(LogLevel::error, std::string("the step could not be solved (") + describe(failure) + "); nothing moved in it");
    next = state;
    for (SolidState& solid : next.solids) {
        std::fill(solid.velocity.begin(), solid.velocity.end(), Vec3(Vec3::Zero()));
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
    return outcome;
}

void Session::Parts::remove_spent_tissue() {
    const ProfileScope scope(profile, "topology");
    for (int i = 0; i < static_cast<int>(world->solids.size()); ++i) {
        const MeshEdit edit = spent_elements(world->solids[i], state.solids[i], i);
        if (!edit.empty()) {
            apply(edit, world->solids[i], state.solids[i]);
        }
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
    return Session(std::make_unique<Parts>(scene, seed, std::move(built).value(), std::move(physics).value()));
}

StepOutcome Session::step(std::span<const DeviceSample> samples, std::span<const Command> commands) {
    const FlushDenormals flush;
    parts_->obey(commands);
    parts_->read_input(samples);
    parts_->move_tools();
    StepOutcome outcome = parts_->advance_physics();
    parts_->remove_spent_tissue();
    parts_->observe();
    return outcome;
}

const SceneDescription& Session::scene() const { return parts_->scene; }
const EyeModel& Session::eye() const { return parts_->eye; }
const WorldModel& Session::world() const { return *parts_->world; }
const WorldState& Session::state() const { return parts_->state; }
std::span<const ToolState> Session::tools() const { return parts_->tools; }
const ContactSet& Session::contacts() const { return parts_->contacts; }
const ObservationSchema& Session::schema() const { return parts_->observer.schema(); }
const Observation& Session::observation() const { return parts_->observation; }
Percept Session::percept() const { return parts_->observer.percept(parts_->observe_input()); }
std::uint64_t Session::state_hash() const { return parts_->hash; }
std::uint64_t Session::step_count() const { return parts_->step; }
double Session::time_s() const { return parts_->state.time_s; }
const Profile& Session::profile() const { return parts_->profile; }
const Log& Session::log() const { return parts_->log; }

Frame Session::frame() const {
    const Parts& p = *parts_;
    return {p.world, p.anatomy, p.state.solids, p.state.bags, p.tools, p.state.time_s};
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
    Status fits = check_fit(snapshot, *p.world, p.observer.memory_size());
    if (!fits) {
        return fits;
    }
    const FlushDenormals flush;
    p.state = snapshot.world;
    p.tools = snapshot.tools;
    p.settings = snapshot.settings;
    p.observer_memory = snapshot.observer_memory;
    p.step = snapshot.step;
    p.contacts.clear();
    p.physics.drop_caches();
    p.look_without_remembering();
    p.hash = hash_state(p.state, p.tools, p.settings, p.observer_memory, p.step, p.seed);
    return success();
}

}  // namespace rhexis
