// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/junit.hpp"

#include <algorithm>

namespace rhexis::cli {
namespace {

/// A text inside an attribute or element. Control characters, which XML cannot hold, become blanks.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
        }
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

std::string test_case(const FinishedScenario& scenario) {
    const nlohmann::json& declared = scenario.file->scenarios.at(scenario.number);
    std::string xml = "    <testcase" + attribute("name", declared.at("name")) +
                      attribute("classname", scenario.file->exercise) + attribute("file", scenario.file->path) +
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
    std::string suites;
    for (auto first = scenarios.begin(); first != scenarios.end();) {
        const auto last =
            std::find_if(first, scenarios.end(), [&](const FinishedScenario& s) { return s.file != first->file; });
        Counts counts;
        std::string cases;
        for (auto scenario = first; scenario != last; ++scenario) {
            counts.add(scenario->result);
            all.add(scenario->result);
            cases += test_case(*scenario);
        }
        suites +=
            "  <testsuite" + attribute("name", first->file->path) + counts.text() + ">\n" + cases + "  </testsuite>\n";
        first = last;
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + attribute("name", "rhexis") + all.text() +
           ">\n" + suites + "</testsuites>\n";
}

}  // namespace rhexis::cli
