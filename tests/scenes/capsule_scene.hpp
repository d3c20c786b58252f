// SPDX-License-Identifier: GPL-3.0-or-later
// The anterior capsule of a patient under instruments that are led by hand.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "eye/anterior_capsule.hpp"
#include "physics/physics.hpp"

namespace rhexis::scenes {

class CapsuleScene {
public:
    /// layers: false: what is folded over passes through what is below. step_s: of a step [s].
    CapsuleScene(double age, const AnteriorCapsuleSettings& settings, std::vector<ToolModel> tools, bool layers = true,
                 double step_s = 0.01, const PhysicsSettings& physics = {});

    [[nodiscard]] const MembraneModel& model() const { return world_->membranes[0]; }
    [[nodiscard]] MembraneState& sheet() { return state_.membranes[0]; }
    [[nodiscard]] const ToolState& tool(int index) const { return tools_[static_cast<std::size_t>(index)]; }
    /// Of the lens's front at a place across the view [mm].
    [[nodiscard]] Vec3 front(double x, double y) const;

    [[nodiscard]] double step_s() const { return step_s_; }
    [[nodiscard]] double time_s() const { return state_.time_s; }
    /// Called in each step with the sheet at its start and at its end, before anything tears. Or none.
    std::function<void(const MembraneState& before, const MembraneState& after)> watch;
    /// A step, with what tears in it. False if it had to be given up.
    bool step();
    /// Steps with nothing done: lens and capsule come to rest.
    void settle(int steps);
    void put(int tool, const Vec3& place, double jaw = 0.0);
    /// In a straight line, at a speed [mm/s]; false if a step had to be given up.
    bool lead(int tool, const Vec3& to, double speed, double jaw = 0.0);
    void withdraw(int tool) { tools_[static_cast<std::size_t>(tool)] = ToolState{}; }

    /// On the sheet, of all instruments, in the last step; and the greatest so far [uN].
    [[nodiscard]] Vec3 force() const { return force_; }
    double greatest_force = 0.0;
    int punctures = 0;               ///< proposed so far
    double force_of_puncture = 0.0;  ///< of the first [uN]

    /// Opens a flap by topology alone: from a radius inside the arc along a radius, then along the arc of that radius
    /// by an angle [mm, rad]. Its tip on the arc comes last.
    void open_flap(double inside, double radius, double angle);

private:
    HalfEllipsoids lens_;
    double step_s_;
    std::shared_ptr<const WorldModel> world_;
    std::unique_ptr<Physics> physics_;
    WorldState state_;
    WorldState next_;
    std::vector<ToolState> tools_;
    ContactSet contacts_;
    Profile profile_;
    Vec3 force_ = Vec3::Zero();
};

}  // namespace rhexis::scenes
