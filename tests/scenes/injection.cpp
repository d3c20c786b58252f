// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/injection.hpp"

#include <utility>

namespace rhexis::scenes {

Injection::Injection(const ShellModel& model, const ToolModel& injector, ShellState start,
                     const ShellContactSettings& settings)
    : state(std::move(start)),
      contacts(model, settings),
      tools_({&injector, 1}),
      stepper_(std::move(ShellStepper::create(model)).value()) {
    hand_.present = true;
    state.loaded = false;
}

ShellPartners Injection::partners() const {
    ShellPartners partners;
    partners.tools = tools_.tools();
    partners.tool_states = tools_.states();
    partners.tubes = tools_.tubes();
    partners.tube_states = tools_.tube_states();
    partners.tube_tools = tools_.tube_tools();
    return partners;
}

ShellMotion Injection::step(double jaw, double dt) {
    hand_.previous_jaw = hand_.jaw;
    hand_.jaw = jaw;
    tools_.place({&hand_, 1}, {&plunger, 1}, dt);
    const Vec3 weightless = Vec3::Zero();
    ShellState next;
    ShellStepReport all;
    for (;;) {
        const ShellPartners partners = this->partners();
        int rollbacks = 0;
        const ShellMotion motion =
            move_shell(stepper_, contacts, {state, partners, weightless, dt}, next, report, rollbacks);
        all.newton_iterations += report.newton_iterations;
        all.linear_iterations += report.linear_iterations;
        ++tries;
        const Vec3 force = contacts.force_of(ContactPartner::tool, 0);
        if (tools_.stands({&force, 1}, report.residual)) {
            report.newton_iterations = all.newton_iterations;
            report.linear_iterations = all.linear_iterations;
            plunger = tools_.plungers()[0];
            state = std::move(next);
            return motion;
        }
    }
}

}  // namespace rhexis::scenes
