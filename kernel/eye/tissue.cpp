// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/tissue.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "eye/table.hpp"

namespace rhexis {

namespace {

constexpr std::array<TableRow, 2> lens_modulus_by_age{{{20.0, 1000.0}, {60.0, 5000.0}}};
constexpr std::array<TableRow, 6> modulus_by_grade{
    {{1.0, 2000.0}, {2.0, 2000.0}, {3.0, 5000.0}, {4.0, 12000.0}, {5.0, 30000.0}, {6.0, 80000.0}}};

/// Proposal within the 1 to 2 kPa usually taken for cortex; grade does not change it.
constexpr std::array<TableRow, 2> cortex_modulus_by_age{{{20.0, 1000.0}, {60.0, 2000.0}}};

// Extinction of the nucleus [1/mm] for red, green and blue: proposal; grade 1 continues the slope from 2 to 4.
constexpr std::array<TableRow, 4> extinction_red{{{1.0, 0.029}, {2.0, 0.05}, {4.0, 0.15}, {6.0, 0.6}}};
constexpr std::array<TableRow, 4> extinction_green{{{1.0, 0.041}, {2.0, 0.08}, {4.0, 0.30}, {6.0, 1.2}}};
constexpr std::array<TableRow, 4> extinction_blue{{{1.0, 0.069}, {2.0, 0.15}, {4.0, 0.70}, {6.0, 3.0}}};

constexpr double epinucleus_extinction = 0.5;  ///< share of the nucleus's
constexpr double cortex_extinction = 0.25;
constexpr double white_extinction = 3.0;  ///< of the cortex of a white cataract, all colours alike [1/mm]: proposal

/// Of all lens tissue: nearly incompressible, but far enough from 0.5 for linear tetrahedra not to lock and for an
/// explicit step that is not much shorter than the one that is sought.
constexpr double poisson_ratio = 0.47;
constexpr double density = 1.05e-3;  ///< [g/mm^3]

/// Ultrasound energy to emulsify tissue [mJ/mm^3]: proposal, 30 at 5 kPa and growing with the root of the modulus, so
/// that grade 6 takes four times as much as grade 3. To be tuned with surgeons.
double ablation_energy(double young_modulus) { return 30.0 * std::sqrt(young_modulus / 5000.0); }

/// Energy per area of crack [uN/mm]: proposal, 0.2 J/m^2 at 5 kPa, growing with the root of the
/// modulus like the energy of ultrasound. Cortex is soft and tough.
double toughness(double young_modulus) { return 200.0 * std::sqrt(young_modulus / 5000.0); }

Material tissue(const char* name, double young_modulus, const Vec3& extinction) {
    Material material;
    material.name = name;
    material.young_modulus = young_modulus;
    material.poisson_ratio = poisson_ratio;
    material.density = density;
    material.ablation_energy = ablation_energy(young_modulus);
    material.toughness = toughness(young_modulus);
    material.extinction = extinction;
    return material;
}

}  // namespace

double nucleus_scale(const Patient& patient) { return 0.60 + 0.025 * patient.nuclear_grade; }

double epinucleus_scale(const Patient& patient) {
    // Midway between nucleus and capsule.
    return 0.5 * (1.0 + nucleus_scale(patient));
}

int region_at(const Patient& patient, const HalfEllipsoids& shape, const Vec3& point) {
    const double level = surface_level(shape, point);
    if (level < nucleus_scale(patient)) {
        return nucleus;
    }
    return level < epinucleus_scale(patient) ? epinucleus : cortex;
}

double nucleus_modulus(const Patient& patient) {
    return std::max(linear_between(lens_modulus_by_age, patient.age),
                    geometric_between(modulus_by_grade, patient.nuclear_grade));
}

std::vector<Material> lens_materials(const Patient& patient) {
    const double inner = nucleus_modulus(patient);
    const double outer = linear_between(cortex_modulus_by_age, patient.age);
    const double grade = patient.nuclear_grade;
    const Vec3 extinction(geometric_between(extinction_red, grade), geometric_between(extinction_green, grade),
                          geometric_between(extinction_blue, grade));
    const Vec3 haze = Vec3::Constant(patient.cortical_opacity * white_extinction);
    return {tissue("nucleus", inner, extinction),
            tissue("epinucleus", std::sqrt(inner * outer), epinucleus_extinction * extinction),
            tissue("cortex", outer, cortex_extinction * extinction + haze)};
}

std::array<LensZone, 3> lens_zones(const Patient& patient) {
    const std::vector<Material> materials = lens_materials(patient);
    return {LensZone{1.0, materials[cortex].extinction},
            LensZone{epinucleus_scale(patient), materials[epinucleus].extinction},
            LensZone{nucleus_scale(patient), materials[nucleus].extinction}};
}

}  // namespace rhexis
