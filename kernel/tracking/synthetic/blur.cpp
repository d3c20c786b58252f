// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/synthetic/blur.hpp"

#include <cmath>
#include <cstddef>

namespace rhexis::tracking::synthetic {
namespace {

std::vector<float> bell(double sigma) {
    std::vector<float> weights;
    double sum = 0.0;
    const int reach = static_cast<int>(std::ceil(blur_reach * sigma));
    for (int i = -reach; i <= reach; ++i) {
        const double weight = std::exp(-0.5 * i * i / (sigma * sigma));
        weights.push_back(static_cast<float>(weight));
        sum += weight;
    }
    for (float& weight : weights) {
        weight = static_cast<float>(weight / sum);
    }
    return weights;
}

/// Along one line of `count` values that are `stride` apart; nothing is beyond its ends.
void blur_line(float* values, int count, std::size_t stride, const std::vector<float>& weights,
               std::vector<float>& line) {
    const int reach = static_cast<int>(weights.size()) / 2;
    line.assign(static_cast<std::size_t>(count + 2 * reach), 0.0F);
    for (int i = 0; i < count; ++i) {
        line[static_cast<std::size_t>(i + reach)] = values[static_cast<std::size_t>(i) * stride];
    }
    for (int i = 0; i < count; ++i) {
        float sum = 0.0F;
        for (std::size_t j = 0; j < weights.size(); ++j) {
            sum += weights[j] * line[static_cast<std::size_t>(i) + j];
        }
        values[static_cast<std::size_t>(i) * stride] = sum;
    }
}

}  // namespace

void blur(std::vector<float>& values, int width, int height, double sigma, std::vector<float>& line) {
    const std::vector<float> weights = bell(sigma);
    const auto stride = static_cast<std::size_t>(width);
    for (int y = 0; y < height; ++y) {
        blur_line(values.data() + static_cast<std::size_t>(y) * stride, width, 1, weights, line);
    }
    for (int x = 0; x < width; ++x) {
        blur_line(values.data() + x, height, stride, weights, line);
    }
}

}  // namespace rhexis::tracking::synthetic
