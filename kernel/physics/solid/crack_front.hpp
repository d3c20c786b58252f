// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: the fronts of a body's cracks and what drives them on. A front is made of the edges of broken faces
// that are in no other broken face and not on the surface. What the energy loses when a node of it goes on through the
// material is its pull [LiShihNeedleman1985],
//   p = sum over tetrahedra of V (F^T P - R^T P - w 1) grad N,
// R the mean rotation around the node, so that a body that turns pulls at nothing. A mesh spreads it over the nodes
// beside the front; theirs counts with it. Pull by length of front is the energy that an area of crack frees.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "energy/corotational_tet.hpp"
#include "flow/mesh_edit.hpp"

namespace rhexis {

/// Between two tetrahedra, or of one (tets[1] -1). Nodes that were split since count as the first of them.
struct CrackFace {
    BrokenFace tets{0, 0};
    std::array<int, 3> nodes{0, 0, 0};
    Vec3 normal = Vec3::UnitZ();  ///< unit, at rest, away from the first tetrahedron
    double area = 0.0;            ///< [mm^2]
    double height = 0.0;          ///< mean of the tetrahedra over it [mm]
};

/// What a tetrahedron bears; strain and stress at its rest orientation.
struct TetStress {
    Mat3 rotation = Mat3::Identity();
    Mat3 strain = Mat3::Zero();
    Mat3 stress = Mat3::Zero();  ///< [Pa]
    double energy = 0.0;         ///< per volume [Pa]
};

enum class FaceState : std::uint8_t { none, whole, broken, surface };

class CrackFront {
public:
    /// The edges of the front now.
    void find(const std::vector<CrackFace>& faces, const std::vector<FaceState>& states,
              const std::vector<std::uint8_t>& present, std::size_t nodes);

    [[nodiscard]] bool empty() const { return edges_.empty(); }
    [[nodiscard]] bool has(int node) const { return role_[static_cast<std::size_t>(node)] == Role::front; }
    /// At the front or beside it; after `pull`.
    [[nodiscard]] bool near(int node) const { return role_[static_cast<std::size_t>(node)] != Role::none; }

    /// What tetrahedra that count (nodes as CrackFace has them) pull at the front; none at nodes that are `pressed`.
    void pull(const std::vector<std::array<int, 4>>& tets, const std::vector<RestTet>& rest,
              const std::vector<TetStress>& stress, const std::vector<std::uint8_t>& present,
              const std::vector<char>& pressed);

    /// Energy that a face frees per area, going on from an edge of the front [uN/mm]. An end of the edge that is on the
    /// surface counts as far as the face goes along it.
    [[nodiscard]] double energy(const CrackFace& face, const std::vector<Vec3>& at_rest) const;

    /// The length of front that each of its nodes stands for.
    void measure(const std::vector<Vec3>& at_rest);

private:
    enum class Role : std::uint8_t { none, beside, front };
    using Edge = std::array<int, 2>;
    struct Node {
        Mat3 rotation = Mat3::Zero();
        Vec3 force = Vec3::Zero();
        Vec3 pull = Vec3::Zero();
        Vec3 outward = Vec3::Zero();  ///< of the surface that it is on; in the end unit, or zero
        double length = 0.0;          ///< of front
        int tets = 0;
    };

    void add_tet(const std::array<int, 4>& tet, const RestTet& rest, const TetStress& stress);
    void gather(const std::vector<std::array<int, 4>>& tets, const std::vector<std::uint8_t>& present);

    std::vector<Edge> edges_;  ///< ascending
    std::vector<Role> role_;   ///< per node
    std::vector<Node> nodes_;
    std::vector<Edge> scratch_;
    std::vector<Edge> surface_edges_;
};

}  // namespace rhexis
