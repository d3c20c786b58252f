// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis track: exposures in, poses out, until it is ended.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <deque>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/clock.hpp"
#include "track/camera_views.hpp"
#include "track/commands.hpp"
#include "track/onlooker.hpp"
#include "track/server.hpp"
#include "track/status.hpp"
#include "tracking/annotated.hpp"
#include "tracking/camera_health.hpp"

namespace rhexis::tracking {
namespace {

volatile std::sig_atomic_t asked_to_end = 0;

std::int64_t time_of_day_us() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::microseconds>(since).count();
}

/// Of the last second: medians of what each set of exposures took, how many there were, and how many did not come.
class Rate {
public:
    void note(double now_s, double took_s, std::uint64_t lost) {
        recent_.push_back({now_s, took_s, lost});
        while (now_s - recent_.front().now_s > 1.0) {
            recent_.pop_front();
        }
    }
    [[nodiscard]] double per_s() const {
        const double passed_s = recent_.empty() ? 0.0 : recent_.back().now_s - recent_.front().now_s;
        return passed_s > 0.0 ? static_cast<double>(recent_.size() - 1) / passed_s : 0.0;
    }
    /// Exposures that did not come.
    [[nodiscard]] std::uint64_t lost() const {
        return recent_.empty() ? 0 : recent_.back().lost - recent_.front().lost;
    }
    [[nodiscard]] double median_ms() const {
        std::vector<double> all;
        for (const Noted& one : recent_) {
            all.push_back(one.took_s);
        }
        if (all.empty()) {
            return 0.0;
        }
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
        std::nth_element(all.begin(), middle, all.end());
        return 1e3 * *middle;
    }

private:
    struct Noted {
        double now_s;
        double took_s;
        std::uint64_t lost;
    };
    std::deque<Noted> recent_{};
};

void print_json(const TrackedBodies& told, const std::vector<MarkerBody>& bodies) {
    nlohmann::json line{{"time_s", told.time_s}, {"bodies", nlohmann::json::object()}};
    for (std::size_t i = 0; i < told.bodies.size(); ++i) {
        const TrackedBody& body = told.bodies[i];
        const Quat& turned = body.tip.orientation;
        const Vec3& tip = body.tip.position;
        line["bodies"][bodies[i].name] =
            body.seen == Seen::lost
                ? nlohmann::json{{"seen", "lost"}}
                : nlohmann::json{{"seen", body.seen == Seen::seen ? "seen" : "held"},
                                 {"tip_mm", {tip.x(), tip.y(), tip.z()}},
                                 {"orientation_xyzw", {turned.x(), turned.y(), turned.z(), turned.w()}},
                                 {"cameras", body.cameras},
                                 {"residual_px", body.residual_px}};
    }
    std::printf("%s\n", line.dump().c_str());
}

class Tracking {
public:
    Tracking(const TrackOptions& options, const Setup& setup, std::unique_ptr<SpotSource> source,
             std::optional<Server> server, Onlooker* onlooker)
        : options_(options),
          setup_(setup),
          source_(std::move(source)),
          server_(std::move(server)),
          onlooker_(onlooker),
          tracker_(setup.rig, setup.bodies, setup.head, TrackerSettings{}),
          lines_(setup),
          health_(static_cast<int>(setup.rig.cameras.size())),
          paced_(!options.as_fast_as_can_be && !std::holds_alternative<CapturePlan>(setup.source)) {}

    Status run() {
        const double begun_s = wall_seconds();
        std::vector<CameraSpots> come;
        const TrackedBodies* told = nullptr;
        while (!is_to_end()) {
            const double work_began_s = thread_cpu_seconds();
            const Result<bool> more = source_->next(come);
            if (!more) {
                return more.error();
            }
            if (!more.value()) {
                break;
            }
            std::swap(exposures_, come);
            if (const Status kept = keep(); !kept) {
                return kept;
            }
            told = &tracker_.step(exposures_);
            rate_.note(wall_seconds(), thread_cpu_seconds() - work_began_s, source_->lost());
            wait_until(begun_s + told->time_s);
            tell(*told);
            if (options_.seconds > 0.0 && told->time_s >= options_.seconds) {
                break;
            }
        }
        linger();
        const Status drawn =
            options_.picture.empty() ? success() : write_annotated(options_.picture, setup_.rig, setup_.bodies, seen());
        const Status shown = onlooker_ == nullptr
                                 ? success()
                                 : onlooker_->finish(told != nullptr ? painter_of(*told) : Onlooker::Painter());
        return drawn ? shown : drawn;
    }

private:
    [[nodiscard]] bool is_to_end() const { return asked_to_end != 0 || (onlooker_ != nullptr && onlooker_->closed()); }

    /// Recorded or synthetic exposures come when they would have come; meanwhile the network is served.
    void wait_until(double due_s) {
        do {
            turn();
            if (!paced_ || wall_seconds() >= due_s) {
                return;
            }
            std::this_thread::sleep_for(std::chrono::microseconds(500));
        } while (!is_to_end());
    }

    Status keep() {
        return options_.keep.empty() || source_->images() == nullptr
                   ? success()
                   : keep_frames(options_.keep, setup_.rig, *source_->images(), kept_++);
    }

    void turn() {
        if (server_) {
            server_->turn(wall_seconds(), time_of_day_us());
            for (const std::string& note : server_->take_notes()) {
                std::fprintf(stderr, "rhexis: a listener: %s\n", note.c_str());
            }
            tell_of_inputs(server_->inputs_trouble(wall_seconds()));
        }
    }

    /// After a moment, in which it connects.
    void tell_of_inputs(const std::string& trouble) {
        constexpr double patient_s = 1.0;
        if (wall_seconds() - begun_s_ < patient_s || trouble == inputs_trouble_) {
            return;
        }
        inputs_trouble_ = trouble;
        std::fprintf(stderr, "rhexis: inputs, %s: %s\n", setup_.inputs.c_str(),
                     trouble.empty() ? "all is well" : trouble.c_str());
    }

    void linger() {
        constexpr double enough_s = 0.2;  // listeners have the last of it
        for (const double begun_s = wall_seconds(); server_ && wall_seconds() - begun_s < enough_s;) {
            turn();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    void tell(const TrackedBodies& told) {
        look_after(told.time_s);
        if (server_) {
            server_->tell(told, time_of_day_us(), wall_seconds());
            server_->warn(warning_, time_of_day_us());
            turn();
        }
        if (options_.json) {
            print_json(told, setup_.bodies);
        }
        if (told.time_s - shown_s_ >= 0.2 || shown_s_ < 0.0) {
            shown_s_ = told.time_s;
            lines_.show(told, health());
        }
        if (onlooker_ != nullptr && onlooker_->wants()) {
            onlooker_->show(painter_of(told));
        }
    }

    [[nodiscard]] RigHealth health() const {
        return {rate_.per_s(), rate_.median_ms(), source_->lost(), rate_.lost(), server_ ? server_->listeners() : 0,
                warning_,      warned_camera_};
    }

    /// What is drawn meanwhile is a copy; images are shared.
    [[nodiscard]] Onlooker::Painter painter_of(const TrackedBodies& told) const {
        return [view = TrackingView{seen(), told, health()}, &setup = setup_](
                   const ScreenWish& wish, ScreenMoment& moment) { moment = moment_of(setup, view, wish); };
    }

    /// Which camera sees all bodies beside where the others have them.
    void look_after(double time_s) {
        health_.add(time_s, tracker_.offsets());
        const std::optional<Drift> drift = health_.drift();
        warning_.clear();
        warned_camera_ = drift ? drift->camera : -1;
        if (drift) {
            const std::string& name = setup_.rig.cameras[static_cast<std::size_t>(drift->camera)].name;
            std::array<char, 160> text{};
            std::snprintf(text.data(), text.size(),
                          drift->alone ? "%s was moved: it sees all %.1f pixels off"
                                       : "the rig is off, %s most, by %.1f pixels: calibrate",
                          name.c_str(), drift->median_px.norm());
            warning_ = text.data();
        }
    }

    [[nodiscard]] SeenByCameras seen() const {
        SeenByCameras seen{exposures_, source_->images(), {}};
        for (std::size_t i = 0; i < setup_.bodies.size(); ++i) {
            seen.bodies.push_back(tracker_.in_rig(static_cast<int>(i)));
        }
        return seen;
    }

    const TrackOptions& options_;
    const Setup& setup_;
    std::unique_ptr<SpotSource> source_;
    std::optional<Server> server_;
    Onlooker* onlooker_;  ///< null: nobody looks on
    Tracker tracker_;
    StatusLines lines_;
    CameraHealth health_;
    bool paced_;
    Rate rate_{};
    std::string warning_{};
    int warned_camera_ = -1;
    std::vector<CameraSpots> exposures_{};  ///< the last ones
    double shown_s_ = -1.0;
    double begun_s_ = wall_seconds();
    std::string inputs_trouble_{};
    std::uint64_t kept_ = 0;
};

}  // namespace

Status track(const TrackOptions& options) {
    const Result<Setup> setup = read_setup(options.setup);
    if (!setup) {
        return setup.error();
    }
    if (!setup.value().rig.calibrated) {
        return Error{"this rig is not calibrated", setup.value().rig_path, "rhexis track calibrate " + options.setup};
    }
    const Result<std::unique_ptr<Onlooker>> onlooker = Onlooker::open(options.screen, options.open_screen);
    if (!onlooker) {
        return onlooker.error();
    }
    Result<std::unique_ptr<SpotSource>> source = open_source(setup.value());
    if (!source) {
        return source.error();
    }
    std::optional<Server> server;
    if (!options.silent) {
        Result<Server> opened = Server::open(setup.value());
        if (!opened) {
            return opened.error();
        }
        server.emplace(std::move(opened).value());
        std::fprintf(stderr, "told at %s\n", server->places().c_str());
    }
    std::signal(SIGINT, [](int) { asked_to_end = 1; });
    std::signal(SIGTERM, [](int) { asked_to_end = 1; });
    return Tracking(options, setup.value(), std::move(source).value(), std::move(server), onlooker.value().get()).run();
}

}  // namespace rhexis::tracking
