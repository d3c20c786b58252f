// SPDX-License-Identifier: GPL-3.0-or-later
// Backward Euler of one corotational solid, together with the rigid bodies that it touches.
#pragma once

#include <string_view>

#include "base/result.hpp"
#include "base/threads.hpp"
#include "flow/solid.hpp"
#include "physics/solve/implicit_step.hpp"

namespace rhexis {

class ElasticAssembly;

class ImplicitSolid {
public:
    /// model and pool must outlive this. instruction_set: "" for the best of this machine, or "baseline", "avx2",
    /// "avx512": same bits, other speed. Fails on one that the machine lacks.
    static Result<ImplicitSolid> create(const SolidModel& model, ThreadPool& pool,
                                        std::string_view instruction_set = {});

    /// One step of dt [s]. external: force per coarse node without gravity [uN]; gravity [mm/s^2] is applied inside.
    /// bodies: at the start of the step on entry, at its end on return.
    ImplicitReport step(const SolidState& state, const Vec3& gravity, std::span<const Vec3> external, double dt,
                        const ImplicitSettings& settings, const CouplingFunction& coupling,
                        std::vector<RigidUnknown>& bodies, SolidState& next);

    /// Forgets the kept factor.
    void drop_caches() { step_.drop_caches(); }

private:
    ImplicitSolid(ImplicitStep step, ElasticAssembly& assembly) : step_(std::move(step)), assembly_(&assembly) {}

    ImplicitStep step_;
    ElasticAssembly* assembly_;  ///< the body of step_
    NodeMotion motion_;
};

}  // namespace rhexis
