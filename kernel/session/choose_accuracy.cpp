// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/choose_accuracy.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "base/numbers.hpp"
#include "session/accuracy_quantities.hpp"
#include "session/build_world.hpp"

namespace rhexis {
namespace {

constexpr std::array<double, 5> possible_steps{0.02, 0.01, 0.005, 0.002, 0.001};  // [s]
constexpr double step_slack = 1e-9;                                               // [s]
constexpr const char* tetrahedra_name = "patient.tetrahedra";

const AccuracyModel& model_named(const std::string& name) {
    const auto& all = accuracy_models();
    return *std::find_if(all.begin(), all.end(), [&name](const auto& model) { return model.tissue == name; });
}

bool takes_part(const AccuracyModel& model, const SceneDescription& scene) {
    return has_tissue(scene, std::string(model.tissue)) &&
           (model.with.empty() || has_tissue(scene, std::string(model.with)));
}

/// What a model may be off by, in this scene.
std::map<std::string, double> budget_of(const AccuracyModel& model, const SceneDescription& scene,
                                        const AccuracyWish& wish) {
    std::map<std::string, double> budget;
    for (const ModelQuantity& quantity : model.quantities) {
        if (quantity.with.empty() || has_tissue(scene, std::string(quantity.with))) {
            const auto own = wish.budget.find(std::string(quantity.name));
            budget[std::string(quantity.name)] = own == wish.budget.end() ? quantity.standard : own->second;
        }
    }
    return budget;
}

double hand_value(const SceneDescription& scene, const std::string& name) {
    return name == tetrahedra_name ? scene.patient.tetrahedra : all_settings(scene).at(name);
}

std::string thing(const std::string& model) {
    std::string text = model;
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

std::string mesh_text(const AccuracyRow& row) {
    std::string text;
    for (const auto& [name, value] : row.mesh) {
        text += name + " = " + short_number(value) + ", ";
    }
    text += short_number(1e3 * row.step_s) + " ms";
    return row.way.empty() ? text : text + ", " + row.way;
}

std::string errors_text(const std::map<std::string, double>& errors) {
    std::string text;
    for (const auto& [name, value] : errors) {
        char number[32];
        std::snprintf(number, sizeof number, "%.2g", value);
        text += (text.empty() ? "" : ", ") + name + " " + number;
    }
    return text;
}

/// A way to simulate a model.
struct Candidate {
    AccuracyRow row;
    std::map<std::string, double> expected;
    double cost = 0.0;
    double excess = 0.0;  ///< largest ratio of an error to what it may be; at most 1: it is kept
};

/// The ways to simulate one model of a scene.
class Candidates {
public:
    Candidates(const SceneDescription& scene, const AccuracyWish& wish, const AccuracyTable& table)
        : scene_(scene), wish_(wish), table_(table), budget_(budget_of(model_named(table.model), scene, wish)) {}

    [[nodiscard]] const AccuracyTable& table() const { return table_; }
    [[nodiscard]] const std::map<std::string, double>& budget() const { return budget_; }

    /// Whether the exercise says itself how fine the model is, in all or a part of it, or how it is advanced.
    [[nodiscard]] bool by_hand() const {
        const AccuracyRow& first = table_.rows[0];
        return (scene_.advance != Advance::automatic && !first.way.empty()) ||
               std::any_of(first.mesh.begin(), first.mesh.end(),
                           [this](const auto& entry) { return wish_.by_hand.contains(entry.first); });
    }

    /// At a step, cheapest first. hand: with what is said by hand.
    [[nodiscard]] std::vector<Candidate> at(double step_s, bool hand) const {
        std::vector<Candidate> found;
        const bool any_step = wish_.step_s.has_value() || (hand && by_hand());
        for (const AccuracyRow& row : table_.rows) {
            if ((!any_step && std::abs(row.step_s - step_s) > step_slack) || !is_possible(row, hand)) {
                continue;
            }
            AccuracyRow own = row;
            own.step_s = step_s;
            for (auto& [name, value] : own.mesh) {
                value = hand && wish_.by_hand.contains(name) ? hand_value(scene_, name) : value;
            }
            const bool known = std::any_of(found.begin(), found.end(), [&own](const Candidate& other) {
                return other.row.way == own.way && other.row.mesh == own.mesh;
            });
            if (!known) {
                found.push_back(judged(own));
            }
        }
        std::stable_sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
            return a.cost != b.cost ? a.cost < b.cost : a.row.mesh < b.row.mesh;
        });
        return found;
    }

    /// The cheapest that keeps the budget, or is said by hand; null: there is none.
    [[nodiscard]] std::optional<Candidate> cheapest(double step_s, bool hand) const {
        const std::vector<Candidate> all = at(step_s, hand);
        const auto kept = std::find_if(all.begin(), all.end(), [](const Candidate& one) { return one.excess <= 1.0; });
        if (kept != all.end()) {
            return *kept;
        }
        return hand && by_hand() && !all.empty() ? std::optional(*nearest(all)) : std::nullopt;
    }

    /// The one that exceeds the budget least, at the steps allowed.
    [[nodiscard]] std::optional<Candidate> best(const std::vector<double>& steps) const {
        std::vector<Candidate> all;
        for (const double step_s : steps) {
            const std::vector<Candidate> some = at(step_s, true);
            all.insert(all.end(), some.begin(), some.end());
        }
        return all.empty() ? std::nullopt : std::optional(*nearest(all));
    }

private:
    static std::vector<Candidate>::const_iterator nearest(const std::vector<Candidate>& all) {
        return std::min_element(all.begin(), all.end(),
                                [](const Candidate& a, const Candidate& b) { return a.excess < b.excess; });
    }

    /// Whether the scene can be advanced so, with what takes part in it. A way by hand is taken as it is, whether or
    /// not the scene bears it; a mesh by hand is advanced the first way of the table.
    [[nodiscard]] bool is_possible(const AccuracyRow& row, bool hand) const {
        if (scene_.advance != Advance::automatic && hand) {
            return row.way.empty() || (row.way == "implicit") == (scene_.advance == Advance::implicit);
        }
        if (!row.not_with.empty() && has_tissue(scene_, row.not_with)) {
            return false;
        }
        return !(hand && by_hand()) || row.way == table_.rows[0].way;
    }

    [[nodiscard]] Candidate judged(const AccuracyRow& row) const {
        Candidate one{row, {}, expected_cost_of(table_, row), 0.0};
        for (const auto& [quantity, allowed] : budget_) {
            const std::optional<double> error = expected_error(table_, row, quantity);
            if (error) {
                one.expected[quantity] = *error;
            }
            one.excess = std::max(one.excess, error ? *error / allowed : std::numeric_limits<double>::infinity());
        }
        return one;
    }

    const SceneDescription& scene_;
    const AccuracyWish& wish_;
    const AccuracyTable& table_;
    std::map<std::string, double> budget_;
};

/// A step with the cheapest of each model.
struct Together {
    double step_s = 0.0;
    double cost = 0.0;
    std::vector<Candidate> models;
};

std::optional<Together> together_at(double step_s, const std::vector<Candidates>& models, bool hand) {
    Together all{step_s, 0.0, {}};
    for (const Candidates& model : models) {
        std::optional<Candidate> one = model.cheapest(step_s, hand);
        if (!one) {
            return std::nullopt;
        }
        all.cost += one->cost;
        all.models.push_back(std::move(*one));
    }
    return all;
}

std::optional<Together> cheapest_of(const std::vector<double>& steps, const std::vector<Candidates>& models,
                                    bool hand) {
    std::optional<Together> least;
    for (const double step_s : steps) {
        std::optional<Together> one = together_at(step_s, models, hand);
        if (one && (!least || one->cost < least->cost)) {
            least = std::move(one);
        }
    }
    return least;
}

/// Every quantity that the scene is judged by.
std::set<std::string> judged_by(const std::vector<Candidates>& models) {
    std::set<std::string> names{std::string(time_quantity)};
    for (const Candidates& model : models) {
        for (const auto& [name, allowed] : model.budget()) {
            names.insert(name);
        }
    }
    return names;
}

Status check_quantities(const AccuracyWish& wish, const std::vector<Candidates>& models) {
    const std::set<std::string> known = judged_by(models);
    for (const auto& [name, allowed] : wish.budget) {
        if (known.contains(name)) {
            continue;
        }
        std::string list;
        for (const std::string& one : known) {
            list += (list.empty() ? "" : ", ") + one;
        }
        return Error{"accuracy: nothing in this scene is judged by " + name, wish.where, "one of " + list};
    }
    return success();
}

/// Of the first model that no step lets keep its budget, or of all together.
Error not_kept(const std::vector<double>& steps, const std::vector<Candidates>& models, const AccuracyWish& wish) {
    for (const Candidates& model : models) {
        const bool kept = std::any_of(steps.begin(), steps.end(),
                                      [&model](double step_s) { return model.cheapest(step_s, true).has_value(); });
        if (kept) {
            continue;
        }
        std::string text =
            "accuracy: no mesh and step of the " + thing(model.table().model) + " keeps " + errors_text(model.budget());
        const std::optional<Candidate> best = model.best(steps);
        return {text, wish.where,
                best ? "the nearest is " + errors_text(best->expected) + " with " + mesh_text(best->row)
                     : "its table has no row at such a step"};
    }
    return {"accuracy: no step keeps the budgets of all tissues", wish.where, "a step_s by hand, or larger budgets"};
}

ModelAccuracy accuracy_of(const Candidates& model, const Candidate& chosen, const std::optional<Candidate>& instead) {
    ModelAccuracy result;
    result.model = model.table().model;
    result.way = chosen.row.way;
    result.mesh = chosen.row.mesh;
    result.budget = model.budget();
    result.expected = chosen.expected;
    result.cost = chosen.cost;
    result.by_hand = model.by_hand();
    result.machine = model.table().machine;
    if (result.by_hand && instead) {
        result.instead = instead->row.mesh;
    }
    return result;
}

}  // namespace

std::vector<std::string> accuracy_models_of(const SceneDescription& scene) {
    std::vector<std::string> names;
    for (const AccuracyModel& model : accuracy_models()) {
        if (takes_part(model, scene)) {
            names.emplace_back(model.tissue);
        }
    }
    return names;
}

Result<std::vector<AccuracyTable>> read_accuracy_tables(const std::string& folder, const SceneDescription& scene) {
    std::vector<AccuracyTable> tables;
    for (const std::string& name : accuracy_models_of(scene)) {
        Result<AccuracyTable> table = read_accuracy_table(folder, name);
        if (!table) {
            return table.error();
        }
        tables.push_back(std::move(table).value());
    }
    return tables;
}

Result<SceneAccuracy> choose_accuracy(const SceneDescription& scene, const AccuracyWish& wish,
                                      const std::vector<AccuracyTable>& tables) {
    std::vector<Candidates> models;
    for (const AccuracyTable& table : tables) {
        models.emplace_back(scene, wish, table);
    }
    if (Status known = check_quantities(wish, models); !known) {
        return known.error();
    }
    SceneAccuracy accuracy;
    const auto time = wish.budget.find(std::string(time_quantity));
    accuracy.time_s = time == wish.budget.end() ? standard_time_error_s : time->second;
    accuracy.step_by_hand = wish.step_s.has_value();
    std::vector<double> steps;
    if (wish.step_s) {
        steps = {*wish.step_s};
    } else {
        std::copy_if(possible_steps.begin(), possible_steps.end(), std::back_inserter(steps),
                     [&accuracy](double step_s) { return step_s <= accuracy.time_s + step_slack; });
    }
    const std::optional<Together> chosen = cheapest_of(steps, models, true);
    if (!chosen) {
        return not_kept(steps, models, wish);
    }
    accuracy.step_s = chosen->step_s;
    for (std::size_t i = 0; i < models.size(); ++i) {
        accuracy.models.push_back(accuracy_of(models[i], chosen->models[i], models[i].cheapest(chosen->step_s, false)));
    }
    return accuracy;
}

void set_accuracy(const SceneAccuracy& accuracy, SceneDescription& scene) {
    scene.accuracy = accuracy;
    scene.step_s = accuracy.step_s;
    for (const ModelAccuracy& model : accuracy.models) {
        for (const auto& [name, value] : model.mesh) {
            if (name == tetrahedra_name) {
                scene.patient.tetrahedra = static_cast<int>(value);
            } else {
                scene.settings[name] = value;
            }
        }
        if (model.way == "implicit") {
            scene.advance = Advance::implicit;
        }
    }
}

}  // namespace rhexis
