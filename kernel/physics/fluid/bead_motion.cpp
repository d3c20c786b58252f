// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/fluid/bead_motion.hpp"

#include <algorithm>

namespace rhexis {
namespace {

bool holds_one(const BeadsState& beads, int tool) {
    return std::any_of(beads.beads.begin(), beads.beads.end(), [&](const Bead& bead) { return bead.tool == tool; });
}

/// Jaws that close take the nearest bead in their reach.
void take(const BeadsModel& model, const ToolState& forceps, int tool, BeadsState& beads) {
    if (!(forceps.previous_jaw >= closed_jaw && forceps.jaw < closed_jaw) || holds_one(beads, tool)) {
        return;
    }
    Bead* nearest = nullptr;
    double least = model.grip;
    for (Bead& bead : beads.beads) {
        const double away = (bead.position - forceps.pose.position).norm();
        if (bead.tool < 0 && away <= least) {
            nearest = &bead;
            least = away;
        }
    }
    if (nearest != nullptr) {
        nearest->tool = tool;
        nearest->off = nearest->position - forceps.pose.position;
        ++beads.grasps;
    }
}

/// What jaws hold goes with their tip, until they open or leave, or the tip moves faster than the grip bears.
void carry(const BeadsModel& model, const ToolState& forceps, Bead& bead, BeadsState& beads) {
    const bool kept = forceps.present && forceps.jaw < closed_jaw && forceps.velocity.norm() <= model.slip_speed;
    if (kept) {
        bead.position = forceps.pose.position + bead.off;
        return;
    }
    bead.tool = -1;
    beads.drops += over_tray(model, bead.position) ? 0 : 1;
}

void sink(const BeadsModel& model, double dt, Bead& bead) {
    bead.position.z() = std::max(model.floor, bead.position.z() - model.sinking * dt);
    const double out = bead.position.head<2>().norm();
    if (out > model.wall) {
        bead.position.head<2>() *= model.wall / out;
    }
}

}  // namespace

void move_beads(const WorldModel& world, std::span<const ToolState> tools, double dt, BeadsState& beads) {
    const BeadsModel& model = *world.beads;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (world.tools[i].kind == ToolKind::forceps && tools[i].present) {
            take(model, tools[i], static_cast<int>(i), beads);
        }
    }
    for (Bead& bead : beads.beads) {
        if (bead.tool >= 0) {
            carry(model, tools[static_cast<std::size_t>(bead.tool)], bead, beads);
        } else {
            sink(model, dt, bead);
        }
    }
}

}  // namespace rhexis
