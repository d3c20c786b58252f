// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/fitted_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rhexis::station {
namespace {

constexpr double settled_s = 0.25;
constexpr int least_pixels = 16;

int pixels(int of, double share) { return std::max(least_pixels, static_cast<int>(std::lround(share * of))); }

}  // namespace

Result<FittedRenderer> FittedRenderer::create(int width, int height, double share) {
    Result<Renderer> renderer = Renderer::create_in_window(pixels(width, share), pixels(height, share));
    if (!renderer) {
        return renderer.error();
    }
    return FittedRenderer(std::move(renderer).value(), Size{width, height}, share);
}

FittedRenderer::FittedRenderer(Renderer renderer, Size area, double share)
    : renderer_(std::make_unique<Renderer>(std::move(renderer))),
      area_(area),
      share_(share),
      tried_(area),
      asked_(area) {}

bool FittedRenderer::fit(int width, int height, double share, double now_s) {
    const Size asked{width, height};
    if (asked != asked_) {
        asked_ = asked;
        since_s_ = now_s;
    }
    const bool settled = asked_ != tried_ && now_s - since_s_ >= settled_s;
    if (!settled && share == share_) {
        return false;
    }
    tried_ = settled ? asked_ : tried_;
    share_ = share;
    Result<Renderer> renderer = Renderer::create_in_window(pixels(tried_.width, share), pixels(tried_.height, share));
    if (!renderer) {
        return false;
    }
    area_ = tried_;
    renderer_ = std::make_unique<Renderer>(std::move(renderer).value());
    return true;
}

void FittedRenderer::show(const Frame& frame, const Camera& camera, const ScreenArea& area, Stereo stereo) {
    const int eyes = stereo == Stereo::side_by_side ? 2 : 1;
    const double scale = std::min(static_cast<double>(area.width) / (eyes * area_.width),
                                  static_cast<double>(area.height) / area_.height);
    ScreenArea fitted;
    fitted.width = static_cast<int>(std::lround(scale * eyes * area_.width));
    fitted.height = static_cast<int>(std::lround(scale * area_.height));
    fitted.left = area.left + (area.width - fitted.width) / 2;
    fitted.bottom = area.bottom + (area.height - fitted.height) / 2;
    renderer_->show(frame, camera, fitted, stereo);
}

}  // namespace rhexis::station
