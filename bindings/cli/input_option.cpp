// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input_option.hpp"

#include <cstdio>
#include <utility>

namespace rhexis::cli {

std::string is_tracked_input(const std::string& input) {
    if (!station::is_tracked(input)) {
        return input + " is no vrpn://ADDRESS[:PORT] or vrpn+tcp://ADDRESS[:PORT]";
    }
    const Result<vrpn::ServerPlace> place = station::tracking_place(input);
    return place ? "" : place.error().text();
}

std::string is_input(const std::string& input) {
    if (input == "mouse" || input == "gamepad") {
        return "";
    }
    return station::is_tracked(input) ? is_tracked_input(input) : input + " not in {mouse,gamepad} nor vrpn://ADDRESS";
}

Result<std::unique_ptr<HeadlessPerson>> HeadlessPerson::connect(const TrackedArguments& given,
                                                                const ExerciseOptions& exercise) {
    const Result<ExerciseHost> host = ExerciseHost::load(exercise);
    if (!host) {
        return host.error();
    }
    Result<station::Mapping> mapping = station::Mapping::read(station::standard_mapping(exercise.root, false, false));
    if (!mapping) {
        return mapping.error();
    }
    station::TrackedOptions options;
    options.step_s = host.value().scene().step_s;
    options.desk = false;
    options.gives_up_s = given.give_up_s;
    options.say = [at = given.input](const std::string& text) {
        std::fprintf(stderr, "rhexis: %s: %s\n", at.c_str(), text.c_str());
    };
    std::unique_ptr<HeadlessPerson> made(new HeadlessPerson);
    Result<std::unique_ptr<station::TrackedSource>> source = station::TrackedSource::create(
        made->desk_, {given.input, given.registration, host.value().scene().instruments}, std::move(options));
    if (!source) {
        return source.error();
    }
    made->source_ = std::move(source).value();
    if (const Status linked = made->source_->wait(given.wait_s); !linked) {
        return Error{linked.error().what, given.input, "a VRPN server there; --wait SECONDS for one that comes later"};
    }
    station::PersonOptions of_person{std::move(mapping).value(), station::tracked_device, exercise.root};
    made->person_ = std::make_unique<station::Person>(std::move(of_person), *made->source_, made->desk_, nullptr);
    return made;
}

}  // namespace rhexis::cli
