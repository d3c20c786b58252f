// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: which faces between tetrahedra give way. A crack goes on where its front (physics/solid/crack_front)
// frees more energy per area than a face takes, along the faces at its edges. Where there is no front, a new one begins
// at the surface, where a face yields
//
//   G = c t^2 h / (2 E) > toughness,   t: tension across the face, mean of the two tetrahedra beside it
//
// with h their mean height over it. Pressures are averaged over nodes, as in the elements of the lens.
#pragma once

#include <vector>

#include "flow/contact.hpp"
#include "flow/mesh_edit.hpp"
#include "flow/solid.hpp"
#include "physics/contact/contact_surface.hpp"
#include "physics/solid/crack_front.hpp"

namespace rhexis {

/// Makes what a face yields about that of linear fracture mechanics (docs/cracking.md).
inline constexpr double crack_factor = 4.5;

class CrackFinder {
public:
    explicit CrackFinder(const SolidModel& model);

    /// Faces that give way now, ascending; at most a few, none beside each other. Nothing is looked at while tools pull
    /// and push with less than `least_force`, which cannot break what has a toughness.
    void find(const SolidModel& model, const SolidState& state, const ContactSurface& surface,
              const ContactSet& contacts, int solid, std::vector<BrokenFace>& broken);

    /// Energy that each interior face yields, as a share of what it takes, after a look at a state. For tests.
    [[nodiscard]] const std::vector<double>& ratios() const { return ratios_; }
    [[nodiscard]] const std::vector<CrackFace>& faces() const { return faces_; }
    void look(const SolidModel& model, const SolidState& state, const ContactSurface& surface,
              const ContactSet& contacts, int solid);

private:
    void find_faces(const SolidModel& model);
    void find_states(const SolidState& state);
    void find_stress(const SolidModel& model, const SolidState& state);
    void average_pressure(const SolidModel& model, const SolidState& state);
    void mark_touched(const SolidModel& model, const ContactSet& contacts, int solid);
    void mark_open(const ContactSurface& surface);
    [[nodiscard]] double tension_energy(const CrackFace& face, double modulus) const;

    std::vector<CrackFace> faces_;  ///< ascending by their tetrahedra; those of one last
    std::vector<RestTet> rest_;
    std::vector<int> first_;                    ///< per node: the first at its place, itself unless it was split off
    std::vector<std::array<int, 4>> together_;  ///< tetrahedra with those
    std::vector<char> apart_;                   ///< per face: its two sides share less than its three nodes
    bool tough_ = false;                        ///< any material can break

    // Scratch
    std::vector<TetStress> stress_;  ///< per tetrahedron
    std::vector<double> mean_;       ///< per node: mean change of volume
    std::vector<double> ratios_;     ///< per face
    std::vector<FaceState> states_;  ///< per face
    std::vector<char> pressed_;      ///< per node: a tool presses on it
    std::vector<char> touched_;      ///< per tetrahedron
    std::vector<char> open_;         ///< per node: on the surface or on a broken face
    CrackFront front_;
};

}  // namespace rhexis
