// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/spots/spot_finder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rhexis::tracking {
namespace {

constexpr int block = 32;  ///< pixels that are looked at together, nearly all of them dark

bool any_bright(const std::uint8_t* pixels, std::uint8_t threshold) {
    std::uint8_t brightest = 0;
    for (int i = 0; i < block; ++i) {
        brightest = std::max(brightest, pixels[i]);
    }
    return brightest >= threshold;
}

/// First pixel from `x` on that is bright; `width`: none.
int next_bright(const std::uint8_t* line, int x, int width, std::uint8_t threshold) {
    while (x < width) {
        if (x + block <= width && !any_bright(line + x, threshold)) {
            x += block;
            continue;
        }
        const int until = std::min(x + block, width);
        for (; x < until; ++x) {
            if (line[x] >= threshold) {
                return x;
            }
        }
    }
    return width;
}

using Window = SpotWindow;

Window grown(int left, int right, int top, int bottom, int by, const GreyImage& image) {
    return {std::max(left - by, 0), std::min(right + by, image.width), std::max(top - by, 0),
            std::min(bottom + by, image.height)};
}

/// Mean light on the ring between two windows, without what is bright itself.
double light_around(const GreyImage& image, const Window& inner, const Window& outer, int threshold) {
    double sum = 0.0;
    int count = 0;
    for (int y = outer.top; y < outer.bottom; ++y) {
        const std::uint8_t* line = image.pixels + static_cast<std::ptrdiff_t>(y) * image.stride;
        const bool within = y >= inner.top && y < inner.bottom;
        for (int x = outer.left; x < outer.right; ++x) {
            if (within && x == inner.left) {
                x = inner.right;
                if (x >= outer.right) {
                    break;
                }
            }
            if (line[x] < threshold) {
                sum += line[x];
                ++count;
            }
        }
    }
    return count > 0 ? sum / count : 0.0;
}

/// What a region's pixels are measured by.
struct Brightness {
    double none = 0.0;  ///< light up to which a pixel weighs nothing
    double full = 1.0;  ///< from which on it weighs 1
    double peak = 0.0;
    int clipped = 0;
};

/// The brightness that a tenth of its bright pixels reach: one glaring pixel does not count.
Brightness brightness_of(const GreyImage& image, const Window& window, double around, const SpotSettings& settings) {
    std::array<int, 256> counts{};
    int bright = 0;
    for (int y = window.top; y < window.bottom; ++y) {
        const std::uint8_t* line = image.pixels + static_cast<std::ptrdiff_t>(y) * image.stride;
        for (int x = window.left; x < window.right; ++x) {
            if (line[x] >= settings.threshold) {
                ++counts[line[x]];
                ++bright;
            }
        }
    }
    Brightness result;
    result.clipped = counts[255];
    int above = 0;
    int high = 255;
    while (high > settings.threshold && above + counts[static_cast<std::size_t>(high)] <= bright / 10) {
        above += counts[static_cast<std::size_t>(high)];
        --high;
    }
    for (int light = 255; light > 0 && result.peak == 0.0; --light) {
        result.peak = counts[static_cast<std::size_t>(light)] > 0 ? light : 0.0;
    }
    result.none = around + settings.low * (high - around);
    result.full = std::max(around + settings.high * (high - around), result.none + 1.0);
    return result;
}

/// Weight, centre and spread of a window.
struct Moments {
    double weight = 0.0;
    Vec2 centre = Vec2::Zero();
    double xx = 0.0;
    double yy = 0.0;
    double xy = 0.0;
};

Moments moments_of(const GreyImage& image, const Window& window, const Brightness& brightness,
                   const SpotSettings& settings) {
    Moments result;
    const int middle_x = (window.left + window.right) / 2;
    const int middle_y = (window.top + window.bottom) / 2;
    std::array<double, 256> weights{};
    for (std::size_t light = 0; light < weights.size(); ++light) {
        weights[light] =
            std::clamp((static_cast<double>(light) - brightness.none) / (brightness.full - brightness.none),
                       settings.low > 0.0 ? 0.0 : -1.0, 1.0);
    }
    double sx = 0.0;
    double sy = 0.0;
    for (int y = window.top; y < window.bottom; ++y) {
        const std::uint8_t* line = image.pixels + static_cast<std::ptrdiff_t>(y) * image.stride;
        const double dy = y - middle_y;
        double row = 0.0;
        double row_x = 0.0;
        double row_xx = 0.0;
        for (int x = window.left; x < window.right; ++x) {
            const double weight = weights[line[x]];
            const double dx = x - middle_x;
            row += weight;
            row_x += weight * dx;
            row_xx += weight * dx * dx;
        }
        result.weight += row;
        sx += row_x;
        sy += row * dy;
        result.xx += row_xx;
        result.xy += row_x * dy;
        result.yy += row * dy * dy;
    }
    const Vec2 mean{sx / result.weight, sy / result.weight};
    result.xx = result.xx / result.weight - mean.x() * mean.x();
    result.yy = result.yy / result.weight - mean.y() * mean.y();
    result.xy = result.xy / result.weight - mean.x() * mean.y();
    result.centre = {mean.x() + middle_x, mean.y() + middle_y};
    return result;
}

double roundness_of(const Moments& moments) {
    const double mean = 0.5 * (moments.xx + moments.yy);
    const double apart = std::hypot(0.5 * (moments.xx - moments.yy), moments.xy);
    return mean + apart > 0.0 ? std::sqrt(std::max(mean - apart, 0.0) / (mean + apart)) : 0.0;
}

}  // namespace

int SpotFinder::root_of(int run) {
    while (runs_[static_cast<std::size_t>(run)].parent != run) {
        int& parent = runs_[static_cast<std::size_t>(run)].parent;
        parent = runs_[static_cast<std::size_t>(parent)].parent;
        run = parent;
    }
    return run;
}

/// above: first run of the line before that may still touch it.
void SpotFinder::add_run(int line, int begin, int end, std::size_t& above, std::size_t above_end) {
    const int self = static_cast<int>(runs_.size());
    runs_.push_back({line, begin, end, self});
    while (above < above_end && runs_[above].end < begin) {
        ++above;
    }
    for (std::size_t i = above; i < above_end && runs_[i].begin <= end; ++i) {
        const int theirs = root_of(static_cast<int>(i));
        const int ours = root_of(self);
        // The earlier run stands for both: regions stay in the order of their first line.
        runs_[static_cast<std::size_t>(std::max(theirs, ours))].parent = std::min(theirs, ours);
    }
}

void SpotFinder::scan(const GreyImage& image) {
    runs_.clear();
    const auto threshold = static_cast<std::uint8_t>(settings_.threshold);
    std::size_t above = 0;
    std::size_t above_end = 0;
    for (int y = 0; y < image.height; ++y) {
        const std::uint8_t* line = image.pixels + static_cast<std::ptrdiff_t>(y) * image.stride;
        const std::size_t first = runs_.size();
        const bool follows = above_end > above && runs_[above_end - 1].line == y - 1;
        std::size_t touching = follows ? above : above_end;
        for (int x = next_bright(line, 0, image.width, threshold); x < image.width;
             x = next_bright(line, x, image.width, threshold)) {
            const int begin = x;
            while (x < image.width && line[x] >= threshold) {
                ++x;
            }
            add_run(y, begin, x, touching, above_end);
        }
        above = first;
        above_end = runs_.size();
    }
}

void SpotFinder::gather() {
    regions_.clear();
    region_of_.assign(runs_.size(), -1);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const Run& run = runs_[i];
        int& region = region_of_[static_cast<std::size_t>(root_of(static_cast<int>(i)))];
        if (region < 0) {
            region = static_cast<int>(regions_.size());
            regions_.push_back({run.begin, run.end, run.line, run.line + 1, 0});
        }
        Region& whole = regions_[static_cast<std::size_t>(region)];
        whole.left = std::min(whole.left, run.begin);
        whole.right = std::max(whole.right, run.end);
        whole.bottom = run.line + 1;
        whole.pixels += run.end - run.begin;
    }
}

void SpotFinder::find_crowded() {
    std::erase_if(regions_, [this](const Region& region) {
        return region.pixels < settings_.least_area || region.pixels > settings_.most_area;
    });
    const int apart = 2 * settings_.margin;
    for (std::size_t i = 0; i < regions_.size(); ++i) {
        for (std::size_t j = i + 1; j < regions_.size(); ++j) {
            Region& one = regions_[i];
            Region& other = regions_[j];
            if (one.left < other.right + apart && other.left < one.right + apart && one.top < other.bottom + apart &&
                other.top < one.bottom + apart) {
                one.crowded = true;
                other.crowded = true;
            }
        }
    }
}

Spot SpotFinder::measure(const GreyImage& image, const Region& region) const {
    const int margin = region.crowded ? 1 : settings_.margin;
    const Window inner = grown(region.left, region.right, region.top, region.bottom, margin, image);
    const Window outer = grown(region.left, region.right, region.top, region.bottom, 2 * settings_.margin, image);
    const double around = light_around(image, inner, outer, settings_.threshold);
    const Brightness brightness = brightness_of(image, inner, around, settings_);
    const Moments moments = moments_of(image, inner, brightness, settings_);
    Spot spot;
    spot.at = moments.centre;
    spot.area = moments.weight;
    spot.roundness = roundness_of(moments);
    spot.peak = brightness.peak;
    spot.clipped = brightness.clipped > 3;
    spot.at_rim = region.left == 0 || region.top == 0 || region.right == image.width || region.bottom == image.height;
    spot.crowded = region.crowded;
    if (settings_.outlines) {
        take_outline(image, inner, around, brightness.peak - around, spot);
    }
    return spot;
}

void SpotFinder::take_outline(const GreyImage& image, const SpotWindow& window, double around, double bright,
                              Spot& spot) const {
    constexpr double whole_rim = 0.7;
    const double radius = std::sqrt(spot.area / std::numbers::pi);
    const std::optional<FittedOutline> outline = fit_outline(image, spot.at, radius, bright, settings_.outline);
    if (outline) {
        spot.at = outline->centre;
        spot.area = std::numbers::pi * (outline->radius - outline->stretch) * (outline->radius + outline->stretch);
        spot.roundness = (outline->radius - outline->stretch) / (outline->radius + outline->stretch);
        spot.sigma_px = outline->sigma_px;
        spot.whole = outline->share;
        if (outline->radius < settings_.small_radius && outline->share > whole_rim) {
            take_light(image, window, around, spot);
        }
    }
}

/// Few pixels tell a small rim; of a whole one the light tells more, unless it is worn or something shines into it.
void SpotFinder::take_light(const GreyImage& image, const SpotWindow& window, double around, Spot& spot) const {
    constexpr double near_px = 0.2;
    SpotSettings by_light = settings_;
    by_light.low = 0.1;
    by_light.high = 1.0;
    const Moments moments = moments_of(image, window, brightness_of(image, window, around, by_light), by_light);
    if ((moments.centre - spot.at).norm() < near_px) {
        spot.at = moments.centre;
    }
}

const FoundSpots& SpotFinder::find(const GreyImage& image) {
    scan(image);
    gather();
    find_crowded();
    found_.spots.clear();
    found_.too_many = regions_.size() > static_cast<std::size_t>(settings_.most_spots);
    for (const Region& region : regions_) {
        if (static_cast<int>(found_.spots.size()) == settings_.most_spots) {
            break;
        }
        found_.spots.push_back(measure(image, region));
    }
    return found_;
}

}  // namespace rhexis::tracking
