// SPDX-License-Identifier: GPL-3.0-or-later
// The capsulorhexis as a shape: how far the tear has come round, where it runs, and how round and well placed the
// opening is. The tear is measured on the sheet at rest, so that a pull on the rim or a fold of the flap changes
// nothing. A closed opening is measured as it stands now, drawn wide by the zonules, as a surgeon sees it. Both as seen
// along the eye's axis: in the plane z = 0, which tells from the rim's own plane by less than a thousandth for a rim
// half a millimetre off the centre of a lens. In the eye itself: the cornea shows all of it about a tenth larger.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "flow/membrane.hpp"

namespace rhexis {

/// NaN: not defined now.
struct RhexisShape {
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    bool opened = false;           ///< there is an opening; of several the one with the longest edge is measured
    bool closed = false;           ///< what it goes round has come loose from what hangs at the outer edge
    bool run_out = false;          ///< some tear has passed where the zonules insert, or reached the sheet's outer edge
    double length = 0.0;           ///< of all tears of the sheet, along them [mm]
    double loose_area = 0.0;       ///< of all that has come off what hangs at the outer edge [mm^2]
    double turned = 0.0;           ///< angle about the axis that the tear has gone round, 0 to 2 pi (closed) [rad]
    double tip_radius = none;      ///< of the leading tip from the axis [mm]; none once no tip is left
    double tip_angle = none;       ///< of the leading tip about the axis, from +x towards +y, -pi to pi [rad]
    double tip_heading = none;     ///< of the leading tip: its direction outward from the tangent, -pi/2 to pi/2 [rad]
    double largest_radius = none;  ///< greatest distance of the opening's edge from the axis, tags included [mm]
    double smallest_radius = none;  ///< least distance of the closed rim from the axis, now [mm]
    double mean_diameter = none;    ///< of the circle of the same area; only of a closed rim, now [mm]
    double rest_diameter = none;    ///< likewise on the sheet at rest [mm]
    double circularity = none;      ///< 4 pi area / perimeter^2: 1 for a circle; only of a closed rim, now
    Vec2 centre = {none, none};     ///< centroid of the opening from the axis; only of a closed rim, now [mm]
    double flap_area = 0.0;         ///< that the outline encloses on the sheet at rest [mm^2]
    double overlap = none;          ///< angle over which a closed rim covers the edge of an implant's optic, now [rad]
    std::vector<int> rim;           ///< nodes once round a closed rim, without its slits
    std::vector<int> lip;           ///< nodes of the flap's edge from the leading tip on for 2 mm, where there is a tip
    std::vector<int> margin;        ///< likewise of the edge of what stays
};

/// The shape of the opening in a sheet that faces +z. start: the sheet before it was torn. The outline of a closed
/// opening is its rim, without the slits (tags) that go off from it. Of one that is not closed it is the tear and the
/// straight chord between its ends, about which the flap hinges; only the flap's area is taken from that. Area,
/// diameter, centroid and least radius are those of 64 points of the rim, evenly along it.
///
/// Circularity is that of the same points after each is averaged with those up to a sixteenth of the way round (1 mm of
/// a usual rim) on either side, weighted by nearness. A perimeter grows with every detail that is let into it, and the
/// details under an edge's length are the mesh's: without that a circle torn in 1,500 triangles scores 0.95 to 0.99.
/// Ovals are kept, of three lobes nine tenths of the height, of five three quarters; of a notch that is half a
/// millimetre wide a quarter of the depth.
///
/// The angle that the tear has gone round is that between its two ends, without what runs nearer to the axis than 1 mm:
/// a slit across the centre has not gone half way. `zonules`: radius beyond which a tear has run out [mm]. The leading
/// tip is the one that went on last. Work: in proportion to the sheet's triangles; see RhexisGauge.
RhexisShape rhexis_shape(const MembraneSheet& start, const MembraneState& state,
                         double zonules = std::numeric_limits<double>::infinity());

/// Measures a closed rim anew as it stands in `state`, whose sheet `shape` is of. Work: in proportion to the rim's
/// nodes.
void measure_rim_now(const MembraneState& state, RhexisShape& shape);

/// Distance from the axis of the outermost node of the uncut sheet at which a zonule inserts: a spring that has a
/// length of its own [mm]. Infinite without zonules.
double zonules_end(const MembraneModel& model);

/// Cheap enough for every step: looks for the opening only when the sheet is another one than before.
class RhexisGauge {
public:
    void measure(const MembraneModel& model, const MembraneState& state);
    [[nodiscard]] const RhexisShape& shape() const { return shape_; }

private:
    std::shared_ptr<const MembraneSheet> measured_;  ///< held, so that no other sheet gets its address
    RhexisShape shape_;
};

}  // namespace rhexis
