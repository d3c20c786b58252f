// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: which faces between tetrahedra give way. A crack runs on from the surface, or from faces that have
// broken, where a face yields more energy than its area takes:
//
//   G = c t^2 h / (2 E) > toughness,   t: tension across the face, mean of the two tetrahedra beside it
//
// with h their mean height over the face. In front of a sharp crack the mean tension over h falls as K / sqrt(h), so
// that t^2 h does not depend on the mesh; c is what makes G that of linear fracture mechanics (docs/cracking.md).
// Shear and pressure do not count. Pressures are averaged over nodes, as in the elements of the lens.
#pragma once

#include <vector>

#include "energy/corotational_tet.hpp"
#include "flow/contact.hpp"
#include "flow/mesh_edit.hpp"
#include "flow/solid.hpp"
#include "physics/contact/contact_surface.hpp"

namespace rhexis {

/// Such that the energy at the tip of a crack in a stretched strip is what the strip frees (docs/cracking.md).
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
    struct Face {
        BrokenFace tets{0, 0};
        std::array<int, 3> nodes{0, 0, 0};
        Vec3 normal = Vec3::UnitZ();  ///< unit, at rest
        double height = 0.0;          ///< mean of the two tetrahedra over it [mm]
    };
    [[nodiscard]] const std::vector<Face>& faces() const { return faces_; }
    void look(const SolidModel& model, const SolidState& state, const ContactSurface& surface,
              const ContactSet& contacts, int solid);

private:
    void find_stress(const SolidModel& model, const SolidState& state);
    void mark_touched(const SolidModel& model, const ContactSet& contacts, int solid);

    std::vector<Face> faces_;
    std::vector<RestTet> rest_;
    bool tough_ = false;  ///< any material can break

    // Scratch
    std::vector<Mat3> shear_;    ///< per tetrahedron: 2 mu (S - I), at rest orientation [Pa]
    std::vector<double> theta_;  ///< per tetrahedron: tr S - 3
    std::vector<double> mean_;   ///< per node
    std::vector<double> ratios_;
    std::vector<char> touched_;  ///< per tetrahedron
    std::vector<char> open_;     ///< per node: on the surface or on a broken face
};

}  // namespace rhexis
