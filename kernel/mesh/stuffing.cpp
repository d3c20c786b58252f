// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/stuffing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mesh/quality.hpp"

namespace rhexis {

namespace {

// How close to a lattice point a crossing must lie to pull the point onto the surface, as a share of the edge, for the
// lattice's long (cubic) and short (diagonal) edges: the pair of [Labelle2007] table 1 that gives the best angles.
constexpr double snap_long = 0.24999;
constexpr double snap_short = 0.41189;

using Tet = std::array<int, 4>;
using Edge = std::pair<int, int>;

Edge edge_of(int a, int b) { return a < b ? Edge{a, b} : Edge{b, a}; }

/// The lattice around the shape: points, what side they are on, and its tetrahedra near or inside the shape.
struct Lattice {
    std::vector<Vec3> points;
    std::vector<int> side;  ///< -1 inside, 0 on the surface, +1 outside
    std::vector<Tet> tets;
};

struct Box {
    std::array<int, 3> count{};
    Vec3 low = Vec3::Zero();

    [[nodiscard]] int corner(int i, int j, int k) const { return 2 * (i + count[0] * (j + count[1] * k)); }
    [[nodiscard]] int centre(int i, int j, int k) const { return corner(i, j, k) + 1; }
};

Box box_around(const HalfEllipsoids& shape, double spacing, const Vec3& offset) {
    const Vec3 low(-shape.radius, -shape.radius, -shape.posterior);
    const Vec3 high(shape.radius, shape.radius, shape.anterior);
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const double first = std::floor(low[axis] / spacing - offset[axis]) - 1.0;
        const double last = std::ceil(high[axis] / spacing - offset[axis]) + 1.0;
        box.low[axis] = (first + offset[axis]) * spacing;
        box.count[static_cast<std::size_t>(axis)] = static_cast<int>(last - first) + 1;
    }
    return box;
}

void add_points(const HalfEllipsoids& shape, double spacing, const Box& box, Lattice& lattice) {
    for (int k = 0; k < box.count[2]; ++k) {
        for (int j = 0; j < box.count[1]; ++j) {
            for (int i = 0; i < box.count[0]; ++i) {
                const Vec3 corner = box.low + spacing * Vec3(i, j, k);
                lattice.points.push_back(corner);
                lattice.points.push_back(corner + Vec3::Constant(0.5 * spacing));
            }
        }
    }
    for (const Vec3& point : lattice.points) {
        const double level = surface_level(shape, point);
        lattice.side.push_back(level < 1.0 ? -1 : level > 1.0 ? 1 : 0);
    }
}

/// The four tetrahedra around the axis that joins two neighbouring cube centres across a square of corners.
void add_tets_around(int centre_a, int centre_b, const std::array<int, 4>& square, Lattice& lattice) {
    for (std::size_t s = 0; s < 4; ++s) {
        const Tet tet{centre_a, centre_b, square[s], square[(s + 1) % 4]};
        const bool inside = std::any_of(tet.begin(), tet.end(),
                                        [&lattice](int n) { return lattice.side[static_cast<std::size_t>(n)] < 0; });
        if (inside) {
            lattice.tets.push_back(tet);
        }
    }
}

Lattice make_lattice(const HalfEllipsoids& shape, double spacing, const Vec3& offset) {
    const Box box = box_around(shape, spacing, offset);
    Lattice lattice;
    add_points(shape, spacing, box, lattice);
    for (int k = 0; k + 1 < box.count[2]; ++k) {
        for (int j = 0; j + 1 < box.count[1]; ++j) {
            for (int i = 0; i + 1 < box.count[0]; ++i) {
                const int here = box.centre(i, j, k);
                add_tets_around(here, box.centre(i + 1, j, k),
                                {box.corner(i + 1, j, k), box.corner(i + 1, j + 1, k), box.corner(i + 1, j + 1, k + 1),
                                 box.corner(i + 1, j, k + 1)},
                                lattice);
                add_tets_around(here, box.centre(i, j + 1, k),
                                {box.corner(i, j + 1, k), box.corner(i, j + 1, k + 1), box.corner(i + 1, j + 1, k + 1),
                                 box.corner(i + 1, j + 1, k)},
                                lattice);
                add_tets_around(here, box.centre(i, j, k + 1),
                                {box.corner(i, j, k + 1), box.corner(i + 1, j, k + 1), box.corner(i + 1, j + 1, k + 1),
                                 box.corner(i, j + 1, k + 1)},
                                lattice);
            }
        }
    }
    return lattice;
}

/// Where the segment from `inside` to `outside` leaves the shape: bisection, then exactly onto the surface.
Vec3 crossing(const HalfEllipsoids& shape, const Vec3& inside, const Vec3& outside) {
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        (surface_level(shape, inside + middle * (outside - inside)) < 1.0 ? low : high) = middle;
    }
    return onto_surface(shape, inside + low * (outside - inside));
}

/// A crossing of a lattice edge with the surface.
struct Cut {
    Vec3 point = Vec3::Zero();
    int node = -1;             ///< of the mesh being made
    double inside_length = 0;  ///< from the inner end [mm]
};
using Cuts = std::map<Edge, Cut>;

Cuts find_cuts(const HalfEllipsoids& shape, const Lattice& lattice) {
    Cuts cuts;
    for (const Tet& tet : lattice.tets) {
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                const std::size_t a = static_cast<std::size_t>(tet[i]);
                const std::size_t b = static_cast<std::size_t>(tet[j]);
                if (lattice.side[a] < 0 && lattice.side[b] > 0) {
                    const auto [place, is_new] = cuts.try_emplace(edge_of(tet[i], tet[j]));
                    if (is_new) {
                        place->second.point = crossing(shape, lattice.points[a], lattice.points[b]);
                        place->second.inside_length = (place->second.point - lattice.points[a]).norm();
                    }
                }
            }
        }
    }
    return cuts;
}

/// Moves lattice points that are too close to a crossing onto the nearest one.
void snap_points(const Cuts& cuts, double spacing, Lattice& lattice) {
    std::vector<double> nearest(lattice.points.size(), 1e300);
    std::vector<Vec3> target(lattice.points.size());
    for (const auto& [edge, cut] : cuts) {
        const bool is_long = (edge.first % 2) == (edge.second % 2);
        const double reach = spacing * (is_long ? snap_long : snap_short * std::sqrt(0.75));
        for (int end : {edge.first, edge.second}) {
            const std::size_t n = static_cast<std::size_t>(end);
            const double distance = (cut.point - lattice.points[n]).norm();
            if (distance < reach && distance < nearest[n]) {
                nearest[n] = distance;
                target[n] = cut.point;
            }
        }
    }
    for (std::size_t n = 0; n < nearest.size(); ++n) {
        if (nearest[n] < 1e300) {
            lattice.points[n] = target[n];
            lattice.side[n] = 0;
        }
    }
}

/// Makes the mesh from the lattice: whole tetrahedra inside, the inner part of those that straddle the surface.
class Clipper {
public:
    Clipper(const Lattice& lattice, Cuts& cuts) : lattice_(lattice), cuts_(cuts), node_(lattice.points.size(), -1) {}

    StuffedSolid run() {
        for (const Tet& tet : lattice_.tets) {
            clip(tet);
        }
        solid_.mesh.region.assign(solid_.mesh.tets.size(), 0);
        return std::move(solid_);
    }

private:
    [[nodiscard]] int side(int point) const { return lattice_.side[static_cast<std::size_t>(point)]; }

    int add_node(const Vec3& at, bool surface) {
        solid_.mesh.nodes.push_back(at);
        solid_.on_surface.push_back(surface ? 1 : 0);
        return static_cast<int>(solid_.mesh.nodes.size()) - 1;
    }

    int point_node(int point) {
        int& node = node_[static_cast<std::size_t>(point)];
        if (node < 0) {
            node = add_node(lattice_.points[static_cast<std::size_t>(point)], side(point) == 0);
        }
        return node;
    }

    int cut_node(int inside, int outside) {
        Cut& cut = cuts_.at(edge_of(inside, outside));
        if (cut.node < 0) {
            cut.node = add_node(cut.point, true);
        }
        return cut.node;
    }

    /// True if, of two cut edges to the same outer point, the diagonal of the quadrilateral between them starts at the
    /// inner end a (and ends on the cut of b). Both tetrahedra at that quadrilateral must answer alike.
    [[nodiscard]] bool diagonal_from_first(int a, int b, int outside) const {
        const double of_a = cuts_.at(edge_of(a, outside)).inside_length;
        const double of_b = cuts_.at(edge_of(b, outside)).inside_length;
        return of_a != of_b ? of_a < of_b : a < b;
    }

    void emit(int a, int b, int c, int d) {
        const std::vector<Vec3>& x = solid_.mesh.nodes;
        const std::array<std::size_t, 4> n{static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                                           static_cast<std::size_t>(c), static_cast<std::size_t>(d)};
        const bool positive = tet_volume(x[n[0]], x[n[1]], x[n[2]], x[n[3]]) > 0.0;
        solid_.mesh.tets.push_back(positive ? Tet{a, b, c, d} : Tet{a, b, d, c});
    }

    /// The prism between triangles v and w; the diagonal of each side goes from v of the corner that comes first in
    /// `order` to w of the other.
    static std::array<Tet, 3> cut_prism(const std::array<int, 3>& v, const std::array<int, 3>& w,
                                        const std::array<std::size_t, 3>& order) {
        const auto [p, q, r] = order;
        return {{{v[p], v[q], v[r], w[r]}, {v[p], v[q], w[q], w[r]}, {v[p], w[p], w[q], w[r]}}};
    }

    void emit_prism(const std::array<int, 3>& v, const std::array<int, 3>& w, const std::array<std::size_t, 3>& order) {
        for (const Tet& tet : cut_prism(v, w, order)) {
            emit(tet[0], tet[1], tet[2], tet[3]);
        }
    }

    [[nodiscard]] double worst_ratio(const std::array<Tet, 3>& tets) const {
        double worst = 1.0;
        for (const Tet& tet : tets) {
            std::array<Vec3, 4> x;
            for (std::size_t k = 0; k < 4; ++k) {
                x[k] = solid_.mesh.nodes[static_cast<std::size_t>(tet[k])];
            }
            worst = std::min(worst, std::abs(radius_ratio(x[0], x[1], x[2], x[3])));
        }
        return worst;
    }

    /// Three points inside, one outside: what is left is a prism.
    void clip_one_off(std::array<int, 3> in, int out) {
        std::sort(in.begin(), in.end(), [this, out](int a, int b) { return diagonal_from_first(a, b, out); });
        std::array<int, 3> v{};
        std::array<int, 3> w{};
        for (std::size_t i = 0; i < 3; ++i) {
            v[i] = point_node(in[i]);
            w[i] = cut_node(in[i], out);
        }
        emit_prism(v, w, {0, 1, 2});
    }

    /// Two inside (a, b), two outside (c, d): a prism whose ends are the corners at a and b. The side on the surface
    /// belongs to no other tetrahedron, so its diagonal is free where the other two leave a choice.
    void clip_two_off(int a, int b, int c, int d) {
        const std::array<int, 3> v{point_node(a), cut_node(a, c), cut_node(a, d)};
        const std::array<int, 3> w{point_node(b), cut_node(b, c), cut_node(b, d)};
        const bool first_c = diagonal_from_first(a, b, c);
        const bool first_d = diagonal_from_first(a, b, d);
        if (first_c != first_d) {
            emit_prism(v, w, first_c ? std::array<std::size_t, 3>{2, 0, 1} : std::array<std::size_t, 3>{1, 0, 2});
            return;
        }
        const std::array<std::size_t, 3> one =
            first_c ? std::array<std::size_t, 3>{0, 1, 2} : std::array<std::size_t, 3>{1, 2, 0};
        const std::array<std::size_t, 3> other =
            first_c ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{2, 1, 0};
        const bool better = worst_ratio(cut_prism(v, w, other)) > worst_ratio(cut_prism(v, w, one));
        emit_prism(v, w, better ? other : one);
    }

    /// Two inside (a, b), one on the surface, one outside: a pyramid over the quadrilateral between the cuts.
    void clip_beside_surface(int a, int b, int on, int out) {
        const bool from_a = diagonal_from_first(a, b, out);
        const int first = point_node(from_a ? a : b);
        const int second = point_node(from_a ? b : a);
        const int first_cut = cut_node(from_a ? a : b, out);
        const int second_cut = cut_node(from_a ? b : a, out);
        const int apex = point_node(on);
        emit(first, second, second_cut, apex);
        emit(first, second_cut, first_cut, apex);
    }

    void clip(const Tet& tet) {
        std::array<std::vector<int>, 3> by_side;
        for (int point : tet) {
            by_side[static_cast<std::size_t>(side(point) + 1)].push_back(point);
        }
        const auto& [in, on, out] = by_side;
        if (in.empty()) {
            return;
        }
        if (out.empty()) {
            emit(point_node(tet[0]), point_node(tet[1]), point_node(tet[2]), point_node(tet[3]));
        } else if (in.size() == 3) {
            clip_one_off({in[0], in[1], in[2]}, out[0]);
        } else if (in.size() == 2 && on.empty()) {
            clip_two_off(in[0], in[1], out[0], out[1]);
        } else if (in.size() == 2) {
            clip_beside_surface(in[0], in[1], on[0], out[0]);
        } else {
            Tet nodes{};
            for (std::size_t k = 0; k < 4; ++k) {
                nodes[k] = side(tet[k]) > 0 ? cut_node(in[0], tet[k]) : point_node(tet[k]);
            }
            emit(nodes[0], nodes[1], nodes[2], nodes[3]);
        }
    }

    const Lattice& lattice_;
    Cuts& cuts_;
    std::vector<int> node_;  ///< of each lattice point; -1 until used
    StuffedSolid solid_;
};

}  // namespace

StuffedSolid stuff(const HalfEllipsoids& shape, double spacing, const Vec3& offset) {
    Lattice lattice = make_lattice(shape, spacing, offset);
    Cuts cuts = find_cuts(shape, lattice);
    snap_points(cuts, spacing, lattice);
    return Clipper(lattice, cuts).run();
}

}  // namespace rhexis
