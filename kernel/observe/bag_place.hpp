// SPDX-License-Identifier: GPL-3.0-or-later
// Where a capsular bag that is a membrane is, and how its opening is stretched.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "flow/membrane.hpp"

namespace rhexis {

struct BagPlace {
    Vec3 centre = Vec3::Zero();      ///< of the equator [mm]
    Vec3 axis = Vec3::UnitZ();       ///< through it, to the front: unit
    double radius = 0.0;             ///< mean of the equator [mm]
    double widest = 0.0;             ///< distance of the equator's farthest place from the axis [mm]
    Vec3 rim_centre = Vec3::Zero();  ///< of the opening [mm]
    double rim_radius = 0.0;         ///< its mean [mm]
    double rim_stretch = 1.0;        ///< length of the most stretched eighth of the rim over that at rest
    bool rim_split = false;          ///< a tear has gone from the rim
};

/// The mesh at rest must be about the eye's axis, with one hole or more in front, of which the narrowest is the
/// opening.
///
/// The equator is that of the mesh at rest: the node farthest from the axis in each of its sectors. The axis is turned
/// as the plane of these nodes is since. Lengths of the rim leave out edges that a tear has cut.
class BagGauge {
public:
    explicit BagGauge(const MembraneModel& model);

    /// Remembers the sheet that it saw last, for a rim that is the same.
    BagPlace measure(const MembraneState& state);

    /// Whether a place is within the bag, which a plane across its opening shuts: by the angle that its wall takes of
    /// all directions.
    [[nodiscard]] bool holds(const MembraneState& state, const Vec3& place) const;

    /// Whether a node of any later sheet lies behind the equator, or near the rim, at rest.
    [[nodiscard]] bool is_posterior(const MembraneSheet& sheet, int node) const;
    [[nodiscard]] bool is_at_rim(const MembraneSheet& sheet, int node) const;

private:
    /// An edge of the rim: its nodes in the sheet that was seen last (-1: cut), and how much of it lies in each eighth.
    struct RimEdge {
        std::array<int, 2> nodes;
        double length = 0.0;  ///< at rest [mm]
        std::array<double, 8> share{};
    };
    void find_equator(const TriMesh& mesh);
    void find_rim(const MembraneSheet& sheet);
    void follow(const MembraneSheet& sheet);
    [[nodiscard]] Mat3 frame(const std::vector<Vec3>& x, const Vec3& middle) const;
    [[nodiscard]] double stretch(const std::vector<Vec3>& x) const;

    std::shared_ptr<const MembraneSheet> seen_;  ///< held, so that no other sheet gets its address
    std::vector<int> equator_;                   ///< nodes, once round
    std::vector<Vec2> weight_;                   ///< of each for the directions across the axis
    Mat3 rest_frame_ = Mat3::Identity();
    Vec3 rest_middle_ = Vec3::Zero();
    double equator_z_ = 0.0;
    std::vector<int> rim_;        ///< nodes of the sheet at the start, once round
    std::vector<RimEdge> edges_;  ///< from each of them to the next
    bool split_ = false;
};

}  // namespace rhexis
