// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/make_eye.hpp"

#include "eye/anatomy.hpp"
#include "eye/capsular_bag.hpp"
#include "eye/patient.hpp"
#include "eye/tissue.hpp"
#include "mesh/places.hpp"
#include "mesh/shapes.hpp"

namespace rhexis {

namespace {

// Rayleigh damping of the lens. On its mass: the fluid and viscoelastic around it; free motion decays in 0.1 s. On its
// stiffness: viscosity of the tissue; kept to 1e-5 s, because an explicit step shrinks by sqrt(1 + z^2) - z with z =
// damping_stiffness / stable step: by 3 % at the 0.3 ms that are sought, but by 28 % with 1e-4 s.
constexpr double damping_mass = 20.0;
constexpr double damping_stiffness = 1e-5;

constexpr double aqueous_density = 1.0e-3;  ///< [g/mm^3]

SolidModel make_lens(const Patient& patient, const HalfEllipsoids& shape) {
    SolidModel lens;
    lens.name = "lens";
    lens.coarse = lens_body(shape, patient.tetrahedra);
    for (std::size_t t = 0; t < lens.coarse.tets.size(); ++t) {
        lens.coarse.region[t] = region_at(patient, shape, centroid(lens.coarse.nodes, lens.coarse.tets[t]));
    }
    lens.fine = subdivide(lens.coarse);
    lens.materials = lens_materials(patient);
    lens.damping_mass = damping_mass;
    lens.damping_stiffness = damping_stiffness;
    lens.buoyancy_density = aqueous_density;
    return lens;
}

}  // namespace

Result<EyeModel> make_eye(const Patient& patient, bool solid_lens) {
    if (const Status status = check(patient); !status.ok()) {
        return status.error();
    }
    const HalfEllipsoids shape = lens_shape(patient);
    EyeModel eye;
    eye.patient = patient;
    eye.anatomy = make_anatomy(patient);
    eye.anatomy.lens_zones = lens_zones(patient);
    double lens_mass = shape_volume(shape) * lens_materials(patient)[nucleus].density;
    if (solid_lens) {
        eye.lens = make_lens(patient, shape);
        lens_mass = remaining_mass(eye.lens, rest_state(eye.lens));
    }
    eye.bag = make_bag(shape, lens_mass, patient.age);
    return eye;
}

}  // namespace rhexis
