// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/wound_cutting.hpp"

#include <algorithm>
#include <cmath>

#include "physics/anatomy/wound_closing.hpp"

namespace rhexis {

namespace {

constexpr double chunk = 0.25;       ///< of a blade's way, whose direction is looked at [mm]. Proposal
constexpr double last_chunk = 0.1;   ///< and of the last before it comes out [mm]. Proposal
constexpr double bend = 0.94;        ///< cosine, 20 degrees: a change of direction is another plane. Proposal
constexpr double scratch = 0.05;     ///< depth that is no cut yet [mm]
constexpr double same_entry = 0.75;  ///< a blade that comes back so near to an outer lip goes into that wound [mm]
constexpr double main_blade = 1.6;   ///< a blade so wide cuts the main wound [mm]
constexpr double film = 0.06;        ///< about Descemet's membrane, in which a blade drags it along [mm]. Proposal
constexpr double grazing = 0.17;     ///< sine, 10 degrees: so flat a way does. Proposal
constexpr double opening = 0.3;      ///< of the inner lip towards the axis, through which a tip comes [mm]. Proposal
constexpr double inner_lip_reach = 2.0;  ///< of an inner lip [mm]
constexpr double flap_reach = 3.0;   ///< of an inner lip: viscoelastic given so near flattens its flap [mm]. Proposal
constexpr double flattening = 3.0;   ///< of a flap by a syringe pressed with full force [1/s]. Proposal
constexpr double least_peel = 0.02;  ///< less is none [mm]
constexpr double leaves_iris = 0.1;  ///< a touch ends when the gap is as wide [mm]

/// Where a way from a to b meets a surface from which they have these distances, of different sign.
Vec3 crossing(const Vec3& a, double from, const Vec3& b, double to) { return a + from / (from - to) * (b - a); }

void follow(const Vec3& place, double least, Wound& wound) {
    const Vec3 way = place - wound.mark;
    const double length = way.norm();
    if (length < least) {
        return;
    }
    const Vec3 direction = way / length;
    const double turned = wound.heading.squaredNorm() > 0.0 ? direction.dot(wound.heading) : 1.0;
    if (turned < 0.0) {
        return;  // it is drawn back
    }
    wound.planes += turned < bend ? 1 : 0;
    wound.heading = direction;
    wound.mark = place;
    wound.tunnel += length;
}

/// The wound that leaks more is kept of those that were left.
void leave_wound(const WoundsModel& model, const Wound& left, Wound& kept) {
    const double usual = 20.0 * pascal_per_mmhg;
    if (!kept.cut ||
        wound_conductance(model, left, 0.0, usual, 0.0) > wound_conductance(model, kept, 0.0, usual, 0.0)) {
        kept = left;
    }
}

void begin(const WoundsModel& model, std::size_t which, const Vec3& place, WoundsState& state) {
    Wound& wound = state.wounds[which];
    if (wound.begun && (place - wound.outer).norm() < same_entry) {
        return;
    }
    if (wound.cut && which == main_wound) {
        leave_wound(model, wound, state.wounds[old_wound]);
    }
    const Vec3 planned = wound.inner;
    wound = Wound{};
    wound.inner = planned;
    wound.begun = true;
    wound.outer = wound.mark = place;
    wound.planes = 1;
}

/// The blade widens behind its point, and what it moves sideways it cuts.
void widen(const ToolModel& blade, const ToolState& tool, Wound& wound) {
    const Vec3& tip = tool.pose.position;
    const Vec3 axis = tool.pose.orientation * Vec3::UnitZ();
    const double off = (tip + (wound.outer - tip).dot(axis) * axis - wound.outer).dot(along_lip(wound));
    wound.left = std::min(wound.left, off);
    wound.right = std::max(wound.right, off);
    wound.passed = std::max(wound.passed, (tip - wound.inner).norm());
    const double share = std::clamp(wound.passed / std::max(blade.blade_point, 0.01), 0.0, 1.0);
    wound.width = std::max(wound.width, blade.blade_width * share + wound.right - wound.left);
}

void peel(double length, Wound& wound) {
    wound.peel += length;
    wound.most_peel = std::max(wound.most_peel, wound.peel);
}

/// A blade that goes along the back of the cornea drags its membrane with it.
void drag_membrane(const WoundsModel& model, const Vec3& from, const Vec3& to, Wound& wound) {
    const Vec3 way = to - from;
    const double length = way.norm();
    const double inwards = inset_of(model, to) - inset_of(model, from);
    if (!(inwards > 0.0) || std::abs(beyond_back(model, to)) > film) {
        return;
    }
    const Vec3 normal = (to - model.back_centre).normalized();
    if (std::abs(normal.dot(way)) < grazing * length) {
        peel(length, wound);
    }
}

void cut(const WoundsModel& model, const ToolModel& blade, const ToolState& tool, WoundsState& state) {
    const std::size_t which = blade.blade_width > main_blade ? main_wound : side_port;
    const Vec3& from = tool.previous_pose.position;
    const Vec3& to = tool.pose.position;
    const double depth = below_front(model, to);
    if (!(depth > scratch)) {
        return;
    }
    if (const double before = below_front(model, from); !(before > scratch)) {
        begin(model, which, crossing(from, before, to, depth), state);
    }
    Wound& wound = state.wounds[which];
    if (!wound.begun) {
        return;
    }
    drag_membrane(model, from, to, wound);
    const double past = beyond_back(model, to);
    if (!wound.cut && past > 0.0) {
        const double before = beyond_back(model, from);
        wound.inner = before < 0.0 ? crossing(from, before, to, past) : from;
        follow(wound.inner, last_chunk, wound);
        wound.tunnel += (wound.inner - wound.mark).norm();
        wound.cut = true;
        state.checked = false;
    } else if (!wound.cut) {
        follow(to, chunk, wound);
    }
    if (wound.cut && past > 0.0) {
        widen(blade, tool, wound);
    }
}

/// How high the tip stands over iris or lens [mm].
double clearance(const WoundsModel& model, const WorldState& state, double shift, const Vec3& tip) {
    const double rho = tip.head<2>().norm();
    const double pupil = state.iris ? state.iris->pupil_radius : model.pupil_radius;
    const double share = rho / model.lens_radius;
    const double lens = model.lens_front * std::sqrt(std::max(0.0, 1.0 - share * share));
    return tip.z() - (rho > pupil ? model.iris_z : lens) - shift;
}

void count_touches(const WorldModel& world, std::span<const ToolState> tools, WorldState& state) {
    const WoundsModel& model = *world.wounds;
    const double shift = diaphragm_shift(*world.chamber, volume_in_front(*state.chamber, &*state.wounds), 0.0);
    double least = leaves_iris;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const Vec3& tip = tools[i].pose.position;
        if (world.tools[i].kind == ToolKind::blade && tools[i].present && beyond_back(model, tip) > 0.0) {
            least = std::min(least, clearance(model, state, shift, tip));
        }
    }
    WoundsState& wounds = *state.wounds;
    if (least <= 0.0 && !wounds.touching) {
        ++wounds.touches;
        wounds.touching = true;
    } else if (least >= leaves_iris) {
        wounds.touching = false;
    }
}

bool is_blunt(const ToolModel& tool) {
    return tool.kind != ToolKind::blade && tool.kind != ToolKind::needle && tool.kind != ToolKind::sponge;
}

/// A blunt tip that comes out of the stroma beside the opening of the inner lip takes the membrane with it.
void catch_membrane(const WoundsModel& model, int tool, const ToolState& state, WoundsState& wounds) {
    const Vec3& from = state.previous_pose.position;
    const Vec3& to = state.pose.position;
    const double before = beyond_back(model, from);
    const double past = beyond_back(model, to);
    if (!(before <= 0.0 && past > 0.0 && below_front(model, from) > 0.0)) {
        return;
    }
    const Vec3 place = crossing(from, before, to, past);
    for (std::size_t i = 0; i < wound_count; ++i) {
        Wound& wound = wounds.wounds[i];
        const double beside = inset_of(model, place) - inset_of(model, wound.inner) - opening;
        if (wound.cut && beside > 0.0 && (place - wound.inner).norm() < inner_lip_reach) {
            wounds.catching = tool;
            wounds.caught_at = i;
            return;
        }
    }
}

void push_membrane(const WorldModel& world, std::span<const ToolState> tools, WoundsState& wounds) {
    const WoundsModel& model = *world.wounds;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (!tools[i].present || !is_blunt(world.tools[i])) {
            continue;
        }
        if (wounds.catching < 0) {
            catch_membrane(model, static_cast<int>(i), tools[i], wounds);
        }
        if (wounds.catching == static_cast<int>(i)) {
            const double way =
                inset_of(model, tools[i].pose.position) - inset_of(model, tools[i].previous_pose.position);
            peel(std::max(0.0, way), wounds.wounds[wounds.caught_at]);
        }
    }
    if (wounds.catching >= 0) {
        const ToolState& tool = tools[static_cast<std::size_t>(wounds.catching)];
        if (!tool.present || beyond_back(model, tool.pose.position) < 0.0) {
            wounds.catching = -1;
        }
    }
}

/// Viscoelastic under a flap lays it flat again, unless a tip still holds it.
void flatten(const WorldModel& world, std::span<const ToolState> tools, double dt, WoundsState& wounds) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        const Vec3& tip = tools[i].pose.position;
        if (world.tools[i].kind != ToolKind::cannula || world.tools[i].stains || !tools[i].present ||
            !(tools[i].jaw > 0.0) || beyond_back(*world.wounds, tip) < 0.0) {
            continue;
        }
        for (std::size_t k = 0; k < wound_count; ++k) {
            Wound& wound = wounds.wounds[k];
            const bool held = wounds.catching >= 0 && wounds.caught_at == k;
            if (wound.cut && !held && (tip - wound.inner).norm() < flap_reach) {
                wound.peel /= 1.0 + flattening * tools[i].jaw * dt;
                wound.peel = wound.peel < least_peel ? 0.0 : wound.peel;
            }
        }
    }
}

}  // namespace

void cut_wounds(const WorldModel& model, std::span<const ToolState> tools, double dt, WorldState& state) {
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (model.tools[i].kind == ToolKind::blade && tools[i].present) {
            cut(*model.wounds, model.tools[i], tools[i], *state.wounds);
        }
    }
    count_touches(model, tools, state);
    push_membrane(model, tools, *state.wounds);
    flatten(model, tools, dt, *state.wounds);
}

}  // namespace rhexis
