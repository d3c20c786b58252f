// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/state_keeper.hpp"

#include "session/prepared_state.hpp"

namespace rhexis {
Status StateKeeper::begun(Timeline&) {
    const Status watched = options_.when.empty() ? success() : host_.watch(options_.when, "--save-state");
    if (!watched) {
        error_ = watched.error();
    }
    return success();
}

Status StateKeeper::look(Moment& moment) {
    const bool now = !error_ && !kept_ && reached(moment);
    moment.stop = moment.stop || error_.has_value();
    if (!now) {
        return success();
    }
    kept_ = true;
    header_.identity = host_.identity().dump();  // an exercise that is edited while it runs is another
    return write_state(options_.path, {header_, moment.timeline.session()->copy_state()});
}

bool StateKeeper::reached(const Moment& moment) {
    if (options_.at_s >= 0.0) {
        return moment.timeline.has_come_to(options_.at_s);
    }
    if (options_.when.empty()) {
        return moment.last;
    }
    const Result<bool> now = host_.reached();
    if (!now) {
        error_ = now.error();
    }
    return now && now.value();
}

}  // namespace rhexis
