// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pupil_changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rhexis {

namespace {

constexpr float seen_depth = 2e-3F;  ///< change of optical depth that shows: of light, two in a thousand
constexpr double softened_mm = 0.4;  ///< as far as what is beside a change may look another way

constexpr double largest_outline = 1.85;  ///< of a crumb, that the shader draws: times its radius

/// Of a row, whether something differs by what is seen.
bool differs(const float* a, const float* b, int count) {
    float most = 0.0F;
    for (int i = 0; i < count; ++i) {
        most = std::max(most, std::abs(a[i] - b[i]));
    }
    return !(most <= seen_depth);
}

}  // namespace

PupilChanges::PupilChanges(int width, int height) : width_(width), changed_(width, height), crumbs_(width, height) {}

const TileMask& PupilChanges::find(const DepthRaster& raster, const Frame& frame, const View& view,
                                   const PixelRect& area, std::vector<unsigned char>& parameters) {
    changed_.clear();
    if (parameters != parameters_ || painted_.size() != raster.sum().size()) {
        changed_.mark(area);
        painted_ = raster.sum();
        parameters_.swap(parameters);
    } else {
        mark_depths(raster, area);
        changed_.grow(softened_mm / pixel_mm(view, Vec3::Zero()));
    }
    mark_crumbs(frame, view);
    return changed_;
}

/// Tile by tile; what is marked counts as painted with the depths of now.
void PupilChanges::mark_depths(const DepthRaster& raster, const PixelRect& area) {
    const std::vector<float>& sum = raster.sum();
    const int channels = raster.channels();
    for (int top = area.y; top < area.y + area.height; top += band_rows) {
        const int rows = std::min(band_rows, area.y + area.height - top);
        for (int left = area.x; left < area.x + area.width; left += band_rows) {
            const int columns = std::min(band_rows, area.x + area.width - left);
            bool changed = false;
            for (int row = 0; row < rows && !changed; ++row) {
                const std::size_t at = channels * (static_cast<std::size_t>(top + row) * width_ + left);
                changed = differs(&sum[at], &painted_[at], channels * columns);
            }
            if (!changed) {
                continue;
            }
            changed_.mark({left, top, columns, rows});
            for (int row = 0; row < rows; ++row) {
                const std::size_t at = channels * (static_cast<std::size_t>(top + row) * width_ + left);
                std::copy_n(&sum[at], channels * columns, &painted_[at]);
            }
        }
    }
}

void PupilChanges::mark_crumbs(const Frame& frame, const View& view) {
    changed_.mark(crumbs_.rects());
    crumbs_.clear();
    for (const Debris& crumb : frame.debris) {
        const Vec3 half = Vec3::Constant(largest_outline * radius_of(crumb));
        const std::array<Vec3, 4> ends{crumb.position - half, crumb.position + half,
                                       crumb.position + Vec3(half.x(), -half.y(), half.z()),
                                       crumb.position + Vec3(-half.x(), half.y(), -half.z())};
        crumbs_.mark(rect_around(view, ends, 4));
    }
    changed_.mark(crumbs_.rects());
}

}  // namespace rhexis
