// SPDX-License-Identifier: GPL-3.0-or-later
// Folding an implant into the cartridge of an injector: the shell and its contacts, driven by a device.
#pragma once

#include <memory>

#include "base/result.hpp"
#include "flow/frame.hpp"
#include "flow/scene.hpp"
#include "session/folding_device.hpp"
#include "session/prepared_state.hpp"

namespace rhexis {

/// A scene of an implant and an injector, as settings of sessions say; those that are not named have their standard
/// value.
SceneDescription folding_scene(const std::map<std::string, double>& settings);

/// How the folding stands; energies in nJ.
struct FoldProgress {
    int stage = 0;         ///< of folding_stages(); their number at the end
    double share = 0.0;    ///< of all the time that it takes
    double time = 0.0;     ///< [s]
    double elastic = 0.0;  ///< in the spring of the material's modulus
    double branch = 0.0;   ///< in that of the relaxing branch
    double kinetic = 0.0;
    double contact = 0.0;  ///< in the springs of contact
    double deepest = 0.0;  ///< deepest penetration since the stage began, over thickness
    int rough = 0;         ///< steps since the stage began that did not balance
    int steps = 0;
    double cpu_s = 0.0;
};

class ImplantFold {
public:
    /// Of folding_scene(). Fails on settings out of range, and where the folded lens does not go into the bore.
    static Result<ImplantFold> create(const SceneDescription& scene);
    ~ImplantFold();
    ImplantFold(ImplantFold&&) noexcept;

    [[nodiscard]] bool done() const;
    /// Fails when no step of any size can be solved.
    Status step();
    [[nodiscard]] FoldProgress progress() const;
    [[nodiscard]] Frame frame() const;

    /// The implant in its injector, as runs begin with it. Fails where it sticks out of the cartridge's chamber.
    [[nodiscard]] Result<PreparedState> result() const;

private:
    struct Parts;
    explicit ImplantFold(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace rhexis
