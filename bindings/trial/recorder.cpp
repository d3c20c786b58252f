// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/recorder.hpp"

#include <cmath>

namespace rhexis {

Status Recorder::begun(Timeline& timeline) {
    const Session& session = *timeline.session();
    checkpoint_steps_ = static_cast<std::uint64_t>(std::lround(checkpoint_interval_s / session.scene().step_s));
    const Status status = at_rest_ ? success() : writer_.add(session.copy_state());
    return status ? writer_.add(RecordedStart{session.observation(), session.state_hash()}) : status;
}

Status Recorder::stepped(const TrialStep& step) {
    const Session& session = step.session;
    const Status status = writer_.add(RecordedStep{session.step_count(),
                                                   {step.samples.begin(), step.samples.end()},
                                                   {step.commands.begin(), step.commands.end()},
                                                   session.observation(),
                                                   session.state_hash()});
    return status && session.step_count() % checkpoint_steps_ == 0 ? writer_.add(session.snapshot()) : status;
}

}  // namespace rhexis
