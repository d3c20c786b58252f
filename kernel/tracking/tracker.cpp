// SPDX-License-Identifier: GPL-3.0-or-later
#include "tracking/tracker.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "math/poses.hpp"
#include "tracking/bodies/identity.hpp"

namespace rhexis::tracking {
namespace {

double middle_time(std::span<const CameraSpots> exposures) {
    std::vector<double> times;
    for (const CameraSpots& exposure : exposures) {
        times.push_back(exposure.time_s);
    }
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
}

/// Three points of others may lie nearly as three markers of a body do: then some images are off.
bool may_be_others(const Fit& fit, const TrackerSettings& settings) {
    double squares = 0.0;
    for (const Vec2& off : fit.offs) {
        squares += off.squaredNorm() / static_cast<double>(fit.offs.size());
    }
    return std::sqrt(squares) > settings.most_new_px;
}

/// A body that points are taken for.
struct Claim {
    std::size_t body = 0;
    Identified found{};
};

bool goes_before(const Claim& one, const Claim& other) {
    return one.found.markers != other.found.markers ? one.found.markers > other.found.markers
                                                    : one.found.worst_mm < other.found.worst_mm;
}

}  // namespace

double believed_sigma(const Spot& spot, double area, double smear_px, const TrackerSettings& settings) {
    // What a spot that moves covers: the disc, and its width as far as it went.
    const double width_px = 2.0 * (std::sqrt(area / std::numbers::pi) + settings.blur_px);
    const double covered = 0.25 * std::numbers::pi * width_px * width_px + smear_px * width_px;
    const double share = spot.area / covered;
    if (spot.at_rim || share < settings.least_area || share > settings.most_area ||
        spot.roundness < settings.least_roundness * width_px / (width_px + smear_px)) {
        return 0.0;
    }
    const double least = settings.spot_sigma_px * (1.0 + 0.1 * smear_px);
    if (spot.sigma_px > 0.0) {
        return std::hypot(std::hypot(spot.sigma_px, least), settings.area_px * (share - 1.0));
    }
    return spot.crowded ? 5.0 * least : least;
}

Tracker::Tracker(Rig rig, std::vector<MarkerBody> bodies, std::optional<int> head, const TrackerSettings& settings)
    : rig_(std::move(rig)), bodies_(std::move(bodies)), head_(head), settings_(settings), resting_head_(settings.head) {
    tracks_.assign(bodies_.size(), Track{Seen::lost, MotionFilter(settings.filter), 0.0, Pose{}, Fit{}});
    told_.bodies.resize(bodies_.size());
}

void Tracker::prepare(std::span<const CameraSpots> exposures) {
    exposures_.clear();
    taken_.clear();
    offsets_.clear();
    for (const CameraSpots& exposure : exposures) {
        if (!last_s_ || exposure.time_s > *last_s_ - 0.5 * settings_.hold_s) {
            exposures_.push_back(exposure);
            taken_.emplace_back(exposure.spots.size(), false);
        }
    }
    if (!exposures_.empty()) {
        time_s_ = middle_time(exposures_);
    }
}

const TrackedBodies& Tracker::step(std::span<const CameraSpots> exposures) {
    prepare(exposures);
    if (exposures_.empty() || (last_s_ && time_s_ <= *last_s_)) {
        return told_;
    }
    follow();
    acquire();
    last_s_ = time_s_;
    tell();
    return told_;
}

void Tracker::add_candidates(int body, const Pose& at_time, const Motion& motion, double gate_px) {
    const MarkerBody& shape = bodies_[static_cast<std::size_t>(body)];
    for (std::size_t e = 0; e < exposures_.size(); ++e) {
        const CameraSpots& exposure = exposures_[e];
        const Camera& camera = rig_.cameras[static_cast<std::size_t>(exposure.camera)];
        const Pose then = moved(at_time, motion, exposure.time_s - time_s_);
        for (std::size_t m = 0; m < shape.markers.size(); ++m) {
            const Vec3 seen = camera.pose.to_body(then.to_world(shape.markers[m]));
            if (seen.z() <= 4.0 * shape.radius_mm) {
                continue;
            }
            const Vec2 image = sphere_image(camera.lens, seen, shape.radius_mm);
            const double area = sphere_area(camera.lens, seen, shape.radius_mm);
            const double smear_px = motion.velocity.norm() * settings_.exposure_s * camera.lens.fx / seen.z();
            for (std::size_t s = 0; s < exposure.spots.size(); ++s) {
                const double apart_px = (exposure.spots[s].at - image).norm();
                if (taken_[e][s] || apart_px > gate_px) {
                    continue;
                }
                if (const double sigma = believed_sigma(exposure.spots[s], area, smear_px, settings_); sigma > 0.0) {
                    candidates_.push_back(
                        {body, static_cast<int>(e), static_cast<int>(m), static_cast<int>(s), apart_px, sigma});
                }
            }
        }
    }
}

/// To each marker in each exposure at most one spot, and to each spot at most one marker: the nearest first.
void Tracker::assign() {
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.apart_px < b.apart_px; });
    std::vector<Candidate> kept;
    for (const Candidate& candidate : candidates_) {
        const bool clear = std::none_of(kept.begin(), kept.end(), [&candidate](const Candidate& other) {
            return other.exposure == candidate.exposure &&
                   (other.spot == candidate.spot || (other.body == candidate.body && other.marker == candidate.marker));
        });
        if (clear) {
            kept.push_back(candidate);
        }
    }
    candidates_ = std::move(kept);
}

std::vector<Sighting> Tracker::sightings_of(int body) const {
    std::vector<Sighting> sightings;
    for (const Candidate& candidate : candidates_) {
        if (candidate.body == body) {
            const CameraSpots& exposure = exposures_[static_cast<std::size_t>(candidate.exposure)];
            sightings.push_back({exposure.camera, candidate.marker, candidate.spot,
                                 exposure.spots[static_cast<std::size_t>(candidate.spot)].at, candidate.sigma_px,
                                 exposure.time_s - time_s_});
        }
    }
    return sightings;
}

void Tracker::follow() {
    candidates_.clear();
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        const Track& track = tracks_[i];
        if (track.seen != Seen::lost) {
            const double unseen_s = time_s_ - track.seen_s;
            // Where it is becomes less sure with each exposure in which it is not seen.
            const double gate_px = settings_.gate_px * std::clamp(unseen_s / 0.01, 1.0, 4.0);
            add_candidates(static_cast<int>(i), track.filter.foreseen(time_s_), track.filter.motion(), gate_px);
        }
    }
    assign();
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        Track& track = tracks_[i];
        if (track.seen == Seen::lost) {
            continue;
        }
        const int body = static_cast<int>(i);
        if (accept(body, sightings_of(body), track.filter.foreseen(time_s_), false)) {
            continue;
        }
        track.seen = time_s_ - track.seen_s <= settings_.hold_s ? Seen::held : Seen::lost;
        if (track.seen == Seen::held) {
            track.shown = track.filter.foreseen(time_s_);
        }
    }
}

/// True of a body that was lost.
bool Tracker::near_where_it_was(int body, const Fit& fit) const {
    const Track& track = tracks_[static_cast<std::size_t>(body)];
    const Pose& tip = bodies_[static_cast<std::size_t>(body)].tip;
    if (track.seen == Seen::lost) {
        return true;
    }
    const Vec3 foreseen = times(track.filter.foreseen(time_s_), tip).position;
    return (times(fit.pose, tip).position - foreseen).norm() <= settings_.most_leap_mm;
}

/// A pose of these sightings, if it is to be believed. fresh: the body was not where it should have been.
bool Tracker::accept(int body, const std::vector<Sighting>& sightings, const Pose& begun, bool fresh) {
    const MarkerBody& shape = bodies_[static_cast<std::size_t>(body)];
    Track& track = tracks_[static_cast<std::size_t>(body)];
    const Motion motion = fresh ? Motion{} : track.filter.motion();
    std::optional<Fit> fit = fit_body(rig_.cameras, shape, sightings, begun, motion, settings_.fit);
    const bool believed =
        fit && fit->residual_px <= settings_.most_residual_px && fit->cameras >= 2 &&
        2 * fit->counted > static_cast<int>(sightings.size()) &&
        (fit->markers > 3 || (near_where_it_was(body, *fit) && !(fresh && may_be_others(*fit, settings_))));
    if (!believed) {
        return false;
    }
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        offsets_.push_back({sightings[i].camera, fit->offs[i]});
        for (std::size_t e = 0; e < exposures_.size(); ++e) {
            if (exposures_[e].camera == sightings[i].camera) {
                taken_[e][static_cast<std::size_t>(sightings[i].spot)] = true;
            }
        }
    }
    if (fresh) {
        track.filter.begin(fit->pose, time_s_);
        track.shown = fit->pose;
    } else {
        track.shown = track.filter.take(fit->pose, time_s_);
    }
    track.seen = Seen::seen;
    track.seen_s = time_s_;
    track.fit = std::move(*fit);
    return true;
}

void Tracker::acquire() {
    const bool wanted =
        std::any_of(tracks_.begin(), tracks_.end(), [](const Track& t) { return t.seen != Seen::seen; });
    if (!wanted) {
        return;
    }
    acquire_with(settings_.matching.least_views);
    acquire_with(2);
}

/// Points that only two cameras see meet by chance: of those, all markers of a body are asked for. Of all bodies the
/// one of most markers goes first, for points of several bodies may happen to lie as three markers of another do.
void Tracker::acquire_with(int least_views) {
    MatchingSettings matching = settings_.matching;
    matching.least_views = least_views;
    const std::vector<MatchedPoint> matched = match_spots(rig_.cameras, exposures_, taken_, matching);
    std::vector<Vec3> points;
    for (const MatchedPoint& point : matched) {
        points.push_back(point.point);
    }
    std::vector<bool> used(points.size(), false);
    std::vector<Claim> claims;
    const auto claim = [&](std::size_t body) {
        const int asked = least_views >= 3 ? 3 : static_cast<int>(bodies_[body].markers.size());
        std::optional<Identified> found = identify(bodies_[body], points, used, settings_.distance_mm);
        if (found && found->markers >= asked) {
            claims.push_back({body, std::move(*found)});
        }
    };
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        if (tracks_[i].seen != Seen::seen) {
            claim(i);
        }
    }
    while (!claims.empty()) {
        const auto best = std::min_element(claims.begin(), claims.end(), goes_before);
        const Claim one = std::move(*best);
        claims.erase(best);
        const std::vector<int>& of = one.found.points;
        if (std::any_of(of.begin(), of.end(), [&used](int point) { return point >= 0 && used[at(point)]; })) {
            claim(one.body);  // others had some of its points
        } else if (acquire_at(static_cast<int>(one.body), one.found.pose)) {
            for (const int point : of) {
                if (point >= 0) {
                    used[at(point)] = true;
                }
            }
        }
    }
}

/// By its images, where points say that it is.
bool Tracker::acquire_at(int body, const Pose& pose) {
    candidates_.clear();
    add_candidates(body, pose, Motion{}, settings_.gate_px);
    assign();
    return accept(body, sightings_of(body), pose, true);
}

std::optional<Pose> Tracker::in_rig(int body) const {
    const Track& track = tracks_[static_cast<std::size_t>(body)];
    return track.seen == Seen::lost ? std::nullopt : std::optional<Pose>(track.shown);
}

/// Called once in a step.
Pose Tracker::head_frame() {
    if (!head_) {
        return {};
    }
    const Track& track = tracks_[static_cast<std::size_t>(*head_)];
    if (track.seen == Seen::lost) {
        resting_head_.forget();
    } else if (track.seen == Seen::seen) {
        return resting_head_.take(track.fit, time_s_);
    }
    return resting_head_.mean().value_or(track.shown);
}

void Tracker::tell() {
    told_.time_s = time_s_;
    const bool by_head = head_.has_value();
    // The eye is where the head body has its tip.
    const Pose frame = by_head ? times(head_frame(), bodies_[static_cast<std::size_t>(*head_)].tip) : Pose{};
    const Seen head_seen = by_head ? tracks_[static_cast<std::size_t>(*head_)].seen : Seen::seen;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        const Track& track = tracks_[i];
        TrackedBody& body = told_.bodies[i];
        const bool itself = by_head && static_cast<int>(i) == *head_;
        body.seen = itself ? track.seen : std::min(track.seen, head_seen);
        if (body.seen == Seen::lost) {
            continue;
        }
        body.pose = itself ? track.shown : relative(frame, track.shown);
        body.tip = times(body.pose, bodies_[i].tip);
        body.time_s = body.seen == Seen::seen ? time_s_ : track.seen_s;
        body.cameras = track.seen == Seen::seen ? track.fit.cameras : 0;
        body.markers = track.seen == Seen::seen ? track.fit.markers : 0;
        body.residual_px = track.fit.residual_px;
    }
}

}  // namespace rhexis::tracking
