// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/tears.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/index.hpp"
#include "mesh/shapes.hpp"
#include "physics/membrane/tear_tip.hpp"

namespace rhexis::scenes {
namespace {

constexpr double young_modulus = 1e6;  // [Pa]
constexpr double thickness = 0.01;     // of membrane() [mm]

/// A square sheet scaled to a rectangle of about so many triangles, of even shape.
TriMesh rectangle(double width, double height, int triangles) {
    // squares of the rectangle's height side by side
    TriMesh mesh = square_sheet(width, static_cast<int>(triangles * width / height));
    std::vector<int> kept(mesh.nodes.size(), -1);
    // the rows of a square sheet are horizontal: those below `height` make the strip, stretched to it
    double top = 0.0;
    for (const Vec3& x : mesh.nodes) {
        top = x.y() <= height * 1.02 ? std::max(top, x.y()) : top;
    }
    TriMesh strip;
    for (const std::array<int, 3>& t : mesh.triangles) {
        if (std::any_of(t.begin(), t.end(), [&](int n) { return mesh.nodes[at(n)].y() > top + 1e-9; })) {
            continue;
        }
        std::array<int, 3> own{};
        for (std::size_t k = 0; k < 3; ++k) {
            int& index = kept[at(t[k])];
            if (index < 0) {
                index = static_cast<int>(strip.nodes.size());
                const Vec3& x = mesh.nodes[at(t[k])];
                strip.nodes.emplace_back(x.x(), height * (x.y() / top), 0.0);
            }
            own[k] = index;
        }
        strip.triangles.push_back(own);
    }
    return strip;
}

int nearest_node(const TriMesh& mesh, const Vec3& place) {
    int best = 0;
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
        best = (mesh.nodes[at(n)] - place).norm() < (mesh.nodes[at(best)] - place).norm() ? n : best;
    }
    return best;
}

/// Tears from an edge node straight along +x to x = end.
void cut_along(const MembraneModel& model, MembraneState& state, int node, double end) {
    const double line = state.sheet->mesh.nodes[at(node)].y();
    Result<MembraneEdit> edit = notch(model, state, node, Vec3::UnitX());
    while (edit.ok()) {
        state = applied(state, edit.value());
        const Vec3& here = state.sheet->mesh.nodes[at(state.tips.back().node)];
        if (here.x() >= end) {
            return;
        }
        edit = tear(model, state, static_cast<int>(state.tips.size()) - 1, Vec3(0.4, line - here.y(), 0.0));
    }
}

/// Below zero for a node of what lies below the line y = middle, told by its triangles: copies lie on the line.
double leg_of(const MembraneSheet& sheet, int node, double middle) {
    double side = 0.0;
    for (int i = sheet.neighbours.offset[at(node)]; i < sheet.neighbours.offset[at(node) + 1]; ++i) {
        for (const int other : sheet.mesh.triangles[at(sheet.neighbours.triangles[at(i)])]) {
            side += sheet.mesh.nodes[at(other)].y() - middle;
        }
    }
    return side;
}

/// A model whose sheet already has the state's tears: fixed nodes of it can be copies too.
MembraneModel with_sheet(MembraneModel model, const MembraneState& state) {
    MembraneSheet sheet = *state.sheet;
    std::iota(sheet.origin.begin(), sheet.origin.end(), 0);
    model.sheet = std::make_shared<const MembraneSheet>(std::move(sheet));
    return model;
}

/// A strip with a slit of 4 mm along its middle from x = 0.
struct SlitStrip {
    MembraneModel model;  ///< the slit is in its sheet
    std::vector<TearTip> tips;
    double line = 0.0;  ///< y of the slit: that of the nearest row of nodes [mm]
};

SlitStrip slit_strip(double width, double height, int triangles, double toughness) {
    MembraneModel whole = membrane("strip", rectangle(width, height, triangles), isotropic(young_modulus, 0.45));
    whole.toughness = {toughness, toughness};
    whole.damping_mass = 50.0;
    MembraneState cut = rest_state(whole);
    const int mouth = nearest_node(whole.sheet->mesh, Vec3(0.0, 0.5 * height, 0.0));
    cut_along(whole, cut, mouth, 4.0);
    return {with_sheet(whole, cut), cut.tips, whole.sheet->mesh.nodes[at(mouth)].y()};
}

/// Energy release at the first tip as a share of what it takes to tear straight on.
double readiness(HeldSheet& held) {
    const TearTip& tip = held.state().tips.at(0);
    return release_at(held.model(), held.state(), tip.node, held.model().tear_radius).dot(tip.direction) /
           held.model().toughness.along;
}

/// Of the triangles between two x, at rest.
double energy_density(HeldSheet& held, double from, double to) {
    const MembraneSheet& sheet = *held.state().sheet;
    const std::vector<MembraneTriangle> triangles = membrane_triangles(held.model(), sheet);
    double energy = 0.0;
    double volume = 0.0;
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
        const double x = triangle_middle(sheet.mesh, t).x();
        if (x > from && x < to) {
            energy += triangles[at(t)].volume * membrane_state(triangles[at(t)], points_now(held.state(), t)).energy;
            volume += triangles[at(t)].volume;
        }
    }
    return energy / volume;
}

}  // namespace

bool tear_once(const MembraneModel& model, MembraneState& state, const TearRules& rules) {
    const std::vector<TearProposal> proposals = propose_tears(model, state);
    if (proposals.empty()) {
        return false;
    }
    const auto most = std::max_element(
        proposals.begin(), proposals.end(),
        [](const TearProposal& a, const TearProposal& b) { return a.release / a.toughness < b.release / b.toughness; });
    const Result<MembraneEdit> edit = tear(model, state, most->tip, most->direction, rules);
    if (!edit.ok()) {
        return false;
    }
    state = applied(state, edit.value());
    return true;
}

TearLoad pure_shear(int triangles, double toughness) {
    const double width = 12.0;
    const double height = 2.0;
    const SlitStrip strip = slit_strip(width, height, triangles, toughness);
    MembraneModel model = strip.model;
    const std::vector<int> low = nodes_at(model.sheet->mesh, 1, 0.0);
    const std::vector<int> high = nodes_at(model.sheet->mesh, 1, height);
    hold(model, low, high);
    HeldSheet held(model);
    held.state().tips = strip.tips;
    TearLoad load;
    load.expected = toughness;
    const double pull = 0.02 * height * std::sqrt(toughness / (young_modulus * height));
    bool torn = false;
    for (int i = 0; i < 400 && load.steps < 12; ++i) {
        for (const int node : high) {
            held.state().position[at(node)].y() += torn ? 0.0 : pull;
        }
        held.settle({}, 2e-3, 300);
        // ahead of the tip and away from the far end the strip is in pure shear
        torn = tear_once(held.model(), held.state());
        if (torn) {
            const double tip =
                held.state().tips.empty() ? width : held.state().sheet->mesh.nodes[at(held.state().tips[0].node)].x();
            if (tip > width - 3.0) {
                break;
            }
            load.measured += height * energy_density(held, tip + 1.5, width - 1.0);
            ++load.steps;
        }
    }
    load.measured /= std::max(1, load.steps);
    return load;
}

namespace {

/// Pulls that bring a tip to where it tears in few steps: most of the way at the rate of the last pull, then by 1 um,
/// which adds half a per cent to the energy that comes free.
class ApproachedTear {
public:
    /// [mm]. readiness: energy that comes free at the tip, share of what the tear takes.
    double next(double readiness) {
        const double rate = (readiness - before_) / pull_;
        before_ = readiness;
        pull_ = rate > 0.0 ? std::clamp(0.7 * (1.0 - readiness) / rate, 0.001, 2.0 * pull_) : 0.01;
        return pull_;
    }

private:
    double before_ = 0.0;
    double pull_ = 0.01;
};

}  // namespace

TearLoad trousers(int triangles, double toughness) {
    const double width = 10.0;
    const double height = 4.0;
    const SlitStrip strip = slit_strip(width, height, triangles, toughness);
    MembraneModel model = strip.model;
    const double line = strip.line;
    std::vector<int> low;
    std::vector<int> high;
    for (const int node : nodes_at(model.sheet->mesh, 0, 0.0)) {
        (leg_of(*model.sheet, node, line) < 0.0 ? low : high).push_back(node);
    }
    hold(model, low, high);
    HeldSheet held(model);
    held.state().tips = strip.tips;
    // the legs start turned up and down at a right angle
    for (int n = 0; n < static_cast<int>(held.state().position.size()); ++n) {
        const Vec3& x = model.sheet->mesh.nodes[at(n)];
        if (x.x() < 4.0) {
            const double up = leg_of(*model.sheet, n, line) < 0.0 ? 1.0 : -1.0;
            held.state().position[at(n)] = Vec3(4.0, x.y(), up * (4.0 - x.x()));
        }
    }
    TearLoad load;
    load.expected = toughness;
    bool torn = false;
    ApproachedTear approach;
    for (int i = 0; i < 600 && load.steps < 4; ++i) {
        const double pull = torn ? 0.0 : approach.next(readiness(held));
        for (const int node : low) {
            held.state().position[at(node)].z() += pull;
        }
        for (const int node : high) {
            held.state().position[at(node)].z() -= pull;
        }
        held.settle({}, 0.02, 25);
        const double force = std::abs(held.force_on(low).z());
        torn = tear_once(held.model(), held.state());
        if (torn) {
            // each leg is pulled along and free across
            const auto part = [&](double width_of_leg) {
                const double strain = force / (thickness * width_of_leg * young_modulus);
                return force * (1.0 + strain) / thickness - 0.5 * width_of_leg * young_modulus * strain * strain;
            };
            load.measured += part(line) + part(height - line);
            ++load.steps;
            if (held.state().tips.empty() ||
                held.state().sheet->mesh.nodes[at(held.state().tips[0].node)].x() > width - 2.0) {
                break;
            }
        }
    }
    load.measured /= std::max(1, load.steps);
    return load;
}

namespace {

constexpr double plate_side = 10.0;
constexpr double plate_stress = 1000.0;  // 0.1 % strain

MembraneModel plate(int triangles) {
    MembraneModel model = membrane("sheet", square_sheet(plate_side, triangles), isotropic(young_modulus, 0.3));
    model.damping_mass = 50.0;
    model.slack_share = 1.0;  // the handbook's plate bears compression
    return model;
}

/// From the middle of the plate so far to the right: x at the left end and at the right one.
struct Slit {
    double from = 0.0;
    double to = 0.0;
};

/// Across the pull, which is along y. Snapping leaves its ends within 0.05 mm of where they are asked for, or short of
/// an edge beyond.
void cut_slit(const MembraneModel& model, MembraneState& cut, const Slit& slit) {
    const double middle = 0.5 * plate_side;
    const TriMesh& mesh = cut.sheet->mesh;
    const int node = nearest_node(mesh, Vec3(middle + 0.5 * (slit.from + slit.to), middle, 0.0));
    const Vec3 origin = mesh.nodes[at(node)];
    const int triangle = cut.sheet->neighbours.triangles[at(cut.sheet->neighbours.offset[at(node)])];
    const std::size_t before = cut.tips.size();
    Result<MembraneEdit> edit = puncture(model, cut, triangle, origin, Vec3::UnitX());
    while (edit.ok()) {
        cut = applied(cut, edit.value());
        const auto x_of = [&](const TearTip& tip) { return cut.sheet->mesh.nodes[at(tip.node)].x() - middle; };
        const auto is_right = [&](const TearTip& tip) { return x_of(tip) > origin.x() - middle; };
        const auto first = cut.tips.begin() + static_cast<std::ptrdiff_t>(before);
        const auto short_tip = std::find_if(first, cut.tips.end(), [&](const TearTip& tip) {
            return is_right(tip) ? x_of(tip) < slit.to - 0.05 : x_of(tip) > slit.from + 0.05;
        });
        if (short_tip == cut.tips.end()) {
            break;
        }
        const Vec3& here = cut.sheet->mesh.nodes[at(short_tip->node)];
        const double way = is_right(*short_tip) ? 0.4 : -0.4;
        edit = tear(model, cut, static_cast<int>(short_tip - cut.tips.begin()), Vec3(way, origin.y() - here.y(), 0.0));
    }
}

/// At rest, pulled at its edges along y.
std::unique_ptr<HeldSheet> pulled_plate(const MembraneModel& whole, const MembraneState& cut) {
    const MembraneModel model = with_sheet(whole, cut);
    auto held = std::make_unique<HeldSheet>(model);
    held->state().tips = cut.tips;
    std::vector<Vec3> load(held->state().position.size(), Vec3::Zero());
    const TriMesh& mesh = model.sheet->mesh;
    for (const double edge : {0.0, plate_side}) {
        for (const std::array<int, 3>& t : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& a = mesh.nodes[at(t[k])];
                const Vec3& b = mesh.nodes[at(t[(k + 1) % 3])];
                if (a.y() == edge && b.y() == edge) {
                    const double share = 0.5 * plate_stress * thickness * (edge > 0.0 ? 1.0 : -1.0) * (b - a).norm();
                    load[at(t[k])].y() += share;
                    load[at(t[(k + 1) % 3])].y() += share;
                }
            }
        }
    }
    held->settle(load, 1e-5, 600, 0.02);
    return held;
}

double release_along(HeldSheet& held, const TearTip& tip) {
    return release_at(held.model(), held.state(), tip.node, held.model().tear_radius).dot(tip.direction);
}

}  // namespace

MiddleCrack middle_crack(int triangles) {
    const MembraneModel model = plate(triangles);
    MembraneState cut = rest_state(model);
    cut_slit(model, cut, {-1.0, 1.0});
    MiddleCrack result;
    result.half_length = 0.5 * std::abs(cut.sheet->mesh.nodes[at(cut.tips[0].node)].x() -
                                        cut.sheet->mesh.nodes[at(cut.tips[1].node)].x());
    result.sheet = pulled_plate(model, cut);
    const double ratio = result.half_length / (0.5 * plate_side);
    const double factor =
        (1.0 - 0.025 * ratio * ratio + 0.06 * std::pow(ratio, 4)) / std::sqrt(std::cos(0.5 * M_PI * ratio));
    result.expected = plate_stress * plate_stress * M_PI * result.half_length / young_modulus * factor * factor;
    for (const TearTip& tip : cut.tips) {
        result.release += 0.5 * release_along(*result.sheet, tip);
    }
    return result;
}

FacingSlits facing_slits(int triangles, double gap) {
    const MembraneModel model = plate(triangles);
    MembraneState cut = rest_state(model);
    cut_slit(model, cut, {-1.3, -0.5 * gap});
    cut_slit(model, cut, {0.5 * gap, 1.3});
    const std::unique_ptr<HeldSheet> held = pulled_plate(model, cut);
    FacingSlits result;
    result.tips = static_cast<int>(cut.tips.size());
    double inner = 0.0;  // distances from the middle
    double outer = 0.0;
    for (const TearTip& tip : cut.tips) {
        const double x = cut.sheet->mesh.nodes[at(tip.node)].x() - 0.5 * plate_side;
        const bool is_inner = x * tip.direction.x() < 0.0;
        (is_inner ? inner : outer) += 0.5 * std::abs(x);
        (is_inner ? result.inner : result.outer) += 0.5 * release_along(*held, tip);
    }
    held->state().tips.clear();
    for (const TearTip& tip : cut.tips) {
        const double x = cut.sheet->mesh.nodes[at(tip.node)].x() - 0.5 * plate_side;
        result.blind += x * tip.direction.x() < 0.0 ? 0.5 * release_along(*held, tip) : 0.0;
    }
    const double modulus = std::sqrt(1.0 - inner * inner / (outer * outer));
    const double share = std::comp_ellint_2(modulus) / std::comp_ellint_1(modulus);
    const double apart = outer * outer - inner * inner;
    const auto squared = [](double v) { return v * v; };
    const double unit = plate_stress * plate_stress * M_PI / young_modulus;
    result.expected_inner = unit * squared(outer * outer * share - inner * inner) / (inner * apart);
    result.expected_outer = unit * outer * outer * outer * squared(1.0 - share) / apart;
    return result;
}

}  // namespace rhexis::scenes
