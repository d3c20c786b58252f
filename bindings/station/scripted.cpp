// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/scripted.hpp"

#include <algorithm>

#include "flow/microscope.hpp"

namespace rhexis::station {

Result<std::unique_ptr<Scripted>> Scripted::create(const ExerciseOptions& options, const Fingers& fingers,
                                                   std::unique_ptr<WallClock> clock, std::unique_ptr<Typist> typist) {
    Result<ExerciseHost> host = ExerciseHost::load(options);
    if (!host) {
        return host.error();
    }
    return std::unique_ptr<Scripted>(
        new Scripted(std::move(host).value(), fingers, std::move(clock), std::move(typist)));
}

Result<std::vector<UserEvent>> Scripted::take(std::uint64_t step, bool waits, const Hands& hands,
                                              const Surroundings& around, const Session& session) {
    std::vector<UserEvent> come;
    if (clock_) {
        Result<std::vector<UserEvent>> paced = clock_->take(step, waits, hands, around, session);
        if (!paced) {
            return paced.error();
        }
        come = std::move(paced).value();
    }
    if (typist_) {
        typist_->heed(come);
    } else {  // the hand is the surgeon's; an instructor may be anybody
        std::erase_if(come, [](const UserEvent& event) { return event.kind != EventKind::staff; });
    }
    asked_twice_ = last_step_ == step;
    if (asked_twice_ && !(typist_ && typist_->rests())) {
        return come;
    }
    last_step_ = step;
    Result<std::vector<UserEvent>> done = work(typist_ ? typist_->ahead(hands, around) : hands, around, session);
    if (!done) {
        return done;
    }
    if (!typist_) {
        come.insert(come.end(), done.value().begin(), done.value().end());
        return come;
    }
    const Status sent = typist_->send(done.value());
    return sent ? Result<std::vector<UserEvent>>(std::move(come)) : sent.error();
}

/// What the surgeon does in a step, with these hands.
Result<std::vector<UserEvent>> Scripted::work(const Hands& hands, const Surroundings& around, const Session& session) {
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
