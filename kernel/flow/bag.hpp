// SPDX-License-Identifier: GPL-3.0-or-later
// The capsular bag as the lens meets it while its wall is not simulated: a smooth closed rigid surface that hangs on
// zonule springs. (Its wall becomes a membrane when an exercise needs it.)
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "flow/zonules.hpp"
#include "math/types.hpp"

namespace rhexis {

/// Two half-ellipsoids that share the equator, in the bag's own frame: axis z, anterior is +z.
///   f(x) = (x^2 + y^2) / radius^2 + z^2 / c^2 - 1, c = anterior for z >= 0, else posterior; the inside has f < 0.
struct BagShape {
    double radius = 4.6;     ///< equatorial [mm]
    double anterior = 1.9;   ///< equatorial plane to anterior pole [mm]
    double posterior = 2.7;  ///< equatorial plane to posterior pole [mm]
};

/// Signed distance of a point in the bag's frame (negative inside) and the outward unit normal there.
struct SurfaceDistance {
    double distance = 0.0;  ///< [mm]
    Vec3 normal = Vec3::UnitZ();
};
SurfaceDistance bag_distance(const BagShape& shape, const Vec3& point);

/// A linear spring from a point of the bag to a fixed point of the ciliary body. It acts along its line and is
/// unstretched where the bag rests (pose identity: the bag's frame is the eye's).
struct ZonuleSpring {
    Vec3 on_bag = Vec3::Zero();      ///< in the bag's frame [mm]
    Vec3 on_ciliary = Vec3::Zero();  ///< in the eye's frame [mm]
    double stiffness = 0.0;          ///< [uN/mm]
};

/// Force of a zonule on the bag, which acts at bag.to_world(spring.on_bag) [uN]. Zero at rest.
Vec3 zonule_force(const ZonuleSpring& spring, const Pose& bag);

/// Change of that force against a displacement of its point, without the part from the spring's turning: positive
/// semidefinite [uN/mm].
Mat3 zonule_stiffness(const ZonuleSpring& spring, const Pose& bag);

/// Length over length at rest, less 1; negative: slack.
double zonule_strain(const ZonuleSpring& spring, const Pose& bag);

struct BagModel {
    BagShape shape;
    std::vector<ZonuleSpring> zonules;
    double mass = 0.01;           ///< [g], of capsule and the fluid that moves with it
    double damping = 0.0;         ///< force per velocity of the centre [uN s/mm] (and mm^2 times that for rotation)
    double opening_radius = 0.0;  ///< radius of the anterior opening (capsulorhexis) [mm]; no wall inside it
    double friction = 0.1;        ///< Coulomb coefficient, lens against bag
    double film = 0.0;            ///< what cortex left on the capsule bears in shear before it slides [Pa]
    double cushion = 0.0;         ///< stiffness with which the vitreous holds it along z [uN/mm]; 0: no vitreous
    double adhesion = 0.0;        ///< cortex to capsule where they still adhere: strength [Pa]
    std::vector<std::uint8_t> adherent;  ///< per coarse node of the lens: 1 where they do at the start; empty: nowhere
    std::optional<ZonuleModel> breakable;  ///< zonules that can break; none: they hold whatever happens
};

struct BagState {
    Pose pose;
    Vec3 velocity = Vec3::Zero();          ///< of the centre [mm/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< [rad/s]
    double cushion_z = 0.0;                ///< where the vitreous holds it now [mm]
    Vec6 load = Vec6::Zero();              ///< force and torque of instruments on its wall [uN, uN mm]
    std::vector<std::uint8_t> adherent;    ///< as in the model, now
    std::optional<ZonuleState> zonules;    ///< there where the model has zonules that can break
};

}  // namespace rhexis
