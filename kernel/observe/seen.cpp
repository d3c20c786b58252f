// SPDX-License-Identifier: GPL-3.0-or-later
#include "observe/seen.hpp"

#include <string>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "math/roots.hpp"
#include "observe/bag_edge.hpp"

namespace rhexis {
namespace {

bool over_pupil(const EyeAnatomy& eye, const Vec3& place) {
    return place.x() * place.x() + place.y() * place.y() <= eye.pupil_radius * eye.pupil_radius;
}

Landmark in_lens(const std::string& name, bool exists, const Vec3& rest, double size, const LensMotion& motion,
                 const EyeAnatomy& eye) {
    const Vec3 place = motion.to_eye(rest);
    return {name, exists && over_pupil(eye, place), place, size};
}

Landmark surface_at_tip(const ObserveInput& input, const LensView& lens) {
    Landmark mark{"surface_at_tip", false, Vec3::Zero(), 0.0};
    if (input.tools.empty() || !input.tools[0].present) {
        return mark;
    }
    const Vec3 rest = lens.motion->to_rest(input.tools[0].pose.position);
    const Vec2 across(rest.x(), rest.y());
    const int cell = lens.grid->cell_at(across);
    if (cell < 0 || !lens.grid->inside(cell)) {
        return mark;
    }
    const double depth = local_depth(*lens.grid, *lens.fill, cell);
    const Vec3 place(rest.x(), rest.y(), front_surface(*lens.grid, across) - depth);
    return in_lens("surface_at_tip", true, place, 0.0, *lens.motion, input.eye.anatomy);
}

/// Of each groove that can be told apart: both ends on the front of the lens and the deepest place of its floor. They
/// turn with the lens, so that a turn can be seen.
void add_groove_landmarks(const LensView& lens, const EyeAnatomy& eye, std::vector<Landmark>& marks) {
    for (std::size_t i = 0; i < lens.arms->size(); ++i) {
        const GrooveShape& groove = (*lens.arms)[i];
        const std::string name = "groove_" + std::to_string(i + 1);
        const double size = 0.5 * groove.width;
        marks.push_back(in_lens(name + "_start", true, groove.near_end, size, *lens.motion, eye));
        marks.push_back(in_lens(name + "_end", true, groove.far_end, size, *lens.motion, eye));
        marks.push_back(in_lens(name + "_floor", true, groove.floor, 0.0, *lens.motion, eye));
    }
}

void add_lens_landmarks(const ObserveInput& input, const LensView& lens, std::vector<Landmark>& marks) {
    const EyeAnatomy& eye = input.eye.anatomy;
    const GrooveShape& groove = *lens.groove;
    const Vec3 pole(0.0, 0.0, front_surface(*lens.grid, Vec2::Zero()));
    marks.push_back(in_lens("lens_front", true, pole, 0.0, *lens.motion, eye));
    marks.push_back(surface_at_tip(input, lens));
    marks.push_back(in_lens("groove_near", groove.exists, groove.near_end, 0.5 * groove.width, *lens.motion, eye));
    marks.push_back(in_lens("groove_far", groove.exists, groove.far_end, 0.5 * groove.width, *lens.motion, eye));
    marks.push_back(in_lens("groove_floor", groove.exists, groove.floor, 0.0, *lens.motion, eye));
    add_groove_landmarks(lens, eye, marks);
}

/// From how many degrees without zonules on the bag visibly lacks its hold there. Proposal
constexpr double seen_gap_deg = 30.0;

/// Height of the edge of the opening over the equator, share of the front pole's.
double rim_share(const BagModel& bag) {
    const double share = bag.opening_radius / bag.shape.radius;
    return std::sqrt(std::max(0.0, 1.0 - share * share));
}

/// The edge of the opened anterior capsule; it shows where the pupil is wider.
Landmark capsulorhexis(const BagModel& bag, const BagState& state, const EyeAnatomy& eye) {
    const double share = bag.opening_radius / bag.shape.radius;
    const Vec3 middle(0.0, 0.0, bag.shape.anterior * std::sqrt(std::max(0.0, 1.0 - share * share)));
    return {"capsulorhexis", bag.opening_radius > 0.0 && bag.opening_radius < eye.pupil_radius,
            state.pose.to_world(middle), bag.opening_radius};
}

/// The open end of a tip, or the end of what has none.
Vec3 mouth_of(const ToolModel& tool, const Pose& pose) {
    return tool.bore_radius > 0.0 ? pose.to_world(tip_mouth(tool).centre) : pose.position;
}

/// Pieces that the lens is in, the largest first, and where each is nearest to the first instrument's tip.
void add_fragment_landmarks(const ObserveInput& input, const LensView& lens, std::vector<Landmark>& marks) {
    constexpr std::size_t most = 8;  // that one keeps apart
    const std::vector<LensPiece>& pieces = *lens.pieces;
    const EyeAnatomy& eye = input.eye.anatomy;
    const bool tool = !input.tools.empty() && input.tools[0].present;
    const std::vector<Vec3> near = tool ? nearest_tissue(*lens.model, input.state.solids[0], pieces,
                                                         mouth_of(input.world.tools[0], input.tools[0].pose))
                                        : std::vector<Vec3>{};
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return pieces[a].volume > pieces[b].volume; });
    for (std::size_t i = 0; i < std::min(most, order.size()); ++i) {
        const LensPiece& piece = pieces[order[i]];
        const std::string name = "fragment_" + std::to_string(i + 1);
        marks.push_back({name, over_pupil(eye, piece.centre), piece.centre, ball_radius(piece.volume)});
        if (tool) {
            marks.push_back({name + "_near", over_pupil(eye, near[order[i]]), near[order[i]], 0.0});
        }
    }
}

/// Clear vitreous shows by what it does: the pupil peaks towards a strand in the wound. Triamcinolone shows it itself.
void add_vitreous_landmarks(const ObserveInput& input, std::vector<Landmark>& marks) {
    constexpr double shows = 0.3;  // of what hangs in front: share that is white
    constexpr double peaks = 1.0;  // of what hangs in the wound [mm^3]
    const VitreousState& vitreous = *input.state.vitreous;
    const Vec3 hole = vitreous_place(input.world, input.state.bags, *input.state.capsule, vitreous);
    const double front = vitreous_in_front(vitreous);
    const double radius = vitreous_radius(front);
    marks.push_back({"pupil_peak", vitreous.wound > peaks, input.world.vitreous->wound, vitreous.wound});
    marks.push_back({"vitreous", vitreous.marked > shows && front > 0.1, hole + radius * Vec3::UnitZ(), radius});
    marks.push_back({"vitreous_strand", vitreous.marked > shows && vitreous.wound > 0.1, input.world.vitreous->wound,
                     vitreous_radius(vitreous.wound)});
    // Its edge bends the light: how full the chamber is of it can be judged as in a still chamber.
    marks.push_back({"viscoelastic", true, Vec3(0.0, 0.0, input.eye.anatomy.iris_z),
                     filled_share(*input.world.vitreous, vitreous)});
}

/// A bag that lies beside its place: its edge, where it comes out behind the iris, and its tilt. Where zonules lack
/// lies under the iris: it shows by the edge of the opening, where the pupil does. Hooks and ring show.
void add_zonule_landmarks(const ObserveInput& input, std::vector<Landmark>& marks) {
    const EyeAnatomy& eye = input.eye.anatomy;
    const BagState& bag = input.state.bags[0];
    const ZonuleGap gap = widest_gap(input.world.bags[0], *bag.zonules);
    const BagEdge edge = bag_edge(input);
    marks.push_back({"bag_edge", edge.inside > 0.0, edge.place, edge.inside});
    // Towards a gap the edge of the opening stands nearest to the middle: there it lacks its hold.
    const Vec3 slack_edge =
        bag.pose.to_world(input.world.bags[0].opening_radius * gap.middle +
                          input.world.bags[0].shape.anterior * rim_share(input.world.bags[0]) * Vec3::UnitZ());
    marks.push_back({"zonule_gap", gap.width_deg >= seen_gap_deg && over_pupil(eye, slack_edge), slack_edge,
                     0.5 * gap.width_deg * std::numbers::pi / 180.0 * input.world.bags[0].opening_radius});
    marks.push_back({"ring", bag.zonules->ring >= 1.0, bag.pose.position, input.world.bags[0].shape.radius});
    for (std::size_t i = 0; i < bag.zonules->hooks.size(); ++i) {
        marks.push_back(
            {"capsule_hook_" + std::to_string(i + 1), true, bag.pose.to_world(bag.zonules->hooks[i].on_bag), 0.0});
    }
}

/// The wave by its edge in the reflex, how far the lens has turned by a spoke of its cortex, the pupil as it is now.
void add_hydrodissection_landmarks(const ObserveInput& input, const LensView& lens, std::vector<Landmark>& marks) {
    const HydrodissectionState& hydro = *input.state.hydrodissection;
    const Pose& bag = input.state.bags[0].pose;
    marks.push_back({"fluid_wave", wave_share(hydro) > 0.0, bag.to_world(hydro.entry), wave_share(hydro)});
    if (lens.motion != nullptr) {
        constexpr double spoke = 2.0;  // from the axis [mm]
        const Vec2& turn = lens.motion->turn;
        const Vec3 place(spoke * turn.x(), spoke * turn.y(), bag.position.z() + input.world.bags[0].shape.anterior);
        marks.push_back({"cortical_spoke", true, place, 0.1});
    }
    if (input.state.iris) {
        marks.push_back({"pupil_edge", true, Vec3(0.0, 0.0, input.state.iris->z), input.state.iris->pupil_radius});
    }
}

/// Of each sector that has cortex, the outermost that the iris leaves free, in the fornix or on the back; size: share
/// of the sector that is left and shows. Of cortex that a mouth holds, the mouth.
void add_cortex_landmarks(const ObserveInput& input, std::vector<Landmark>& marks) {
    const CortexModel& model = *input.world.cortex;
    const CortexState& cortex = *input.state.cortex;
    const EyeAnatomy& eye = input.eye.anatomy;
    const int rings = model.cells.rings;
    for (int sector = 0; sector < model.cells.sectors; ++sector) {
        double left = 0.0;
        Vec3 outermost = Vec3::Zero();
        for (int ring = 0; ring < rings; ++ring) {
            const int cell = sector * rings + ring;
            const double volume = cortex.volume[static_cast<std::size_t>(cell)];
            const Vec3 place = input.state.bags[0].pose.to_world(cortex_place(model, input.world.bags[0].shape, cell));
            if (volume > 0.0 && over_pupil(eye, place)) {
                left += volume / (model.volume * rings);
                outermost = place;
            }
        }
        marks.push_back({"cortex_" + std::to_string(sector + 1), left > 0.02, outermost, left});
    }
    const bool held = cortex.held && cortex.tool >= 0;
    const auto tool = static_cast<std::size_t>(std::max(0, cortex.tool));
    const Vec3 mouth = held ? mouth_of(input.world.tools[tool], input.tools[tool].pose) : Vec3(Vec3::Zero());
    marks.push_back({"cortex_at_tip", held && over_pupil(eye, mouth), mouth, 0.3});
}

/// How the implant lies, and what is left before and behind it: an optic on viscoelastic floats when it is touched.
void add_retained_landmarks(const ObserveInput& input, std::vector<Landmark>& marks) {
    constexpr double floats = 0.03;  // of all viscoelastic, behind the optic
    const RetainedViscoelasticModel& model = *input.world.retained;
    const RetainedViscoelasticState& left = *input.state.retained;
    const double start = std::max(1.0, viscoelastic_at_start(model));
    const Vec3 optic = input.state.bags[0].pose.to_world(Vec3(0.0, 0.0, model.optic_z));
    marks.push_back({"optic", true, optic, model.optic_radius});
    marks.push_back({"optic_floats", left.behind > floats * start, optic, left.behind / start});
    marks.push_back(
        {"viscoelastic", left.front > floats * start, Vec3(0.0, 0.0, input.eye.anatomy.iris_z), left.front / start});
}

/// What shows of a capsule that is held or open, and of an iris that is caught.
void add_harm_landmarks(const ObserveInput& input, std::vector<Landmark>& marks) {
    if (input.state.capsule) {
        const CapsuleState& capsule = *input.state.capsule;
        const Pose& bag = input.state.bags[0].pose;
        marks.push_back({"capsule_folds", capsule.captured, bag.to_world(capsule.place), 1.0});
        marks.push_back(
            {"capsule_hole", capsule.hole_radius > 0.0, bag.to_world(capsule.hole_place), capsule.hole_radius});
    }
    if (input.state.vitreous) {
        add_vitreous_landmarks(input, marks);
    }
    if (input.state.globe) {
        const EyeAnatomy& eye = input.eye.anatomy;
        marks.push_back({"limbus", true, Vec3(0.0, 0.0, eye.limbus_z), eye.limbus_radius});
    }
    if (input.state.prolapse) {
        const bool shows = input.state.prolapse->length > 0.2;
        const Wound& wound = input.state.wounds->wounds[main_wound];
        marks.push_back({"iris_prolapse", shows, wound.outer, input.state.prolapse->length});
    }
    if (!input.state.bags.empty() && input.state.bags[0].zonules) {
        add_zonule_landmarks(input, marks);
    }
    if (input.state.cortex) {
        add_cortex_landmarks(input, marks);
    }
    if (input.state.retained) {
        add_retained_landmarks(input, marks);
    }
    if (input.state.iris) {
        marks.push_back({"iris_caught", input.state.iris->tool >= 0, input.state.iris->place, 0.5});
    }
}

/// Where wounds are to be cut or have been, how they stand open, what comes out of them, and what holds them.
void add_wound_landmarks(const ObserveInput& input, std::vector<Landmark>& marks) {
    constexpr double shows_gape = 0.1;      // share of a wound without a tunnel
    constexpr double shows_fluid = 0.3;     // [mm^3]
    constexpr double shows_swelling = 0.3;  // share of the most
    constexpr double shows_peel = 0.3;      // [mm]
    const WoundsState& state = *input.state.wounds;
    const Wound& main = state.wounds[main_wound];
    const Wound& side = state.wounds[side_port];
    marks.push_back({"incision_site", true, main.outer, 0.5 * main.width});
    marks.push_back({"side_port_site", true, side.outer, 0.5 * side.width});
    marks.push_back({"wound_gape", main.gape > shows_gape, main.outer, main.gape});
    marks.push_back({"wound_fluid", main.fluid > shows_fluid, main.outer, ball_radius(main.fluid)});
    marks.push_back({"side_port_fluid", side.fluid > shows_fluid, side.outer, ball_radius(side.fluid)});
    marks.push_back({"stroma_white", main.swelling > shows_swelling, main.outer, main.swelling});
    marks.push_back({"side_port_white", side.swelling > shows_swelling, side.outer, side.swelling});
    marks.push_back({"descemet_flap", main.peel > shows_peel, main.inner, main.peel});
    marks.push_back({"stitches", main.sutures > 0, main.outer, static_cast<double>(main.sutures)});
    // How hard the eye is, is felt by what presses on it.
    marks.push_back({"hardness", main.press > 0.0 || side.press > 0.0, main.outer,
                     eye_pressure(*input.world.chamber, input.state.chamber->eye_volume) / pascal_per_mmhg});
}

/// Lashes that stick out, the infusion that runs from a tip in the air, and where hands and instruments come from.
void add_lids_landmarks(const ObserveInput& input, std::vector<Landmark>& marks) {
    const LidsModel& model = *input.world.lids;
    const LidsState& lids = *input.state.lids;
    for (std::size_t place = 0; place < lids.covered.size(); ++place) {
        marks.push_back({"lash_" + std::to_string(place + 1), lids.covered[place] == 0,
                         lash_place(model, lids.opening, static_cast<int>(place)), 1.0});
    }
    marks.push_back({"drip", lids.drip > 0.0, Vec3(0.0, 0.0, model.air_z), lids.drip});
    marks.push_back({"hand_rest", true, Vec3(0.0, -12.0, model.air_z + 3.0), 1.0});
}

void add_bead_landmarks(const ObserveInput& input, std::vector<Landmark>& marks) {
    const BeadsModel& model = *input.world.beads;
    const std::vector<Bead>& beads = input.state.beads->beads;
    for (std::size_t i = 0; i < beads.size(); ++i) {
        marks.push_back({"bead_" + std::to_string(i + 1), true, beads[i].position, model.radius});
    }
    marks.push_back({"tray", true, model.target, model.target_radius});
}

}  // namespace

Percept seen(const ObserveInput& input, const LensView& lens, bool iris) {
    const EyeAnatomy& eye = input.eye.anatomy;
    Percept percept;
    percept.time_s = input.state.time_s;
    for (std::size_t i = 0; i < input.tools.size(); ++i) {
        percept.tools.push_back({input.world.tools[i].name, input.tools[i].present, input.tools[i].pose});
    }
    percept.landmarks.push_back({"pupil", iris, Vec3(0.0, 0.0, eye.iris_z), eye.pupil_radius});
    percept.landmarks.push_back({"incision", true, eye.incision, 0.5 * eye.incision_width});
    percept.landmarks.push_back({"wound_white", eye.wound_burn > 0.0, eye.incision, eye.wound_burn});
    percept.landmarks.push_back({"side_port", eye.side_port_width > 0.0, eye.side_port, 0.5 * eye.side_port_width});
    if (!input.tools.empty()) {
        percept.pedal = input.tools[0].pedal;
        percept.power = input.tools[0].power;
    }
    if (input.state.chamber) {
        const ChamberModel& chamber = *input.world.chamber;
        percept.vacuum_mmhg =
            std::max(0.0, -tube_pressure(chamber, input.state.chamber->tube_volume) / pascal_per_mmhg);
        percept.flow_ml_min = input.state.flows.pump / mm3_s_per_ml_min;
        if (lens.pieces != nullptr) {
            add_fragment_landmarks(input, lens, percept.landmarks);
        }
    }
    add_harm_landmarks(input, percept.landmarks);
    if (input.state.wounds) {
        add_wound_landmarks(input, percept.landmarks);
    }
    if (input.state.hydrodissection) {
        add_hydrodissection_landmarks(input, lens, percept.landmarks);
    }
    if (lens.model != nullptr) {
        add_lens_landmarks(input, lens, percept.landmarks);
        if (!input.world.bags.empty()) {
            percept.landmarks.push_back(capsulorhexis(input.world.bags[0], input.state.bags[0], eye));
        }
        percept.reflex_brightness = lens.reflex->mean_brightness;
        if (!input.tools.empty() && input.tools[0].present) {
            percept.tip_brightness = reflex_around(*lens.reflex, *lens.grid, *lens.fill, *lens.motion, eye.pupil_radius,
                                                   input.tools[0].pose.position, reflex_at_tip_mm);
        }
    }
    if (input.state.lids) {
        add_lids_landmarks(input, percept.landmarks);
    }
    if (input.state.beads) {
        add_bead_landmarks(input, percept.landmarks);
    }
    return percept;
}

void put_into_room(const GlobeModel& model, const GlobeState& globe, Percept& percept) {
    for (Landmark& mark : percept.landmarks) {
        mark.position = to_room(model, globe, mark.position);
    }
    for (PerceivedTool& tool : percept.tools) {
        tool.pose = to_room(model, globe, tool.pose);
    }
}

Vec3 pupil_middle(const ObserveInput& input) {
    const Vec3 middle(0.0, 0.0, input.eye.anatomy.iris_z);
    return input.state.globe ? to_room(*input.world.globe, *input.state.globe, middle) : middle;
}

void add_bridge_landmark(double share, const Vec3& place, const EyeAnatomy& eye, Percept& percept) {
    if (share > 0.0) {
        percept.landmarks.push_back({"bridge", over_pupil(eye, place), place, 3.5 * std::sqrt(share)});
    }
}

}  // namespace rhexis
