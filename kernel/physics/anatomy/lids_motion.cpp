// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/anatomy/lids_motion.hpp"

#include <algorithm>

namespace rhexis {
namespace {

constexpr double water_weight = 9.81;  ///< pressure per height of saline: 9.81 Pa per mm

/// A drape that is pressed takes the lashes in its reach under it. They stay there.
void cover(const LidsModel& model, const ToolState& drape, LidsState& lids) {
    if (drape.jaw < model.press) {
        return;
    }
    for (int place = 0; place < static_cast<int>(lids.covered.size()); ++place) {
        const Vec3 lash = lash_place(model, lids.opening, place);
        if ((lash - drape.pose.position).norm() <= model.reach) {
            lids.covered[static_cast<std::size_t>(place)] = 1;
        }
    }
}

/// The spring of a speculum between the lids opens them as far as the hand lets it, and stays.
void open(const LidsModel& model, const ToolState& speculum, LidsState& lids) {
    const Vec3& tip = speculum.pose.position;
    if (tip.head<2>().norm() <= model.speculum_in && tip.z() < model.air_z) {
        lids.opening = std::max(lids.opening, std::clamp(speculum.jaw, 0.0, 1.0));
    }
}

/// In the air the bottle's pressure drives the infusion out of the tip against its line alone.
void test_pedal(const LidsModel& model, const ToolState& tip, double dt, LidsState& lids) {
    const bool runs = tip.irrigation && tip.bottle_height > 0.0;
    lids.drip += runs ? tip.bottle_height * water_weight / model.infusion_resistance : 0.0;
    const bool sucks = tip.aspiration > 0.0 && tip.pump_flow > 0.0;
    lids.tested[0] += runs && tip.aspiration == 0.0 ? dt : 0.0;
    lids.tested[1] += runs && sucks && tip.power == 0.0 ? dt : 0.0;
    lids.tested[2] += runs && sucks && tip.power > 0.0 ? dt : 0.0;
}

}  // namespace

void move_lids(const WorldModel& world, std::span<const ToolState> tools, double dt, LidsState& lids) {
    const LidsModel& model = *world.lids;
    lids.drip = 0.0;
    for (std::size_t i = 0; i < tools.size(); ++i) {
        if (!tools[i].present) {
            continue;
        }
        if (world.tools[i].kind == ToolKind::drape) {
            cover(model, tools[i], lids);
        } else if (world.tools[i].kind == ToolKind::speculum) {
            open(model, tools[i], lids);
        } else if (world.tools[i].kind == ToolKind::phaco && tools[i].pose.position.z() >= model.air_z) {
            test_pedal(model, tools[i], dt, lids);
        }
    }
}

}  // namespace rhexis
