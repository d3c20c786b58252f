// SPDX-License-Identifier: GPL-3.0-or-later
// Inside physics: instruments as a shell meets them. Of an injector that is the bore of its cartridge and its plunger,
// which goes along the bore as the hand pushes it.
#pragma once

#include <span>
#include <vector>

#include "flow/tool.hpp"
#include "flow/tube.hpp"

namespace rhexis {

class ShellTools {
public:
    explicit ShellTools(std::span<const ToolModel> tools);

    /// Where they are in a step.
    void place(std::span<const ToolState> states);

    [[nodiscard]] std::span<const ToolModel> tools() const { return tools_; }
    [[nodiscard]] std::span<const ToolState> states() const { return states_; }
    /// Bores of the injectors that are in the eye, in the frames of what carries them.
    [[nodiscard]] std::span<const TubeModel> tubes() const { return tubes_; }
    [[nodiscard]] std::span<const ToolState> tube_states() const { return tube_states_; }

private:
    std::vector<Cartridge> cartridges_;  ///< of tools, those without one empty
    std::vector<ToolModel> tools_;
    std::vector<ToolState> states_;
    std::vector<TubeModel> tubes_;
    std::vector<ToolState> tube_states_;
};

}  // namespace rhexis
