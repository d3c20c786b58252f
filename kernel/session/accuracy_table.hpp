// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of what a model's ways, meshes and steps cost and what error they make: assets/accuracy/*.csv. They are made
// by scripts/dev/accuracy_tables.py from charts that are kept in docs/data; nothing is timed where the program runs.
//
//   # rhexis accuracy table 1
//   # answer: 24,000 tetrahedra in steps of 1 ms        what errors are against
//   # machine: AMD EPYC                                 that costs were measured on
//   way,not_with,patient.tetrahedra,step_ms,cost,volume,force,depth
//   explicit,,3000,10,0.39,0.27,1.29,0.015
//
// A column whose name has a dot is a setting that decides how fine the model is; one that is named as a quantity
// (accuracy_quantities.hpp) is its error, empty where nobody knows it. `way` and `not_with` may be missing.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace rhexis {

struct AccuracyRow {
    std::string way;
    std::string not_with;  ///< tissue that this way knows nothing of
    std::map<std::string, double> mesh;
    double step_s = 0.01;
    double cost = 0.0;                    ///< [CPU s per simulated s]
    std::map<std::string, double> error;  ///< by quantity
};

struct AccuracyTable {
    std::string model;
    std::string machine;
    std::string answer;
    std::vector<AccuracyRow> rows;
};

/// folder/MODEL.csv. Fails in one line when it is missing, of another version, or not such a table.
Result<AccuracyTable> read_accuracy_table(const std::string& folder, const std::string& model);

/// Error to expect of a way at a mesh and step: the largest that it makes there or anywhere finer, for what is coarser
/// than others and yet nearer to the answer is so by chance. Between the rows of the table it is that of the next
/// coarser one. Nothing when no row is as coarse, or one that counts tells nothing.
std::optional<double> expected_error(const AccuracyTable& table, const AccuracyRow& at, const std::string& quantity);

/// That of the row itself, or of the cheapest that is finer, or else of the dearest that is coarser.
double expected_cost_of(const AccuracyTable& table, const AccuracyRow& at);

}  // namespace rhexis
