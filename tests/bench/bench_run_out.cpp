// SPDX-License-Identifier: GPL-3.0-or-later
// Why a capsulorhexis runs out: how often it does under hands that do not correct it, over fill of the chamber with
// viscoelastic, pressure of the vitreous, age and direction of pull; and what pulls on the capsule before it is cut.
#include "bench/bench_run_out.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>

#include "base/clock.hpp"
#include "scenes/capsule_load.hpp"
#include "scenes/proportions.hpp"
#include "scenes/retraction.hpp"
#include "scenes/run_out.hpp"

namespace rhexis::bench {
namespace {

using nlohmann::json;
using scenes::Chamber;
using scenes::Fate;
using scenes::Interval;
using scenes::Pulls;
using scenes::RunOutResult;
using scenes::RunOutTrial;

constexpr double positive_pressure = 20.0;  ///< of the vitreous in an eye that pushes [mmHg]
constexpr double standard_age = 68.0;
constexpr int quick_triangles = 800;
constexpr double published_cut = 5.67;  ///< [Tan2025] [mm]

/// How the same hands, or hands that all pull one way, are put to the test.
struct Condition {
    std::string name;
    Chamber chamber;
    std::optional<double> inwards;  ///< of every pull [degrees]; none: pulls of the seed's beginner
};

struct Tally {
    int attempts = 0;
    int ran_out = 0;
    int stuck = 0;
    double radius = 0.0;        ///< sum of where tears ended [mm]
    double round_at_out = 0.0;  ///< sum over those that ran out [degrees]
    double peak_force = 0.0;    ///< greatest [uN]
    double cpu = 0.0;           ///< [s]
};

void count(const RunOutResult& result, Tally& tally) {
    ++tally.attempts;
    tally.ran_out += result.fate == Fate::ran_out ? 1 : 0;
    tally.stuck += result.fate == Fate::got_stuck ? 1 : 0;
    tally.radius += result.radius;
    tally.round_at_out += result.fate == Fate::ran_out ? result.round : 0.0;
    tally.peak_force = std::max(tally.peak_force, result.peak_force);
}

/// Seeds 1 to so many, each a mesh and a hand, under all the conditions.
std::vector<Tally> tally(const BenchOptions& options, double age, int seeds, const std::vector<Condition>& conditions) {
    std::vector<Tally> tallies(conditions.size());
    for (int i = 1; i <= (options.quick ? 1 : seeds); ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        RunOutTrial trial(age, seed, options.quick ? quick_triangles : 1500);
        for (std::size_t c = 0; c < conditions.size(); ++c) {
            const double start = thread_cpu_seconds();
            const Pulls pulls =
                conditions[c].inwards ? scenes::steady_pulls(*conditions[c].inwards) : scenes::pulls_of_beginner(seed);
            count(trial.run(conditions[c].chamber, pulls), tallies[c]);
            tallies[c].cpu += thread_cpu_seconds() - start;
        }
    }
    return tallies;
}

json row_of(const Condition& condition, double age, const Tally& tally) {
    const Interval interval = scenes::wilson(tally.ran_out, tally.attempts);
    json row{{"name", condition.name},
             {"age", age},
             {"fill", condition.chamber.fill},
             {"vitreous_mmhg", condition.chamber.vitreous_mmhg},
             {"push_mn", scenes::push_of_vitreous(condition.chamber) * 1e-3},
             {"attempts", tally.attempts},
             {"ran_out", tally.ran_out},
             {"stuck", tally.stuck},
             {"share", static_cast<double>(tally.ran_out) / tally.attempts},
             {"share_low", interval.low},
             {"share_high", interval.high},
             {"end_radius_mm", tally.radius / tally.attempts},
             {"peak_mn", tally.peak_force * 1e-3},
             {"cpu_s_per_attempt", tally.cpu / tally.attempts}};
    if (tally.ran_out > 0) {
        row["round_at_out_deg"] = tally.round_at_out / tally.ran_out;
    }
    if (condition.inwards) {
        row["inwards_deg"] = *condition.inwards;
    }
    return row;
}

json rows_of(const std::vector<Condition>& conditions, double age, const std::vector<Tally>& tallies) {
    json rows = json::array();
    for (std::size_t c = 0; c < conditions.size(); ++c) {
        rows.push_back(row_of(conditions[c], age, tallies[c]));
    }
    return rows;
}

void append(const json& more, json& rows) { rows.insert(rows.end(), more.begin(), more.end()); }

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string name_of(const char* what, double value) {
    return std::string("run_out/").append(what).append(" ").append(number(value));
}

std::string name_of(const char* what, double value, double fill) {
    return name_of(what, value).append("/fill ").append(number(fill));
}

std::vector<double> fills(const BenchOptions& options) {
    return options.quick ? std::vector<double>{0.2, 1.0} : std::vector<double>{0.2, 0.4, 0.6, 0.8, 1.0};
}

json over_fill(const BenchOptions& options) {
    std::vector<Condition> conditions;
    for (const double fill : fills(options)) {
        conditions.push_back({name_of("fill", fill), {fill, positive_pressure}, {}});
    }
    const std::vector<Tally> tallies = tally(options, standard_age, 40, conditions);
    json rows = rows_of(conditions, standard_age, tallies);
    const bool falls = std::is_sorted(tallies.rbegin(), tallies.rend(),
                                      [](const Tally& a, const Tally& b) { return a.ran_out < b.ran_out; });
    const Tally& least = tallies.front();
    const Tally& full = tallies.back();
    rows.push_back({{"name", "run_out/falls with fill"},
                    {"monotone", falls},
                    {"fisher_p", scenes::fisher(least.ran_out, least.attempts, full.ran_out, full.attempts)},
                    {"passed", falls || options.quick}});
    return rows;
}

json over_age(const BenchOptions& options) {
    json rows = json::array();
    const std::vector<double> ages = options.quick ? std::vector<double>{45.0} : std::vector<double>{25, 45, 68, 90};
    for (const double age : ages) {
        std::vector<Condition> conditions;
        for (const double fill : {0.2, 1.0}) {
            conditions.push_back({name_of("age", age, fill), {fill, positive_pressure}, {}});
        }
        append(rows_of(conditions, age, tally(options, age, 7, conditions)), rows);
    }
    return rows;
}

json over_direction(const BenchOptions& options) {
    std::vector<Condition> conditions;
    for (const double fill : {0.2, 0.6, 1.0}) {
        for (const double inwards : {-10.0, 0.0, 10.0, 20.0, 30.0, 40.0}) {
            if (!options.quick || inwards == 10.0) {
                conditions.push_back({name_of("direction", inwards, fill), {fill, positive_pressure}, inwards});
            }
        }
    }
    return rows_of(conditions, standard_age, tally(options, standard_age, 6, conditions));
}

struct RescueTally {
    double inwards = 0.0;  ///< [degrees]
    Chamber chamber;
    int attempts = 0;
    int rescued = 0;
    int reached_edge = 0;
    double pulls = 0.0;  ///< sum
};

void rescue_all(RunOutTrial& trial, std::vector<RescueTally>& tallies) {
    const scenes::TornFlap torn = trial.now();
    for (RescueTally& tally : tallies) {
        const scenes::RescueResult result = trial.rescue(torn, tally.chamber, tally.inwards);
        ++tally.attempts;
        tally.rescued += result.rescued ? 1 : 0;
        tally.reached_edge += result.reached_edge ? 1 : 0;
        tally.pulls += result.pulls;
    }
}

json row_of(const RescueTally& tally) {
    const Interval interval = scenes::wilson(tally.rescued, std::max(1, tally.attempts));
    return {{"name", name_of("rescue", tally.inwards, tally.chamber.fill)},
            {"inwards_deg", tally.inwards},
            {"fill", tally.chamber.fill},
            {"attempts", tally.attempts},
            {"rescued", tally.rescued},
            {"reached_edge", tally.reached_edge},
            {"share_low", interval.low},
            {"share_high", interval.high},
            {"pulls", tally.pulls / std::max(1, tally.attempts)}};
}

/// Tears that ran out by 1 mm in a shallow chamber, each led back with refill and without.
json rescues(const BenchOptions& options) {
    const Chamber shallow{0.2, positive_pressure};
    const Chamber refilled{1.0, positive_pressure};
    std::vector<RescueTally> tallies;
    for (const double inwards : options.quick ? std::vector<double>{30.0} : std::vector<double>{30.0, 60.0, 90.0}) {
        tallies.push_back({inwards, refilled});
        tallies.push_back({inwards, shallow});
    }
    for (int i = 1; i <= (options.quick ? 1 : 24); ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        RunOutTrial trial(standard_age, seed, options.quick ? quick_triangles : 1500);
        if (trial.run(shallow, scenes::pulls_of_beginner(seed), 1.0).fate == Fate::ran_out) {
            rescue_all(trial, tallies);
        }
    }
    json rows = json::array();
    for (std::size_t i = 0; i + 1 < tallies.size(); i += 2) {
        const RescueTally& with = tallies[i];
        const RescueTally& without = tallies[i + 1];
        rows.push_back(row_of(with));
        rows.push_back(row_of(without));
        rows.back()["fisher_p"] = scenes::fisher(with.rescued, with.attempts, without.rescued, without.attempts);
    }
    return rows;
}

json tension_row(double age, const Chamber& chamber) {
    scenes::CapsuleScene scene(age, {}, {});
    scene.sheet().support.push = scenes::push_of_vitreous(chamber);
    scene.settle(100);
    const scenes::CapsuleLoad load = scenes::capsule_load(scene.model(), scene.sheet());
    return {{"name",
             name_of("tension", age, chamber.fill).append("/").append(number(chamber.vitreous_mmhg)).append(" mmHg")},
            {"age", age},
            {"fill", chamber.fill},
            {"vitreous_mmhg", chamber.vitreous_mmhg},
            {"push_mn", scenes::push_of_vitreous(chamber) * 1e-3},
            {"lift_mm", load.lift},
            {"zonules_mn", load.zonules * 1e-3},
            {"tension_radial_mn_mm", load.tension_radial * 1e-3},
            {"tension_circular_mn_mm", load.tension_circular * 1e-3},
            {"energy_uj", load.energy * 1e-3}};
}

json tension(const BenchOptions& options) {
    json rows = json::array();
    for (const double pressure : {10.0, positive_pressure}) {
        for (const double fill : fills(options)) {
            rows.push_back(tension_row(standard_age, {fill, pressure}));
        }
    }
    for (const double age : {25.0, 45.0, 90.0}) {
        for (const double fill : {0.2, 1.0}) {
            rows.push_back(tension_row(age, {fill, positive_pressure}));
        }
    }
    return rows;
}

json retraction_row(double age, double tension) {
    const double before = thread_cpu_seconds();
    const scenes::Retraction cut = scenes::retraction(age, published_cut, {.zonule_tension = tension});
    return {{"name", "retraction/" + number(age) + "/tension " + number(tension)},
            {"age", age},
            {"tension", tension},
            {"at_rest_mm", cut.rest},
            {"cut_mm", cut.cut},
            {"open_mm", cut.open},
            {"growth_percent", 100.0 * (cut.open / cut.cut - 1.0)},
            {"cpu_s", thread_cpu_seconds() - before}};
}

json retractions(const BenchOptions& options) {
    json rows = json::array();
    for (const double age : {25.0, 45.0, 55.0, 68.0, 80.0, 90.0}) {
        rows.push_back(retraction_row(age, 1.0));
        if (options.quick) {
            return rows;
        }
    }
    for (const double tension : {0.0, 0.5, 2.0}) {
        rows.push_back(retraction_row(standard_age, tension));
    }
    return rows;
}

}  // namespace

std::vector<BenchCase> run_out_cases() {
    return {
        {"retraction", "how far a round cut of 5.67 mm springs open, over age and tension of the zonules", retractions},
        {"run_out_tension", "what pulls on the uncut capsule, over fill of the chamber, pressure and age", tension},
        {"run_out", "share of capsulorhexes that run out, over fill of the chamber, that is push of the vitreous",
         over_fill},
        {"run_out_age", "the same over age, in a shallow chamber and a full one", over_age},
        {"run_out_direction", "the same over direction of pull", over_direction},
        {"run_out_rescue", "share of tears led back, with refill of viscoelastic and without", rescues}};
}

}  // namespace rhexis::bench
