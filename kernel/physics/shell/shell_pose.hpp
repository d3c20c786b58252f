// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: where places of a shell's surface are at an iterate of a step, and how they follow its freedoms.
#pragma once

#include <span>
#include <vector>

#include "physics/shell/shell_samples.hpp"
#include "physics/solve/contact_term.hpp"

namespace rhexis {

class ShellPose {
public:
    /// points: as of ShellBody, place and turn of each node; turns count from `reference`.
    void set(std::span<const Quat> reference, const std::vector<Vec3>& points);

    [[nodiscard]] Vec3 at(const ShellPlace& place) const;  ///< [mm]
    /// `arm` at the start of the step, turned as the place has since.
    [[nodiscard]] Vec3 turned(const ShellPlace& place, const Vec3& arm) const;
    /// What the displacement of a point at `arm` from a place is of the nodes' freedoms, times `scale`. turned: `arm`
    /// is that of the start of the step, else of now. free: per number of a node's freedoms.
    void add_shares(const ShellPlace& place, const Vec3& arm, bool turned, double scale,
                    std::span<const std::uint8_t> free, std::vector<ContactShare>& shares) const;

private:
    std::vector<Vec3> position_;
    std::vector<Mat3> rotation_;  ///< since rest
    std::vector<Mat3> turn_;      ///< since the start of the step
    std::vector<Mat3> rate_;      ///< spin per turn
};

}  // namespace rhexis
