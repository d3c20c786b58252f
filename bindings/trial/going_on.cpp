// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/going_on.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

#include "base/output_file.hpp"

namespace rhexis {

Result<GoingOn> going_on_from(Recording recording, std::uint64_t step) {
    if (step > recording.steps.size()) {
        return Error{"there is no step " + std::to_string(step), "recording",
                     "0 to " + std::to_string(recording.steps.size())};
    }
    recording.steps.resize(step);
    std::erase_if(recording.checkpoints, [step](const Snapshot& snapshot) { return snapshot.step > step; });
    return GoingOn{std::move(recording), step};
}

Result<std::string> put_aside(const std::string& recording) {
    const std::filesystem::path path(recording);
    for (int number = 1;; ++number) {
        std::filesystem::path aside = path;
        aside.replace_filename("left_" + std::to_string(number) + ".rhx");
        std::error_code failed;
        if (std::filesystem::exists(aside, failed)) {
            continue;
        }
        std::filesystem::rename(path, aside, failed);
        return failed ? Result<std::string>(cannot_write(aside.string(), failed.value())) : aside.string();
    }
}

Status CaughtUp::start(const ObservationSchema& schema, const std::vector<std::string>& instruments) {
    Status status = exercise_.start(schema, instruments);
    if (before_ == nullptr) {
        return status;
    }
    std::span<const Command> given;
    for (std::uint64_t step = 0; status && step < before_->step; ++step) {
        const Observation& seen =
            step == 0 ? before_->recording.start.observation : before_->recording.steps[step - 1].observation;
        const Result<std::vector<Command>> wanted = exercise_.observe(seen, given);  // was recorded with the step
        status = wanted ? success() : Status(wanted.error());
        given = before_->recording.steps[step].commands;
    }
    return status;
}

Result<std::vector<Command>> CaughtUp::observe(const Observation& observation, std::span<const Command> given) {
    const bool after_recorded = std::exchange(first_, false) && before_ != nullptr && before_->step > 0;
    return exercise_.observe(observation, after_recorded ? before_->recording.steps.back().commands : given);
}

}  // namespace rhexis
