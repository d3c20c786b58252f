// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of contact that tests and benchmarks share.
#pragma once

#include <memory>
#include <vector>

#include "physics/physics.hpp"

namespace rhexis::scenes {

/// A world being stepped, with its tools moved by the caller.
class Scene {
public:
    /// The model must be steppable: asserted.
    explicit Scene(WorldModel model, const PhysicsSettings& settings = {});

    /// Puts a tool there at once; it has not moved there.
    void place_tool(int tool, const Pose& pose);
    void withdraw_tool(int tool) { tools[static_cast<std::size_t>(tool)].present = false; }
    /// Where a tool will be at the end of the next step.
    void move_tool(int tool, const Pose& pose);
    void step(double dt);
    /// Drops what the solvers keep from step to step.
    void forget() { physics_.drop_caches(); }

    /// Force of the solids on a tool, mean over the last step [uN].
    [[nodiscard]] Vec3 tool_force(int tool) const;
    /// Force of a kind of partner on the solids [uN].
    [[nodiscard]] Vec3 force_from(ContactPartner partner) const;
    /// Deepest penetration in the last step [mm], 0 or more.
    [[nodiscard]] double penetration() const;
    [[nodiscard]] double speed() const;    ///< fastest node [mm/s]
    [[nodiscard]] Vec3 centre() const;     ///< mean node of solid 0 [mm]
    [[nodiscard]] double kinetic() const;  ///< [nJ]
    [[nodiscard]] double elastic() const;  ///< [nJ]

    std::shared_ptr<const WorldModel> model;
    WorldState state;
    std::vector<ToolState> tools;
    ContactSet contacts;
    StepOutcome outcome;
    int rollbacks = 0;  ///< of all steps
    Profile profile;

private:
    Physics physics_;
    WorldState next_;
};

Pose pose_at(const Vec3& position);

/// A cube of `cells`^3 cells and 1 mm on a plane. Gravity is turned instead of the plane: by `slope` [rad] from the
/// plane's normal, downhill along `heading` [rad] from +x.
WorldModel cube_on_slope(double slope, double heading, double friction, Advance advance, int cells = 2);

/// A block of 2 n x 2 n x n cells with its top at z = 0, half as wide and as deep as `size` [mm], held at the bottom,
/// and a ball of `radius` as tool 0, without friction. centre: size of the cells at the origin, as a share of size / n;
/// 1: all are equal.
WorldModel ball_on_block(int n, double size, double centre, double young_modulus, double poisson_ratio, double radius,
                         Advance advance);

/// The default patient's lens free in its bag, with a tool of that name; lens of about that many tetrahedra.
WorldModel lens_in_bag(const char* tool, Advance advance, int tetrahedra = 3000, double grade = 3.0);

}  // namespace rhexis::scenes
