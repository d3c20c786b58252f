// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "desk_scene.hpp"
#include "station/event_source.hpp"

using namespace rhexis;
using namespace rhexis::station;

namespace {

std::string in_file(const std::string& text) {
    const std::string path = (std::filesystem::temp_directory_path() / "rhexis_test_events.jsonl").string();
    std::ofstream(path) << text;
    const Result<EventFile> read = read_events(path);
    std::filesystem::remove(path);
    return read ? "" : read.error().text();
}

}  // namespace

TEST_SUITE("events") {
    TEST_CASE("what is written is read again") {
        const std::string path = (std::filesystem::temp_directory_path() / "rhexis_test_written.jsonl").string();
        Result<EventWriter> writer = EventWriter::create(path, {{"curriculum", "groove"}});
        REQUIRE(writer.ok());
        const std::vector<UserEvent> events = {key("Left Shift", 1.0),
                                               {EventKind::pointer, "", 0.0, 0.25, -0.125},
                                               {EventKind::wheel, "", -2.0, 0.0, 0.0},
                                               {EventKind::axis, "pad.leftx", 0.5, 0.0, 0.0},
                                               {EventKind::quit, "", 0.0, 0.0, 0.0}};
        for (std::size_t i = 0; i < events.size(); ++i) {
            REQUIRE(writer.value().add(10 * i, events[i]).ok());
        }
        REQUIRE(writer.value().finish().ok());
        const Result<EventFile> file = read_events(path);
        std::filesystem::remove(path);
        REQUIRE(file.ok());
        CHECK(file.value().header["curriculum"] == "groove");
        REQUIRE(file.value().lines.size() == events.size());
        for (std::size_t i = 0; i < events.size(); ++i) {
            CHECK(file.value().lines[i].step == 10 * i);
            CHECK(to_json(file.value().lines[i].event) == to_json(events[i]));
        }
    }

    TEST_CASE("a file that is none is told by its line") {
        const std::string first = "{\"rhexis_events\":1}\n";
        CHECK(in_file("").find("empty") != std::string::npos);
        CHECK(in_file("hello\n").find(":1") != std::string::npos);
        CHECK(in_file("{\"rhexis_events\":2}\n").find("another version") != std::string::npos);
        CHECK(in_file(first + "{\"event\":\"pointr\",\"step\":1}\n").find("did you mean pointer") != std::string::npos);
        CHECK(in_file(first + "{\"event\":\"key\",\"name\":3,\"step\":1}\n").find(":2") != std::string::npos);
        CHECK(in_file(first + "{\"event\":\"axis\",\"name\":\"pad.leftx\",\"value\":1e9,\"step\":1}\n")
                  .find("-1000 to 1000") != std::string::npos);
        CHECK(in_file(first + "{\"event\":\"key\",\"name\":\"A\",\"value\":1,\"step\":-1}\n").find("whole number") !=
              std::string::npos);
        CHECK(in_file(first + "{\"event\":\"quit\",\"step\":5}\n{\"event\":\"quit\",\"step\":4}\n").find(":3") !=
              std::string::npos);
        CHECK(in_file(first).empty());
    }

    TEST_CASE("no number that is none reaches the hands") {
        DeskScene scene(true);
        scene.take({EventKind::press, "pad.a", 1.0, 0.0, 0.0});
        scene.take({EventKind::axis, "pad.leftx", std::nan(""), 0.0, 0.0});
        scene.take({EventKind::axis, "pedal.0", std::nan(""), 0.0, 0.0});
        scene.take({EventKind::axis, "pad.lefty", 1e300, 0.0, 0.0});
        scene.advance(0.1);
        CHECK(scene.sample(0).pose.position.allFinite());
        CHECK(std::isfinite(scene.sample(0).pedal));
        CHECK(scene.sample(0).pose.position.norm() < 20.0);
    }
}
