// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two simulations of the same hand have the same tears, cracks and grips.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "flow/observation.hpp"

namespace rhexis {

/// What one of them has and the other has not.
struct GripDifference {
    double time_s = 0.0;  ///< since when
    std::string measure;
    double first = 0.0;  ///< its value in each, then
    double second = 0.0;
};

/// Holds two courses of measures against each other. A tear or crack has begun where a measure of it is more than at
/// the start; a mouth holds where it is shut. What differs for no longer than 0.1 s has happened in both.
class DifferingGrip {
public:
    /// first, second: values at the start.
    DifferingGrip(const ObservationSchema& schema, const std::vector<double>& first, const std::vector<double>& second);

    /// The values at a later time. Nothing while both have the same.
    std::optional<GripDifference> look(double time_s, const std::vector<double>& first,
                                       const std::vector<double>& second);
    /// Whether they differ now, not yet for long enough to say so.
    [[nodiscard]] bool in_doubt() const;

private:
    enum class Kind { more_than_at_start, yes, count, shut };
    struct Sign {
        std::size_t measure;
        std::string name;
        Kind kind;
        double first_start;
        double second_start;
        std::optional<GripDifference> since{};
    };
    static std::optional<Kind> kind_of(const MeasureInfo& info);
    static double seen(const Sign& sign, double value, double start);
    std::vector<Sign> signs_;
};

}  // namespace rhexis
