// SPDX-License-Identifier: GPL-3.0-or-later
// Every instrument of every exercise can be tracked.
#include <doctest/doctest.h>

#include "flow/microscope.hpp"
#include "lua/curriculum_files.hpp"
#include "lua/exercise_instruments.hpp"
#include "tracking/bodies/known_bodies.hpp"

namespace rhexis::tracking {

TEST_CASE("each exercise's instruments have bodies, which with the head's are not taken for one another") {
    std::size_t operations = 0;
    std::size_t most = 0;
    for (const std::string& exercise : curricula_in(".")) {
        CAPTURE(exercise);
        Result<std::vector<std::string>> instruments = instruments_of("curricula/" + exercise, ".");
        REQUIRE_MESSAGE(instruments.ok(), (instruments ? "" : instruments.error().text()));
        std::erase(instruments.value(), microscope_name);
        CHECK_FALSE(instruments.value().empty());
        const Result<std::vector<MarkerBody>> bodies = known_bodies(instruments.value());
        REQUIRE_MESSAGE(bodies.ok(), (bodies ? "" : bodies.error().text()));
        CHECK(bodies.value().size() == instruments.value().size() + 1);
        const Status status = check_signatures(bodies.value());
        CHECK_MESSAGE(status.ok(), (status ? "" : status.error().text()));
        most = std::max(most, instruments.value().size());
        operations += exercise == "full_operation" ? 1 : 0;
    }
    CHECK(operations == 1);
    CHECK(most > 10);  // an operation has those of all its parts
    CHECK_FALSE(instruments_of("no_such_exercise", ".").ok());
}

}  // namespace rhexis::tracking
