// SPDX-License-Identifier: GPL-3.0-or-later
// Where in the picture a place of the room shows, and what a cursor points at: the lines of sight of the picture that
// is drawn, of a size of its own, so that a window's size changes nothing.
#pragma once

#include <optional>

#include "flow/frame.hpp"
#include "render/renderer.hpp"
#include "render/view.hpp"

namespace rhexis::station {

/// A place of the picture: heights of the picture from its middle, to the right and up.
using Cursor = Vec2;

class Sight {
public:
    /// camera: in the room. globe: null where the eye does not roll.
    Sight(const Camera& camera, const EyeAnatomy* eye, const GlobeModel* model, const GlobeState* globe);

    /// inside: behind the cornea.
    [[nodiscard]] Cursor cursor_on(const Vec3& place, bool inside) const;
    /// The place at a height of the room [mm] that shows under the cursor.
    [[nodiscard]] Vec3 under(const Cursor& cursor, double height, bool inside) const;

private:
    View air_;
    View water_;
    std::optional<GlobeModel> model_;
    std::optional<GlobeState> globe_;
};

}  // namespace rhexis::station
