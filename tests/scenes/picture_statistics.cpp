// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/picture_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rhexis::testing {
namespace {

constexpr int across = 176;

using Pixel = std::array<double, 3>;

struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Pixel> pixels;
};

/// Each pixel the mean of what it covers.
Picture averaged_down(const Image& image) {
    const double scale = std::max(1.0, static_cast<double>(image.width) / across);
    Picture small{static_cast<int>(image.width / scale), static_cast<int>(image.height / scale), {}};
    for (int y = 0; y < small.height; ++y) {
        const int top = static_cast<int>(y * scale);
        const int bottom = std::min(image.height, std::max(top + 1, static_cast<int>((y + 1) * scale)));
        for (int x = 0; x < small.width; ++x) {
            const int left = static_cast<int>(x * scale);
            const int right = std::min(image.width, std::max(left + 1, static_cast<int>((x + 1) * scale)));
            Pixel sum{};
            for (int row = top; row < bottom; ++row) {
                for (int column = left; column < right; ++column) {
                    for (std::size_t c = 0; c < 3; ++c) {
                        sum[c] += image.rgb[3 * (static_cast<std::size_t>(row) * image.width + column) + c];
                    }
                }
            }
            const int count = (bottom - top) * (right - left);
            // whole numbers, as a picture of that size has
            small.pixels.push_back(
                {std::floor(sum[0] / count), std::floor(sum[1] / count), std::floor(sum[2] / count)});
        }
    }
    return small;
}

double luma(const Pixel& pixel) { return 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]; }

double linear(double value) {
    value /= 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

struct Spread {
    double mean = 0.0;
    double sd = 0.0;
};

Spread spread_of(const std::vector<double>& values) {
    Spread found;
    const double n = static_cast<double>(values.size());
    for (const double value : values) {
        found.mean += value / n;
    }
    for (const double value : values) {
        found.sd += (value - found.mean) * (value - found.mean) / n;
    }
    found.sd = std::sqrt(found.sd);
    return found;
}

/// Change of luma from a pixel to those at its right and below, in the mean.
double gradient_of(const Picture& picture, const std::vector<double>& lumas) {
    double sum = 0.0;
    const auto at = [&](int x, int y) { return lumas[static_cast<std::size_t>(y) * picture.width + x]; };
    for (int y = 0; y + 1 < picture.height; ++y) {
        for (int x = 0; x + 1 < picture.width; ++x) {
            sum += std::hypot(at(x + 1, y) - at(x, y), at(x, y + 1) - at(x, y));
        }
    }
    return sum / std::max(1, (picture.width - 1) * (picture.height - 1));
}

double saturation_of(const Picture& picture) {
    double sum = 0.0;
    for (const Pixel& pixel : picture.pixels) {
        const auto [least, most] = std::minmax_element(pixel.begin(), pixel.end());
        sum += *most > 0.0 ? (*most - *least) / *most : 0.0;
    }
    return sum / static_cast<double>(picture.pixels.size());
}

}  // namespace

Statistics statistics_of(const Image& image) {
    const Picture picture = averaged_down(image);
    const double n = static_cast<double>(picture.pixels.size());
    std::vector<double> lumas;
    std::vector<double> light;
    Pixel sum{};
    for (const Pixel& pixel : picture.pixels) {
        lumas.push_back(luma(pixel));
        light.push_back(luma({linear(pixel[0]), linear(pixel[1]), linear(pixel[2])}));
        for (std::size_t c = 0; c < 3; ++c) {
            sum[c] += pixel[c];
        }
    }
    const Spread shown = spread_of(lumas);
    const Spread lit = spread_of(light);
    const double gradient = gradient_of(picture, lumas);
    std::sort(lumas.begin(), lumas.end());
    const auto at_share = [&](double share) {
        return lumas[std::min(lumas.size() - 1, static_cast<std::size_t>(share * n))];
    };
    const auto share = [&](auto&& is) {
        return static_cast<double>(std::count_if(lumas.begin(), lumas.end(), is)) / n;
    };
    return {at_share(0.5),
            shown.mean,
            shown.sd,
            at_share(0.05),
            at_share(0.95),
            share([](double v) { return v < 25.0; }),
            share([](double v) { return v > 245.0; }),
            lit.sd / lit.mean,
            gradient,
            sum[0] / sum[1],
            sum[2] / sum[1],
            saturation_of(picture)};
}

int count_within(const Statistics& values) {
    int count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        count += values[i] >= wanted_statistics[i].least && values[i] <= wanted_statistics[i].most ? 1 : 0;
    }
    return count;
}

std::string outside_of(const Statistics& values) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Statistic& one = wanted_statistics[i];
        if (values[i] < one.least || values[i] > one.most) {
            char line[120];
            std::snprintf(line, sizeof line, "%s%s %.3g (wanted %g to %g)", text.empty() ? "" : ", ", one.name,
                          values[i], one.least, one.most);
            text += line;
        }
    }
    return text;
}

Image part_of(const Image& image, int left, int top, int width, int height) {
    Image part{width, height, {}};
    for (int y = top; y < top + height; ++y) {
        const auto from = image.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * image.width + left);
        part.rgb.insert(part.rgb.end(), from, from + 3 * static_cast<std::ptrdiff_t>(width));
    }
    return part;
}

Image square_of_field(const Image& image) {
    const int side = std::min(image.width, static_cast<int>(image.height / std::sqrt(2.0)));
    return part_of(image, (image.width - side) / 2, (image.height - side) / 2, side, side);
}

}  // namespace rhexis::testing
