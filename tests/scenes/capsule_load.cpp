// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/capsule_load.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "physics/membrane/membrane_body.hpp"

namespace rhexis::scenes {
namespace {

constexpr double ring_inner = 2.3;  ///< [mm]
constexpr double ring_outer = 2.9;  ///< [mm]

double pull_of_zonules(const MembraneModel& model, const MembraneState& sheet) {
    double sum = 0.0;
    for (const NodeSpring& spring : model.springs) {
        const double length = (sheet.position[at(spring.node)] - spring.anchor).norm();
        sum += spring.on_support ? 0.0 : spring.stiffness * std::max(0.0, length - spring.slack);
    }
    return sum;
}

/// Of a stress (11, 22, 12) along a direction of the plane, unit.
double along(const Vec3& stress, const Vec2& direction) {
    return stress[0] * direction.x() * direction.x() + stress[1] * direction.y() * direction.y() +
           2.0 * stress[2] * direction.x() * direction.y();
}

}  // namespace

CapsuleLoad capsule_load(const MembraneModel& model, const MembraneState& sheet) {
    CapsuleLoad load;
    load.lift = sheet.support.lift;
    load.zonules = pull_of_zonules(model, sheet);
    load.energy = elastic_energy(model, sheet);
    const MembraneSheet& own = *sheet.sheet;
    double area = 0.0;
    for (int t = 0; t < static_cast<int>(own.thickness.size()); ++t) {
        const Vec3 middle = triangle_middle(own.mesh, t);
        const double radius = middle.head<2>().norm();
        if (radius < ring_inner || radius > ring_outer) {
            continue;
        }
        const PlaneFrame frame = frame_of(own.mesh, t);
        const MembraneTriangle triangle = membrane_triangle(model, own, t, frame);
        const Vec3 stress = membrane_state(triangle, points_now(sheet, t)).stress;
        const Vec3 front = front_of(own.mesh, t);
        const Vec2 circular = frame.to_plane(front.cross(middle)).normalized();
        const Vec2 radial(circular.y(), -circular.x());
        load.tension_radial += triangle.volume * along(stress, radial);  // volume: area times thickness
        load.tension_circular += triangle.volume * along(stress, circular);
        area += triangle.volume / own.thickness[at(t)];
    }
    load.tension_radial /= area;
    load.tension_circular /= area;
    return load;
}

}  // namespace rhexis::scenes
