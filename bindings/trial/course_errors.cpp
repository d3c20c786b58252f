// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/course_errors.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

constexpr double mean_over_s = 0.1;
constexpr const char* force = "force";
constexpr const char* path = "path";

std::vector<std::size_t> named(const ObservationSchema& schema, const std::vector<std::string>& endings) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < schema.size(); ++i) {
        if (std::any_of(endings.begin(), endings.end(),
                        [&](const std::string& ending) { return schema[i].name.ends_with(ending); })) {
            found.push_back(i);
        }
    }
    return found;
}

bool told(const std::vector<double>& own, const std::vector<double>& finer, std::size_t i) {
    return !std::isnan(own[i]) && !std::isnan(finer[i]);
}

}  // namespace

CourseErrors::CourseErrors(const ObservationSchema& schema)
    : over_time_{{"depth", named(schema, {"chamber.depth_mm"})},
                 {"pressure", named(schema, {"chamber.pressure_mmhg"})},
                 {path, named(schema, {"rhexis.tip_x_mm", "rhexis.tip_y_mm"})}},
      at_end_{{"volume", named(schema, {"lens.removed_mm3"})}, {"tear", named(schema, {"rhexis.torn_mm"})}} {
    for (const std::size_t measure : named(schema, {".force_mN"})) {
        forces_.push_back({measure});
    }
}

void CourseErrors::add(double time_s, const std::vector<double>& own, const std::vector<double>& finer) {
    for (const auto& [quantity, measures] : over_time_) {
        for (const std::size_t i : measures) {
            if (told(own, finer, i)) {
                Sums& sums = sums_[quantity];
                sums.difference += (own[i] - finer[i]) * (own[i] - finer[i]);
                sums.size += finer[i] * finer[i];
                sums.count += 1.0 / static_cast<double>(measures.size());
            }
        }
    }
    for (const auto& [quantity, measures] : at_end_) {
        for (const std::size_t i : measures) {
            if (told(own, finer, i) && finer[i] > 0.0) {
                ends_[quantity] = std::abs(own[i] - finer[i]) / finer[i];
            }
        }
    }
    if (const long now = static_cast<long>(time_s / mean_over_s); now != while_) {
        close_means();
        while_ = now;
    }
    for (Mean& mean : forces_) {
        if (told(own, finer, mean.measure)) {
            mean.own += own[mean.measure];
            mean.finer += finer[mean.measure];
            mean.steps += 1.0;
        }
    }
}

/// Nothing pressing on either side says nothing of how well a force is met.
void CourseErrors::close_means() {
    for (Mean& mean : forces_) {
        if (mean.own > 0.0 || mean.finer > 0.0) {
            const double difference = (mean.own - mean.finer) / mean.steps;
            sums_[force].difference += difference * difference;
            sums_[force].count += 1.0;
            greatest_ = std::max(greatest_, mean.finer / mean.steps);
        }
        mean = {mean.measure};
    }
}

std::map<std::string, double> CourseErrors::errors() const {
    std::map<std::string, double> errors = ends_;
    CourseErrors closed = *this;
    closed.close_means();
    for (const auto& [quantity, sums] : closed.sums_) {
        const double mean = std::sqrt(sums.difference / sums.count);
        const double whole = quantity == force ? closed.greatest_ : std::sqrt(sums.size / sums.count);
        if (quantity == path) {
            errors[quantity] = mean;
        } else if (whole > 0.0) {
            errors[quantity] = mean / whole;
        }
    }
    return errors;
}

}  // namespace rhexis
