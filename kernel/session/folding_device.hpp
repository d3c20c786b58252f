// SPDX-License-Identifier: GPL-3.0-or-later
// The device that folds an implant: two forceps that tuck its haptics onto the optic, one after the other, or none; and
// the wings of a cartridge, which bend up from a trough nearly flat to a round bore and roll the lens round the
// haptics. What they do and when is all there is here; what the lens does is its own mechanics.
//
// The lens lies flat about the origin, front to +z; the bore's axis runs along y, above the lens.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "eye/implant.hpp"
#include "flow/tool.hpp"
#include "flow/tube.hpp"
#include "tools/injector.hpp"

namespace rhexis {

/// A part of the folding, in its order.
struct FoldingStage {
    const char* name;
    double duration = 0.0;  ///< [s]
};
std::span<const FoldingStage> folding_stages();

/// Where the device is at a moment.
struct FoldingPose {
    std::array<Pose, 4> jaw;        ///< of tools()
    std::array<bool, 4> present{};  ///< else it is out of the way
    double radius = 0.0;            ///< of the trough or bore [mm]
    double suction = 0.0;           ///< that holds the optic down in the trough [uN]
};

/// Inner diameter of a cartridge that the lens, with its haptics on its optic if they are tucked, fills as far as it
/// can, to the next hundredth [mm]. model: of the lens.
double smallest_bore(const ImplantShape& shape, const ShellModel& model, bool tucked);

/// Fails where the lens sticks out of the chamber of the cartridge, naming how far.
Status check_laid_in(const Cartridge& cartridge, const ShellModel& model, const ShellState& laid);

class FoldingDevice {
public:
    /// Both must have passed their checks.
    FoldingDevice(const ImplantShape& shape, const InjectorShape& cartridge);

    /// Whether a stage is gone through: without tucking there are no forceps.
    [[nodiscard]] bool has(int stage) const;

    /// Front and back jaw at the upper haptic, then at the lower one.
    [[nodiscard]] const std::vector<ToolModel>& tools() const { return tools_; }
    /// share: of the stage, 0 to 1.
    [[nodiscard]] FoldingPose pose(int stage, double share) const;
    /// Trough or bore of that radius: its floor always where the lens lay at first.
    [[nodiscard]] TubeModel wings(double radius) const;
    /// A lens at rest on its back as it lies in the device.
    [[nodiscard]] ShellState laid_out(ShellState flat) const;
    /// The folded lens as it lies in a cartridge of the bore, in the injector's frame; free of loads and at rest.
    [[nodiscard]] ShellState laid_in(const Cartridge& cartridge, const ShellState& folded) const;

private:
    [[nodiscard]] Pose grip_at(int haptic, double share) const;

    ImplantShape shape_;
    double bore_;
    double friction_;
    bool tucked_;
    bool inverted_;
    std::vector<ToolModel> tools_;
};

}  // namespace rhexis
