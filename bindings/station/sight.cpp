// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/sight.hpp"

namespace rhexis::station {
namespace {

constexpr int side = 1024;  ///< of a square picture
constexpr int newton_steps = 4;
constexpr double nudge_mm = 1e-3;

}  // namespace

Sight::Sight(const Camera& room, const EyeAnatomy* eye, const GlobeModel* model, const GlobeState* globe) {
    Camera camera = room;
    if (model != nullptr && globe != nullptr) {
        model_ = *model;
        globe_ = *globe;
        camera = camera_in_eye(room, *model, *globe);
    }
    air_ = view_in_air(camera, side, side);
    water_ = eye != nullptr && eye->has_cornea ? view_through_cornea(camera, side, side, *eye) : air_;
}

Cursor Sight::cursor_on(const Vec3& place, bool inside) const {
    const Vec3 seen = globe_ ? to_eye(*model_, *globe_, place) : place;
    const Vec2 pixel = pixel_of(inside ? water_ : air_, seen);
    return {pixel.x() / side - 0.5, 0.5 - pixel.y() / side};
}

/// What shows where is a projection: Newton's steps go there within rounding.
Vec3 Sight::under(const Cursor& cursor, double height, bool inside) const {
    Vec3 place(0.0, 0.0, height);
    for (int i = 0; i < newton_steps; ++i) {
        const Cursor now = cursor_on(place, inside);
        Eigen::Matrix2d slope;
        slope.col(0) = (cursor_on(place + Vec3(nudge_mm, 0.0, 0.0), inside) - now) / nudge_mm;
        slope.col(1) = (cursor_on(place + Vec3(0.0, nudge_mm, 0.0), inside) - now) / nudge_mm;
        place.head<2>() += slope.inverse() * (cursor - now);
    }
    return place;
}

}  // namespace rhexis::station
