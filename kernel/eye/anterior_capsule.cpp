// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/anterior_capsule.hpp"

#include <array>
#include <cmath>

#include "base/assert.hpp"
#include "base/index.hpp"
#include "eye/anatomy.hpp"
#include "eye/capsular_bag.hpp"
#include "eye/posterior_capsule.hpp"
#include "eye/table.hpp"
#include "eye/tissue_numbers.hpp"
#include "mesh/shapes.hpp"

namespace rhexis {
namespace {

constexpr double extent = 0.9;            ///< of the sheet, share of the equator's radius: beyond, it bends back
constexpr double jitter = 0.2;            ///< of the nodes, share of an edge
constexpr double settling = 0.02;         ///< time in which lens and capsule come to rest [s]
constexpr double layer_distance = 0.02;   ///< about its thickness, and less than its nodes sink in under a tool [mm]
constexpr double insertion_width = 0.25;  ///< of the ring in which the zonules insert, each way [mm]

double across(const Vec3& place) { return std::sqrt(place.x() * place.x() + place.y() * place.y()); }

TriMesh cap(const HalfEllipsoids& lens, const AnteriorCapsuleSettings& settings) {
    // rings of nodes would lead a tear round
    TriMesh mesh = jittered(round_sheet(extent * lens.radius, settings.triangles), jitter, settings.mesh_seed);
    for (Vec3& node : mesh.nodes) {
        node.z() = anterior_z(lens, across(node));
    }
    return mesh;
}

MembraneSheet sheet_of(const HalfEllipsoids& lens, double age, const AnteriorCapsuleSettings& settings) {
    MembraneSheet sheet = uniform_sheet(cap(lens, settings), Vec3::UnitX(), capsule_at_equator);
    for (int t = 0; t < static_cast<int>(sheet.fibre.size()); ++t) {
        const Vec3 middle = triangle_middle(sheet.mesh, t);
        sheet.thickness[at(t)] = anterior_thickness(age, across(middle), lens.radius);
        const Vec3 round = Vec3::UnitZ().cross(middle);
        if (settings.circles && round.norm() > 1e-9) {
            const Vec3 front = front_of(sheet.mesh, t);
            sheet.fibre[at(t)] = (round - round.dot(front) * front).normalized();
        }
    }
    return sheet;
}

/// The sheet's rim hangs on the capsule that goes on beyond it and lies on the lens. Returns how stiffly, in all.
double hang_on_lens(const std::vector<int>& rim, double age, double equator, MembraneModel& model) {
    const std::vector<Vec3>& nodes = model.sheet->mesh.nodes;
    double sum = 0.0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
        const Vec3& node = nodes[at(rim[i])];
        const Vec3& next = nodes[at(rim[(i + 1) % rim.size()])];  // round sheets number their rim in turn, evenly
        const double thickness = anterior_thickness(age, across(node), equator);
        const double stiffness = capsule_modulus(age) * thickness / capsule_beyond_sheet * (next - node).norm();
        model.springs.push_back({rim[i], node, stiffness, 0.0, true});
        sum += stiffness;
    }
    return sum;
}

/// Springs that together are as stiff as those of the bag's zonules on one side of it, and the rest of the bag.
/// tension: of the anterior zonules, share of the standard one.
void hang(const BagModel& bag, double age, double tension, MembraneModel& model) {
    const TriMesh& mesh = model.sheet->mesh;
    const std::vector<std::uint8_t> edge = on_boundary(mesh, model.sheet->neighbours);
    double anterior = 0.0;
    double posterior = 0.0;
    RHEXIS_ASSERT(!bag.zonules.empty());
    const ZonuleSpring* inserted = bag.zonules.data();
    for (const ZonuleSpring& zonule : bag.zonules) {
        const bool front = zonule.on_bag.z() > 0.0;
        (front ? anterior : posterior) += zonule.stiffness;
        inserted = front ? &zonule : inserted;
    }
    std::vector<int> insertion;
    std::vector<int> rim;
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
        if (edge[at(node)] != 0) {
            rim.push_back(node);
        } else if (std::abs(across(mesh.nodes[at(node)]) - across(inserted->on_bag)) < insertion_width) {
            insertion.push_back(node);
        }
    }
    double drawn_back = 0.0;  // the vitreous bears what the zonules pull the lens back with
    for (const int node : insertion) {
        const Vec3 anchor = ciliary_place(mesh.nodes[at(node)], *inserted);
        const double length = (anchor - mesh.nodes[at(node)]).norm();
        const double stretch = std::min(length, tension * zonule_stretch);
        const double stiffness = anterior / static_cast<double>(insertion.size());
        model.springs.push_back({node, anchor, stiffness, length - stretch});
        drawn_back += stiffness * stretch * (mesh.nodes[at(node)].z() - anchor.z()) / length;
    }
    for (const int node : rim) {
        model.springs.push_back({node, mesh.nodes[at(node)], posterior / static_cast<double>(rim.size()), 0.0});
    }
    model.support->stiffness = vitreous_stiffness;
    model.support->slack_lift = drawn_back / vitreous_stiffness;
    const double on_lens = hang_on_lens(rim, age, model.support->shape.radius, model);
    model.support->damping = settling * (vitreous_stiffness + anterior + posterior + on_lens);
}

}  // namespace

double anterior_thickness(double age, double rho, double equator) {
    const std::array<TableRow, 3> rows{{{0.0, linear_between(capsule_thickness_pole, age)},
                                        {capsule_thickest_at * equator, linear_between(capsule_thickness_middle, age)},
                                        {equator, capsule_at_equator}}};
    return linear_between(rows, rho);
}

MembraneModel make_anterior_capsule(const HalfEllipsoids& lens, const BagModel& bag, double age,
                                    const AnteriorCapsuleSettings& settings) {
    const double modulus = capsule_modulus(age);
    MembraneModel model;
    model.buoyancy_density = model.density;  // it floats
    model.name = anterior_capsule_name;
    model.sheet = std::make_shared<const MembraneSheet>(sheet_of(lens, age, settings));
    model.material = settings.circles ? Orthotropic{modulus, capsule_across_share * modulus, capsule_poisson_ratio, 0.0}
                                      : isotropic(modulus, capsule_poisson_ratio);
    const double toughness = settings.toughness * capsule_toughness;
    model.toughness = {toughness, settings.circles ? capsule_fibre_toughness * toughness : toughness};
    model.piercing = capsule_piercing_force / capsule_piercing_thickness;
    model.damping_mass = viscoelastic_drag;
    model.support = SupportModel{{lens.radius, lens.anterior, lens.posterior}, 0.05, 0.0, 0.0, 0.0};
    model.layer_distance = layer_distance;
    hang(bag, age, settings.zonule_tension, model);
    return model;
}

}  // namespace rhexis
