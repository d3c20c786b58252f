// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/hot_reload.hpp"

#include <cstdio>

namespace rhexis {

Status HotReload::look(Moment& moment) {
    const double time_s = moment.timeline.observation().time_s;
    const Result<bool> boundary = host_.at_boundary();
    if (!boundary || !boundary.value() || time_s <= 0.0) {
        return success();
    }
    const Result<std::optional<std::vector<Command>>> changes = host_.reload();
    if (changes && !changes.value()) {
        return success();
    }
    nlohmann::json note = {{"time_s", time_s}, {"sha256", host_.identity().at("sha256")}};
    if (changes) {
        moment.commands.insert(moment.commands.end(), changes.value()->begin(), changes.value()->end());
    } else {
        note["refused"] = changes.error().text();
    }
    const std::string said =
        changes ? "the changed exercise is taken up" : changes.error().text() + "; the run goes on unchanged";
    std::fprintf(stderr, "rhexis: after %.2f s: %s\n", time_s, said.c_str());
    reloads_.push_back(std::move(note));
    return success();
}

}  // namespace rhexis
