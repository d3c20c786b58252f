// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis records next, course: where trainees are in a course, and what comes next.
#include <cstdio>
#include <iostream>
#include <map>

#include "cli/counted.hpp"
#include "cli/course_file.hpp"
#include "cli/exercise_title.hpp"
#include "cli/records_command.hpp"
#include "trial/places.hpp"

namespace rhexis::cli {
namespace {

using nlohmann::json;
using records::Attempt;
using records::LessonPlan;
using records::LessonState;

struct CourseState {
    LessonPlan plan;
    records::Gates gates;
    std::map<std::string, std::vector<LessonState>> trainees;
};

Result<CourseState> state_of(const RecordsOptions& given, const Context& context) {
    Result<LessonPlan> plan = read_course_or_usual(given.course, context.root);
    if (!plan) {
        return plan.error();
    }
    Result<records::Gates> gates = gates_of(given, context);
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
    if (given.trainee.empty()) {
        if (const Status status = check_wanted(store.value(), given, attempts.value()); !status) {
            return status.error();
        }
    }
    std::map<std::string, std::vector<Attempt>> of_each;
    if (!given.trainee.empty()) {
        of_each[given.trainee] = {};  // who has nothing stored begins with the first lesson
    }
    for (const Attempt& attempt : attempts.value()) {
        of_each[attempt.trainee.pseudonym].push_back(attempt);
    }
    CourseState state{std::move(plan).value(), std::move(gates).value(), {}};
    for (const auto& [trainee, own] : of_each) {
        state.trainees[trainee] = records::states_of(state.plan, state.gates, own);
    }
    return state;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

std::string word_of(const LessonState& state) { return state.passed() ? "passed" : state.open() ? "open" : "closed"; }

/// What a trainee has done of a lesson.
std::string told_of(const LessonState& state, const records::Gates& gates) {
    const records::Course& course = state.course;
    if (state.passed()) {
        return "since attempt " + std::to_string(course.open_after);
    }
    if (!state.open()) {
        return "until " + joined(state.waits_for) + (state.waits_for.size() == 1 ? " is" : " are") + " passed";
    }
    if (course.attempts.empty()) {
        return "not tried";
    }
    return counted(course.attempts.size(), "attempt") + ", " + std::to_string(course.in_a_row) + " of " +
           std::to_string(gates.of(state.lesson.exercise).in_a_row) + " passes in a row";
}

json lesson_json(const LessonState& state, const records::Gates& gates) {
    const records::Gate& gate = gates.of(state.lesson.exercise);
    const records::Course& course = state.course;
    return {{"exercise", state.lesson.exercise},
            {"after", state.lesson.after},
            {"state", word_of(state)},
            {"waits_for", state.waits_for},
            {"attempts", course.attempts.size()},
            {"peak", course.peak() ? json(*course.peak()) : json()},
            {"in_a_row", course.in_a_row},
            {"needed_in_a_row", gate.in_a_row},
            {"pass", gate.pass},
            {"open_after", course.open_after}};
}

json course_json(const CourseState& state) {
    json data = {{"course", state.plan.name}, {"title", state.plan.title}, {"trainees", json::array()}};
    for (const auto& [trainee, lessons] : state.trainees) {
        const LessonState* next = records::next_of(lessons);
        json own = {{"trainee", trainee},
                    {"next", next != nullptr ? json(next->lesson.exercise) : json()},
                    {"lessons", json::array()}};
        for (const LessonState& lesson : lessons) {
            own["lessons"].push_back(lesson_json(lesson, state.gates));
        }
        data["trainees"].push_back(own);
    }
    return data;
}

/// The same for readers: exercises by their titles, in the language of the page.
Result<json> page_data(const CourseState& state, const RecordsOptions& given, const Context& context) {
    const Result<std::string> language = language_of_page(given.language, context.root);
    if (!language) {
        return language.error();
    }
    json data = course_json(state);
    for (const records::Lesson& lesson : state.plan.lessons) {
        data["titles"][lesson.exercise] = title_of(lesson.exercise, language.value(), context.root);
    }
    return data;
}

int write_page(const CourseState& state, const RecordsOptions& given, const Context& context) {
    Result<json> data = page_data(state, given, context);
    return data ? write_records_page(given, "records.course", std::move(data).value(), context)
                : complain(data.error());
}

int next(const RecordsOptions& given, const Context& context) {
    const Result<CourseState> state = state_of(given, context);
    if (!state) {
        return complain(state.error());
    }
    if (given.json) {
        std::cout << course_json(state.value()).dump(2) << '\n';
        return done;
    }
    const std::vector<LessonState>& lessons = state.value().trainees.at(given.trainee);
    std::printf("%s: %s\n", state.value().plan.name.c_str(), state.value().plan.title.c_str());
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        std::printf("  %2zu  %-24s  %-6s  %s\n", i + 1, lessons[i].lesson.exercise.c_str(), word_of(lessons[i]).c_str(),
                    told_of(lessons[i], state.value().gates).c_str());
    }
    const LessonState* following = records::next_of(lessons);
    if (following == nullptr) {
        std::printf("%s has passed all of it\n", given.trainee.c_str());
    } else {
        const std::string& exercise = following->lesson.exercise;
        std::printf("next: rhexis run %s --trainee %s --course %s\n", exercise.c_str(), given.trainee.c_str(),
                    state.value().plan.name.c_str());
    }
    return done;
}

int course(const RecordsOptions& given, const Context& context) {
    if (const Status status = check_page_language(given, context); !status) {
        return complain(status.error());
    }
    const Result<CourseState> state = state_of(given, context);
    if (!state) {
        return complain(state.error());
    }
    if (given.json) {
        std::cout << course_json(state.value()).dump(2) << '\n';
    } else {
        std::printf("%-16s  %-8s  %s\n", "trainee", "passed", "next");
        for (const auto& [trainee, lessons] : state.value().trainees) {
            std::size_t passed = 0;
            for (const LessonState& lesson : lessons) {
                passed += lesson.passed() ? 1 : 0;
            }
            const LessonState* following = records::next_of(lessons);
            std::printf("%-16s  %2zu of %-2zu  %s\n", trainee.c_str(), passed, lessons.size(),
                        following != nullptr ? following->lesson.exercise.c_str() : "-");
        }
    }
    return given.html.empty() ? done : write_page(state.value(), given, context);
}

void add_course_options(CLI::App& command, const std::shared_ptr<RecordsOptions>& given) {
    command.add_option("--gates", given->gates, "File of gates [rubrics/gates.json]");
    command.add_option("--pass", given->pass, "Pass mark of every exercise, a share of the scale [as the gates say]");
    command.add_flag("--json", given->json, "Print it as JSON");
}

}  // namespace

void add_records_course(CLI::App& records, const std::shared_ptr<RecordsOptions>& given, Context& context) {
    CLI::App* command = records.add_subcommand("next", "Which lesson of a course a trainee comes to next");
    command->add_option("trainee", given->trainee, "Pseudonym")->required();
    command->add_option("--course", given->course, "File, or name of one in courses/ [RHEXIS_COURSE, or cataract]");
    add_course_options(*command, given);
    command->callback([given, &context] { context.status = next(*given, context); });

    command = records.add_subcommand("course", "Where all trainees are in a course, trainee by exercise");
    command->add_option("course", given->course, "File, or name of one in courses/ [RHEXIS_COURSE, or cataract]");
    command->add_option("--cohort", given->cohort, "Trainees of this cohort only");
    add_course_options(*command, given);
    CLI::Option* html = command->add_option("--html", given->html, "Write it as a page");
    add_page_language(*command, given, html);
    command->callback([given, &context] { context.status = course(*given, context); });
}

}  // namespace rhexis::cli
