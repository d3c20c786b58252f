// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "records/identity.hpp"
#include "records/process_mark.hpp"
#include "records/store.hpp"
#include "support/folder.hpp"

namespace rhexis::records::test {

/// An attempt that has begun.
inline Attempt begun(const std::string& trainee, const std::string& date = "2026-03-01T09:30:00Z") {
    Attempt attempt;
    attempt.id = new_id();
    attempt.trainee = {trainee, "", ""};
    attempt.exercise = "groove";
    attempt.title = "Sculpting a groove";
    attempt.version = 1;
    attempt.surgeon = "expert";
    attempt.seed = 0xfedcba9876543210u;
    attempt.begun = date;
    attempt.process = process_mark();
    attempt.folder = "/nowhere/" + attempt.id;
    return attempt;
}

/// A finished one with this share of the scale.
inline Attempt finished(const std::string& trainee, double scaled, const std::string& date = "2026-03-01T09:30:00Z") {
    Attempt attempt = begun(trainee, date);
    attempt.state = AttemptState::finished;
    attempt.ended = date;
    attempt.completed = true;
    attempt.duration_s = 60.0;
    attempt.rubric = "OSACSS";
    attempt.max = 10.0;
    attempt.total = 2.0 + 8.0 * scaled;
    attempt.scaled = scaled;
    attempt.recording_sha256 = attempt.id;
    attempt.items = {{"T5", "Tear", 1.0 + 4.0 * scaled, ""}, {"T9", "Groove", 1.0 + 4.0 * scaled, "radial"}};
    attempt.measures = {{"T5.time", "Time", 45.5, "s", 5.0}, {"T5.gap", "Gap", std::nullopt, "mm", std::nullopt}};
    return attempt;
}

inline Store open(const std::string& path) {
    Result<Store> store = Store::open(path);
    REQUIRE_MESSAGE(store.ok(), (store ? "" : store.error().text()));
    return std::move(store).value();
}

}  // namespace rhexis::records::test
