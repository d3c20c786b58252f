// SPDX-License-Identifier: GPL-3.0-or-later
#include "track/camera_views.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace rhexis::tracking {
namespace {

template <typename... Values>
std::string printed(const char* format, Values... values) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

ScreenRow row_of(const std::string& name, std::size_t number, const TrackedBody& body) {
    ScreenRow row{body_colour(number), {name, word_of(body.seen)}};
    if (body.seen != Seen::lost) {
        const Vec3& tip = body.tip.position;
        row.cells.push_back(std::to_string(body.cameras));
        row.cells.push_back(std::to_string(body.markers));
        row.cells.push_back(printed("%.3f", body.residual_px));
        for (const double along : {tip.x(), tip.y(), tip.z()}) {
            row.cells.push_back(printed("%.2f", along));
        }
    }
    return row;
}

/// The rig's own, or that too many exposures do not come.
std::string warning_of(const RigHealth& health, std::size_t cameras) {
    constexpr double usual = 0.01;  // of all
    const double all = health.sets_per_s * static_cast<double>(cameras);
    if (!health.warning.empty() || static_cast<double>(health.lost_lately) <= usual * all) {
        return health.warning;
    }
    return printed("%llu of %.0f exposures did not come in the last second",
                   static_cast<unsigned long long>(health.lost_lately), all);
}

bool is_wanted(const ScreenWish& wish, int picture) { return wish.one < 0 || wish.one == picture; }

void add_pictures(const Rig& rig, std::span<const MarkerBody> bodies, const SeenByCameras& seen, const ScreenWish& wish,
                  ScreenMoment& moment) {
    const int width = std::clamp(wish.picture_width, 64, 4096);
    for (int i = 0; i < static_cast<int>(rig.cameras.size()); ++i) {
        moment.pictures.push_back({rig.cameras[static_cast<std::size_t>(i)].name,
                                   is_wanted(wish, i) ? annotated_camera(rig, bodies, seen, i, width) : Image{},
                                   false});
    }
}

}  // namespace

ScreenMoment moment_of(const Setup& setup, const TrackingView& view, const ScreenWish& wish) {
    ScreenMoment moment;
    moment.state = printed("%.1f s   %.0f exposures/s, %.2f ms each, %llu lost; %zu listening", view.told.time_s,
                           view.health.sets_per_s, view.health.compute_ms,
                           static_cast<unsigned long long>(view.health.lost), view.health.listeners);
    moment.warning = warning_of(view.health, setup.rig.cameras.size());
    add_pictures(setup.rig, setup.bodies, view.seen, wish, moment);
    if (view.health.warned_camera >= 0) {
        moment.pictures[static_cast<std::size_t>(view.health.warned_camera)].warned = true;
    }
    moment.titles = {"body", "state", "cameras", "markers", "residual, pixels", "tip x, mm", "y", "z"};
    for (std::size_t i = 0; i < view.told.bodies.size(); ++i) {
        moment.rows.push_back(row_of(setup.bodies[i].name, i, view.told.bodies[i]));
    }
    moment.legend = {"ring: a spot that was found", "cross: where a marker of a body should be",
                     "dot and line: its tip, and 60 mm of its shaft"};
    return moment;
}

CalibrationView view_of(const Rig& rig, const WandLook& look) {
    CalibrationView view{look.share, {look.exposures, look.images, {}}, wand_coverage(rig, look.frames), {}};
    view.views.assign(rig.cameras.size(), 0);
    for (const WandFrame& frame : look.frames) {
        for (const WandView& one : frame.views) {
            ++view.views[static_cast<std::size_t>(one.camera)];
        }
    }
    return view;
}

ScreenMoment moment_of(const Setup& setup, const CalibrationView& view, const ScreenWish& wish) {
    constexpr std::array<unsigned char, 3> white{220, 220, 220};
    ScreenMoment moment;
    moment.state = printed("%s: %.0f %%", wand_advice, 100.0 * view.share);
    add_pictures(setup.rig, {}, view.seen, wish, moment);
    moment.titles = {"camera", "exposures with the wand", "covered"};
    for (std::size_t i = 0; i < view.coverage.size(); ++i) {
        if (Image& picture = moment.pictures[i].image; picture.width > 0) {
            draw_coverage(view.coverage[i], picture);
        }
        moment.rows.push_back({white,
                               {setup.rig.cameras[i].name, std::to_string(view.views[i]),
                                printed("%.0f %%", 100.0 * view.coverage[i].share())}});
    }
    moment.legend = {"ring: a spot that was found", "lit: where the wand was seen"};
    return moment;
}

}  // namespace rhexis::tracking
