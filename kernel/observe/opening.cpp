// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/opening.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "base/index.hpp"
#include "observe/ring_area.hpp"

namespace rhexis {
namespace {

/// A boundary of the sheet, or the stretch of one that follows a tear.
struct Stretch {
    std::vector<int> nodes;
    bool ring = true;  ///< the last node is beside the first
};

std::vector<Vec3> places_of(const TriMesh& mesh, const std::vector<int>& nodes) {
    std::vector<Vec3> places;
    for (const int node : nodes) {
        places.push_back(mesh.nodes[at(node)]);
    }
    return places;
}

double ring_length(const std::vector<Vec3>& places) {
    double sum = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        sum += (places[(i + 1) % places.size()] - places[i]).norm();
    }
    return sum;
}

double boundary_length(const TriMesh& mesh, const std::vector<std::vector<int>>& loops) {
    double sum = 0.0;
    for (const std::vector<int>& loop : loops) {
        sum += ring_length(places_of(mesh, loop));
    }
    return sum;
}

/// Which nodes were on the outer edge at the start. They keep their numbers.
std::vector<std::uint8_t> outer_nodes(const TriMesh& start, const std::vector<std::vector<int>>& loops, int nodes) {
    std::vector<std::uint8_t> outer(at(nodes), 0);
    double longest = 0.0;
    const std::vector<int>* edge = nullptr;
    for (const std::vector<int>& loop : loops) {
        const double length = ring_length(places_of(start, loop));
        if (length > longest) {
            longest = length;
            edge = &loop;
        }
    }
    if (edge != nullptr) {
        for (const int node : *edge) {
            outer[at(node)] = 1;
        }
    }
    return outer;
}

/// Per node: whether its part of the sheet has a node of the outer edge.
std::vector<std::uint8_t> attached_nodes(const MembraneSheet& sheet, const std::vector<std::uint8_t>& outer) {
    const std::vector<int> parts = sheet_parts(sheet.neighbours);
    const auto part_of = [&](std::size_t node) {
        return at(parts[at(sheet.neighbours.triangles[at(sheet.neighbours.offset[node])])]);
    };
    std::vector<std::uint8_t> attached(parts.size() + 1, 0);
    for (std::size_t n = 0; n < outer.size(); ++n) {
        if (outer[n] != 0 && !is_out(sheet, static_cast<int>(n))) {
            attached[part_of(n)] = 1;
        }
    }
    std::vector<std::uint8_t> result(outer.size(), 0);
    for (std::size_t n = 0; n < outer.size(); ++n) {
        result[n] = is_out(sheet, static_cast<int>(n)) ? 0 : attached[part_of(n)];
    }
    return result;
}

/// Splits a boundary that has old nodes of the outer edge into the stretches between them. Where a tear ran out it left
/// two nodes at one place; one of them may be an old one, which then belongs to the stretch too.
void add_stretches(const TriMesh& mesh, const std::vector<int>& loop, const std::vector<std::uint8_t>& outer,
                   std::vector<Stretch>& stretches) {
    const auto same_place = [&mesh](int a, int b) { return mesh.nodes[at(a)] == mesh.nodes[at(b)]; };
    std::vector<int> turned = loop;
    std::rotate(turned.begin(), std::find_if(turned.begin(), turned.end(), [&](int n) { return outer[at(n)] != 0; }),
                turned.end());
    turned.push_back(turned.front());
    for (std::size_t i = 1; i < turned.size(); ++i) {
        if (outer[at(turned[i])] != 0) {
            continue;
        }
        const std::size_t first = i;
        while (outer[at(turned[i])] == 0) {
            ++i;
        }
        Stretch stretch;
        if (same_place(turned[first - 1], turned[i - 1])) {
            stretch.nodes.push_back(turned[first - 1]);
        }
        stretch.nodes.insert(stretch.nodes.end(), turned.begin() + static_cast<std::ptrdiff_t>(first),
                             turned.begin() + static_cast<std::ptrdiff_t>(i));
        if (same_place(turned[first], turned[i])) {
            stretch.nodes.push_back(turned[i]);
        }
        stretch.ring = same_place(stretch.nodes.front(), stretch.nodes.back());
        stretches.push_back(std::move(stretch));
    }
}

/// Whether the way a, b, c goes back at b on the line that it came. Tears leave no angle under 15 degrees, so this is
/// the end of a slit.
bool turns_back(const Vec3& a, const Vec3& b, const Vec3& c) {
    constexpr double most_cosine = 0.999;
    const Vec3 back = a - b;
    const Vec3 on = c - b;
    return !(back.dot(on) < most_cosine * back.norm() * on.norm());  // one of them may be zero
}

/// Nodes of a ring less the slits that go off from it: empty if it was nothing else.
std::vector<int> without_slits(const TriMesh& mesh, std::vector<int> ring) {
    std::size_t i = 0;
    for (std::size_t kept = 0; ring.size() > 2 && kept < ring.size();) {
        const std::size_t n = ring.size();
        const auto place = [&](std::size_t k) -> const Vec3& { return mesh.nodes[at(ring[k % n])]; };
        if (turns_back(place(i + n - 1), place(i), place(i + 1))) {
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
            i = (i + n - 2) % (n - 1);
            kept = 0;
        } else {
            i = (i + 1) % n;
            ++kept;
        }
    }
    return ring.size() > 2 ? ring : std::vector<int>{};
}

constexpr double least_area = 2.0;  ///< of an opening; less is a scrap that a needle cut out [mm^2]

/// A way along a boundary that forgets what it walks back.
class Way {
public:
    explicit Way(const Vec3& start) : places_{start}, length_{0.0} {}

    void go_to(const Vec3& place) {
        while (places_.size() > 1 && turns_back(places_[places_.size() - 2], places_.back(), place)) {
            places_.pop_back();
            length_.pop_back();
        }
        if (place != places_.back()) {
            length_.push_back(length_.back() + (place - places_.back()).norm());
            places_.push_back(place);
        }
    }

    [[nodiscard]] double length() const { return length_.back(); }
    [[nodiscard]] const std::vector<Vec3>& places() const { return places_; }

private:
    std::vector<Vec3> places_;
    std::vector<double> length_;
};

/// The longest way from the first place of a ring that encloses nothing, and at which of its places it ends.
std::pair<std::vector<Vec3>, std::size_t> longest_way(const std::vector<Vec3>& ring) {
    Way way(ring.front());
    std::pair<std::vector<Vec3>, std::size_t> longest{way.places(), 0};
    double most = 0.0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        way.go_to(ring[i]);
        if (way.length() > most) {
            most = way.length();
            longest = {way.places(), i};
        }
    }
    return longest;
}

/// Along a tear that encloses nothing, from one end to the other. start: number of the place to begin at; -1: an end.
std::vector<Vec3> unfolded(std::vector<Vec3> ring, int start) {
    const auto from = [&ring](std::size_t i) {
        std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(i), ring.end());
    };
    from(start >= 0 ? at(start) : longest_way(ring).second);
    return longest_way(ring).first;
}

std::vector<Vec3> along(const std::vector<Vec3>& path) {
    Way way(path.front());
    for (const Vec3& place : path) {
        way.go_to(place);
    }
    return way.places();
}

/// From the leading tip along one lip to that other tip of the same stretch to which it is farthest; empty: it has no
/// other. Scraps that came loose on the way are passed on one side.
std::vector<Vec3> between_tips(const TriMesh& mesh, const std::vector<TearTip>& tips, const Stretch& stretch,
                               int place) {
    std::vector<int> turned = stretch.nodes;
    std::rotate(turned.begin(), turned.begin() + place, turned.end());
    std::vector<Vec3> farthest;
    double most = 0.0;
    for (const TearTip& tip : tips) {
        const auto found = std::find(turned.begin() + 1, turned.end(), tip.node);
        if (found == turned.end()) {
            continue;
        }
        const std::vector<Vec3> way = along(places_of(mesh, {turned.begin(), found + 1}));
        double length = 0.0;
        for (std::size_t i = 1; i < way.size(); ++i) {
            length += (way[i] - way[i - 1]).norm();
        }
        if (length > most) {
            most = length;
            farthest = way;
        }
    }
    return farthest;
}

/// Area of what does not hang at the outer edge any more, in the eye or out of it.
double loose_area(const MembraneState& state, const std::vector<std::uint8_t>& attached) {
    const TriMesh& mesh = state.sheet->mesh;
    double sum = state.area_out;
    for (const std::array<int, 3>& n : mesh.triangles) {
        if (attached[at(n[0])] == 0) {
            sum += triangle_area(mesh.nodes[at(n[0])], mesh.nodes[at(n[1])], mesh.nodes[at(n[2])]);
        }
    }
    return sum;
}

/// The stretches that follow openings of what still hangs at the outer edge.
std::vector<Stretch> open_edges(const MembraneSheet& sheet, const std::vector<std::vector<int>>& loops,
                                const std::vector<std::uint8_t>& outer, const std::vector<std::uint8_t>& attached,
                                bool& run_out) {
    const auto is_outer = [&outer](int node) { return outer[at(node)] != 0; };
    std::vector<Stretch> stretches;
    for (const std::vector<int>& loop : loops) {
        if (std::none_of(loop.begin(), loop.end(), is_outer)) {
            if (attached[at(loop.front())] != 0) {
                stretches.push_back({loop});
            }
        } else if (!std::all_of(loop.begin(), loop.end(), is_outer)) {
            run_out = true;
            add_stretches(sheet.mesh, loop, outer, stretches);
        }
    }
    return stretches;
}

/// The last tip on a stretch: its number and where it is on the stretch; -1, -1: none.
std::pair<int, int> leading_tip(const std::vector<TearTip>& tips, const std::vector<int>& nodes) {
    for (int tip = static_cast<int>(tips.size()) - 1; tip >= 0; --tip) {
        const auto found = std::find(nodes.begin(), nodes.end(), tips[at(tip)].node);
        if (found != nodes.end()) {
            return {tip, static_cast<int>(found - nodes.begin())};
        }
    }
    return {-1, -1};
}

/// Nodes of one lip of a tear, from its tip on for 2 mm. forward: along the stretch, or against it.
std::vector<int> lip_from(const TriMesh& mesh, const Stretch& stretch, int place, bool forward) {
    constexpr double length = 2.0;
    const int count = static_cast<int>(stretch.nodes.size());
    std::vector<int> lip{stretch.nodes[at(place)]};
    double sum = 0.0;
    for (int i = 1; i < count && sum < length; ++i) {
        const int next = forward ? place + i : place - i;
        if (!stretch.ring && (next < 0 || next >= count)) {
            break;
        }
        const int node = stretch.nodes[at((next + count) % count)];
        sum += (mesh.nodes[at(node)] - mesh.nodes[at(lip.back())]).norm();
        lip.push_back(node);
    }
    return lip;
}

/// Mean distance from the axis of what hangs at a lip, without its first node, which both lips share.
double distance_of_lip(const MembraneSheet& sheet, const std::vector<int>& lip) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 1; i < lip.size(); ++i) {
        const TriNeighbours& near = sheet.neighbours;
        for (int k = near.offset[at(lip[i])]; k < near.offset[at(lip[i]) + 1]; ++k) {
            sum += triangle_middle(sheet.mesh, near.triangles[at(k)]).head<2>().norm();
            ++count;
        }
    }
    return count > 0 ? sum / count : HUGE_VAL;
}

/// The flap's is the one that lies nearer to the axis.
void find_lips(const MembraneSheet& sheet, const Stretch& stretch, int place, TornOpening& opening) {
    opening.lip = lip_from(sheet.mesh, stretch, place, true);
    opening.margin = lip_from(sheet.mesh, stretch, place, false);
    if (distance_of_lip(sheet, opening.margin) <= distance_of_lip(sheet, opening.lip)) {
        std::swap(opening.lip, opening.margin);
    }
}

/// Null: there is none.
const Stretch* longest_of(const TriMesh& mesh, const std::vector<Stretch>& stretches) {
    double longest = 0.0;
    const Stretch* found = nullptr;
    for (const Stretch& stretch : stretches) {
        const double length = ring_length(places_of(mesh, stretch.nodes));
        if (length > longest) {
            longest = length;
            found = &stretch;
        }
    }
    return found;
}

}  // namespace

TornOpening find_opening(const MembraneSheet& start, const MembraneState& state) {
    const TriMesh& mesh = state.sheet->mesh;
    const std::vector<std::vector<int>> before = boundary_loops(start.mesh, start.neighbours);
    const std::vector<std::vector<int>> loops = boundary_loops(mesh, state.sheet->neighbours);
    const std::vector<std::uint8_t> outer = outer_nodes(start.mesh, before, static_cast<int>(mesh.nodes.size()));
    TornOpening opening;
    const std::vector<std::uint8_t> attached = attached_nodes(*state.sheet, outer);
    const std::vector<Stretch> stretches = open_edges(*state.sheet, loops, outer, attached, opening.run_out);
    opening.loose = loose_area(state, attached);
    const double edges = boundary_length(mesh, loops) + state.edge_out;
    opening.torn = std::max(0.0, 0.5 * (edges - boundary_length(start.mesh, before)));
    const Stretch* const chosen = longest_of(mesh, stretches);
    if (chosen == nullptr) {
        return opening;
    }
    const auto [tip, place] = leading_tip(state.tips, chosen->nodes);
    opening.exists = true;
    opening.tip = tip;
    if (tip >= 0) {
        find_lips(*state.sheet, *chosen, place, opening);
    }
    opening.edge = places_of(mesh, chosen->nodes);
    if (!chosen->ring) {
        opening.curve = along(opening.edge);
        return opening;
    }
    const std::vector<int> rim = without_slits(mesh, chosen->nodes);
    opening.curve = places_of(mesh, rim);
    opening.closed = std::abs(ring_area(opening.curve)) > least_area;
    if (opening.closed) {
        opening.rim = rim;
    } else {
        opening.curve = place >= 0 ? between_tips(mesh, state.tips, *chosen, place) : std::vector<Vec3>{};
    }
    if (opening.curve.empty()) {
        opening.curve = unfolded(opening.edge, place);
    }
    return opening;
}

}  // namespace rhexis
