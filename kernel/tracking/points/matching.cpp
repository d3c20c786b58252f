// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/points/matching.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis::tracking {
namespace {

/// What of an exposure is free, with the rays that lines of sight are tested by.
struct Sight {
    const Camera* camera = nullptr;
    const CameraSpots* exposure = nullptr;
    std::vector<int> spots{};
    std::vector<Ray> rays{};
};

std::vector<Sight> sights_of(std::span<const Camera> cameras, std::span<const CameraSpots> exposures,
                             const std::vector<std::vector<bool>>& taken) {
    std::vector<Sight> sights;
    for (std::size_t i = 0; i < exposures.size(); ++i) {
        Sight sight;
        sight.camera = &cameras[static_cast<std::size_t>(exposures[i].camera)];
        sight.exposure = &exposures[i];
        for (std::size_t j = 0; j < exposures[i].spots.size(); ++j) {
            if (!taken[i][j]) {
                sight.spots.push_back(static_cast<int>(j));
                sight.rays.push_back(ray_of(*sight.camera, exposures[i].spots[j].at));
            }
        }
        sights.push_back(std::move(sight));
    }
    return sights;
}

/// Where two rays pass each other at their nearest; none: parallel, or behind a camera.
struct Passing {
    Vec3 middle;
    double apart_mm;
    double depth_mm;  ///< from the nearer camera
};
std::optional<Passing> passing(const Ray& one, const Ray& other) {
    const double together = one.along.dot(other.along);
    const double across = 1.0 - together * together;
    if (across < 1e-4) {
        return std::nullopt;
    }
    const Vec3 between = other.from - one.from;
    const double first = (between.dot(one.along) - together * between.dot(other.along)) / across;
    const double second = (together * between.dot(one.along) - between.dot(other.along)) / across;
    if (first <= 0.0 || second <= 0.0) {
        return std::nullopt;
    }
    const Vec3 a = one.from + first * one.along;
    const Vec3 b = other.from + second * other.along;
    return Passing{0.5 * (a + b), (a - b).norm(), std::min(first, second)};
}

View view_of(const Sight& sight, std::size_t spot) {
    const int index = sight.spots[spot];
    return {sight.exposure->camera, index, sight.exposure->spots[static_cast<std::size_t>(index)].at};
}

/// Its nearest free spot in a third camera.
std::optional<View> seen_by(const Sight& sight, const Vec3& point, double tolerance_px) {
    const std::optional<Vec2> image = project(*sight.camera, point);
    if (!image) {
        return std::nullopt;
    }
    std::optional<View> nearest;
    double least = tolerance_px;
    for (std::size_t i = 0; i < sight.spots.size(); ++i) {
        const View view = view_of(sight, i);
        if (const double off = (view.at - *image).norm(); off < least) {
            least = off;
            nearest = view;
        }
    }
    return nearest;
}

/// Grown from a pair: the point that all cameras which see it agree on; none: too few do.
std::optional<MatchedPoint> grown(std::span<const Camera> cameras, const std::vector<Sight>& sights, const View& one,
                                  const View& other, const Vec3& middle, const MatchingSettings& settings) {
    MatchedPoint result;
    result.views = {one, other};
    Vec3 point = middle;
    for (const Sight& sight : sights) {
        const int camera = sight.exposure->camera;
        if (camera == one.camera || camera == other.camera) {
            continue;
        }
        // Two rays at a small angle leave the point uncertain along them; each camera more makes it surer.
        if (const std::optional<View> view = seen_by(sight, point, 3.0 * settings.tolerance_px)) {
            result.views.push_back(*view);
            const std::optional<Triangulated> with = triangulate(cameras, result.views);
            if (!with || with->residual_px > settings.tolerance_px) {
                result.views.pop_back();
            } else {
                point = with->point;
                result.residual_px = with->residual_px;
            }
        }
    }
    result.point = point;
    if (static_cast<int>(result.views.size()) < settings.least_views) {
        return std::nullopt;
    }
    if (result.views.size() == 2) {
        const std::optional<Triangulated> both = triangulate(cameras, result.views);
        if (!both || both->residual_px > settings.tolerance_px) {
            return std::nullopt;
        }
        result.point = both->point;
        result.residual_px = both->residual_px;
    }
    return result;
}

void add_pairs(std::span<const Camera> cameras, const std::vector<Sight>& sights, const Sight& first,
               const Sight& second, const MatchingSettings& settings, std::vector<MatchedPoint>& all) {
    for (std::size_t i = 0; i < first.rays.size(); ++i) {
        for (std::size_t j = 0; j < second.rays.size(); ++j) {
            const std::optional<Passing> near = passing(first.rays[i], second.rays[j]);
            if (!near || near->middle.norm() > settings.farthest_mm ||
                near->apart_mm * first.camera->lens.fx > 2.0 * settings.tolerance_px * near->depth_mm) {
                continue;
            }
            if (std::optional<MatchedPoint> point =
                    grown(cameras, sights, view_of(first, i), view_of(second, j), near->middle, settings)) {
                all.push_back(std::move(*point));
            }
        }
    }
}

}  // namespace

std::vector<MatchedPoint> match_spots(std::span<const Camera> cameras, std::span<const CameraSpots> exposures,
                                      const std::vector<std::vector<bool>>& taken, const MatchingSettings& settings) {
    const std::vector<Sight> sights = sights_of(cameras, exposures, taken);
    std::vector<MatchedPoint> candidates;
    for (std::size_t i = 0; i < sights.size(); ++i) {
        for (std::size_t j = i + 1; j < sights.size(); ++j) {
            add_pairs(cameras, sights, sights[i], sights[j], settings, candidates);
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const MatchedPoint& a, const MatchedPoint& b) {
        return a.views.size() != b.views.size() ? a.views.size() > b.views.size() : a.residual_px < b.residual_px;
    });
    std::vector<std::vector<bool>> used(cameras.size());
    for (const CameraSpots& exposure : exposures) {
        used[static_cast<std::size_t>(exposure.camera)].assign(exposure.spots.size(), false);
    }
    std::vector<MatchedPoint> chosen;
    for (MatchedPoint& candidate : candidates) {
        const bool free = std::none_of(candidate.views.begin(), candidate.views.end(), [&used](const View& view) {
            return used[static_cast<std::size_t>(view.camera)][static_cast<std::size_t>(view.spot)];
        });
        if (free) {
            for (const View& view : candidate.views) {
                used[static_cast<std::size_t>(view.camera)][static_cast<std::size_t>(view.spot)] = true;
            }
            chosen.push_back(std::move(candidate));
        }
    }
    return chosen;
}

}  // namespace rhexis::tracking
