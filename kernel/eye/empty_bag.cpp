// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/empty_bag.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "base/index.hpp"
#include "base/numbers.hpp"
#include "base/ranges.hpp"
#include "eye/anatomy.hpp"
#include "eye/anterior_capsule.hpp"
#include "eye/capsular_bag.hpp"
#include "eye/posterior_capsule.hpp"
#include "eye/table.hpp"
#include "eye/tissue_numbers.hpp"
#include "math/turn.hpp"
#include "mesh/shapes.hpp"

namespace rhexis {
namespace {

double from_axis(const Vec3& place) { return std::sqrt(place.x() * place.x() + place.y() * place.y()); }

/// A quarter of an ellipse from the equator to a pole, by length.
class Meridian {
public:
    /// pole: its distance from the equatorial plane, negative for the posterior one.
    Meridian(double radius, double pole) {
        constexpr int pieces = 400;
        for (int i = 0; i <= pieces; ++i) {
            const double u = static_cast<double>(i) / pieces;
            const Vec2 place(radius * (1.0 - u * u) / (1.0 + u * u), pole * 2.0 * u / (1.0 + u * u));
            along_.push_back(places_.empty() ? 0.0 : along_.back() + (place - places_.back()).norm());
            places_.push_back(place);
        }
    }
    /// Distance from the axis and height, at a length from the equator.
    [[nodiscard]] Vec2 at_length(double length) const {
        const auto next = std::upper_bound(along_.begin() + 1, along_.end() - 1, length);
        const std::size_t i = static_cast<std::size_t>(next - along_.begin());
        const double share = std::clamp((length - along_[i - 1]) / (along_[i] - along_[i - 1]), 0.0, 1.0);
        return places_[i - 1] + share * (places_[i] - places_[i - 1]);
    }
    /// Length from the equator to where it comes as near to the axis.
    [[nodiscard]] double length_to(double distance) const {
        std::size_t i = 1;
        while (i + 1 < places_.size() && places_[i].x() > distance) {
            ++i;
        }
        const double share = (places_[i - 1].x() - distance) / (places_[i - 1].x() - places_[i].x());
        return along_[i - 1] + share * (along_[i] - along_[i - 1]);
    }
    [[nodiscard]] double length() const { return along_.back(); }

private:
    std::vector<Vec2> places_;
    std::vector<double> along_;
};

/// Of the opening's edge in a direction from the axis, without trigonometry: linear between the rays of its points.
double opening_at(const EmptyBagSettings& settings, const Vec3& direction) {
    const std::size_t count = settings.opening.size();
    if (count == 0) {
        return settings.opening_radius;
    }
    const auto left_of = [](const Vec2& ray, const Vec2& d) { return ray.x() * d.y() - ray.y() * d.x(); };
    const double each = 2.0 * std::numbers::pi / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 ray = direction_at(each * static_cast<double>(i));
        const double from = left_of(ray, direction.head<2>());
        const double to = left_of(direction.head<2>(), direction_at(each * static_cast<double>(i + 1)));
        if (from >= 0.0 && to > 0.0 && ray.dot(direction.head<2>()) > 0.0) {
            const double share = from / (from + to);
            return (1.0 - share) * settings.opening[i] + share * settings.opening[(i + 1) % count];
        }
    }
    return settings.opening.front();
}

double mean_opening(const EmptyBagSettings& settings) {
    double sum = 0.0;
    for (const double radius : settings.opening) {
        sum += radius;
    }
    return settings.opening.empty() ? settings.opening_radius : sum / static_cast<double>(settings.opening.size());
}

/// Rings of a round sheet: ring k has 6 k nodes, the first of them 1 + 3 k (k - 1).
int first_of(int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); }

/// Rings of the posterior capsule, pole to equator, and of the anterior one, opening to equator.
struct Rings {
    int posterior = 0;
    int opening = 0;  ///< the ring that is the opening's edge
};

Rings rings_for(const HalfEllipsoids& lens, const EmptyBagSettings& settings) {
    const double posterior = Meridian(lens.radius, -lens.posterior).length();
    const double anterior = Meridian(lens.radius, lens.anterior).length_to(mean_opening(settings));
    // 6 n^2 triangles behind; before it those but for the 6 m^2 within the opening, where n - m rings have the spacing
    // of the others
    const double share = std::clamp(anterior / posterior, 0.0, 0.9);
    const double both = 2.0 - (1.0 - share) * (1.0 - share);
    Rings rings;
    rings.posterior = std::max(5, static_cast<int>(std::lround(std::sqrt(settings.triangles / (6.0 * both)))));
    rings.opening = std::max(3, rings.posterior - std::max(2, static_cast<int>(std::lround(share * rings.posterior))));
    return rings;
}

/// The posterior capsule with the equator, then the anterior one.
TriMesh bag_mesh(const HalfEllipsoids& lens, const EmptyBagSettings& settings) {
    const Meridian behind(lens.radius, -lens.posterior);
    const Meridian before(lens.radius, lens.anterior);
    const Rings rings = rings_for(lens, settings);
    const int n = rings.posterior;
    const TriMesh flat = round_sheet(1.0, 6 * n * n);
    TriMesh mesh;
    for (int ring = 0; ring <= n; ++ring) {
        const Vec2 place = behind.at_length(behind.length() * (n - ring) / n);
        for (int i = first_of(ring); i < first_of(ring + 1); ++i) {
            const Vec3 out = ring == 0 ? Vec3(Vec3::Zero()) : flat.nodes[at(i)].normalized();
            mesh.nodes.push_back(place.x() * out + place.y() * Vec3::UnitZ());
        }
    }
    const auto anterior = [&](int node) {  // its number there, of the same place in the flat sheet
        return node >= first_of(n) ? node : first_of(n + 1) + node - first_of(rings.opening);
    };
    for (int ring = rings.opening; ring < n; ++ring) {
        for (int i = first_of(ring); i < first_of(ring + 1); ++i) {
            const Vec3 out = flat.nodes[at(i)].normalized();
            const double length = before.length_to(opening_at(settings, out));
            const Vec2 place = before.at_length(length * (n - ring) / (n - rings.opening));
            mesh.nodes.push_back(place.x() * out + place.y() * Vec3::UnitZ());
        }
    }
    for (const std::array<int, 3>& t : flat.triangles) {
        mesh.triangles.push_back({t[0], t[2], t[1]});
    }
    for (const std::array<int, 3>& t : flat.triangles) {
        if (*std::min_element(t.begin(), t.end()) >= first_of(rings.opening)) {
            mesh.triangles.push_back({anterior(t[0]), anterior(t[1]), anterior(t[2])});
        }
    }
    return mesh;
}

double thickness_at(const HalfEllipsoids& lens, double age, const Vec3& place) {
    const double rho = from_axis(place);
    if (place.z() > 0.0) {
        return anterior_thickness(age, rho, lens.radius);
    }
    return posterior_pole_thickness +
           (capsule_at_equator - posterior_pole_thickness) * std::min(1.0, rho / lens.radius);
}

Vec3 direction_in(const TriMesh& mesh, int triangle) {
    const std::array<int, 3>& n = mesh.triangles[at(triangle)];
    return (mesh.nodes[at(n[1])] - mesh.nodes[at(n[0])]).normalized();
}

MembraneSheet sheet_of(const HalfEllipsoids& lens, double age, const EmptyBagSettings& settings) {
    MembraneSheet sheet;
    sheet.mesh = bag_mesh(lens, settings);
    sheet.neighbours = tri_neighbours(sheet.mesh);
    for (int node = 0; node < static_cast<int>(sheet.mesh.nodes.size()); ++node) {
        sheet.origin.push_back(node);
    }
    for (int t = 0; t < static_cast<int>(sheet.mesh.triangles.size()); ++t) {
        sheet.fibre.push_back(direction_in(sheet.mesh, t));
        sheet.thickness.push_back(thickness_at(lens, age, triangle_middle(sheet.mesh, t)));
        sheet.stiffness.push_back(1.0);
    }
    return sheet;
}

/// Nodes of the ring of one side that is nearest to where zonules insert, in the mean of its nodes: those before the
/// equator follow the opening's edge.
std::vector<int> insertion(const TriMesh& mesh, const Rings& rings, bool front, double rho) {
    const int before = front ? first_of(rings.posterior + 1) - first_of(rings.opening) : 0;  // as in bag_mesh
    double least = HUGE_VAL;
    std::vector<int> nearest;
    for (int ring = front ? rings.opening : 0; ring < rings.posterior; ++ring) {
        const int first = before + first_of(ring);
        const int count = first_of(ring + 1) - first_of(ring);
        double off = 0.0;
        for (int i = 0; i < count; ++i) {
            off += std::abs(from_axis(mesh.nodes[at(first + i)]) - rho) / count;
        }
        if (off < least) {
            least = off;
            nearest.resize(at(count));
            std::iota(nearest.begin(), nearest.end(), first);
        }
    }
    return nearest;
}

void hang(const BagModel& bag, const Rings& rings, MembraneModel& model) {
    const TriMesh& mesh = model.sheet->mesh;
    for (const bool front : {true, false}) {
        double stiffness = 0.0;
        const ZonuleSpring* inserted = nullptr;
        for (const ZonuleSpring& zonule : bag.zonules) {
            if ((zonule.on_bag.z() > 0.0) == front) {
                stiffness += zonule.stiffness;
                inserted = &zonule;
            }
        }
        if (inserted == nullptr) {
            continue;  // no zonules there
        }
        const std::vector<int> ring = insertion(mesh, rings, front, from_axis(inserted->on_bag));
        for (const int node : ring) {
            const Vec3& place = mesh.nodes[at(node)];
            const Vec3 anchor = ciliary_place(place, *inserted);
            model.springs.push_back({node, anchor, stiffness / static_cast<double>(ring.size()),
                                     std::max(0.0, (anchor - place).norm() - zonule_stretch_hollow)});
        }
    }
}

/// The vitreous behind: each node of the posterior capsule on a bed of its share of the area.
void lay_on_vitreous(MembraneModel& model) {
    const TriMesh& mesh = model.sheet->mesh;
    std::vector<double> area(mesh.nodes.size(), 0.0);
    for (const std::array<int, 3>& t : mesh.triangles) {
        const double third = triangle_area(mesh.nodes[at(t[0])], mesh.nodes[at(t[1])], mesh.nodes[at(t[2])]) / 3.0;
        for (const int node : t) {
            area[at(node)] += third;
        }
    }
    for (int node = 0; node < static_cast<int>(mesh.nodes.size()); ++node) {
        if (mesh.nodes[at(node)].z() < -1e-9) {
            model.springs.push_back({node, mesh.nodes[at(node)], vitreous_bed * area[at(node)], 0.0});
        }
    }
}

}  // namespace

Status check_opening(const std::vector<double>& opening) {
    constexpr double most_change = 1.0;  // beyond, triangles would be thin
    for (std::size_t i = 0; i < opening.size(); ++i) {
        const std::string name = "radius " + std::to_string(i) + " of the opening";
        if (Status status = check_range(name, opening[i], 1.0, 4.0, "bag", " mm"); !status) {
            return status;
        }
    }
    for (std::size_t i = 0; i < opening.size(); ++i) {
        const double change = std::abs(opening[(i + 1) % opening.size()] - opening[i]);
        if (change > most_change) {
            return Error{
                "the edge of the opening jumps by " + short_number(change) + " mm beside radius " + std::to_string(i),
                "bag", "at most " + short_number(most_change) + " mm"};
        }
    }
    const double count = static_cast<double>(opening.size());
    return opening.empty() ? success() : check_range("number of radii of the opening", count, 16.0, 1024.0, "bag");
}

Status check_empty_bag(const EmptyBagSettings& settings) {
    if (Status status = check_opening(settings.opening); !status) {
        return status;
    }
    return check_ranges({{"triangles", static_cast<double>(settings.triangles), 300.0, 8000.0, ""},
                         {"opening_radius", settings.opening_radius, 1.0, 4.0, " mm"},
                         {"rim_strength", settings.rim_strength, 0.1, 2.0, ""},
                         {"friction", settings.friction, 0.0, 10.0, ""}},
                        "bag");
}

MembraneModel make_empty_bag(const HalfEllipsoids& lens, const BagModel& bag, double age,
                             const EmptyBagSettings& settings) {
    MembraneModel model;
    model.buoyancy_density = model.density;  // it floats
    model.name = empty_bag_name;
    model.sheet = std::make_shared<const MembraneSheet>(sheet_of(lens, age, settings));
    model.material = isotropic(capsule_modulus(age), capsule_poisson_ratio);
    model.toughness = {capsule_toughness, capsule_toughness};
    model.piercing = capsule_piercing_force / capsule_piercing_thickness;
    model.damping_mass = viscoelastic_drag;
    model.shell_friction = settings.friction;
    model.rupture_stretch = 1.0 + settings.rim_strength * capsule_rupture_strain;
    hang(bag, rings_for(lens, settings), model);
    lay_on_vitreous(model);
    return model;
}

}  // namespace rhexis
