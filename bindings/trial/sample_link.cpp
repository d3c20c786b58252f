// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/sample_link.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/rng.hpp"
#include "flow/microscope.hpp"

namespace rhexis {
namespace {

Vec3 direction_from(Rng& rng) {
    const double height = 2.0 * rng.uniform() - 1.0;
    const double angle = 2.0 * M_PI * rng.uniform();
    const double across = std::sqrt(std::max(0.0, 1.0 - height * height));
    return {across * std::cos(angle), across * std::sin(angle), height};
}

}  // namespace

void LinkTally::add(std::span<const DeviceSample> hands, std::span<const DeviceSample> seen,
                    const std::vector<bool>& tracked) {
    figures_.steps += 1;
    for (std::size_t i = 0; i < hands.size(); ++i) {
        if (!tracked[i] || !hands[i].present) {
            continue;
        }
        figures_.present += 1;
        if (!seen[i].present) {
            figures_.unseen += 1;
            continue;
        }
        const double off = (hands[i].pose.position - seen[i].pose.position).norm();
        squares_ += off * off;
        figures_.farthest_mm = std::max(figures_.farthest_mm, off);
    }
}

LinkFigures LinkTally::figures(std::string name) const {
    LinkFigures all = figures_;
    all.name = std::move(name);
    const std::int64_t compared = all.present - all.unseen;
    all.rms_mm = compared > 0 ? std::sqrt(squares_ / static_cast<double>(compared)) : 0.0;
    return all;
}

Status MovedSamples::begin(const std::vector<std::string>& instruments, double /*step_s*/) {
    by_.clear();
    moved_.clear();
    for (const std::string& name : instruments) {
        Rng rng(seed_, "moved " + name);
        by_.push_back(distance_mm_ * direction_from(rng));
        moved_.push_back(name != microscope_name);
    }
    return success();
}

Result<std::vector<DeviceSample>> MovedSamples::through(std::span<const DeviceSample> hands) {
    std::vector<DeviceSample> seen(hands.begin(), hands.end());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (moved_[i]) {
            seen[i].pose.position += by_[i];
        }
    }
    tally_.add(hands, seen, moved_);
    return seen;
}

LinkFigures MovedSamples::figures() const {
    return tally_.figures("moved by " + short_number(1e3 * distance_mm_) + " um");
}

Status LinkedOperator::begin(Timeline& timeline) {
    hands_.resize(timeline.scene().instruments.size());
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        hands_[i].instrument = static_cast<int>(i);
    }
    return inner_.begin(timeline);
}

Result<OperatorStep> LinkedOperator::operate(Timeline& timeline) {
    Result<OperatorStep> step = inner_.operate(timeline);
    if (!step || step.value().done) {
        return step;
    }
    for (const DeviceSample& sample : step.value().samples) {
        if (sample.instrument >= 0 && static_cast<std::size_t>(sample.instrument) < hands_.size()) {
            hands_[static_cast<std::size_t>(sample.instrument)] = sample;
        }
    }
    Result<std::vector<DeviceSample>> seen = link_.through(hands_);
    if (!seen) {
        return seen.error();
    }
    step.value().samples = std::move(seen).value();
    return step;
}

}  // namespace rhexis
