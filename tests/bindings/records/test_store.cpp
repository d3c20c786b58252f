// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "attempts.hpp"
#include "records/report_fields.hpp"

using namespace rhexis;
using namespace rhexis::records;
using namespace rhexis::records::test;
using rhexis::test::bytes_of;
using rhexis::test::Folder;

namespace {

/// A process that stores an attempt as begun and is killed.
Attempt left_by_a_killed_process(const std::string& path) {
    Attempt attempt = begun("P07");
    const pid_t child = ::fork();
    if (child == 0) {
        attempt.process = process_mark();
        Result<Store> store = Store::open(path);
        if (!store || !store.value().begin(attempt)) {
            ::_exit(1);
        }
        ::raise(SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFSIGNALED(status));
    return attempt;
}

}  // namespace

TEST_SUITE("record store") {
    TEST_CASE("an attempt reads back as it was stored") {
        const Folder folder;
        Attempt attempt = finished("P07", 0.5);
        attempt.trainee = {"P07", "2026", "simulator"};
        attempt.events = {{12.5, "tear", "radial run-out", "critical", true, 3.25},
                          {20.0, "tear", "touch", "minor", false, std::nullopt}};
        REQUIRE(open(folder / "records.db").finish(attempt).ok());
        Store store = open(folder / "records.db");
        const Result<Attempt> read = store.attempt(attempt.id.substr(0, 6));
        REQUIRE(read.ok());
        const Attempt& found = read.value();
        CHECK(found.state == AttemptState::finished);
        CHECK(found.seed == attempt.seed);
        CHECK(found.total == attempt.total);
        CHECK(found.scaled == attempt.scaled);
        CHECK(found.trainee.arm == "simulator");
        REQUIRE(found.items.size() == 2);
        CHECK(found.items[1].capped_by == "radial");
        REQUIRE(found.measures.size() == 2);
        CHECK_FALSE(found.measures[0].value.has_value());  // T5.gap
        CHECK(found.measures[1].value == 45.5);
        REQUIRE(found.events.size() == 2);
        CHECK(found.events[0].recovery_s == 3.25);
        CHECK_FALSE(found.events[1].recovery_s.has_value());
        CHECK_FALSE(store.attempt("nothing").ok());
        CHECK_FALSE(store.attempt("").ok());
    }

    TEST_CASE("storing twice is storing once") {
        const Folder folder;
        Store store = open(folder / "records.db");
        const Attempt attempt = finished("P07", 0.5);
        REQUIRE(store.begin(attempt).ok());
        REQUIRE(store.finish(attempt).ok());
        REQUIRE(store.finish(attempt).ok());
        Wanted wanted;
        wanted.details = true;
        const std::vector<Attempt> all = store.attempts(wanted).value();
        REQUIRE(all.size() == 1);
        CHECK(all[0].items.size() == 2);
        CHECK(all[0].measures.size() == 2);
    }

    TEST_CASE("an attempt runs while its process lives, and is interrupted once that was killed") {
        const Folder folder;
        const std::string path = folder / "records.db";
        Store store = open(path);
        const Attempt running = begun("P08");
        REQUIRE(store.begin(running).ok());
        const Attempt killed = left_by_a_killed_process(path);
        CHECK(store.attempt(running.id).value().state == AttemptState::running);
        CHECK(store.attempt(killed.id).value().state == AttemptState::interrupted);
        Wanted wanted;
        wanted.finished = true;
        CHECK(store.attempts(wanted).value().empty());
        REQUIRE(store.drop(running.id).ok());
        CHECK(store.attempts({}).value().size() == 1);
    }

    TEST_CASE("cohort and arm stay the trainee's until others are named") {
        const Folder folder;
        Store store = open(folder / "records.db");
        Attempt attempt = begun("P07");
        attempt.trainee = {"P07", "2026", "simulator"};
        REQUIRE(store.begin(attempt).ok());
        attempt = begun("P07");
        REQUIRE(store.begin(attempt).ok());
        CHECK(store.trainee("P07").value().cohort == "2026");
        attempt = begun("P07");
        attempt.trainee.arm = "control";
        REQUIRE(store.begin(attempt).ok());
        CHECK(store.trainee("P07").value().arm == "control");
        CHECK(store.trainee("P07").value().cohort == "2026");
        CHECK(store.trainees().value().size() == 1);
    }

    TEST_CASE("of a trainee who was deleted nothing is left in the file") {
        const Folder folder;
        const std::string path = folder / "records.db";
        Store store = open(path);
        const Attempt own = finished("Zaphod-42", 0.5);
        const Attempt other = finished("P08", 0.5);
        REQUIRE(store.finish(own).ok());
        REQUIRE(store.finish(other).ok());
        const std::vector<RatedItem> items = {{"T5", 4, "well done"}};
        REQUIRE(
            store.rate({{own.id, "R1", "now", "of-Zaphod", items}, {other.id, "Zaphod-42", "now", "", items}}, false)
                .ok());
        REQUIRE(bytes_of(path).find("Zaphod-42") != std::string::npos);
        const Result<std::vector<std::string>> folders = store.remove("Zaphod-42");
        REQUIRE(folders.ok());
        CHECK(folders.value() == std::vector<std::string>{own.folder});
        CHECK(store.attempts({}).value().size() == 1);
        CHECK(store.ratings().value().empty());
        CHECK(bytes_of(path).find("Zaphod") == std::string::npos);
        CHECK(bytes_of(path).find(own.id) == std::string::npos);
        CHECK(bytes_of(path).find("P08") != std::string::npos);
    }

    TEST_CASE("ratings are stored all or none, and replaced only when asked") {
        const Folder folder;
        Store store = open(folder / "records.db");
        const Attempt a = finished("P07", 0.5);
        const Attempt b = finished("P08", 0.5);
        REQUIRE(store.finish(a).ok());
        REQUIRE(store.finish(b).ok());
        const std::vector<RatedItem> four = {{"T5", 4, ""}, {"T6", std::nullopt, "not seen"}};
        REQUIRE(store.rate({{a.id, "R1", "now", "", four}}, false).ok());
        const Status again = store.rate({{b.id, "R1", "now", "", four}, {a.id, "R1", "now", "", four}}, false);
        REQUIRE_FALSE(again.ok());
        CHECK(again.error().what.find("already") != std::string::npos);
        CHECK(store.ratings().value().size() == 1);
        REQUIRE(store.rate({{a.id, "R1", "later", "", {{"T5", 2, ""}}}}, true).ok());
        const std::vector<Rating> ratings = store.ratings().value();
        REQUIRE(ratings.size() == 1);
        REQUIRE(ratings[0].items.size() == 1);
        CHECK(ratings[0].items[0].score == 2);
        CHECK_FALSE(store.rate({{"no-such-attempt", "R1", "now", "", four}}, false).ok());
    }

    TEST_CASE("stores that are no good are refused in one line and left as they are") {
        const Folder folder;
        const std::string path = folder / "records.db";
        CHECK_FALSE(Store::open_existing(path).ok());
        CHECK(bytes_of(path).empty());
        CHECK_FALSE(Store::open(folder / "").ok());
        const std::string text(4096, 'x');
        rhexis::test::write_bytes(path, text);
        const Result<Store> broken = Store::open(path);
        REQUIRE_FALSE(broken.ok());
        CHECK(broken.error().text().find('\n') == std::string::npos);
        CHECK(bytes_of(path) == text);
    }

    TEST_CASE("names with quotes and brackets stay text") {
        const Folder folder;
        Store store = open(folder / "records.db");
        Attempt attempt = finished("P07", 0.5);
        attempt.title = "Robert'); DROP TABLE attempts;--";
        attempt.folder = "/a folder/with 'quotes'";
        REQUIRE(store.finish(attempt).ok());
        CHECK(store.attempt(attempt.id).value().title == attempt.title);
        CHECK(store.attempt(attempt.id).value().folder == attempt.folder);
    }

    TEST_CASE("of a report without a score, or none at all") {
        Attempt attempt = begun("P07");
        CHECK_FALSE(take_report(nlohmann::json::array(), attempt).ok());
        CHECK_FALSE(take_report({{"schema", 2}, {"curriculum", {{"id", "groove"}}}}, attempt).ok());
        REQUIRE(take_report({{"schema", 1}, {"curriculum", {{"id", "groove"}}}, {"osacss", nullptr}}, attempt).ok());
        CHECK_FALSE(attempt.scaled.has_value());
        CHECK(attempt.items.empty());
    }
}
