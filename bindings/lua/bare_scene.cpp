// SPDX-License-Identifier: GPL-3.0-or-later
#include "lua/bare_scene.hpp"

#include <algorithm>

#include "session/denormals.hpp"
#include "session/state_hash.hpp"
#include "tools/advance_tool.hpp"
#include "topology/remove.hpp"
#include "topology/tear.hpp"

namespace rhexis::lua {
namespace {

bool fits(const Snapshot& snapshot, const WorldModel& model) {
    bool same = snapshot.world.solids.size() == model.solids.size() && snapshot.tools.size() == model.tools.size() &&
                snapshot.world.bags.size() == model.bags.size();
    same = same && snapshot.world.membranes.size() == model.membranes.size() &&
           snapshot.world.shells.size() == model.shells.size();
    for (std::size_t k = 0; same && k < model.solids.size(); ++k) {
        const SolidState& solid = snapshot.world.solids[k];
        same = solid.position.size() == model.solids[k].coarse.nodes.size() &&
               solid.present.size() == model.solids[k].coarse.tets.size() &&
               solid.fraction.size() == model.solids[k].fine.tets.size();
    }
    return same;
}

}  // namespace

BareScene::BareScene(double step_s, const Vec3& gravity, PhysicsSettings settings)
    : step_s_(step_s), settings_(std::move(settings)) {
    WorldModel empty;
    empty.gravity = gravity;
    model_ = std::make_shared<const WorldModel>(std::move(empty));
}

// A model never changes once it is shared: pictures and snapshots may still hold the old one.
template <typename Change>
void BareScene::change_model(const Change& change) {
    WorldModel model = *model_;
    change(model);
    model_ = std::make_shared<const WorldModel>(std::move(model));
    physics_.reset();
}

int BareScene::add_solid(SolidModel model, const Vec3& velocity) {
    state_.solids.push_back(rest_state(model));
    std::fill(state_.solids.back().velocity.begin(), state_.solids.back().velocity.end(), velocity);
    for (const int node : model.fixed_nodes) {
        state_.solids.back().velocity[static_cast<std::size_t>(node)].setZero();
    }
    change_model([&](WorldModel& world) { world.solids.push_back(std::move(model)); });
    note_elements();
    return static_cast<int>(state_.solids.size()) - 1;
}

int BareScene::add_membrane(MembraneModel model, const TearRules& rules) {
    rules_.push_back(rules);
    state_.membranes.push_back(rest_state(model));
    change_model([&](WorldModel& world) { world.membranes.push_back(std::move(model)); });
    return static_cast<int>(state_.membranes.size()) - 1;
}

Status BareScene::puncture(int membrane, int triangle, const Vec3& place, const Vec3& direction) {
    const std::size_t index = static_cast<std::size_t>(membrane);
    const Result<MembraneEdit> edit =
        rhexis::puncture(model_->membranes[index], state_.membranes[index], triangle, place, direction, rules_[index]);
    if (!edit.ok()) {
        return edit.error();
    }
    state_.membranes[index] = applied(state_.membranes[index], edit.value());
    return success();
}

int BareScene::add_tool(ToolModel model, const Pose& pose) {
    change_model([&](WorldModel& world) { world.tools.push_back(std::move(model)); });
    ToolState state;
    state.present = true;
    state.pose = pose;
    state.previous_pose = pose;
    tools_.push_back(state);
    return static_cast<int>(tools_.size()) - 1;
}

int BareScene::add_plane(const PlaneModel& model) {
    change_model([&](WorldModel& world) { world.planes.push_back(model); });
    return static_cast<int>(model_->planes.size()) - 1;
}

void BareScene::add_load(NodeLoad load) { state_.loads.push_back(std::move(load)); }

void BareScene::clear_loads(int solid) {
    std::erase_if(state_.loads, [solid](const NodeLoad& load) { return load.solid == solid; });
}

void BareScene::remove(int solid, const std::vector<int>& tets) {
    const SolidModel& model = model_->solids[static_cast<std::size_t>(solid)];
    SolidState& state = state_.solids[static_cast<std::size_t>(solid)];
    apply(remove_coarse(model, state, solid, tets), model, state);
    note_elements();
}

std::uint64_t BareScene::state_hash() const { return hash_state(state_, tools_, {}, {}, steps_, 0); }

Frame BareScene::frame() {
    Frame frame;
    frame.model = model_;
    frame.solids = state_.solids;
    frame.membranes = state_.membranes;
    frame.shells = state_.shells;
    frame.bags = state_.bags;
    frame.tools = tools_;
    frame.time_s = state_.time_s;
    return frame;
}

Snapshot BareScene::snapshot() {
    if (physics_) {
        physics_->drop_caches();  // so that this scene goes on as one restored from the snapshot does
    }
    return {state_, tools_, {}, {}, steps_};
}

Status BareScene::put_back(const Snapshot& snapshot) {
    if (!fits(snapshot, *model_)) {
        return Error{"the snapshot is of another scene, or bodies were added since", "", ""};
    }
    state_ = snapshot.world;
    tools_ = snapshot.tools;
    steps_ = snapshot.step;
    contacts_.clear();
    if (physics_) {
        physics_->drop_caches();
    }
    return success();
}

Status BareScene::prepare() {
    if (physics_) {
        return success();
    }
    Result<Physics> made = Physics::create(model_, settings_);
    if (!made) {
        return made.error();
    }
    physics_.emplace(std::move(made).value());
    return success();
}

void BareScene::remove_spent() {
    for (std::size_t k = 0; k < model_->solids.size(); ++k) {
        const MeshEdit edit = spent_elements(model_->solids[k], state_.solids[k], static_cast<int>(k));
        if (!edit.empty()) {
            apply(edit, model_->solids[k], state_.solids[k]);
        }
    }
}

// Where the orders bring the tools; one that cannot be followed (a jump, say) is the script's mistake.
Result<std::vector<ToolState>> BareScene::moved_tools(std::span<const DeviceSample> samples) const {
    std::vector<ToolState> moved;
    for (std::size_t k = 0; k < tools_.size(); ++k) {
        ToolStep step = next_tool(model_->tools[k], tools_[k], samples[k], step_s_, ToolSettings{});
        if (!step.rejected.empty()) {
            return Error{model_->tools[k].name + " cannot move as told: " + step.rejected, "", ""};
        }
        moved.push_back(std::move(step.state));
    }
    return moved;
}

Result<StepOutcome> BareScene::advance(std::span<const DeviceSample> samples) {
    const FlushDenormals flush;
    const Status ready = prepare();
    if (!ready) {
        return ready.error();
    }
    Result<std::vector<ToolState>> moved = moved_tools(samples);
    if (!moved) {
        return moved.error();
    }
    StepOutcome outcome = physics_->advance(state_, moved.value(), step_s_, next_, contacts_, profile_);
    ++steps_;
    if (outcome.failure == StepFailure::none) {
        std::swap(state_, next_);
        tools_ = std::move(moved).value();
        remove_spent();
        for (std::size_t k = 0; k < outcome.membranes.size(); ++k) {
            carry_out(model_->membranes[k], outcome.membranes[k], state_.membranes[k], rules_[k]);
        }
    } else {
        contacts_.clear();
    }
    state_.time_s = static_cast<double>(steps_) * step_s_;
    return outcome;
}

}  // namespace rhexis::lua
