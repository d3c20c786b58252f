// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: layers of a membrane that is folded over on its support. A node that is above another part of the
// sheet is held above the plane of the triangle there: by a one-sided spring, without friction. What is below does not
// feel it; the support does, on which it lies. The plane is where the triangle's velocities lead it: a plane that moved
// with the solution would act on the node and not be acted on, which Newton's method does not see.
#pragma once

#include <array>
#include <vector>

#include "flow/membrane.hpp"
#include "physics/contact/tool_shape.hpp"
#include "physics/solve/contact_term.hpp"

namespace rhexis {

class SheetLayers {
public:
    /// What can meet in a substep of dt [s]. stiffness: of a contact [uN/mm]. Nothing where the model's layers keep no
    /// distance, nothing is torn, or nothing is folded.
    void look(const MembraneModel& model, const MembraneState& state, double stiffness, double dt);
    [[nodiscard]] bool empty() const { return list_.empty(); }

    /// Forces and stiffness at an iterate.
    void terms(const std::vector<Vec3>& position, std::vector<ContactTerm>& terms) const;
    /// At the end of a substep, on the support, along z [uN].
    [[nodiscard]] double force_on_support(const std::vector<Vec3>& position) const;
    /// Adds which node is above which triangle: pressed down, it is known by that for the one that comes up again.
    void remember(std::vector<SheetTouch>& touches) const;

private:
    /// Of the sheet at the start of the substep.
    struct Layer {
        std::array<int, 3> nodes{};
        Vec3 up = Vec3::Zero();  ///< unit, away from the support; zero: too steep to lie on
        Vec3 corner = Vec3::Zero();
        Vec3 low = Vec3::Zero();  ///< of the box about it
        Vec3 high = Vec3::Zero();
        bool over = false;  ///< folded
    };
    struct Meeting {
        int node;
        int triangle;
        Vec3 up;
        double level;  ///< along `up`, that the node is held above [mm]
        bool on_support;
    };
    /// Cells of the view along z, with the triangles in each.
    struct Grid {
        Vec2 low = Vec2::Zero();
        int columns = 0;
        int rows = 0;
        std::vector<int> offset;
        std::vector<int> triangles;
    };
    bool take_layers(const MembraneState& state);
    [[nodiscard]] bool in_view(const Layer& layer) const;
    void fill_grid();
    [[nodiscard]] int cell(double x, double y) const;
    void meet(const MembraneModel& model, const MembraneState& state, int node);
    [[nodiscard]] bool was_above(int node, const Layer& layer) const;
    [[nodiscard]] double force_at(double depth) const;
    [[nodiscard]] double gap(const Meeting& meeting, const std::vector<Vec3>& position) const;

    double dt_ = 0.0;         ///< of the substep [s]
    double distance_ = 0.0;   ///< that layers keep [mm]
    double stiffness_ = 0.0;  ///< [uN/mm]
    std::vector<Meeting> list_;
    // scratch
    std::vector<Layer> layers_;
    std::vector<double> upright_;      ///< per node: area of the triangles about it, less where they are folded
    std::vector<int> above_;           ///< per node: the triangle that it was above, or -1
    std::vector<std::uint8_t> bears_;  ///< per node: of a triangle that something is above
    Box fold_;                         ///< about what is folded
    Grid grid_;
};

}  // namespace rhexis
