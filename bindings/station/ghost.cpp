// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/ghost.hpp"

#include <algorithm>

#include "flow/microscope.hpp"
#include "session/recording.hpp"
#include "trial/places.hpp"

namespace rhexis::station {
namespace {

constexpr double spacing_s = 0.05;  ///< between two places of the way

std::vector<std::string> for_hands(std::vector<std::string> instruments) {
    std::erase(instruments, microscope_name);
    return instruments;
}

}  // namespace

Result<Ghost> Ghost::read(const std::string& path, const std::vector<std::string>& instruments) {
    const Result<Recording> recording = read_recording(recording_path(path));
    if (!recording) {
        return recording.error();
    }
    const SceneDescription& scene = recording.value().header.scene;
    if (for_hands(scene.instruments) != for_hands(instruments)) {
        return Error{"this is the way of other instruments", path, "a run of the same exercise"};
    }
    Ghost ghost;
    ghost.step_s_ = scene.step_s;
    ghost.ways_.resize(scene.instruments.size());
    for (const RecordedStep& step : recording.value().steps) {
        for (const DeviceSample& sample : step.samples) {
            if (sample.present && sample.instrument >= 0 && sample.instrument < static_cast<int>(ghost.ways_.size())) {
                ghost.ways_[static_cast<std::size_t>(sample.instrument)].push_back(sample.pose.position);
            }
        }
    }
    return ghost;
}

std::vector<Vec3> Ghost::ahead(int instrument, const Vec3& tip, double seconds) const {
    if (instrument < 0 || instrument >= static_cast<int>(ways_.size())) {
        return {};
    }
    const std::vector<Vec3>& way = ways_[static_cast<std::size_t>(instrument)];
    const auto nearer = [&tip](const Vec3& a, const Vec3& b) {
        return (a - tip).squaredNorm() < (b - tip).squaredNorm();
    };
    auto at = std::min_element(way.begin(), way.end(), nearer);
    const auto stride = std::max<std::ptrdiff_t>(1, static_cast<std::ptrdiff_t>(spacing_s / step_s_));
    const auto steps = static_cast<std::ptrdiff_t>(seconds / step_s_);
    std::vector<Vec3> list;
    for (std::ptrdiff_t i = 0; i < steps && at < way.end(); i += stride) {
        list.push_back(*at);
        at += std::min(stride, way.end() - at);
    }
    return list;
}

}  // namespace rhexis::station
