// SPDX-License-Identifier: GPL-3.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "station/controls.hpp"
#include "station/words.hpp"

namespace rhexis::station {
namespace {

Words french() {
    Result<Words> words = Words::load(".", "fr", {"phaco", "side_port_blade"});
    REQUIRE(words.ok());
    return std::move(words).value();
}

std::string source(const std::string& path) {
    std::ifstream file("bindings/station/" + path);
    REQUIRE(file.is_open());
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Texts in quotation marks, those that follow each other joined.
std::vector<std::string> texts_in(std::string code) {
    code = std::regex_replace(code, std::regex("#include[^\n]*|//[^\n]*"), "");
    code = std::regex_replace(code, std::regex("\"\\s*\n\\s*\""), "");
    std::vector<std::string> texts;
    const std::regex quoted("\"((?:[^\"\\\\]|\\\\.)*)\"");
    for (std::sregex_iterator it(code.begin(), code.end(), quoted), end; it != end; ++it) {
        texts.push_back((*it)[1]);
    }
    return texts;
}

/// What a person reads, not the name of a panel or a format: several words, or one with a capital.
bool is_read(const std::string& text) {
    const std::string plain = std::regex_replace(text, std::regex("%[.0-9]*[a-z]"), "");
    const auto letters =
        std::count_if(plain.begin(), plain.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
    return letters > 2 &&
           (text.find(' ') != std::string::npos || std::isupper(static_cast<unsigned char>(text[0])) != 0);
}

/// Units and abbreviations, and a state that is shown by a sign.
bool is_the_same(const std::string& text) {
    return (text.find("mmHg") != std::string::npos && text.find("pressure") == std::string::npos) ||
           text == " ml/min" || text.starts_with("CDE ") || text.starts_with("OSACSS ") || text == "to come";
}

}  // namespace

TEST_CASE("all that the window says is there in French") {
    const Words words = french();
    for (const Control& one : control_table()) {
        CHECK_MESSAGE(words.has(one.meaning), one.meaning);
    }
    int read = 0;
    for (const char* file : {"guide.cpp", "window/panels.cpp", "window/choose.cpp",
                             "../theatre/monitor/monitor_panels.cpp", "../theatre/debriefing/debriefing_panels.cpp"}) {
        for (const std::string& text : texts_in(source(file))) {
            if (is_read(text) && text != "Escape" && !text.starts_with("rhexis ") && !is_the_same(text)) {
                ++read;
                CHECK_MESSAGE(words.has(text), text);
            }
        }
    }
    for (const std::string& text : texts_in(source("../../kernel/input/tracked_hands.cpp"))) {
        CHECK_MESSAGE((!is_read(text) || words.has(text)), text);
    }
    CHECK(read > 30);
    const std::regex told("tell\\(\\s*\"([^\"]+)\"");
    for (const char* file : {"hands.cpp", "person.cpp", "instructor.cpp"}) {
        const std::string code = source(file);
        for (std::sregex_iterator it(code.begin(), code.end(), told), end; it != end; ++it) {
            CHECK_MESSAGE(words.has((*it)[1]), (*it)[1].str());
        }
    }
}

TEST_CASE("instruments and settings have the names of reports; values are put in") {
    const Words words = french();
    CHECK(words.instrument("phaco") == "sonde de phaco");
    CHECK(words.instrument("side_port_blade") == "couteau de contre-incision");
    CHECK(words.setting("machine.bottle_cm") != "machine.bottle_cm");
    CHECK(words("Irrigation on: %s; aspiration: %s", {"1", "%s"}) == "Irrigation : 1 ; aspiration : %s");
    const Result<Words> english = Words::load(".", "", {"side_port_blade"});
    REQUIRE(english.ok());
    CHECK(english.value()("Go on") == "Go on");
    CHECK(english.value().instrument("side_port_blade") == "side port blade");
    CHECK(english.value().setting("machine.bottle_cm") == "height of the bottle");
}

}  // namespace rhexis::station
