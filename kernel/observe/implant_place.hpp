// SPDX-License-Identifier: GPL-3.0-or-later
// How an implant lies, as numbers: of its shape alone, without what it lies in.
#pragma once

#include <array>
#include <vector>

#include "flow/implant_parts.hpp"
#include "flow/shell.hpp"
#include "flow/tool.hpp"

namespace rhexis {

struct ImplantPlace {
    Vec3 centre = Vec3::Zero();   ///< of the optic [mm]
    Vec3 normal = Vec3::UnitZ();  ///< of the plane on which the optic's shadow is largest, to the optic's front: unit
    double unfolded = 0.0;        ///< that shadow over the optic's area at rest; 0 where it is rolled up
    double radius = 0.0;          ///< of the optic at rest [mm]
    std::array<Vec3, 2> tip{Vec3::Zero(), Vec3::Zero()};     ///< leading, trailing haptic [mm]
    std::array<Vec3, 2> elbow{Vec3::Zero(), Vec3::Zero()};   ///< likewise, where an arm bends round [mm]
    std::array<Vec3, 2> middle{Vec3::Zero(), Vec3::Zero()};  ///< likewise, halfway from there to the end [mm]
    std::array<bool, 2> on_optic{};                          ///< whether an arm touches the optic
    std::vector<double> half_thickness;                      ///< by nodes, of the thickest triangle about each [mm]
};

class ImplantGauge {
public:
    ImplantGauge(const ShellModel& model, const ImplantParts& parts);
    [[nodiscard]] ImplantPlace measure(const ShellState& state) const;

private:
    [[nodiscard]] bool touches_optic(const ShellState& state, int arm_node, const Vec3& centre) const;

    std::vector<std::array<int, 3>> optic_;  ///< triangles
    std::array<std::vector<int>, 2> arm_;    ///< nodes of each haptic, without where it leaves the optic
    std::array<int, 2> tip_;
    std::array<std::vector<int>, 2> elbow_;   ///< nodes across the arm there
    std::array<std::vector<int>, 2> middle_;  ///< likewise
    std::vector<double> half_thickness_;
    double area_ = 0.0;  ///< of the optic at rest [mm^2]
    double radius_ = 0.0;
};

/// Whether any of the implant is still in the cartridge.
bool is_in_cartridge(const ShellState& implant, const Cartridge& cartridge, const ToolState& injector);

/// Whether a place is in the bore of the cartridge.
bool in_bore(const Cartridge& cartridge, const ToolState& injector, const Vec3& place);

}  // namespace rhexis
