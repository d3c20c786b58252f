// SPDX-License-Identifier: GPL-3.0-or-later
// What an error budget may be about, and what each tissue keeps where an exercise says nothing.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rhexis {

struct AccuracyQuantity {
    std::string_view name;
    std::string_view unit;  ///< "1": share of what it is
    double minimum = 0.0;
    double maximum = 1.0;
    std::string_view meaning;
};

/// All of them, sorted by name.
std::span<const AccuracyQuantity> accuracy_quantities();

/// Error in the moment of what happens: a step tells of it at its end. Of every scene, closed form: the step.
inline constexpr std::string_view time_quantity = "time";
inline constexpr double standard_time_error_s = 0.01;

/// A quantity that a model's table tells of.
struct ModelQuantity {
    std::string_view name;
    double standard;          ///< error that is kept where an exercise says nothing
    std::string_view with{};  ///< only in scenes with this tissue; empty: in all
};

/// A model whose mesh, step or way is chosen by a table.
struct AccuracyModel {
    std::string_view tissue;  ///< that brings it into a scene, and name of its table
    std::string_view with{};  ///< only together with this tissue; empty: alone too
    std::vector<ModelQuantity> quantities;
};

const std::vector<AccuracyModel>& accuracy_models();

}  // namespace rhexis
