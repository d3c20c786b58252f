// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/history.hpp"

#include <cmath>
#include <map>

namespace rhexis::records {
namespace {

using nlohmann::json;

bool is_scored(const Attempt& attempt) {
    return attempt.state == AttemptState::finished && attempt.total && attempt.max && *attempt.max > 0.0;
}

json scores_of(const Attempt& attempt) {
    json items = json::object();
    for (const ItemScore& item : attempt.items) {
        if (item.score) {
            items[item.id] = *item.score;
        }
    }
    return items;
}

json history_of(const std::vector<Attempt>& earlier, const Gate& gate) {
    json list = json::array();
    for (const Attempt& attempt : earlier) {
        if (is_scored(attempt)) {
            list.push_back({{"date", attempt.begun},
                            {"score", *attempt.total},
                            {"max", *attempt.max},
                            {"passed", passes(attempt, gate)},
                            {"completed", attempt.completed},
                            {"items", scores_of(attempt)}});
        }
    }
    return list;
}

/// Mean points of each item, of those who were scored on it.
json mean_items(const std::map<std::string, Attempt>& last_of) {
    std::map<std::string, std::pair<double, int>> sums;
    for (const auto& [trainee, attempt] : last_of) {
        for (const ItemScore& item : attempt.items) {
            if (item.score) {
                sums[item.id].first += *item.score;
                sums[item.id].second += 1;
            }
        }
    }
    json items = json::object();
    for (const auto& [id, sum] : sums) {
        items[id] = sum.first / sum.second;
    }
    return items;
}

/// Of what each completed last: an attempt that was broken off is judged by what was done until then. Null where fewer
/// than two others have completed one.
json cohort_of(const std::vector<Attempt>& attempts, const std::string& cohort, const Attempt& but) {
    std::map<std::string, Attempt> last_of;
    for (const Attempt& attempt : attempts) {
        if (is_scored(attempt) && attempt.completed && attempt.trainee.pseudonym != but.trainee.pseudonym &&
            attempt.input == but.input && attempt.aids.empty()) {
            last_of[attempt.trainee.pseudonym] = attempt;
        }
    }
    if (last_of.size() < 2) {
        return nullptr;
    }
    const double n = static_cast<double>(last_of.size());
    double sum = 0.0;
    for (const auto& [trainee, attempt] : last_of) {
        sum += 100.0 * *attempt.total / *attempt.max;
    }
    double squares = 0.0;
    for (const auto& [trainee, attempt] : last_of) {
        squares += std::pow(100.0 * *attempt.total / *attempt.max - sum / n, 2);
    }
    return {{"group", cohort}, {"n", last_of.size()},         {"mean", sum / n}, {"sd", std::sqrt(squares / (n - 1.0))},
            {"max", 100},      {"items", mean_items(last_of)}};
}

}  // namespace

Result<json> comparison_for(Store& store, const Attempt& attempt, const Gates& gates) {
    Wanted wanted;
    wanted.trainee = attempt.trainee.pseudonym;
    wanted.exercise = attempt.exercise;
    wanted.finished = true;
    wanted.details = true;
    const Result<std::vector<Attempt>> own = store.attempts(wanted);
    if (!own) {
        return own.error();
    }
    json comparison = json::object();
    const Gate& gate = gates.of(attempt.exercise);
    if (json history = history_of(own.value(), gate); !history.empty()) {
        comparison["history"] = std::move(history);
        comparison["pass"] = gate.pass;
    }
    wanted.trainee.clear();
    for (const std::string& cohort : {attempt.trainee.cohort, std::string(reference_cohort)}) {
        wanted.cohort = cohort;
        const Result<std::vector<Attempt>> others =
            cohort.empty() || comparison.contains("cohort") ? std::vector<Attempt>() : store.attempts(wanted);
        if (!others) {
            return others.error();
        }
        if (json found = cohort_of(others.value(), cohort, attempt); !found.is_null()) {
            comparison["cohort"] = std::move(found);
        }
    }
    return comparison;
}

}  // namespace rhexis::records
