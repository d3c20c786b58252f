// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/tear.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/index.hpp"
#include "base/numbers.hpp"
#include "topology/sheet_editor.hpp"
#include "topology/take_out.hpp"

namespace rhexis {
namespace {

/// The star of a node as it lies in the plane that fits it.
struct Fan {
    Vec3 origin;
    Vec3 e1;
    Vec3 e2;

    [[nodiscard]] Vec2 flat(const Vec3& x) const { return {e1.dot(x - origin), e2.dot(x - origin)}; }
};

Fan fan_at(const SheetEditor& editor, int node) {
    Vec3 front = Vec3::Zero();
    for (const int t : editor.star(node)) {
        const std::array<int, 3>& n = editor.mesh().triangles[at(t)];
        const Vec3& a = editor.mesh().nodes[at(n[0])];
        front += (editor.mesh().nodes[at(n[1])] - a).cross(editor.mesh().nodes[at(n[2])] - a);
    }
    front.normalize();
    Fan fan;
    fan.origin = editor.mesh().nodes[at(node)];
    const Vec3 axis = std::abs(front.x()) < 0.7 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    fan.e1 = (axis - axis.dot(front) * front).normalized();
    fan.e2 = front.cross(fan.e1);
    return fan;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether the angle between them has a smaller tangent.
bool within(const Vec2& a, const Vec2& b, double tangent) {
    return a.dot(b) > 0.0 && std::abs(cross(a, b)) < tangent * a.dot(b);
}

Error leads_out(int node) {
    return {"the tear's direction leads out of the sheet at node " + std::to_string(node), "tear",
            "a direction into the sheet"};
}

Status check_direction(const Vec3& direction) {
    if (!direction.allFinite() || !(direction.norm() > 1e-12)) {
        return Error{"the tear has no direction", "tear", "a finite vector that is not zero"};
    }
    return success();
}

bool inner_edge(const SheetEditor& editor, int a, int b) {
    return editor.triangle_with(a, b) >= 0 && editor.triangle_with(b, a) >= 0;
}

/// The neighbour whose edge is inside the sheet and nearest to the direction; -1: none within a right angle.
int nearest_edge(const SheetEditor& editor, const Fan& fan, int node, const Vec2& way) {
    int best = -1;
    double most = 0.0;  // cosine
    for (const int t : editor.star(node)) {
        for (const int other : editor.mesh().triangles[at(t)]) {
            if (other == node || !inner_edge(editor, node, other)) {
                continue;
            }
            const Vec2 edge = fan.flat(editor.mesh().nodes[at(other)]);
            const double cosine = way.dot(edge) / edge.norm();
            if (cosine > most) {
                most = cosine;
                best = other;
            }
        }
    }
    return best;
}

/// Whether no triangle at a node has an angle of a greater cosine or a shorter edge.
bool well_shaped(const SheetEditor& editor, int node, double most_cosine, double shortest) {
    const TriMesh& mesh = editor.mesh();
    for (const int t : editor.star(node)) {
        const std::array<int, 3>& n = mesh.triangles[at(t)];
        const Vec3& a = mesh.nodes[at(n[0])];
        const Vec3& b = mesh.nodes[at(n[1])];
        const Vec3& c = mesh.nodes[at(n[2])];
        if (largest_cosine(a, b, c) > most_cosine ||
            std::min({(b - a).norm(), (c - b).norm(), (a - c).norm()}) < shortest) {
            return false;
        }
    }
    return true;
}

/// The node that a tear from `node` reaches next. Splits an edge of the editor's sheet if that is needed for it.
Result<int> next_node(SheetEditor& editor, const MembraneModel& model, int node, const Vec3& direction,
                      const TearRules& rules) {
    const Fan fan = fan_at(editor, node);
    Vec2 way = fan.flat(fan.origin + direction);
    if (!(way.norm() > 1e-9 * direction.norm())) {
        return leads_out(node);
    }
    way.normalize();
    for (const int t : editor.star(node)) {
        const std::array<int, 3> n = editor.mesh().triangles[at(t)];
        const int k = n[0] == node ? 0 : n[1] == node ? 1 : 2;
        const int p = n[at((k + 1) % 3)];
        const int q = n[at((k + 2) % 3)];
        const Vec2 to_p = fan.flat(editor.mesh().nodes[at(p)]);
        const Vec2 to_q = fan.flat(editor.mesh().nodes[at(q)]);
        if (cross(to_p, way) < 0.0 || cross(way, to_q) < 0.0) {
            continue;
        }
        const double share = cross(to_p, way) / (cross(to_p, way) - cross(to_q, way));
        const bool near_p = within(way, to_p, rules.snap_tangent) || share < rules.snap_share;
        const bool near_q = within(way, to_q, rules.snap_tangent) || share > 1.0 - rules.snap_share;
        if (!rules.existing_edges && !near_p && !near_q) {
            SheetEditor tried = editor;
            const int middle = tried.split_edge(p, q, share);
            // without a shortest edge random tears would go on to split scraps for ever
            const double shortest = rules.shortest_edge * mean_edge(model.sheet->mesh);
            if (well_shaped(tried, middle, rules.most_cosine, shortest)) {
                editor = std::move(tried);
                return middle;
            }
        }
        break;
    }
    const int nearest = nearest_edge(editor, fan, node, way);
    if (nearest < 0) {
        return leads_out(node);
    }
    return nearest;
}

/// The node of a triangle from which a slit through a place begins: its nearest one, or one that splits an edge where
/// that comes nearer and leaves no slivers.
int node_at(SheetEditor& editor, const MembraneModel& model, int triangle, const Vec3& place, const TearRules& rules) {
    const double shortest = rules.shortest_edge * mean_edge(model.sheet->mesh);
    const std::array<int, 3> corners = editor.mesh().triangles[at(triangle)];
    const auto node = [&editor](int n) { return editor.mesh().nodes[at(n)]; };
    const int nearest = *std::min_element(corners.begin(), corners.end(), [&](int a, int b) {
        return (node(a) - place).squaredNorm() < (node(b) - place).squaredNorm();
    });
    double least = (node(nearest) - place).norm();
    int found = nearest;
    const SheetEditor before = editor;
    for (std::size_t k = 0; k < 3 && !rules.existing_edges; ++k) {
        const int a = corners[k];
        const int b = corners[(k + 1) % 3];
        const Vec3 edge = before.mesh().nodes[at(b)] - before.mesh().nodes[at(a)];
        const Vec3 from_a = place - before.mesh().nodes[at(a)];
        const double share = edge.dot(from_a) / edge.squaredNorm();
        const double distance = (from_a - share * edge).norm();
        if (share < rules.snap_share || share > 1.0 - rules.snap_share || distance >= least ||
            !inner_edge(before, a, b)) {
            continue;
        }
        SheetEditor tried = before;
        const int middle = tried.split_edge(a, b, share);
        if (well_shaped(tried, middle, rules.most_cosine, shortest)) {
            least = distance;
            found = middle;
            editor = std::move(tried);
        }
    }
    return found;
}

/// Adds what an opened edge takes; call before it is opened.
void count(const MembraneModel& model, const MembraneSheet& sheet, const SheetEditor& editor, int a, int b,
           MembraneEdit& cost) {
    const Vec3 way = editor.mesh().nodes[at(b)] - editor.mesh().nodes[at(a)];
    const double area = way.norm() * editor.thickness_along(a, b);
    double toughness = 0.0;
    for (const int t : {editor.triangle_with(a, b), editor.triangle_with(b, a)}) {
        toughness += 0.5 * toughness_along(model.toughness, sheet.fibre[at(editor.parent_of(t))], way.normalized());
    }
    cost.torn_area += area;
    cost.torn_energy += area * toughness;
}

/// Tips at the end of a tear: the one it came to, unless it met an edge or another tear there. step: the way it went,
/// meant: where it ought to have gone, unit; owed: of the tip before. What is owed lies in the sheet: on a curved one
/// it would else grow by what that falls away.
void end_at(const SheetEditor& editor, bool ends, int node, const Vec3& step, const Vec3& meant, const Vec3& owed,
            std::vector<TearTip>& tips) {
    std::erase_if(tips, [node](const TearTip& tip) { return tip.node == node; });
    if (!ends) {
        const Fan fan = fan_at(editor, node);
        Vec3 off = owed - step;
        off -= off.dot(meant) * meant;
        tips.push_back({node, meant, fan.e1.dot(off) * fan.e1 + fan.e2.dot(off) * fan.e2});
    }
}

/// Mean length of the edges at a node.
double reach_of(const SheetEditor& editor, int node) {
    double sum = 0.0;
    int count = 0;
    for (const int t : editor.star(node)) {
        for (const int other : editor.mesh().triangles[at(t)]) {
            if (other != node) {
                sum += (editor.mesh().nodes[at(other)] - editor.mesh().nodes[at(node)]).norm();
                ++count;
            }
        }
    }
    return count > 0 ? sum / count : 0.0;
}

/// Where to aim so that what is owed is made good within an edge or two.
Vec3 aim(const Vec3& direction, const Vec3& owed, double reach) {
    const double length = owed.norm();
    return direction.normalized() * reach + owed * (length > 0.5 * reach ? 0.5 * reach / length : 1.0);
}

MembraneEdit finished(const SheetEditor& editor, const MembraneEdit& cost, std::vector<TearTip> tips) {
    MembraneEdit edit = editor.edit();
    edit.torn_area = cost.torn_area;
    edit.torn_energy = cost.torn_energy;
    edit.tips = std::move(tips);
    return edit;
}

Result<MembraneEdit> tear_from(const MembraneModel& model, const MembraneState& state, const TearTip& from,
                               const Vec3& direction, const TearRules& rules) {
    SheetEditor editor(*state.sheet);
    const int node = from.node;
    const Result<int> next = next_node(editor, model, node, aim(direction, from.owed, reach_of(editor, node)), rules);
    if (!next.ok()) {
        return next.error();
    }
    MembraneEdit cost;
    count(model, *state.sheet, editor, node, next.value(), cost);
    std::vector<TearTip> tips = state.tips;
    std::erase_if(tips, [node](const TearTip& tip) { return tip.node == node; });
    const Vec3 way = editor.mesh().nodes[at(next.value())] - editor.mesh().nodes[at(node)];
    const bool ends = editor.on_boundary(next.value());
    editor.open_edge(node, next.value());
    end_at(editor, ends, next.value(), way, direction.normalized(), from.owed, tips);
    return finished(editor, cost, std::move(tips));
}

double longest_edge(const TriMesh& mesh, int triangle) {
    const std::array<int, 3>& n = mesh.triangles[at(triangle)];
    const Vec3& a = mesh.nodes[at(n[0])];
    const Vec3& b = mesh.nodes[at(n[1])];
    const Vec3& c = mesh.nodes[at(n[2])];
    return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

}  // namespace

Result<MembraneEdit> tear(const MembraneModel& model, const MembraneState& state, int tip, const Vec3& direction,
                          const TearRules& rules) {
    if (tip < 0 || tip >= static_cast<int>(state.tips.size())) {
        return Error{"there is no tip " + std::to_string(tip), "tear",
                     state.tips.empty() ? "the sheet has none" : "0 to " + std::to_string(state.tips.size() - 1)};
    }
    if (Status status = check_direction(direction); !status) {
        return status.error();
    }
    return tear_from(model, state, state.tips[at(tip)], direction, rules);
}

Result<MembraneEdit> notch(const MembraneModel& model, const MembraneState& state, int node, const Vec3& direction,
                           const TearRules& rules) {
    if (node < 0 || node >= static_cast<int>(state.sheet->mesh.nodes.size())) {
        return Error{"there is no node " + std::to_string(node), "notch",
                     "0 to " + std::to_string(state.sheet->mesh.nodes.size() - 1)};
    }
    if (Status status = check_direction(direction); !status) {
        return status.error();
    }
    if (is_out(*state.sheet, node)) {
        return Error{"node " + std::to_string(node) + " was taken out", "notch", "a node on the sheet's edge"};
    }
    if (!SheetEditor(*state.sheet).on_boundary(node)) {
        return Error{"node " + std::to_string(node) + " is inside the sheet", "notch",
                     "a node on its edge; a puncture begins inside"};
    }
    return tear_from(model, state, {node, direction.normalized(), Vec3::Zero()}, direction, rules);
}

Result<MembraneEdit> puncture(const MembraneModel& model, const MembraneState& state, int triangle, const Vec3& place,
                              const Vec3& direction, const TearRules& rules) {
    const TriMesh& mesh = state.sheet->mesh;
    if (triangle < 0 || triangle >= static_cast<int>(mesh.triangles.size())) {
        return Error{"there is no triangle " + std::to_string(triangle), "puncture",
                     "0 to " + std::to_string(mesh.triangles.size() - 1)};
    }
    if (Status status = check_direction(direction); !status) {
        return status.error();
    }
    if (!place.allFinite()) {
        return Error{"the place is not finite", "puncture", "numbers"};
    }
    if (const double away = (place - triangle_middle(mesh, triangle)).norm(); away > longest_edge(mesh, triangle)) {
        return Error{"the place is outside the sheet: " + short_number(away) + " mm from the middle of triangle " +
                         std::to_string(triangle),
                     "puncture", "a place of the triangle at rest"};
    }
    SheetEditor editor(*state.sheet);
    const int node = node_at(editor, model, triangle, place, rules);
    if (editor.on_boundary(node)) {
        return Error{"the nearest node " + std::to_string(node) + " is on an edge of the sheet", "puncture",
                     "a place inside the sheet"};
    }
    const Result<int> ahead = next_node(editor, model, node, direction, rules);
    if (!ahead.ok()) {
        return ahead.error();
    }
    const Result<int> back = next_node(editor, model, node, -direction, rules);
    if (!back.ok()) {
        return back.error();
    }
    if (ahead.value() == back.value()) {
        return leads_out(node);
    }
    MembraneEdit cost;
    std::vector<TearTip> tips = state.tips;
    count(model, *state.sheet, editor, node, ahead.value(), cost);
    count(model, *state.sheet, editor, node, back.value(), cost);
    const bool ahead_ends = editor.on_boundary(ahead.value());
    const bool back_ends = editor.on_boundary(back.value());
    const Vec3 origin = editor.mesh().nodes[at(node)];
    const Vec3 way_ahead = editor.mesh().nodes[at(ahead.value())] - origin;
    const Vec3 way_back = editor.mesh().nodes[at(back.value())] - origin;
    editor.open_slit(back.value(), ahead.value(), node);
    end_at(editor, ahead_ends, ahead.value(), way_ahead, direction.normalized(), Vec3::Zero(), tips);
    end_at(editor, back_ends, back.value(), way_back, -direction.normalized(), Vec3::Zero(), tips);
    return finished(editor, cost, std::move(tips));
}

namespace {

/// Area of each part of a sheet that hangs together [mm^2].
std::vector<double> areas_of_parts(const MembraneSheet& sheet) {
    const std::vector<int> parts = sheet_parts(sheet.neighbours);
    std::vector<double> areas;
    for (int t = 0; t < static_cast<int>(parts.size()); ++t) {
        const std::array<int, 3>& n = sheet.mesh.triangles[at(t)];
        areas.resize(std::max(areas.size(), at(parts[at(t)]) + 1), 0.0);
        areas[at(parts[at(t)])] +=
            triangle_area(sheet.mesh.nodes[at(n[0])], sheet.mesh.nodes[at(n[1])], sheet.mesh.nodes[at(n[2])]);
    }
    return areas;
}

/// Whether a cut takes out a scrap that the needle itself would push away rather than cut round.
bool leaves_scrap(const MembraneSheet& before, const MembraneSheet& after) {
    constexpr double scrap = 1.0;  // [mm^2]
    const auto count = [](const MembraneSheet& sheet) {
        const std::vector<double> areas = areas_of_parts(sheet);
        return std::count_if(areas.begin(), areas.end(), [](double area) { return area < scrap; });
    };
    return count(after) > count(before);
}

/// The state after one edge of a cut; nothing where the mesh does not allow it, or where it would take out a scrap.
std::optional<MembraneState> cut_one_edge(const MembraneModel& model, const MembraneState& state, int node, int tip,
                                          const Vec3& direction, const TearRules& rules) {
    const Result<MembraneEdit> edit =
        tip < 0 ? notch(model, state, node, direction, rules) : tear(model, state, tip, direction, rules);
    if (!edit.ok()) {
        return std::nullopt;
    }
    MembraneState after = applied(state, edit.value());
    const bool ended = after.tips.size() < state.tips.size() + (tip < 0 ? 1 : 0);
    if (ended && leaves_scrap(*state.sheet, *after.sheet)) {
        return std::nullopt;
    }
    return after;
}

/// One edge, to where the needle stands, or straight on; from then on the needle pushes the end of the cut before it.
bool cut(const MembraneModel& model, const CutProposal& proposal, MembraneState& state, const TearRules& rules) {
    const auto found = std::find_if(state.tips.begin(), state.tips.end(),
                                    [&](const TearTip& other) { return other.node == proposal.node; });
    const int tip = found == state.tips.end() ? -1 : static_cast<int>(found - state.tips.begin());
    std::optional<MembraneState> after = cut_one_edge(model, state, proposal.node, tip, proposal.direction, rules);
    if (!after && tip >= 0) {
        after = cut_one_edge(model, state, proposal.node, tip, found->direction, rules);
    }
    if (!after) {
        return false;
    }
    const bool goes_on = after->tips.size() >= state.tips.size() + (tip < 0 ? 1 : 0);
    state = std::move(*after);
    std::erase_if(state.grips, [&](const SheetGrip& grip) { return grip.tool == proposal.tool; });
    if (goes_on) {
        state.grips.push_back({proposal.tool, state.tips.back().node, Vec3::Zero(), true, 0.0});
    }
    return true;
}

}  // namespace

int carry_out(const MembraneModel& model, const MembraneStepReport& report, MembraneState& state,
              const TearRules& rules) {
    const std::vector<TearProposal>& proposals = report.tears;
    std::vector<int> nodes;  // an edit renumbers the tips, but no node
    for (const TearProposal& proposal : proposals) {
        nodes.push_back(state.tips[at(proposal.tip)].node);
    }
    int done = 0;
    for (std::size_t i = 0; i < proposals.size(); ++i) {
        const auto tip = std::find_if(state.tips.begin(), state.tips.end(),
                                      [&](const TearTip& other) { return other.node == nodes[i]; });
        if (tip == state.tips.end()) {
            continue;  // another tear met it
        }
        const Result<MembraneEdit> edit =
            tear(model, state, static_cast<int>(tip - state.tips.begin()), proposals[i].direction, rules);
        if (edit.ok()) {
            state = applied(state, edit.value());
            ++done;
        }
    }
    for (std::size_t i = 0; i < report.notches.size() && done == 0; ++i) {
        const NotchProposal& proposal = report.notches[i];
        const Result<MembraneEdit> edit = notch(model, state, proposal.node, proposal.direction, rules);
        if (edit.ok()) {
            state = applied(state, edit.value());
            ++done;
        }
    }
    for (std::size_t i = 0; i < report.cuts.size() && done == 0; ++i) {
        done += cut(model, report.cuts[i], state, rules) ? 1 : 0;
    }
    if (const MembraneEdit out = take_out(model, state, report.out); !out.out.empty()) {
        state = applied(state, out);
        ++done;
    }
    // tears renumber triangles: a needle that still presses goes through in the next step
    for (std::size_t i = 0; i < report.punctures.size() && done == 0; ++i) {
        const PunctureProposal& proposal = report.punctures[i];
        const Result<MembraneEdit> edit =
            puncture(model, state, proposal.triangle, proposal.place, proposal.direction, rules);
        if (edit.ok()) {
            state = applied(state, edit.value());
            state.punctures.push_back(proposal.place);
            ++done;
        }
    }
    return done;
}

MembraneState applied(const MembraneState& state, const MembraneEdit& edit) {
    if (!edit.out.empty()) {
        return without(state, edit);
    }
    MembraneState next = state;
    std::shared_ptr<MembraneSheet> sheet = std::make_shared<MembraneSheet>(*state.sheet);
    for (const SheetNode& node : edit.nodes) {
        const auto between = [&node](const std::vector<Vec3>& list) {
            return Vec3(list[at(node.a)] + node.share * (list[at(node.b)] - list[at(node.a)]));
        };
        sheet->mesh.nodes.push_back(between(sheet->mesh.nodes));
        next.position.push_back(between(next.position));
        next.velocity.push_back(between(next.velocity));
        const bool copy = node.share == 0.0;
        sheet->origin.push_back(copy ? sheet->origin[at(node.a)] : -1);
        for (std::size_t i = 0, count = next.grips.size(); copy && i < count; ++i) {
            if (next.grips[i].node == node.a) {
                next.grips.push_back(next.grips[i]);
                next.grips.back().node = static_cast<int>(next.position.size()) - 1;
            }
        }
        for (SheetLoad& load : next.loads) {
            if (copy && std::find(load.nodes.begin(), load.nodes.end(), node.a) != load.nodes.end()) {
                load.nodes.push_back(static_cast<int>(next.position.size()) - 1);
            }
        }
    }
    std::vector<int> changed;
    for (const SheetTriangle& change : edit.triangles) {
        changed.push_back(change.triangle >= 0 ? change.triangle : static_cast<int>(sheet->mesh.triangles.size()));
        if (change.triangle >= 0) {
            sheet->mesh.triangles[at(change.triangle)] = change.nodes;
            continue;
        }
        sheet->mesh.triangles.push_back(change.nodes);
        sheet->fibre.push_back(Vec3(state.sheet->fibre[at(change.parent)]));
        sheet->thickness.push_back(state.sheet->thickness[at(change.parent)]);
        sheet->stiffness.push_back(state.sheet->stiffness[at(change.parent)]);
    }
    sheet->neighbours = tri_neighbours(sheet->mesh, state.sheet->neighbours, changed);
    next.sheet = std::move(sheet);
    next.tips = edit.tips;
    next.torn_area += edit.torn_area;
    next.torn_energy += edit.torn_energy;
    return next;
}

}  // namespace rhexis
