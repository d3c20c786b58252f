// SPDX-License-Identifier: GPL-3.0-or-later
// A world that a script builds body by body, stepped by tools, physics and topology alone: no eye, no measures.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lua/scene_body.hpp"
#include "physics/physics.hpp"
#include "topology/tear.hpp"

namespace rhexis::lua {

class BareScene final : public SceneBody {
public:
    BareScene(double step_s, const Vec3& gravity, PhysicsSettings settings);

    // Bodies may be added at any time; the solvers are then made anew at the next step. Each returns its index.
    int add_solid(SolidModel model, const Vec3& velocity);
    int add_membrane(MembraneModel model, const TearRules& rules);
    int add_tool(ToolModel model, const Pose& pose);
    int add_plane(const PlaneModel& model);

    MembraneState& membrane(int index) { return state_.membranes[static_cast<std::size_t>(index)]; }
    /// A slit through a place of a triangle at rest.
    Status puncture(int membrane, int triangle, const Vec3& place, const Vec3& direction);

    void add_load(NodeLoad load);
    void clear_loads(int solid);
    /// Takes coarse tetrahedra out of a solid.
    void remove(int solid, const std::vector<int>& tets);

    [[nodiscard]] const WorldModel& model() const override { return *model_; }
    [[nodiscard]] const WorldState& state() const override { return state_; }
    [[nodiscard]] std::span<const ToolState> tools() const override { return tools_; }
    [[nodiscard]] const ContactSet& contacts() const override { return contacts_; }
    [[nodiscard]] std::uint64_t steps() const override { return steps_; }
    [[nodiscard]] double step_s() const override { return step_s_; }
    [[nodiscard]] std::uint64_t state_hash() const override;
    Frame frame() override;
    Snapshot snapshot() override;

private:
    Result<StepOutcome> advance(std::span<const DeviceSample> samples) override;
    Status put_back(const Snapshot& snapshot) override;
    template <typename Change>
    void change_model(const Change& change);
    Status prepare();
    [[nodiscard]] Result<std::vector<ToolState>> moved_tools(std::span<const DeviceSample> samples) const;
    void remove_spent();

    double step_s_;
    PhysicsSettings settings_;
    std::shared_ptr<const WorldModel> model_;
    std::vector<TearRules> rules_;  // per membrane
    WorldState state_;
    WorldState next_;
    std::vector<ToolState> tools_;
    ContactSet contacts_;
    std::uint64_t steps_ = 0;
    std::optional<Physics> physics_;  // none until the model is settled
    Profile profile_;
};

}  // namespace rhexis::lua
