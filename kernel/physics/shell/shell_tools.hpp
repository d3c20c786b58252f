// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: instruments as a shell meets them. Of an injector that is the bore of its cartridge and its plunger,
// which goes along the bore as the hand pushes it and the implant lets it.
#pragma once

#include <span>
#include <vector>

#include "flow/tool.hpp"
#include "flow/tube.hpp"

namespace rhexis {

class ShellTools {
public:
    explicit ShellTools(std::span<const ToolModel> tools);

    /// Where they are in a step of dt [s]. plungers: at its start, per tool.
    void place(std::span<const ToolState> states, std::span<const PlungerState> plungers, double dt);
    /// Whether a step stands, by the force of each tool on shells at its end [uN] and what did not balance, as of
    /// ShellStepReport. If not, a plunger pressed harder than a hand, or hard and nothing came near to balance: it is
    /// placed for a shorter way, and the step must be made again.
    bool stands(std::span<const Vec3> forces, double residual);

    /// Whether no plunger moved in a step. If one did, it is placed where it was, and the step must be made again.
    bool held_still();

    [[nodiscard]] std::span<const ToolModel> tools() const { return tools_; }
    [[nodiscard]] std::span<const ToolState> states() const { return states_; }
    /// Bores of the injectors that are in the eye, in the frames of what carries them.
    [[nodiscard]] std::span<const TubeModel> tubes() const { return tubes_; }
    [[nodiscard]] std::span<const ToolState> tube_states() const { return tube_states_; }
    [[nodiscard]] std::span<const int> tube_tools() const { return tube_tools_; }  ///< numbers of those injectors
    /// Per tool, after a step that stands.
    [[nodiscard]] std::span<const PlungerState> plungers() const { return after_; }

private:
    [[nodiscard]] bool pushes(std::size_t tool) const;
    void move_plungers();

    std::vector<Cartridge> cartridges_;  ///< of tools, those without one empty
    std::vector<ToolModel> tools_;
    std::vector<ToolState> given_;
    std::vector<ToolState> states_;  ///< those, injectors pushed on to where their plungers are
    std::vector<TubeModel> tubes_;
    std::vector<ToolState> tube_states_;
    std::vector<int> tube_tools_;
    std::vector<PlungerState> before_;
    std::vector<PlungerState> after_;
    std::vector<double> goal_;   ///< of plungers [mm]
    std::vector<double> tried_;  ///< growth of their force with the way in tries that did not stand [uN/mm]
    int tries_ = 0;
};

}  // namespace rhexis
