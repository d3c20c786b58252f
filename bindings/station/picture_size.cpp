// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/picture_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rhexis::station {
namespace {

constexpr std::array shares = {1.0, 0.85, 0.7, 0.6, 0.5, 0.42, 0.35};
constexpr double longest_s = 1.0 / 15.0;  ///< a picture may take: beyond, they are drawn smaller
constexpr double spare = 0.75;            ///< of that, what a larger one may be expected to take
constexpr std::size_t looked_at = 24;     ///< pictures, before that is decided,
constexpr double looked_at_s = 1.5;       ///< or as many as there are in so long, but so many:
constexpr std::size_t least_looked_at = 9;
constexpr int most_patience = 512;

double share_of(int size) { return shares[static_cast<std::size_t>(size)]; }

}  // namespace

double PictureSize::share() const { return share_of(size_); }

void PictureSize::begin_anew() {
    took_s_.clear();
    sum_s_ = 0.0;
    first_look_ = true;
}

void PictureSize::count(double took_s) {
    took_s_.push_back(took_s);
    sum_s_ += took_s;
    if (took_s_.size() < least_looked_at || (took_s_.size() < looked_at && sum_s_ < looked_at_s)) {
        return;
    }
    // The median: what a driver builds when something shows for the first time takes seconds once.
    const auto middle = took_s_.begin() + static_cast<std::ptrdiff_t>(took_s_.size() / 2);
    std::nth_element(took_s_.begin(), middle, took_s_.end());
    const double usual_s = *middle;
    took_s_.clear();
    sum_s_ = 0.0;
    if (!first_look_) {
        decide(usual_s);
    }
    first_look_ = false;
}

/// Pixels cost the time: it goes with the square of the share.
void PictureSize::decide(double usual_s) {
    const int last = static_cast<int>(shares.size()) - 1;
    if (usual_s > longest_s) {
        const double wanted = share() * std::sqrt(longest_s / usual_s);
        while (size_ < last && share() > wanted) {
            ++size_;
        }
        if (has_grown_) {
            patience_ = std::min(2 * patience_, most_patience);
        }
        has_grown_ = false;
        easy_looks_ = 0;
    } else if (size_ > 0 && usual_s * std::pow(share_of(size_ - 1) / share(), 2.0) < spare * longest_s) {
        if (++easy_looks_ >= patience_) {
            --size_;
            has_grown_ = true;
            easy_looks_ = 0;
        }
    } else {
        easy_looks_ = 0;
    }
}

}  // namespace rhexis::station
