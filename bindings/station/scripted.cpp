// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/scripted.hpp"

#include <algorithm>

#include "flow/microscope.hpp"

namespace rhexis::station {

Result<std::unique_ptr<Scripted>> Scripted::create(const ExerciseOptions& options, const Fingers& fingers,
                                                   std::unique_ptr<WallClock> clock) {
    Result<ExerciseHost> host = ExerciseHost::load(options);
    if (!host) {
        return host.error();
    }
    return std::unique_ptr<Scripted>(new Scripted(std::move(host).value(), fingers, std::move(clock)));
}

Result<std::vector<UserEvent>> Scripted::take(std::uint64_t step, bool waits, const Hands& hands,
                                              const Surroundings& around, const Session& session) {
    if (clock_) {
        const Result<std::vector<UserEvent>> paced = clock_->take(step, waits, hands, around, session);
        if (!paced) {
            return paced.error();
        }
    }
    asked_twice_ = last_step_ == step;
    if (asked_twice_) {
        return std::vector<UserEvent>{};
    }
    last_step_ = step;
    const std::vector<std::string>& instruments = host_.scene().instruments;
    if (!begun_) {
        begun_ = true;
        if (const Status started = host_.start(session.schema(), instruments); !started) {
            return started.error();
        }
    }
    Percept percept = around.percept;
    if (std::find(instruments.begin(), instruments.end(), microscope_name) == instruments.end()) {
        percept.field.reset();  // its scene has no microscope
    }
    Result<OperatorStep> wanted = host_.operate(percept);
    if (!wanted) {
        return wanted.error();
    }
    std::vector<DeviceSample> samples(session.scene().instruments.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].instrument = static_cast<int>(i);
    }
    for (const DeviceSample& sample : wanted.value().samples) {
        samples[static_cast<std::size_t>(sample.instrument)] = sample;
    }
    return fingers_.reach(hands, hands.stand(), samples, wanted.value().commands, around, session.scene().step_s);
}

}  // namespace rhexis::station
