// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/measure/figures.hpp"

#include <algorithm>

#include "base/numbers.hpp"
#include "tracking/measure/measured_parts.hpp"

namespace rhexis::tracking {
namespace {

Status check_plan(const MeasurePlan& plan) {
    struct Range {
        const char* name;
        double value;
        double low;
        double high;
    };
    const std::array<Range, 5> ranges{{{"seeds", static_cast<double>(plan.seeds), 1, 100},
                                       {"marker_seeds", static_cast<double>(plan.marker_seeds), 0, 1000},
                                       {"image_s", plan.image_s, 0.2, 10},
                                       {"marker_s", plan.marker_s, 0.2, 20},
                                       {"identity_frames", static_cast<double>(plan.identity_frames), 0, 1e8}}};
    for (const Range& range : ranges) {
        if (Status status = check_range(range.name, range.value, range.low, range.high, "measuring"); !status) {
            return status;
        }
    }
    return success();
}

/// The parts of one seed, those that are kept from before and the others.
class SeedMeasurement {
public:
    SeedMeasurement(const MeasurePlan& plan, const KeptParts& kept, std::uint64_t seed)
        : plan_(plan), kept_(kept), seed_(seed) {}

    Result<Numbers> part(const Part& part) {
        Result<std::optional<Numbers>> before = kept_.read(seed_, part.name, part.plan);
        if (!before) {
            return before.error();
        }
        if (before.value()) {
            return std::move(*before.value());
        }
        if (const Status status = calibrate(); !status) {
            return status.error();
        }
        Result<Numbers> numbers = part.measure(*setting_);
        if (!numbers) {
            return named(numbers.error());
        }
        if (const Status status = kept_.write(seed_, part.name, part.plan, numbers.value()); !status) {
            return status.error();
        }
        return numbers;
    }

private:
    /// Once, and only if a part is to be measured.
    Status calibrate() {
        if (setting_) {
            return success();
        }
        Result<Setting> setting = setting_of(plan_, seed_);
        if (!setting) {
            return named(setting.error());
        }
        setting_ = std::move(setting).value();
        return success();
    }
    [[nodiscard]] Error named(Error error) const {
        error.where = "seed " + std::to_string(seed_) + (error.where.empty() ? "" : ", " + error.where);
        return error;
    }

    const MeasurePlan& plan_;
    const KeptParts& kept_;
    std::uint64_t seed_;
    std::optional<Setting> setting_{};
};

struct Task {
    std::size_t seed = 0;  ///< after the first
    const Part* part = nullptr;
};

/// Those that render nothing for more seeds than the others.
std::vector<Task> tasks_of(const MeasurePlan& plan, const std::vector<Part>& parts) {
    std::vector<Task> tasks;
    const int all = std::max(plan.seeds, plan.marker_seeds);
    for (int seed = 0; seed < all; ++seed) {
        for (const Part& part : parts) {
            if (seed < plan.seeds || !part.images) {
                tasks.push_back({static_cast<std::size_t>(seed), &part});
            }
        }
    }
    return tasks;
}

}  // namespace

Result<TrackingFigures> measure_tracking(const MeasurePlan& plan, const MeasureProgress& progress) {
    if (const Status status = check_plan(plan); !status) {
        return status.error();
    }
    KeptParts kept;
    if (!plan.keep.empty()) {
        Result<KeptParts> opened = KeptParts::open(plan.keep);
        if (!opened) {
            return opened.error();
        }
        kept = std::move(opened).value();
    }
    const std::vector<Part> parts = measured_parts(plan);
    const std::vector<Task> tasks = tasks_of(plan, parts);
    std::vector<SeedNumbers> seeds;
    std::optional<SeedMeasurement> measurement;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        const std::uint64_t seed = plan.first_seed + tasks[i].seed;
        if (tasks[i].seed == seeds.size()) {
            seeds.push_back({seed, {}});
            measurement.emplace(plan, kept, seed);
        }
        progress(static_cast<double>(i) / static_cast<double>(tasks.size()),
                 "seed " + std::to_string(seed) + ": " + tasks[i].part->name);
        const Result<Numbers> numbers = measurement->part(*tasks[i].part);
        if (!numbers) {
            return numbers.error();
        }
        append(numbers.value(), seeds.back().numbers);
    }
    TrackingFigures figures = figures_from(seeds);
    figures.first_seed = plan.first_seed;
    figures.seeds = plan.seeds;
    figures.marker_seeds = static_cast<int>(seeds.size());
    return figures;
}

}  // namespace rhexis::tracking
