// SPDX-License-Identifier: GPL-3.0-or-later
// Where spots come from: out of images, or straight from the synthetic rig's markers.
#pragma once

#include <memory>
#include <vector>

#include "tracking/sources/frame_source.hpp"
#include "tracking/spots/spot_finder.hpp"

namespace rhexis::tracking {

class SpotSource {
public:
    virtual ~SpotSource() = default;
    /// The next exposures, at most one of each camera; false: there are no more. As FrameSource::next() else.
    virtual Result<bool> next(std::vector<CameraSpots>& exposures) = 0;
    [[nodiscard]] virtual double rate_hz() const = 0;
    [[nodiscard]] virtual std::uint64_t lost() const { return 0; }
    /// The images that the last exposures' spots are of, which stay as they are for whoever keeps them; null: there are
    /// none.
    [[nodiscard]] virtual std::shared_ptr<const FrameSet> images() const { return nullptr; }
};

class ImageSpots final : public SpotSource {
public:
    ImageSpots(std::unique_ptr<FrameSource> frames, const SpotSettings& settings)
        : frames_(std::move(frames)), finder_(settings) {}

    Result<bool> next(std::vector<CameraSpots>& exposures) override;
    [[nodiscard]] double rate_hz() const override { return frames_->rate_hz(); }
    [[nodiscard]] std::uint64_t lost() const override { return frames_->lost(); }
    [[nodiscard]] std::shared_ptr<const FrameSet> images() const override { return set_; }

private:
    std::unique_ptr<FrameSource> frames_;
    SpotFinder finder_;
    std::shared_ptr<const FrameSet> set_{};
};

}  // namespace rhexis::tracking
