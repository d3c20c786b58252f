// SPDX-License-Identifier: GPL-3.0-or-later
#include "track/chain.hpp"

#include <algorithm>
#include <cmath>

#include "flow/microscope.hpp"
#include "math/poses.hpp"
#include "net/vrpn_report.hpp"

namespace rhexis::tracking {
namespace {

constexpr double before_s = 1.0;  ///< that cameras look before the first step: clocks are compared
constexpr double exposure_s = 5e-4;
constexpr int instants = 2;         ///< of an exposure
constexpr double transit_s = 3e-3;  ///< from the middle of an exposure to a report's arrival, at least
constexpr double jitter_s = 5e-4;   ///< mean of what is added to it
constexpr double day_s = 1.7e9;     ///< the tracking computer's clock differs from the simulation's

std::int64_t us_of(double seconds) { return std::llround(1e6 * seconds); }

void add_spheres(const MarkerBody& body, const Pose& pose, synthetic::Scene& scene) {
    for (const Vec3& marker : body.markers) {
        synthetic::Sphere sphere;
        sphere.centre = pose.to_world(marker);
        sphere.radius = body.radius_mm;
        scene.spheres.push_back(sphere);
    }
}

/// As a wire carries it: what it does to numbers is done.
Result<DeviceReport> over_the_wire(const DeviceReport& report) {
    DeviceReport come = report;
    if (const auto* pose = std::get_if<PoseReport>(&report.what)) {
        Result<PoseReport> read = vrpn::read_pose(vrpn::payload_of(*pose));
        if (!read) {
            return read.error();
        }
        come.what = read.value();
    } else if (const auto* channels = std::get_if<std::vector<double>>(&report.what)) {
        Result<std::vector<double>> read = vrpn::read_analog(vrpn::analog_payload(*channels));
        if (!read) {
            return read.error();
        }
        come.what = std::move(read).value();
    }
    return come;
}

}  // namespace

Result<std::unique_ptr<Chain>> Chain::open(const ChainOptions& options) {
    Result<Setup> setup = read_setup(options.setup);
    if (!setup) {
        return setup.error();
    }
    auto* plan = std::get_if<SyntheticPlan>(&setup.value().source);
    if (plan == nullptr) {
        return Error{"hands go through a synthetic rig only", options.setup, "\"source\": {\"kind\": \"synthetic\"}"};
    }
    if (!setup.value().rig.calibrated) {
        return Error{"this rig is not calibrated", setup.value().rig_path, "rhexis track calibrate " + options.setup};
    }
    if (!setup.value().head) {
        return Error{"no head is tracked", options.setup, "\"head\": the name of a body"};
    }
    if (!options.level.empty()) {
        plan->images = options.level == "images";
    }
    Result<synthetic::SyntheticRig> rig = synthetic::SyntheticRig::create(plan->seed);
    if (!rig) {
        return rig.error();
    }
    return std::unique_ptr<Chain>(new Chain(std::move(setup).value(), std::move(rig).value(), options.seed));
}

Chain::Chain(Setup setup, synthetic::SyntheticRig rig, std::uint64_t seed)
    : setup_(std::move(setup)),
      rig_(std::move(rig)),
      tracker_(setup_.rig, setup_.bodies, setup_.head, TrackerSettings{}),
      finder_(setup_.spots),
      rng_(seed, "chain") {
    for (std::size_t i = 0; i < rig_.cameras.size(); ++i) {
        patterns_.emplace_back(rig_.cameras[i], seed + i);
    }
}

Status Chain::begin(const std::vector<std::string>& instruments, double step_s) {
    step_s_ = step_s;
    tracked_of_.assign(instruments.size(), -1);
    is_tracked_.assign(instruments.size(), false);
    TrackedModel model;
    for (std::size_t i = 0; i < instruments.size(); ++i) {
        if (instruments[i] == microscope_name) {
            continue;
        }
        const auto body = std::find_if(setup_.bodies.begin(), setup_.bodies.end(),
                                       [&](const MarkerBody& one) { return one.name == instruments[i]; });
        if (body == setup_.bodies.end()) {
            return Error{"no body is called \"" + instruments[i] + "\"", setup_.path,
                         "one for each instrument of the exercise"};
        }
        tracked_of_[i] = static_cast<int>(hands_.size());
        is_tracked_[i] = true;
        Hand hand;
        hand.instrument = static_cast<int>(i);
        hand.body = static_cast<int>(body - setup_.bodies.begin());
        hands_.push_back(hand);
        model.instruments.push_back(instruments[i]);
    }
    input_.emplace(std::move(model));
    const std::vector<DeviceSample> nothing(instruments.size());
    time_s_ = -before_s;
    exposed_s_ = -before_s;
    while (time_s_ < -0.5 * step_s_) {
        time_s_ += step_s_;
        expose(time_s_, nothing);
        deliver(us_of(time_s_));
        input_->look(us_of(time_s_), {});
    }
    time_s_ = 0.0;
    return success();
}

/// What stands before the cameras: the head, whose eye is the origin, and the instruments that hands hold.
void Chain::place(double time_s, std::span<const DeviceSample> hands, synthetic::Scene& scene) const {
    scene.spheres.clear();
    scene.capsules.clear();
    scene.discs.clear();
    scene.glints.clear();
    const MarkerBody& head = setup_.bodies[static_cast<std::size_t>(*setup_.head)];
    add_spheres(head, inverse(head.tip), scene);
    for (const Hand& hand : hands_) {
        const DeviceSample& sample = hands[static_cast<std::size_t>(hand.instrument)];
        if (!sample.present) {
            continue;
        }
        const double share = std::clamp((time_s - (time_s_ - step_s_)) / step_s_, 0.0, 1.0);
        const Pose tip = hand.was_there
                             ? Pose{hand.before.position + share * (sample.pose.position - hand.before.position),
                                    hand.before.orientation.slerp(share, sample.pose.orientation)}
                             : sample.pose;
        const MarkerBody& body = setup_.bodies[static_cast<std::size_t>(hand.body)];
        add_spheres(body, times(tip, inverse(body.tip)), scene);
    }
}

void Chain::look(int camera, double time_s, std::span<const DeviceSample> hands, CameraSpots& exposure) {
    const auto index = static_cast<std::size_t>(camera);
    const synthetic::TrueCamera& eye = rig_.cameras[index];
    instants_.resize(instants);
    for (int i = 0; i < instants; ++i) {
        const double part = (i + 0.5) / instants - 0.5;
        place(time_s + eye.time_offset_s + part * exposure_s, hands, instants_[static_cast<std::size_t>(i)]);
    }
    exposure.camera = camera;
    exposure.time_s = time_s;
    if (std::get<SyntheticPlan>(setup_.source).images) {
        const std::uint64_t seed = (static_cast<std::uint64_t>(rng_.next()) << 32U) | rng_.next();
        synthetic::render(eye, patterns_[index], instants_, seed, render_, image_);
        exposure.spots = finder_.find(image_.view()).spots;
    } else {
        synthetic::spots_without_images(eye, instants_, {}, rng_, markers_, exposure.spots);
    }
}

/// All exposures up to a step's end.
void Chain::expose(double time_s, std::span<const DeviceSample> hands) {
    const double interval_s = 1.0 / std::get<SyntheticPlan>(setup_.source).rate_hz;
    std::vector<CameraSpots> exposures(rig_.cameras.size());
    while (exposed_s_ + interval_s <= time_s) {
        exposed_s_ += interval_s;
        for (std::size_t i = 0; i < exposures.size(); ++i) {
            look(static_cast<int>(i), exposed_s_, hands, exposures[i]);
        }
        tell(tracker_.step(exposures), exposed_s_);
    }
    for (const Hand& hand : hands_) {
        const DeviceSample& sample = hands[static_cast<std::size_t>(hand.instrument)];
        const std::string& device = setup_.bodies[static_cast<std::size_t>(hand.body)].name;
        const auto told = jaws_.find(device);
        if (sample.present && (told == jaws_.end() || told->second != sample.jaw)) {
            jaws_[device] = sample.jaw;
            send({device, us_of(time_s + day_s), std::vector<double>{sample.jaw}}, time_s);
        }
    }
}

void Chain::tell(const TrackedBodies& told, double time_s) {
    for (std::size_t i = 0; i < told.bodies.size(); ++i) {
        const TrackedBody& body = told.bodies[i];
        if (body.seen == Seen::seen && static_cast<int>(i) != *setup_.head) {
            send({setup_.bodies[i].name, us_of(time_s + day_s), PoseReport{0, body.tip.position, body.tip.orientation}},
                 time_s);
        }
    }
}

void Chain::send(DeviceReport report, double time_s) {
    const double late_s = -jitter_s * std::log(1.0 - rng_.uniform());
    const Result<DeviceReport> come = over_the_wire(report);
    if (come) {
        // a stream keeps its order
        const std::int64_t before_us = on_their_way_.empty() ? 0 : on_their_way_.back().arrival_us;
        const std::int64_t arrival_us = us_of(time_s + transit_s + late_s);
        on_their_way_.push_back({on_their_way_.empty() ? arrival_us : std::max(arrival_us, before_us), come.value()});
    }
}

void Chain::deliver(std::int64_t until_us) {
    while (!on_their_way_.empty() && on_their_way_.front().arrival_us <= until_us) {
        input_->take(on_their_way_.front().report, on_their_way_.front().arrival_us);
        on_their_way_.pop_front();
    }
}

Result<std::vector<DeviceSample>> Chain::through(std::span<const DeviceSample> hands) {
    time_s_ += step_s_;
    expose(time_s_, hands);
    deliver(us_of(time_s_));
    const TrackingState state = input_->look(us_of(time_s_), {});
    std::vector<DeviceSample> seen(hands.begin(), hands.end());
    for (Hand& hand : hands_) {
        const auto instrument = static_cast<std::size_t>(hand.instrument);
        DeviceSample sample = input_->samples()[static_cast<std::size_t>(tracked_of_[instrument])];
        sample.instrument = hand.instrument;
        sample.pedal = hands[instrument].pedal;  // a foot is not seen by cameras
        seen[instrument] = sample;
        hand.before = hands[instrument].pose;
        hand.was_there = hands[instrument].present;
    }
    if (state != TrackingState::running) {
        tally_.stood();
    }
    tally_.add(hands, seen, is_tracked_);
    return seen;
}

LinkFigures Chain::figures() const {
    return tally_.figures(std::get<SyntheticPlan>(setup_.source).images ? "images" : "markers");
}

}  // namespace rhexis::tracking
