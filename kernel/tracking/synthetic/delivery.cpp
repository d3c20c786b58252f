// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/delivery.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/numbers.hpp"
#include "base/rng.hpp"

namespace rhexis::tracking::synthetic {
namespace {

Status check_delivery(const Delivery& delivery) {
    constexpr double longest_s = 10.0;
    struct Range {
        const char* name;
        double value;
        double low;
        double high;
    };
    const double period = delivery.rate_hz > 0.0 ? 1.0 / delivery.rate_hz : 0.0;
    const std::array<Range, 8> ranges{{{"rate_hz", delivery.rate_hz, 1.0, 1000.0},
                                       {"exposure_s", delivery.exposure_s, 0.0, period},
                                       {"skew_s", delivery.skew_s, 0.0, period},
                                       {"lost", delivery.lost, 0.0, 1.0},
                                       {"delay_s", delivery.delay_s, 0.0, longest_s},
                                       {"jitter_s", delivery.jitter_s, 0.0, longest_s},
                                       {"late", delivery.late, 0.0, 1.0},
                                       {"late_s", delivery.late_s, 0.0, longest_s}}};
    for (const Range& range : ranges) {
        if (Status status = check_range(range.name, range.value, range.low, range.high, "delivery"); !status) {
            return status;
        }
    }
    return success();
}

}  // namespace

Result<std::vector<Shot>> shots(const SyntheticRig& rig, const Delivery& delivery, int frames, std::uint64_t seed) {
    if (const Status status = check_delivery(delivery); !status) {
        return status.error();
    }
    Rng rng(seed, "delivery");
    std::vector<Shot> all;
    const int count = static_cast<int>(rig.cameras.size());
    for (std::int64_t frame = 0; frame < frames; ++frame) {
        for (int camera = 0; camera < count; ++camera) {
            const double skew = count > 1 ? delivery.skew_s * camera / (count - 1) : 0.0;
            Shot shot;
            shot.camera = camera;
            shot.frame = frame;
            shot.time_s = static_cast<double>(frame) / delivery.rate_hz + skew;
            shot.exposed_s = shot.time_s + rig.cameras[static_cast<std::size_t>(camera)].time_offset_s;
            const double jitter = -delivery.jitter_s * std::log(1.0 - rng.uniform());
            const double late = rng.uniform() < delivery.late ? delivery.late_s : 0.0;
            shot.arrives_s = shot.exposed_s + delivery.delay_s + jitter + late;
            if (rng.uniform() >= delivery.lost) {
                all.push_back(shot);
            }
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const Shot& a, const Shot& b) { return a.arrives_s < b.arrives_s; });
    return all;
}

}  // namespace rhexis::tracking::synthetic
