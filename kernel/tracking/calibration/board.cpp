// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/calibration/board.hpp"

#include <array>
#include <charconv>
#include <optional>

#include "base/numbers.hpp"

namespace rhexis::tracking {
namespace {

/// All of a text as a number; none: it is no number.
template <typename Number>
std::optional<Number> number_in(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// The parts of a text between `mark`s; more than three are none.
std::array<std::string_view, 3> three_parts(std::string_view text, char mark) {
    std::array<std::string_view, 3> parts;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t end = text.find(mark);
        if (end == std::string_view::npos) {
            return {};
        }
        parts[i] = text.substr(0, end);
        text.remove_prefix(end + 1);
    }
    parts[2] = text;
    return parts;
}

}  // namespace

Vec2 point_of(const GridPlan& plan, int point) {
    return plan.spacing_mm *
           Vec2(point % plan.columns - 0.5 * (plan.columns - 1), point / plan.columns - 0.5 * (plan.rows - 1));
}

Result<GridPlan> parse_board(std::string_view text) {
    const std::size_t colon = text.find(':');
    const std::string_view kind = text.substr(0, colon);
    const auto [columns_text, rows_text, spacing_text] =
        three_parts(colon == std::string_view::npos ? std::string_view{} : text.substr(colon + 1), 'x');
    const std::optional<int> columns = number_in<int>(columns_text);
    const std::optional<int> rows = number_in<int>(rows_text);
    const std::optional<double> spacing = number_in<double>(spacing_text);
    if ((kind != "dots" && kind != "chess") || !columns || !rows || !spacing) {
        return Error{"\"" + std::string(text) + "\" is no board", "",
                     "dots:COLUMNSxROWSxMM or chess:COLUMNSxROWSxMM, of dots or of inner corners, as dots:13x9x14"};
    }
    const GridPlan plan{*columns, *rows, *spacing, kind == "dots" ? GridKind::dots : GridKind::chess};
    if (const Status status = check_board(plan); !status) {
        return status.error();
    }
    return plan;
}

Status check_board(const GridPlan& plan) {
    for (const Status& status :
         {check_range("columns", plan.columns, 3, 100, "board"), check_range("rows", plan.rows, 3, 100, "board"),
          check_range("spacing", plan.spacing_mm, 0.1, 1000.0, "board", "mm")}) {
        if (!status) {
            return status;
        }
    }
    return success();
}

}  // namespace rhexis::tracking
