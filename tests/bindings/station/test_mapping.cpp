// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/mapping.hpp"

#include <doctest/doctest.h>

#include <unistd.h>

#include <filesystem>
#include <set>
#include <string>

#include "desk_scene.hpp"

using namespace rhexis;
using namespace rhexis::station;

namespace {

std::string complaint(const char* text) {
    const Result<Mapping> mapping = Mapping::from(nlohmann::json::parse(text));
    return mapping ? "" : mapping.error().text();
}

}  // namespace

TEST_SUITE("mapping") {
    TEST_CASE("all standard files reach every control that an exercise needs") {
        for (const int which : {0, 1, 2, 3}) {
            const Mapping mapping = standard(which % 2 == 1, which > 1);
            for (const ControlId id : {ControlId::next_instrument,
                                       ControlId::put_down,
                                       ControlId::swap,
                                       ControlId::squeeze,
                                       ControlId::draw_back,
                                       ControlId::pedal_up,
                                       ControlId::pedal_1,
                                       ControlId::pedal_2,
                                       ControlId::pedal_3,
                                       ControlId::pedal_travel,
                                       ControlId::pedal,
                                       ControlId::microscope_x,
                                       ControlId::microscope_y,
                                       ControlId::microscope_focus,
                                       ControlId::microscope_zoom,
                                       ControlId::microscope_light,
                                       ControlId::dial_next,
                                       ControlId::dial_turn,
                                       ControlId::request_next,
                                       ControlId::request,
                                       ControlId::pause,
                                       ControlId::keep_moment,
                                       ControlId::try_again,
                                       ControlId::ghost,
                                       ControlId::help,
                                       ControlId::stop}) {
                CAPTURE(control(id).name);
                CHECK_FALSE(mapping.inputs_of(id).empty());
            }
        }
        CHECK_FALSE(standard(false).inputs_of(ControlId::tip).empty());
        CHECK_FALSE(standard(true).inputs_of(ControlId::hand_z).empty());
    }

    TEST_CASE("the table of controls is in the order of its ids, and no name is there twice") {
        std::set<std::string> names;
        int index = 0;
        for (const Control& one : control_table()) {
            CHECK(static_cast<int>(one.id) == index++);
            names.insert(one.name);
        }
        CHECK(names.size() == control_table().size());
    }

    TEST_CASE("what a file may not say is said back with what it may") {
        CHECK(complaint(R"({"key": {"Tab": "swop"}})").find("swap") != std::string::npos);
        CHECK(complaint(R"({"keys": {}})").find("did you mean key") != std::string::npos);
        CHECK(complaint(R"({"mouse": {"whel": "depth"}})").find("did you mean wheel") != std::string::npos);
        CHECK(complaint(R"({"mouse": {"move": "swap"}})").find("mouse.move for tip") != std::string::npos);
        CHECK(complaint(R"({"key": {"A": "tip"}})").find("cannot work tip") != std::string::npos);
        CHECK(complaint(R"({"key": 3})").find("key is 3") != std::string::npos);
        CHECK(complaint(R"({"tuning": {"tip_mm": 3}})").find("tip_mm_s") != std::string::npos);
        CHECK(complaint(R"({"tuning": {"tip_mm_s": 3000}})").find("0.1 to 50") != std::string::npos);
        CHECK(complaint(R"({"tuning": {"pedal_first": 0.5}})").find("follow each other") != std::string::npos);
        CHECK(complaint(R"([1])").find("no list") != std::string::npos);
        CHECK(complaint(R"({"key": {"A": "-hand.x"}, "tuning": {"fine": 0.1}})").empty());
    }

    TEST_CASE("a mapping becomes another event by event") {
        for (const bool pad : {false, true}) {
            Mapping mapping = standard(pad);
            const Mapping left = standard(pad, true);
            const std::vector<UserEvent> changes = mapping.changes_to(left);
            CHECK(changes.size() > 4);
            for (const UserEvent& event : changes) {
                const Result<UserEvent> read = event_from(to_json(event));
                REQUIRE(read.ok());
                CHECK(mapping.rebind(read.value()).ok());
            }
            CHECK(mapping.to_json() == left.to_json());
            CHECK(mapping.changes_to(left).empty());
        }
    }

    TEST_CASE("a change that a file could not say changes nothing") {
        Mapping mapping = standard(false);
        const nlohmann::json before = mapping.to_json();
        for (const auto& change : {std::pair("key.W", "swop"),
                                   {"mouse.move", "swap"},
                                   {"keys.W", "swap"},
                                   {"W", "swap"},
                                   {"key.W", "take_instrument"},
                                   {"mouse.whel", "depth"}}) {
            CAPTURE(change.first);
            CHECK_FALSE(mapping.rebind({EventKind::bind, change.first, 0.0, 0.0, 0.0, change.second}).ok());
            CHECK(mapping.to_json() == before);
        }
        CHECK_FALSE(mapping.rebind({EventKind::bind, "tuning.fine", 3.0}).ok());
        CHECK(mapping.rebind({EventKind::bind, "tuning.fine", 0.5}).ok());
        CHECK(mapping.tuning().fine == 0.5);
    }

    TEST_CASE("a person's own is written whole and read again") {
        const std::filesystem::path folder =
            std::filesystem::temp_directory_path() / ("rhexis_mapping_" + std::to_string(::getpid()));
        const std::string path = folder / "a" / "mouse.json";
        REQUIRE(write_mapping(standard(false), path).ok());
        const Result<Mapping> again = Mapping::read(path);
        REQUIRE(again.ok());
        CHECK(again.value().to_json() == standard(false).to_json());
        std::filesystem::remove_all(folder);
    }

    TEST_CASE("what is read is what is written") {
        const Mapping mapping = standard(false);
        const Result<Mapping> again = Mapping::from(mapping.to_json());
        REQUIRE(again.ok());
        CHECK(again.value().to_json() == mapping.to_json());
        CHECK(mapping.find("key.S")->sign == -1.0);
    }
}
