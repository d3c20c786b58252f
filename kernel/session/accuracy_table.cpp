// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/accuracy_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/near_names.hpp"
#include "base/text_file.hpp"
#include "session/accuracy_quantities.hpp"

namespace rhexis {
namespace {

constexpr std::string_view table_family = "# rhexis accuracy table ";
constexpr std::string_view table_version = "1";
constexpr std::size_t largest_table = std::size_t{1} << 20;
constexpr double step_tolerance = 1e-9;  // [s]

/// Fields between commas; none of a table's has quotes.
std::vector<std::string> table_fields(std::string_view line) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',') {
            fields.emplace_back();
        } else if (c != '\r') {
            fields.back() += c;
        }
    }
    return fields;
}

std::vector<std::string_view> table_lines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

bool is_quantity(const std::string& name) {
    const auto known = accuracy_quantities();
    return std::any_of(known.begin(), known.end(), [&name](const auto& quantity) { return quantity.name == name; });
}

bool is_mesh(const std::string& name) { return name.find('.') != std::string::npos; }

class TableReader {
public:
    TableReader(std::string path, AccuracyTable& table) : path_(std::move(path)), table_(table) {}

    Status read(std::string_view text) {
        const std::vector<std::string_view> lines = table_lines(text);
        if (Status version = check_version(lines); !version) {
            return version;
        }
        for (line_ = 2; line_ <= lines.size(); ++line_) {
            const std::string_view line = lines[line_ - 1];
            Status status = line.starts_with("#") ? about(line) : columns_.empty() ? header(line) : row(line);
            if (!status) {
                return status;
            }
        }
        return table_.rows.empty() ? fault("the table has no rows") : success();
    }

private:
    Status fault(const std::string& what) const { return Error{what, path_ + ":" + std::to_string(line_), remedy}; }

    Status check_version(const std::vector<std::string_view>& lines) {
        if (lines.empty() || !lines[0].starts_with(table_family)) {
            return Error{"this is no accuracy table", path_, remedy};
        }
        const std::string_view version = lines[0].substr(table_family.size());
        return version == table_version
                   ? success()
                   : Status(Error{"the accuracy table has version " + std::string(version), path_,
                                  "this program reads version " + std::string(table_version) + ": " + remedy});
    }

    Status about(std::string_view line) {
        for (const auto& [key, field] :
             {std::pair("# machine: ", &table_.machine), std::pair("# answer: ", &table_.answer)}) {
            if (line.starts_with(key)) {
                *field = line.substr(std::string_view(key).size());
            }
        }
        return success();
    }

    Status header(std::string_view line) {
        columns_ = table_fields(line);
        for (const char* needed : {"step_ms", "cost"}) {
            if (std::find(columns_.begin(), columns_.end(), needed) == columns_.end()) {
                return fault(std::string("the table lacks the column ") + needed);
            }
        }
        for (const std::string& name : columns_) {
            const bool known = name == "step_ms" || name == "cost" || name == "way" || name == "not_with";
            if (!known && !is_mesh(name) && !is_quantity(name)) {
                std::vector<std::string> names;
                for (const AccuracyQuantity& quantity : accuracy_quantities()) {
                    names.emplace_back(quantity.name);
                }
                return fault("the column " + name + " is no quantity" + did_you_mean(name, names));
            }
        }
        return success();
    }

    Status row(std::string_view line) {
        const std::vector<std::string> fields = table_fields(line);
        if (fields.size() != columns_.size()) {
            return fault("the row has " + std::to_string(fields.size()) + " fields, the table " +
                         std::to_string(columns_.size()) + " columns");
        }
        AccuracyRow row;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (columns_[i] == "way" || columns_[i] == "not_with") {
                (columns_[i] == "way" ? row.way : row.not_with) = fields[i];
                continue;
            }
            if (fields[i].empty() && is_quantity(columns_[i])) {
                continue;
            }
            double value = 0.0;
            const char* end = fields[i].data() + fields[i].size();
            const auto [stopped, failed] = std::from_chars(fields[i].data(), end, value);
            if (failed != std::errc() || stopped != end || !std::isfinite(value) || value < 0.0) {
                return fault(columns_[i] + " is '" + fields[i] + "', not a number from 0 on");
            }
            put(row, columns_[i], value);
        }
        table_.rows.push_back(std::move(row));
        return success();
    }

    static void put(AccuracyRow& row, const std::string& column, double value) {
        if (column == "step_ms") {
            row.step_s = 1e-3 * value;
        } else if (column == "cost") {
            row.cost = value;
        } else {
            (is_mesh(column) ? row.mesh : row.error)[column] = value;
        }
    }

    static constexpr const char* remedy = "made by scripts/dev/accuracy_tables.py";
    std::string path_;
    AccuracyTable& table_;
    std::size_t line_ = 1;
    std::vector<std::string> columns_;
};

/// Whether a row's mesh and step are as fine as another's, or finer, the same way.
bool as_fine(const AccuracyRow& row, const AccuracyRow& other) {
    if (row.way != other.way || row.step_s > other.step_s + step_tolerance) {
        return false;
    }
    return std::all_of(row.mesh.begin(), row.mesh.end(), [&other](const auto& entry) {
        const auto found = other.mesh.find(entry.first);
        return found == other.mesh.end() || entry.second >= found->second;
    });
}

/// The largest error of a row and of all that are finer; nothing when one of them tells none.
std::optional<double> largest_error(const AccuracyTable& table, const AccuracyRow& row, const std::string& quantity) {
    double largest = 0.0;
    for (const AccuracyRow& finer : table.rows) {
        if (!as_fine(finer, row)) {
            continue;
        }
        const auto found = finer.error.find(quantity);
        if (found == finer.error.end()) {
            return std::nullopt;
        }
        largest = std::max(largest, found->second);
    }
    return largest;
}

}  // namespace

Result<AccuracyTable> read_accuracy_table(const std::string& folder, const std::string& model) {
    AccuracyTable table;
    table.model = model;
    const std::string path = folder + "/" + model + ".csv";
    const Result<std::string> text = read_text_file(path, largest_table);
    if (!text) {
        return Error{"the accuracy table of " + model + " cannot be read: " + text.error().what, path,
                     "made by scripts/dev/accuracy_tables.py, and installed with the program"};
    }
    const Status read = TableReader(path, table).read(without_mark(text.value()));
    return read ? Result<AccuracyTable>(std::move(table)) : read.error();
}

std::optional<double> expected_error(const AccuracyTable& table, const AccuracyRow& at, const std::string& quantity) {
    std::optional<double> least;
    for (const AccuracyRow& row : table.rows) {
        if (!as_fine(at, row)) {
            continue;
        }
        const std::optional<double> largest = largest_error(table, row, quantity);
        if (largest && (!least || *largest < *least)) {
            least = largest;
        }
    }
    return least;
}

double expected_cost_of(const AccuracyTable& table, const AccuracyRow& at) {
    double finer = std::numeric_limits<double>::infinity();
    double coarser = 0.0;
    for (const AccuracyRow& row : table.rows) {
        const bool is_finer = as_fine(row, at);
        const bool is_coarser = as_fine(at, row);
        if (is_finer && is_coarser) {
            return row.cost;
        }
        finer = is_finer ? std::min(finer, row.cost) : finer;
        coarser = is_coarser ? std::max(coarser, row.cost) : coarser;
    }
    return std::isfinite(finer) ? finer : coarser;
}

}  // namespace rhexis
