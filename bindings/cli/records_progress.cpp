// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis records curve, gates.
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/counted.hpp"
#include "cli/exercise_title.hpp"
#include "cli/records_command.hpp"
#include "lua/report_script.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;
using records::Attempt;
using records::Course;
using records::Gate;

struct NamedCourse {
    std::string trainee;
    std::string exercise;
    Gate gate;
    Course course;
};

/// Of the trainee, or of all, in each exercise that was scored.
Result<std::vector<NamedCourse>> courses_of(const RecordsOptions& given, const Context& context) {
    const Result<records::Gates> gates = gates_of(given, context);
    if (!gates) {
        return gates.error();
    }
    Result<records::Store> store = open_records(given);
    if (!store) {
        return store.error();
    }
    const Result<std::vector<Attempt>> attempts = finished_attempts(store.value(), given);
    if (!attempts) {
        return attempts.error();
    }
    std::map<std::pair<std::string, std::string>, std::vector<Attempt>> by_both;
    for (const Attempt& attempt : attempts.value()) {
        by_both[{attempt.trainee.pseudonym, attempt.exercise}].push_back(attempt);
    }
    std::vector<NamedCourse> courses;
    for (const auto& [names, own] : by_both) {
        const Gate& gate = gates.value().of(names.second);
        Course course = records::course_of(own, names.second, gate);
        if (!course.attempts.empty()) {
            courses.push_back({names.first, names.second, gate, std::move(course)});
        }
    }
    if (courses.empty() && !given.trainee.empty()) {
        return Error{
            "nothing scored is stored of " + given.trainee + (given.exercise.empty() ? "" : " in " + given.exercise),
            store.value().path(), "rhexis records trainees lists who is there"};
    }
    return courses;
}

json course_json(const NamedCourse& named) {
    const Course& course = named.course;
    json attempts = json::array();
    for (std::size_t i = 0; i < course.attempts.size(); ++i) {
        const Attempt& attempt = course.attempts[i];
        attempts.push_back({{"attempt", attempt.id},
                            {"date", attempt.begun},
                            {"scaled", *attempt.scaled},
                            {"completed", attempt.completed},
                            {"passed", static_cast<bool>(course.passed[i])},
                            {"why", records::why_no_pass(attempt, named.gate)},
                            {"duration_s", attempt.duration_s}});
    }
    return {{"trainee", named.trainee},
            {"exercise", named.exercise},
            {"title", course.attempts.back().title},
            {"pass", named.gate.pass},
            {"in_a_row", named.gate.in_a_row},
            {"open_after", course.open_after},
            {"time_to_gate_s", course.time_to_gate_s},
            {"first", course.first()},
            {"peak", course.peak() ? json(*course.peak()) : json()},
            {"attempts", attempts}};
}

/// A bar per attempt, with the pass mark in it.
void print_chart(const NamedCourse& named) {
    constexpr int width = 50;
    const int mark = static_cast<int>(std::lround(width * named.gate.pass));
    for (std::size_t i = 0; i < named.course.attempts.size(); ++i) {
        const Attempt& attempt = named.course.attempts[i];
        const std::string why = records::why_no_pass(attempt, named.gate);
        const int length = static_cast<int>(std::lround(width * *attempt.scaled));
        std::string bar(static_cast<std::size_t>(width) + 1, ' ');
        for (int at = 0; at < length; ++at) {
            bar[static_cast<std::size_t>(at)] = '#';
        }
        bar[static_cast<std::size_t>(mark)] = '|';
        std::printf("  %3zu  %s  %s %3.0f %%  %s\n", i + 1, attempt.begun.substr(0, 10).c_str(), bar.c_str(),
                    100.0 * *attempt.scaled, why.empty() ? "passed" : why.c_str());
    }
}

void print_course(const NamedCourse& named) {
    const Course& course = named.course;
    std::printf("%s, %s: first %.0f %%, ", named.trainee.c_str(), named.exercise.c_str(), 100.0 * course.first());
    if (course.peak()) {
        std::printf("best %.0f %%, ", 100.0 * *course.peak());
    } else {
        std::printf("none completed, ");
    }
    if (course.open_after > 0) {
        std::printf("gate open after %s and %.1f min of operating\n",
                    counted(static_cast<std::size_t>(course.open_after), "attempt").c_str(),
                    course.time_to_gate_s / 60.0);
    } else {
        std::printf("gate closed\n");
    }
    print_chart(named);
    std::printf("  |: pass mark, %.3g %% of the scale, %d in a row open the gate\n", 100.0 * named.gate.pass,
                named.gate.in_a_row);
}

/// The page, with the titles of the exercises in its language.
int write_curve_page(const RecordsOptions& given, const std::vector<NamedCourse>& courses, json data,
                     const Context& context) {
    const Result<std::string> language = language_of_page(given.language, context.root);
    if (!language) {
        return complain(language.error());
    }
    for (std::size_t i = 0; i < courses.size(); ++i) {
        const Attempt& last = courses[i].course.attempts.back();
        data["courses"][i]["title"] =
            title_in(language.value(), {last.exercise, last.title, last.language}, context.root);
    }
    return write_records_page(given, "records.curve", std::move(data), context);
}

int curve(const RecordsOptions& given, const Context& context) {
    if (const Status status = check_page_language(given, context); !status) {
        return complain(status.error());
    }
    const Result<std::vector<NamedCourse>> courses = courses_of(given, context);
    if (!courses) {
        return complain(courses.error());
    }
    json data = {{"trainee", given.trainee}, {"courses", json::array()}};
    for (const NamedCourse& named : courses.value()) {
        data["courses"].push_back(course_json(named));
    }
    if (given.json) {
        std::cout << data.dump(2) << '\n';
    } else {
        for (const NamedCourse& named : courses.value()) {
            print_course(named);
        }
    }
    if (given.html.empty()) {
        return done;
    }
    return write_curve_page(given, courses.value(), std::move(data), context);
}

int gates(const RecordsOptions& given, const Context& context) {
    const Result<std::vector<NamedCourse>> courses = courses_of(given, context);
    if (!courses) {
        return complain(courses.error());
    }
    std::printf("%-16s  %-22s  %-6s  %-8s  %s\n", "trainee", "exercise", "pass", "attempts", "gate");
    for (const NamedCourse& named : courses.value()) {
        const Course& course = named.course;
        std::printf("%-16s  %-22s  %4.3g %%  %-8zu  ", named.trainee.c_str(), named.exercise.c_str(),
                    100.0 * named.gate.pass, course.attempts.size());
        if (course.open_after > 0) {
            std::printf("open since attempt %d\n", course.open_after);
        } else {
            std::printf("closed: %d of %d in a row\n", course.in_a_row, named.gate.in_a_row);
        }
    }
    return done;
}

void add_gate_options(CLI::App& command, const std::shared_ptr<RecordsOptions>& given) {
    command.add_option("--exercise", given->exercise, "In this one only");
    command.add_option("--gates", given->gates, "File of gates [rubrics/gates.json]");
    command.add_option("--pass", given->pass, "Pass mark of every exercise, a share of the scale [as the gates say]");
}

}  // namespace

void add_records_progress(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context) {
    CLI::App* command = records.add_subcommand("curve", "How the scores of a trainee came along");
    command->add_option("trainee", given->trainee, "Pseudonym")->required();
    add_gate_options(*command, given);
    CLI::Option* html = command->add_option("--html", given->html, "Write a page with a chart for each exercise");
    add_page_language(*command, given, html);
    command->add_flag("--json", given->json, "Print it as JSON");
    command->callback([given, &context] { context.status = curve(*given, context); });

    command = records.add_subcommand("gates", "Which exercises were passed often enough to go on");
    command->add_option("trainee", given->trainee, "Pseudonym [everybody]");
    add_gate_options(*command, given);
    command->callback([given, &context] { context.status = gates(*given, context); });
}

}  // namespace rhexis::cli
