// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/junit.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>
#include <utility>

namespace rhexis::cli {
namespace {

/// A printf format with one number.
std::string formatted(const char* format, unsigned value) {
    char text[16];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

struct Letter {
    unsigned code = 0;
    std::size_t bytes = 0;  ///< 0: no UTF-8 begins here
};

/// The letter that begins at a byte [RFC 3629]: no overlong forms, no surrogates, nothing past U+10FFFF.
Letter letter_at(const std::string& text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(at);
    if (first < 0x80) {
        return {first, 1};
    }
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    unsigned code = first & (0xffU >> (bytes + 1));
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(at + i) & 0xc0U) != 0x80) {
            return {};
        }
        code = code << 6U | (byte(at + i) & 0x3fU);
    }
    constexpr unsigned smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool letter = first >= 0xc0 && first < 0xf8 && code >= smallest[bytes] && code <= 0x10ffff &&
                        !(code >= 0xd800 && code <= 0xdfff);
    return letter ? Letter{code, bytes} : Letter{};
}

/// An ASCII character as XML has it; control characters that XML cannot hold as Lua writes them.
std::string escaped_ascii(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\t':
        case '\n':
        case '\r':  // plain, a reader would make a blank of it in an attribute
            return formatted("&#%u;", static_cast<unsigned char>(c));
        default:
            return static_cast<unsigned char>(c) < 0x20 ? formatted("\\x%02X", static_cast<unsigned char>(c))
                                                        : std::string(1, c);
    }
}

/// A text inside an attribute or element. What XML cannot hold stands as Lua writes it: \xFF for a byte that is no
/// UTF-8 and for a control character, \u{FFFE} for the two noncharacters that XML excludes.
std::string escaped(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const Letter letter = letter_at(text, at);
        if (letter.bytes == 0) {
            out += formatted("\\x%02X", static_cast<unsigned char>(text[at]));
        } else if (letter.bytes == 1) {
            out += escaped_ascii(text[at]);
        } else if (letter.code == 0xfffe || letter.code == 0xffff) {
            out += formatted("\\u{%X}", letter.code);
        } else {
            out.append(text, at, letter.bytes);
        }
        at += std::max<std::size_t>(letter.bytes, 1);
    }
    return out;
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ").append(name).append("=\"").append(escaped(value)).append("\"");
}

std::string seconds(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

/// The file from where one stands, as a name of packages: tests/iris.lua is tests.iris.
std::string class_of(const std::string& path) {
    const std::filesystem::path near =
        std::filesystem::absolute(path).lexically_normal().lexically_proximate(std::filesystem::current_path());
    std::string name = (*near.begin() == ".." ? std::filesystem::absolute(path).lexically_normal() : near)
                           .relative_path()
                           .replace_extension()
                           .string();
    std::replace(name.begin(), name.end(), '/', '.');
    return name;
}

/// Names of test cases, each given once: a reader of JUnit takes two of the same class and name for one.
class CaseNames {
public:
    /// The name, with " (2)" and so on where the class has it already.
    std::string next(const std::string& class_name, const std::string& name) {
        std::string free = name;
        for (int i = 2; !given_.insert({escaped(class_name), escaped(free)}).second; ++i) {
            free = name + " (" + std::to_string(i) + ")";
        }
        return free;
    }

private:
    std::set<std::pair<std::string, std::string>> given_;
};

std::string test_case(const FinishedScenario& scenario, CaseNames& names) {
    const nlohmann::json& declared = scenario.file->scenarios.at(scenario.number);
    const std::string class_name = class_of(scenario.file->path);
    std::string xml = "    <testcase" + attribute("name", names.next(class_name, declared.at("name"))) +
                      attribute("classname", class_name) + attribute("file", scenario.file->path) +
                      attribute("line", std::to_string(declared.at("line").get<int>())) +
                      attribute("time", seconds(scenario.result.cpu_s)) + ">\n";
    for (const ScenarioFailure& failure : scenario.result.failures) {
        xml += "      <failure" + attribute("message", failure.message) + ">" +
               escaped(failure.where + ": " + failure.message) + "</failure>\n";
    }
    if (!scenario.result.error.empty()) {
        xml += "      <error" + attribute("message", scenario.result.error) + "/>\n";
    }
    return xml + "    </testcase>\n";
}

struct Counts {
    int tests = 0;
    int failures = 0;
    int errors = 0;
    double time = 0.0;
    void add(const ScenarioResult& result) {
        ++tests;
        failures += result.error.empty() && !result.failures.empty() ? 1 : 0;
        errors += result.error.empty() ? 0 : 1;
        time += result.cpu_s;
    }
    [[nodiscard]] std::string text() const {
        return attribute("tests", std::to_string(tests)) + attribute("failures", std::to_string(failures)) +
               attribute("errors", std::to_string(errors)) + attribute("time", seconds(time));
    }
};

}  // namespace

std::string junit_xml(const std::vector<FinishedScenario>& scenarios) {
    Counts all;
    CaseNames names;
    std::string suites;
    for (auto first = scenarios.begin(); first != scenarios.end();) {
        const auto last =
            std::find_if(first, scenarios.end(), [&](const FinishedScenario& s) { return s.file != first->file; });
        Counts counts;
        std::string cases;
        for (auto scenario = first; scenario != last; ++scenario) {
            counts.add(scenario->result);
            all.add(scenario->result);
            cases += test_case(*scenario, names);
        }
        suites +=
            "  <testsuite" + attribute("name", first->file->path) + counts.text() + ">\n" + cases + "  </testsuite>\n";
        first = last;
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + attribute("name", "rhexis") + all.text() +
           ">\n" + suites + "</testsuites>\n";
}

}  // namespace rhexis::cli
