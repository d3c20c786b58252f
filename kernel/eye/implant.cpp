// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/implant.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/index.hpp"
#include "base/numbers.hpp"
#include "base/ranges.hpp"
#include "eye/implant_outline.hpp"

namespace rhexis {
namespace {

Vec3 in_plane(const Vec2& p) { return {p.x(), p.y(), 0.0}; }

/// A mesh that grows by rows of nodes.
struct Growing {
    TriMesh mesh;
    std::vector<ImplantPart> part;

    std::vector<int> add(const std::vector<Vec2>& row) {
        std::vector<int> nodes;
        for (const Vec2& p : row) {
            nodes.push_back(static_cast<int>(mesh.nodes.size()));
            mesh.nodes.push_back(in_plane(p));
        }
        return nodes;
    }

    [[nodiscard]] double distance2(int a, int b) const { return (mesh.nodes[at(a)] - mesh.nodes[at(b)]).squaredNorm(); }

    /// Triangles between two rows, the second on the left of the first's direction: always the shorter diagonal.
    void zip(const std::vector<int>& low, const std::vector<int>& high, ImplantPart of) {
        std::size_t i = 0;
        std::size_t j = 0;
        while (i + 1 < low.size() || j + 1 < high.size()) {
            const bool on_low = j + 1 == high.size() ||
                                (i + 1 < low.size() && distance2(low[i + 1], high[j]) < distance2(low[i], high[j + 1]));
            if (on_low) {
                mesh.triangles.push_back({low[i], low[i + 1], high[j]});
                ++i;
            } else {
                mesh.triangles.push_back({low[i], high[j + 1], high[j]});
                ++j;
            }
            part.push_back(of);
        }
    }
};

/// Of the upper half of a circle, from an angle over `span`: places spaced as wanted there, the end left out.
std::vector<Vec2> spaced_arc(const ImplantShape& shape, double radius, double from, double span, double scale) {
    constexpr int samples = 240;
    std::vector<double> filled{0.0};  // triangles' edges up to there
    for (int i = 0; i < samples; ++i) {
        const Vec2 place = radius * direction_at(from + span * (i + 0.5) / samples);
        filled.push_back(filled.back() + radius * span / samples / wanted_edge(shape, place, scale));
    }
    const int count = std::max(3, static_cast<int>(std::lround(filled.back())));
    std::vector<Vec2> places;
    int i = 1;
    for (int k = 0; k < count; ++k) {
        const double wanted = filled.back() * k / count;
        while (filled[at(i)] <= wanted) {
            ++i;
        }
        const double t = i - 1 + (wanted - filled[at(i - 1)]) / (filled[at(i)] - filled[at(i - 1)]);
        places.push_back(radius * direction_at(from + span * t / samples));
    }
    return places;
}

/// The same again half a turn further.
std::vector<Vec2> and_opposite(std::vector<Vec2> half) {
    const std::size_t count = half.size();
    for (std::size_t i = 0; i < count; ++i) {
        half.push_back(-half[i]);
    }
    return half;
}

int root_cells(const ImplantShape& shape, double scale) {
    const Vec2 root = 0.5 * shape.optic_diameter * direction_at(haptic_root);
    const double width = half_root(shape) * shape.optic_diameter;
    return std::max(2, static_cast<int>(std::lround(width / wanted_edge(shape, root, scale))));
}

/// The optic's rim: half of it begins with a root.
std::vector<Vec2> rim_places(const ImplantShape& shape, double scale) {
    const double radius = 0.5 * shape.optic_diameter;
    const double half = half_root(shape);
    const int cells = root_cells(shape, scale);
    std::vector<Vec2> places;
    for (int i = 0; i < cells; ++i) {
        places.push_back(radius * direction_at(haptic_root + half * (2.0 * i / cells - 1.0)));
    }
    const std::vector<Vec2> rest = spaced_arc(shape, radius, haptic_root + half, M_PI - 2.0 * half, scale);
    places.insert(places.end(), rest.begin(), rest.end());
    return and_opposite(std::move(places));
}

/// Radii of the rings inside the rim, from within.
std::vector<double> ring_radii(const ImplantShape& shape, double scale) {
    const double rim = 0.5 * shape.optic_diameter;
    const auto gap = [&](double radius) {
        double sum = 0.0;
        for (int i = 0; i < 48; ++i) {
            sum += wanted_edge(shape, radius * direction_at(M_PI * i / 48.0), scale) / 48.0;
        }
        return 0.866 * sum;  // height of an equilateral triangle over its edge
    };
    std::vector<double> radii{rim};
    while (radii.back() > 0.5 * gap(radii.back())) {
        radii.push_back(radii.back() - gap(radii.back()));
    }
    // all moved, so that what would be the last is the middle
    const double last = radii.back();
    radii.pop_back();
    std::vector<double> result;
    for (std::size_t k = radii.size() - 1; k > 0; --k) {
        result.push_back(radii[k] - last * (rim - radii[k]) / (rim - last));
    }
    return result;
}

/// Ring nodes from the one nearest to a place, and that one again at the end.
std::vector<int> closed_from(const Growing& mesh, const std::vector<int>& ring, int start) {
    std::size_t first = 0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        first = mesh.distance2(ring[i], start) < mesh.distance2(ring[first], start) ? i : first;
    }
    std::vector<int> result;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
        result.push_back(ring[(first + i) % ring.size()]);
    }
    return result;
}

/// Fills a ring of the optic, half and half so that both are the same. Rings run anticlockwise.
void zip_rings(Growing& mesh, const std::vector<int>& outer, const std::vector<int>& inner) {
    const std::vector<int> around = closed_from(mesh, outer, inner[0]);
    const std::vector<int> within = closed_from(mesh, inner, inner[0]);
    const std::size_t a = outer.size() / 2;
    const std::size_t b = inner.size() / 2;
    for (std::size_t half = 0; half < 2; ++half) {
        mesh.zip({around.begin() + static_cast<std::ptrdiff_t>(half * a),
                  around.begin() + static_cast<std::ptrdiff_t>((half + 1) * a + 1)},
                 {within.begin() + static_cast<std::ptrdiff_t>(half * b),
                  within.begin() + static_cast<std::ptrdiff_t>((half + 1) * b + 1)},
                 ImplantPart::optic);
    }
}

/// Returns the nodes of the rim.
std::vector<int> grow_optic(const ImplantShape& shape, double scale, Growing& mesh) {
    const std::vector<int> middle = mesh.add({Vec2::Zero()});
    std::vector<int> inner;
    for (const double radius : ring_radii(shape, scale)) {
        const std::vector<int> ring = mesh.add(and_opposite(spaced_arc(shape, radius, haptic_root, M_PI, scale)));
        if (inner.empty()) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                mesh.mesh.triangles.push_back({ring[i], ring[(i + 1) % ring.size()], middle[0]});
                mesh.part.push_back(ImplantPart::optic);
            }
        } else {
            zip_rings(mesh, ring, inner);
        }
        inner = ring;
    }
    std::vector<int> rim = mesh.add(rim_places(shape, scale));
    zip_rings(mesh, rim, inner);
    return rim;
}

/// side: 1 for the upper haptic, -1 for the lower. Returns the node at its tip.
int grow_haptic(const ImplantShape& shape, double scale, double side, const std::vector<int>& root, Growing& mesh) {
    const ImplantPart part = side > 0.0 ? ImplantPart::upper_haptic : ImplantPart::lower_haptic;
    std::vector<int> last(root.rbegin(), root.rend());  // from left to right of the way outwards
    for (const HapticSection& section : haptic_sections(shape, scale)) {
        const Vec2 left(-section.along.y(), section.along.x());
        const int cells = std::max(1, static_cast<int>(std::lround(section.width / section.edge)));
        std::vector<Vec2> row;
        for (int i = 0; i <= cells; ++i) {
            row.push_back(side * (section.middle + section.width * (0.5 - static_cast<double>(i) / cells) * left));
        }
        const std::vector<int> next = mesh.add(row);
        mesh.zip(last, next, part);
        last = next;
    }
    return last[last.size() / 2];
}

/// Moves nodes within to the middle of their neighbours, all at once.
void relax(int sweeps, TriMesh& mesh) {
    const TriNeighbours neighbours = tri_neighbours(mesh);
    const std::vector<std::uint8_t> edge = on_boundary(mesh, neighbours);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        std::vector<Vec3> sum(mesh.nodes.size(), Vec3::Zero());
        std::vector<int> count(mesh.nodes.size(), 0);
        for (const std::array<int, 3>& t : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                sum[at(t[k])] += mesh.nodes[at(t[(k + 1) % 3])] + mesh.nodes[at(t[(k + 2) % 3])];
                count[at(t[k])] += 2;
            }
        }
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            if (edge[n] == 0) {
                mesh.nodes[n] = 0.5 * (mesh.nodes[n] + sum[n] / count[n]);
            }
        }
    }
}

Implant grown(const ImplantShape& shape, double scale) {
    Growing mesh;
    Implant implant;
    const std::vector<int> rim = grow_optic(shape, scale, mesh);
    const std::size_t cells = at(root_cells(shape, scale));
    for (std::size_t side = 0; side < 2; ++side) {
        const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(side * rim.size() / 2);
        implant.root[side].assign(rim.begin() + first, rim.begin() + first + static_cast<std::ptrdiff_t>(cells + 1));
        implant.tip[side] = grow_haptic(shape, scale, side == 0 ? 1.0 : -1.0, implant.root[side], mesh);
    }
    relax(6, mesh.mesh);
    implant.part = std::move(mesh.part);
    implant.model.name = "implant";
    implant.model.mesh = std::move(mesh.mesh);
    return implant;
}

}  // namespace

double optic_thickness(const ImplantShape& shape, double distance) {
    const double share = 2.0 * distance / shape.optic_diameter;
    return shape.centre_thickness - (shape.centre_thickness - shape.edge_thickness) * std::min(share * share, 1.0);
}

Status check_implant(const ImplantShape& shape) {
    // room between the optic's rim and an arm for the haptic to turn
    const double least_overall = std::max(10.0, shape.optic_diameter + 2.0 * shape.haptic_width + 3.0);
    if (Status s = check_ranges({{"optic_diameter", shape.optic_diameter, 4.0, 7.5, " mm"},
                                 {"haptic_width", shape.haptic_width, 0.2, 0.8, " mm"},
                                 {"overall_diameter", shape.overall_diameter, least_overall, 14.0, " mm"},
                                 {"centre_thickness", shape.centre_thickness, 0.1, 2.0, " mm"},
                                 {"edge_thickness", shape.edge_thickness, 0.05, shape.centre_thickness, " mm"},
                                 {"haptic_thickness", shape.haptic_thickness, 0.05, 1.0, " mm"}},
                                "implant");
        !s) {
        return s;
    }
    return check_range("triangles", shape.triangles, 400, 8000, "implant");
}

Result<Implant> make_implant(const ImplantShape& shape) {
    if (Status status = check_implant(shape); !status) {
        return status.error();
    }
    // first near the number of triangles, then the scale about there that comes nearest: it jumps by whole rows
    double scale = 1.0;
    for (int attempt = 0; attempt < 4; ++attempt) {
        scale *= std::sqrt(static_cast<double>(grown(shape, scale).part.size()) / shape.triangles);
    }
    Implant best;
    int least = shape.triangles + 1;
    for (int k = -20; k <= 20; ++k) {
        Implant one = grown(shape, scale * (1.0 + 0.01 * k));
        const int off = std::abs(static_cast<int>(one.part.size()) - shape.triangles);
        if (off < least) {
            least = off;
            best = std::move(one);
        }
    }
    best.model.thickness.reserve(best.part.size());
    for (int t = 0; t < static_cast<int>(best.part.size()); ++t) {
        best.model.thickness.push_back(best.part[at(t)] == ImplantPart::optic
                                           ? optic_thickness(shape, triangle_middle(best.model.mesh, t).norm())
                                           : shape.haptic_thickness);
    }
    if (Status status = check_shell(best.model); !status) {
        return status.error();
    }
    return best;
}

namespace {

void put_in_water(const ImplantShape& shape, ShellModel& model) {
    constexpr double water_density = 1e-3;    // [g/mm^3]
    constexpr double water_viscosity = 1e-3;  // [Pa s]
    model.relaxation = ShellRelaxation{};
    model.fluid_density = water_density;
    model.drag = disc_drag(water_viscosity, 0.5 * shape.optic_diameter);
}

}  // namespace

ImplantParts implant_parts(const ImplantShape& shape) { return make_implant(shape).value(); }

ShellModel free_implant(const ImplantShape& shape) {
    ShellModel model = std::move(make_implant(shape).value().model);
    put_in_water(shape, model);
    return model;
}

ShellModel acrylic_implant(const ImplantShape& shape) {
    Implant implant = std::move(make_implant(shape)).value();
    ShellModel model = std::move(implant.model);
    put_in_water(shape, model);
    for (const int node : {std::min(implant.tip[0], implant.tip[1]), std::max(implant.tip[0], implant.tip[1])}) {
        model.holds.push_back({node, {true, true, true, true, true, true}});
    }
    return model;
}

}  // namespace rhexis
