// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/accuracy_notes.hpp"

#include <algorithm>
#include <cstdio>

#include "base/numbers.hpp"

namespace rhexis {
namespace {

std::string two_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    return text;
}

std::string spaced(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::string mesh_words(const std::map<std::string, double>& mesh) {
    std::string text;
    for (const auto& [name, value] : mesh) {
        text += (text.empty() ? "" : ", ") + name + " = " + short_number(value);
    }
    return text;
}

/// "force 1.3 (0.75)".
std::string error_words(const ModelAccuracy& model) {
    std::string text;
    for (const auto& [name, allowed] : model.budget) {
        const auto found = model.expected.find(name);
        text += (text.empty() ? "" : ", ") + name + " " +
                (found == model.expected.end() ? "unknown" : two_digits(found->second)) + " (" + short_number(allowed) +
                ")";
    }
    return text;
}

bool exceeds(const ModelAccuracy& model) {
    return std::any_of(model.budget.begin(), model.budget.end(), [&model](const auto& entry) {
        const auto found = model.expected.find(entry.first);
        return found == model.expected.end() || found->second > entry.second;
    });
}

}  // namespace

std::vector<std::string> accuracy_lines(const SceneAccuracy& accuracy) {
    std::vector<std::string> lines{
        "step: " + short_number(1e3 * accuracy.step_s) + " ms (" +
        (accuracy.step_by_hand ? "by hand" : "time " + short_number(accuracy.time_s) + " s") + ")"};
    for (const ModelAccuracy& model : accuracy.models) {
        std::string line = spaced(model.model) + ": ";
        for (const std::string& part : {model.way, mesh_words(model.mesh)}) {
            line += part.empty() ? "" : part + ", ";
        }
        line += model.by_hand ? "by hand, " : "";
        lines.push_back(line + "expected error (and what it may be): " + error_words(model));
    }
    return lines;
}

std::vector<std::string> accuracy_warnings(const SceneAccuracy& accuracy) {
    std::vector<std::string> lines;
    for (const ModelAccuracy& model : accuracy.models) {
        if (!model.by_hand || (!exceeds(model) && model.mesh == model.instead)) {
            continue;
        }
        const std::string own = spaced(model.model) + ": " + mesh_words(model.mesh) + " by hand";
        const std::string instead = model.instead.empty() ? "no mesh of its table keeps that at this step"
                                                          : "the budget alone would take " + mesh_words(model.instead);
        lines.push_back("accuracy: " + own + (exceeds(model) ? " does not keep its budget" : " is not what it needs") +
                        ": expected error (and what it may be) " + error_words(model) + "; " + instead);
    }
    const double cost = expected_cost(accuracy);
    if (cost > 1.0) {
        lines.push_back("accuracy: not in real time on one core: " + two_digits(cost) +
                        " CPU s per simulated s by the tables, measured on " + accuracy.models.front().machine);
    }
    return lines;
}

std::string measured_line(const nlohmann::json& measured) {
    std::string errors;
    for (const auto& [name, value] : measured.at("errors").items()) {
        errors += (errors.empty() ? "" : ", ") + name + " " + two_digits(value.get<double>());
    }
    char compared[64];
    std::snprintf(compared, sizeof compared, "%.1f of %.1f s compared", measured.at("compared_s").get<double>(),
                  measured.at("of_s").get<double>());
    std::string line =
        "against twice the resolution, " + std::string(compared) + ": " + (errors.empty() ? "nothing to tell" : errors);
    const nlohmann::json& differs = measured.at("differs");
    if (differs.is_object()) {
        char at[32];
        std::snprintf(at, sizeof at, "%.2f s", differs.at("time_s").get<double>());
        const std::string measure = differs.at("measure");
        line += measure.empty() ? "; there the finer one could not be stepped from " + std::string(at) + " on"
                                : "; from " + std::string(at) + " on " + measure + " differs";
    }
    return line;
}

}  // namespace rhexis
