// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/solid/implicit_solid.hpp"

#include <string>
#include <utility>

#include "physics/solid/elastic_assembly.hpp"

namespace rhexis {

Result<ImplicitSolid> ImplicitSolid::create(const SolidModel& model, ThreadPool& /*pool*/,
                                            std::string_view instruction_set) {
    const linear_kernel::Kernel* const linear = linear_kernel::choose(instruction_set);
    const elastic_kernel::Kernel* const elastic = elastic_kernel::choose(instruction_set);
    if (linear == nullptr || elastic == nullptr) {
        return Error{"unknown or missing instruction set \"" + std::string(instruction_set) + "\"", "instruction_set",
                     "\"\", \"baseline\", \"avx2\" or \"avx512\", as the machine has"};
    }
    Result<ElasticAssembly> made = ElasticAssembly::create(model, *elastic);
    if (!made.ok()) {
        return made.error();
    }
    std::unique_ptr<ElasticAssembly> assembly = std::make_unique<ElasticAssembly>(std::move(made).value());
    ElasticAssembly& reference = *assembly;
    return ImplicitSolid(ImplicitStep(std::move(assembly), *linear), reference);
}

ImplicitReport ImplicitSolid::step(const SolidState& state, const Vec3& gravity, std::span<const Vec3> external,
                                   double dt, const ImplicitSettings& settings, const CouplingFunction& coupling,
                                   std::vector<RigidUnknown>& bodies, SolidState& next) {
    assembly_->load(state);
    const ImplicitReport report =
        step_.step(state.position, state.velocity, gravity, external, dt, settings, coupling, bodies, motion_);
    next = state;
    next.position = motion_.position;
    next.velocity = motion_.velocity;
    return report;
}

}  // namespace rhexis
