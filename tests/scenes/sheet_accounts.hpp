// SPDX-License-Identifier: GPL-3.0-or-later
// What must stay as it was however a sheet is torn, and what must add up.
#pragma once

#include <string>

#include "flow/membrane.hpp"
#include "scenes/random_tears.hpp"

namespace rhexis::scenes {

/// Edges between two triangles.
int inner_edges(const MembraneSheet& sheet);

class SheetAccounts {
public:
    /// The model must outlive this.
    explicit SheetAccounts(const MembraneModel& model);

    /// After a change: the worst of what was seen so far goes to `found`. Returns the first fault, or nothing.
    std::string look(const MembraneState& state, RandomTears& found) const;
    /// After a step that tore nothing.
    [[nodiscard]] std::string motion_fault(const MembraneState& state) const;
    /// After something was taken out: what is left is sound, and both together are all that there was.
    [[nodiscard]] std::string taken_out_fault(const MembraneState& state) const;
    /// Whether each triangle lies in one of the model's and is made of the same.
    [[nodiscard]] std::string descent_fault(const MembraneState& state) const;

private:
    [[nodiscard]] std::string sheet_fault(const MembraneState& state) const;

    const MembraneModel* model_;
    double area_;         ///< [mm^2]
    double mass_;         ///< [g]
    double rim_;          ///< length times thickness of all free edges [mm^2]
    double most_cosine_;  ///< of an angle, that the rule allows
    double mean_edge_;    ///< [mm]
    double bound_;        ///< of the triangles
};

}  // namespace rhexis::scenes
