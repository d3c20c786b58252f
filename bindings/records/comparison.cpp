// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/comparison.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "records/agreement.hpp"

namespace rhexis::records {
namespace {

using nlohmann::json;
using Points = std::map<std::string, double>;  // by item

/// An attempt as the simulator and the raters saw it.
struct Target {
    Points simulator;
    std::map<std::string, Points> raters;
};

constexpr const char* total = "total";

Points points_of(const Attempt& attempt) {
    Points points;
    for (const ItemScore& item : attempt.items) {
        if (item.score) {
            points[item.id] = *item.score;
        }
    }
    return points;
}

Points points_of(const Rating& rating) {
    Points points;
    for (const RatedItem& item : rating.items) {
        if (item.score) {
            points[item.id] = *item.score;
        }
    }
    return points;
}

/// Mean points x 20 over the items that everybody scored.
void add_totals(Target& target) {
    std::set<std::string> shared;
    for (const auto& [id, score] : target.simulator) {
        shared.insert(id);
    }
    for (const auto& [rater, points] : target.raters) {
        std::erase_if(shared, [&points = points](const std::string& id) { return !points.contains(id); });
    }
    if (shared.empty()) {
        return;
    }
    const auto add_total = [&shared](Points& points) {
        const double sum =
            std::accumulate(shared.begin(), shared.end(), 0.0,
                            [&points](double so_far, const std::string& id) { return so_far + points[id]; });
        points[total] = 20.0 * sum / static_cast<double>(shared.size());
    };
    add_total(target.simulator);
    for (auto& [rater, points] : target.raters) {
        add_total(points);
    }
}

std::vector<Target> targets_of(const std::vector<Attempt>& attempts, const std::vector<Rating>& ratings) {
    std::vector<Target> targets;
    for (const Attempt& attempt : attempts) {
        Target target{points_of(attempt), {}};
        for (const Rating& rating : ratings) {
            if (rating.attempt == attempt.id) {
                target.raters[rating.rater] = points_of(rating);
            }
        }
        if (!target.raters.empty()) {
            add_totals(target);
            targets.push_back(std::move(target));
        }
    }
    return targets;
}

json correlation_json(const Scores& scores) {
    std::string why;
    const std::optional<Correlation> found = intraclass(scores, why);
    if (!found) {
        return {{"why", why}};
    }
    return {{"n", found->targets}, {"k", found->judges}, {"single", found->single}, {"average", found->average}};
}

json limits_json(const std::vector<double>& a, const std::vector<double>& b) {
    const std::optional<Limits> found = limits_of_agreement(a, b);
    if (!found) {
        return {{"why", a.empty() ? "nothing that both have scored" : "only one attempt that both have scored"}};
    }
    return {{"n", found->n}, {"bias", found->bias}, {"sd", found->sd}, {"low", found->low}, {"high", found->high}};
}

/// The raters' scores of the item where all of them gave one.
Scores by_all(const std::vector<Target>& targets, const std::vector<std::string>& raters, const std::string& item) {
    Scores scores;
    for (const Target& target : targets) {
        std::vector<double> row;
        for (const std::string& rater : raters) {
            const auto points = target.raters.find(rater);
            if (points != target.raters.end() && points->second.contains(item)) {
                row.push_back(points->second.at(item));
            }
        }
        if (row.size() == raters.size()) {
            scores.push_back(std::move(row));
        }
    }
    return scores;
}

/// Those whom the correlation among raters is of: an attempt counts there when all of them have scored it, so who rated
/// less than half as many as who rated most would leave nothing to correlate.
std::vector<std::string> steady_raters(const std::vector<Target>& targets, const std::vector<std::string>& raters) {
    std::map<std::string, std::size_t> rated;
    std::size_t most = 0;
    for (const Target& target : targets) {
        for (const auto& [rater, points] : target.raters) {
            most = std::max(most, ++rated[rater]);
        }
    }
    std::vector<std::string> steady;
    std::copy_if(raters.begin(), raters.end(), std::back_inserter(steady),
                 [&rated, most](const std::string& rater) { return 2 * rated[rater] >= most; });
    return steady.size() < 2 ? raters : steady;
}

/// Correlation among the steady ones, limits of every pair.
json among_raters(const std::vector<Target>& targets, const std::vector<std::string>& raters,
                  const std::vector<std::string>& steady, const std::string& item) {
    if (raters.size() < 2) {
        return {{"icc", {{"why", "too few raters: two at least"}}}, {"pairs", json::array()}};
    }
    json pairs = json::array();
    for (std::size_t i = 0; i < raters.size(); ++i) {
        for (std::size_t j = i + 1; j < raters.size(); ++j) {
            std::vector<double> a;
            std::vector<double> b;
            for (const std::vector<double>& row : by_all(targets, {raters[i], raters[j]}, item)) {
                a.push_back(row[0]);
                b.push_back(row[1]);
            }
            pairs.push_back({{"a", raters[i]}, {"b", raters[j]}, {"limits", limits_json(a, b)}});
        }
    }
    return {{"icc", correlation_json(by_all(targets, steady, item))}, {"pairs", pairs}};
}

/// The simulator beside the mean of those raters who scored the item.
json against_raters(const std::vector<Target>& targets, const std::string& item) {
    Scores scores;
    std::vector<double> simulator;
    std::vector<double> raters;
    json points = json::array();
    for (const Target& target : targets) {
        double sum = 0.0;
        int count = 0;
        for (const auto& [rater, given] : target.raters) {
            if (given.contains(item)) {
                sum += given.at(item);
                ++count;
            }
        }
        if (count == 0 || !target.simulator.contains(item)) {
            continue;
        }
        const double own = target.simulator.at(item);
        const double mean = sum / count;
        scores.push_back({own, mean});
        simulator.push_back(own);
        raters.push_back(mean);
        points.push_back({0.5 * (own + mean), own - mean});
    }
    return {{"icc", correlation_json(scores)}, {"limits", limits_json(simulator, raters)}, {"points", points}};
}

/// T2 before T10.
bool before(const std::string& a, const std::string& b) {
    const auto letters = [](const std::string& id) { return id.find_first_of("0123456789"); };
    const std::string kind_a = a.substr(0, letters(a));
    const std::string kind_b = b.substr(0, letters(b));
    if (kind_a != kind_b) {
        return kind_a > kind_b;  // tasks before global items
    }
    return a.size() != b.size() ? a.size() < b.size() : a < b;
}

}  // namespace

json compare_judges(const std::vector<Attempt>& attempts, const std::vector<Rating>& ratings) {
    const std::vector<Target> targets = targets_of(attempts, ratings);
    std::set<std::string> rater_names;
    std::set<std::string> item_names;
    for (const Target& target : targets) {
        for (const auto& [rater, points] : target.raters) {
            rater_names.insert(rater);
            for (const auto& [id, score] : points) {
                item_names.insert(id);
            }
        }
    }
    item_names.erase(total);
    std::map<std::string, std::string> titles;
    for (const Attempt& attempt : attempts) {
        for (const ItemScore& item : attempt.items) {
            titles[item.id] = item.name;
        }
    }
    const std::vector<std::string> raters(rater_names.begin(), rater_names.end());
    std::vector<std::string> items(item_names.begin(), item_names.end());
    std::sort(items.begin(), items.end(), before);
    items.emplace_back(total);
    const std::vector<std::string> steady = steady_raters(targets, raters);
    std::vector<std::string> left_out;
    std::set_difference(raters.begin(), raters.end(), steady.begin(), steady.end(), std::back_inserter(left_out));
    json rows = json::array();
    for (const std::string& item : items) {
        rows.push_back({{"item", item},
                        {"name", item == total ? "Mean points per item x 20" : titles[item]},
                        {"raters", among_raters(targets, raters, steady, item)},
                        {"simulator", against_raters(targets, item)}});
    }
    return {{"raters", raters}, {"left_out", left_out}, {"attempts", targets.size()}, {"rows", rows}};
}

}  // namespace rhexis::records
