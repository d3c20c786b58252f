// SPDX-License-Identifier: GPL-3.0-or-later
// How far the measures of an attempt are off those of a finer simulation of the same hand, in the quantities of error
// budgets.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "flow/observation.hpp"

namespace rhexis {

class CourseErrors {
public:
    explicit CourseErrors(const ObservationSchema& schema);

    /// Values of a step that ends at time_s, ascending; NaN: the measure tells of nothing then.
    void add(double time_s, const std::vector<double>& own, const std::vector<double>& finer);

    /// By quantity; none of those of which nothing was told.
    [[nodiscard]] std::map<std::string, double> errors() const;

private:
    struct Sums {
        double difference = 0.0;  ///< squares
        double size = 0.0;        ///< of the finer, likewise
        double count = 0.0;
    };
    /// A mouth grips and lets go by chance: a force is compared in means over a while.
    struct Mean {
        std::size_t measure = 0;
        double own = 0.0;  ///< sums over the while
        double finer = 0.0;
        double steps = 0.0;
    };

    void close_means();

    std::map<std::string, std::vector<std::size_t>> over_time_;  ///< measures of a quantity
    std::map<std::string, std::vector<std::size_t>> at_end_;
    std::map<std::string, Sums> sums_;
    std::map<std::string, double> ends_;
    std::vector<Mean> forces_;
    long while_ = 0;         ///< number of the one that it is now
    double greatest_ = 0.0;  ///< mean force of the finer [mN]
};

}  // namespace rhexis
