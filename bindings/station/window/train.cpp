// SPDX-License-Identifier: GPL-3.0-or-later
// A person operates in a window: the simulation on a thread of its own, the picture and the devices on this one.
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "base/clock.hpp"
#include "render/image_file.hpp"
#include "render/renderer.hpp"
#include "station/mapping.hpp"
#include "station/person.hpp"
#include "station/scripted.hpp"
#include "station/station.hpp"
#include "station/window/panels.hpp"
#include "station/window/window.hpp"

namespace rhexis::station {
namespace {

constexpr double longest_wait_s = 0.02;  ///< for a picture, before events are looked for again

/// Shares of the window's size that a picture may have, so that there are enough of them.
constexpr std::array picture_sizes = {1.0, 0.85, 0.7, 0.6, 0.5};
constexpr double least_rate = 15.0;  ///< pictures per second: below, they are drawn smaller
constexpr int looked_at = 12;        ///< pictures, before that is decided

/// Draws the newest state, with the instruments where the hands are by now.
class Picture {
public:
    struct Wishes {
        Stereo stereo = Stereo::off;
        const Ghost* ghost = nullptr;
        bool keep_rate = false;  ///< pictures are drawn smaller where there would be too few
    };

    Picture(Window& window, Panels& panels, Renderer renderer, HoldScript holds, const Wishes& wishes)
        : window_(window),
          panels_(panels),
          wishes_(wishes),
          renderer_(std::make_unique<Renderer>(std::move(renderer))),
          holds_(std::move(holds)),
          begun_s_(wall_seconds()) {}

    void posted(const UserEvent& event) { ahead_.push_back({++posted_, event}); }

    /// taken: receives what the window shows; null: nobody wants it.
    std::vector<UserEvent> draw(Shown& shown, double step_s, Image* taken = nullptr) {
        run_ahead(shown, step_s);
        const double before = wall_seconds();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, window_.width(), window_.height());
        renderer_->show(shown.frame, adjusted(microscope_camera(shown.frame), shown.hands),
                        {0, 0, window_.width(), window_.height()}, wishes_.stereo);
        std::vector<UserEvent> clicked =
            panels_.draw(shown, wishes_.ghost, {rate_, picture_sizes[static_cast<std::size_t>(size_)]});
        window_.show_cursor(shown.hands.paused);
        if (taken != nullptr) {
            *taken = read_window();
        }
        window_.present();
        count(wall_seconds() - before);
        return clicked;
    }

private:
    [[nodiscard]] Image read_window() const {
        const int width = window_.width();
        const int height = window_.height();
        Image image{width, height, std::vector<unsigned char>(3 * static_cast<std::size_t>(width) * height)};
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        for (int row = 0; row < height; ++row) {  // the window's first one is at the bottom
            glReadPixels(0, height - 1 - row, width, 1, GL_RGB, GL_UNSIGNED_BYTE,
                         &image.rgb[3 * static_cast<std::size_t>(row) * width]);
        }
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        return image;
    }

    void count(double took_s) {
        ++count_;
        slow_s_ += took_s;
        const double now = wall_seconds();
        if (now - begun_s_ >= 1.0) {
            rate_ = count_ / (now - begun_s_);
            begun_s_ = now;
            count_ = 0;
        }
        if (++looked_ < looked_at) {
            return;
        }
        const double mean_s = slow_s_ / looked_;
        looked_ = 0;
        slow_s_ = 0.0;
        if (wishes_.keep_rate && !first_look_ && mean_s > 1.0 / least_rate &&
            size_ + 1 < static_cast<int>(picture_sizes.size())) {
            draw_smaller(mean_s);
        }
        first_look_ = false;  // textures were painted meanwhile
    }

    /// As much smaller as it takes: pixels cost the time.
    void draw_smaller(double mean_s) {
        const double wanted = picture_sizes[static_cast<std::size_t>(size_)] * std::sqrt(1.0 / (least_rate * mean_s));
        while (size_ + 1 < static_cast<int>(picture_sizes.size()) &&
               picture_sizes[static_cast<std::size_t>(size_)] > wanted) {
            ++size_;
        }
        const double share = picture_sizes[static_cast<std::size_t>(size_)];
        Result<Renderer> smaller = Renderer::create_in_window(static_cast<int>(share * window_.width()),
                                                              static_cast<int>(share * window_.height()));
        if (smaller) {
            renderer_ = std::make_unique<Renderer>(std::move(smaller).value());
        }
        first_look_ = true;
    }

    /// What the hands have done since this state was made.
    void run_ahead(Shown& shown, double step_s) {
        while (!ahead_.empty() && ahead_.front().first <= shown.events) {
            ahead_.pop_front();
        }
        Hands hands(shown.hands, *shown.stand, holds_);
        for (const auto& [number, event] : ahead_) {
            hands.take(event, shown.around);
        }
        if (shown.waits || !hands.advance(shown.around, step_s)) {
            return;
        }
        for (const DeviceSample& sample : hands.samples(shown.around, step_s)) {
            const auto at = static_cast<std::size_t>(sample.instrument);
            if (at < shown.frame.tools.size() && sample.present) {
                ToolState& tool = shown.frame.tools[at];
                tool.present = true;
                tool.jaw = sample.jaw;
                tool.pose = shown.frame.globe ? to_eye(*shown.frame.model->globe, *shown.frame.globe, sample.pose)
                                              : sample.pose;
            }
        }
    }

    Window& window_;
    Panels& panels_;
    Wishes wishes_;
    std::unique_ptr<Renderer> renderer_;
    HoldScript holds_;
    std::deque<std::pair<std::uint64_t, UserEvent>> ahead_;
    std::uint64_t posted_ = 0;
    double begun_s_;
    double rate_ = 0.0;
    int count_ = 0;
    int size_ = 0;  ///< in picture_sizes
    int looked_ = 0;
    double slow_s_ = 0.0;
    bool first_look_ = true;
};

/// A person, not a file or a virtual surgeon.
bool operates(const StationOptions& options) { return !options.again && options.by.empty(); }

/// A mapping's file that is edited while the station runs.
class MappingFile {
public:
    MappingFile(std::string path, Mapping read)
        : path_(std::move(path)), read_(std::move(read)), written_(last_written()) {}

    /// What has changed in it since it was read last; what is wrong with it is told.
    std::vector<UserEvent> changes(Panels& panels) {
        const double now = wall_seconds();
        if (now - looked_s_ < 1.0) {
            return {};
        }
        looked_s_ = now;
        const std::filesystem::file_time_type written = last_written();
        if (written == written_) {
            return {};
        }
        written_ = written;
        Result<Mapping> mapping = Mapping::read(path_);
        if (!mapping) {
            panels.notice(mapping.error().text());
            return {};
        }
        std::vector<UserEvent> events = read_.changes_to(mapping.value());
        read_ = std::move(mapping).value();
        panels.notice(panels.words()("read again: %s", {path_}));
        return events;
    }

private:
    [[nodiscard]] std::filesystem::file_time_type last_written() const {
        std::error_code unknown;
        return std::filesystem::last_write_time(path_, unknown);
    }

    std::string path_;
    Mapping read_;
    std::filesystem::file_time_type written_;
    double looked_s_ = 0.0;
};

/// Until the trial has ended.
void look_on(const StationOptions& options, Desk& desk, Window& window, Panels& panels, MappingFile& file,
             Picture& picture, double step_s) {
    std::uint64_t seen = 0;
    bool any = false;
    const auto post = [&](const std::vector<UserEvent>& events) {
        for (const UserEvent& event : events) {
            desk.post(event);
            picture.posted(event);
        }
    };
    while (!desk.ended()) {
        for (const UserEvent& event : window.poll()) {
            if (operates(options)) {
                const std::optional<std::vector<UserEvent>> captured = panels.captured(event);
                post(captured ? *captured : std::vector{event});
            } else if (event.kind == EventKind::quit) {
                desk.close();
            }
        }
        if (operates(options)) {
            post(file.changes(panels));
        }
        const std::shared_ptr<Shown> shown = any ? desk.wait_for(seen, longest_wait_s) : desk.newest();
        if (!shown) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            continue;
        }
        if (any && !operates(options) && shown->step == seen) {
            continue;  // nobody moves anything before the next one
        }
        any = true;
        const std::vector<UserEvent> clicked = picture.draw(*shown, step_s);
        seen = shown->step;
        desk.drawn(seen);
        if (operates(options)) {
            post(clicked);
        }
    }
}

/// What the window shows in the end.
Status keep_picture(const StationOptions& options, const Desk& desk, Picture& picture, double step_s) {
    const std::shared_ptr<Shown> last = desk.newest();
    if (options.screenshot.empty() || !last) {
        return success();
    }
    Image image;
    picture.draw(*last, step_s, &image);
    return write_png(image, options.screenshot);
}

struct Prepared {
    std::string mapping_file;
    Mapping mapping;
    std::vector<MappingOffer> offers;
    std::string own;  ///< where a person's mapping is kept
    std::optional<EventFile> file;
    std::optional<EventWriter> writer;
    std::optional<Ghost> ghost;
};

nlohmann::json events_header(const StationOptions& options, const Mapping& mapping) {
    nlohmann::json header = options.begun_with;
    header["curriculum"] = options.attempt.exercise.curriculum;
    header["seed"] = options.attempt.exercise.seed;
    header["set"] = options.attempt.exercise.set;
    header["input"] = options.pad ? "gamepad" : "mouse";
    header["mapping"] = mapping.to_json();
    return header;
}

std::string setting_of(const StationOptions& options, const char* name) {
    const auto found = options.attempt.exercise.set.find(name);
    return found == options.attempt.exercise.set.end() ? "" : found->second;
}

/// The one that is named, else a person's own, else the standard one.
std::string mapping_file(const StationOptions& options) {
    const bool left = setting_of(options, "handedness") == "left";
    const std::string own = own_mapping(options.pad, left);
    std::error_code unknown;
    if (options.mapping.empty() && operates(options) && !own.empty() && std::filesystem::exists(own, unknown)) {
        return own;
    }
    return options.mapping.empty() ? standard_mapping(options.attempt.exercise.root, options.pad, left)
                                   : options.mapping;
}

Status offer_mappings(const StationOptions& options, Prepared& prepared) {
    for (const auto& [title, left] : {std::pair("Right-handed", false), {"Left-handed", true}}) {
        Result<Mapping> mapping = Mapping::read(standard_mapping(options.attempt.exercise.root, options.pad, left));
        if (!mapping) {
            return mapping.error();
        }
        prepared.offers.push_back({title, std::move(mapping).value()});
    }
    prepared.own = own_mapping(options.pad, setting_of(options, "handedness") == "left");
    return success();
}

Result<Prepared> prepare(const StationOptions& options) {
    Prepared prepared;
    prepared.mapping_file = mapping_file(options);
    if (const Status offered = offer_mappings(options, prepared); !offered) {
        return offered.error();
    }
    Result<Mapping> mapping = Mapping::read(prepared.mapping_file);
    if (options.again) {
        Result<EventFile> file = read_events(options.events);
        if (!file) {
            return file.error();
        }
        prepared.file = std::move(file).value();
        mapping = Mapping::from(prepared.file->header.value("mapping", nlohmann::json::object()));
    }
    if (!mapping) {
        return mapping.error();
    }
    prepared.mapping = std::move(mapping).value();
    if (!options.events.empty() && !options.again) {
        Result<EventWriter> writer = EventWriter::create(options.events, events_header(options, prepared.mapping));
        if (!writer) {
            return writer.error();
        }
        prepared.writer.emplace(std::move(writer).value());
    }
    return prepared;
}

/// No wall clock: each step waits for its picture, where it has one.
bool is_stepped(const StationOptions& options) { return options.again || (!options.by.empty() && !options.live); }

Result<std::unique_ptr<EventSource>> make_source(const StationOptions& options, const Prepared& prepared, Desk& desk,
                                                 double step_s) {
    if (options.again) {
        return std::unique_ptr<EventSource>(std::make_unique<Steps>(*prepared.file));
    }
    if (options.by.empty()) {
        return std::unique_ptr<EventSource>(std::make_unique<WallClock>(desk, step_s));
    }
    ExerciseOptions of_surgeon = options.attempt.exercise;
    of_surgeon.surgeon = options.by;
    Result<std::unique_ptr<Scripted>> scripted =
        Scripted::create(of_surgeon, Fingers(options.pad ? Style::pad : Style::mouse, options.width, options.height),
                         options.live ? std::make_unique<WallClock>(desk, step_s) : nullptr);
    return scripted ? Result<std::unique_ptr<EventSource>>(std::move(scripted).value()) : scripted.error();
}

Result<AttemptResult> train(const StationOptions& options) {
    Result<Prepared> made = prepare(options);
    if (!made) {
        return made.error();
    }
    Prepared& prepared = made.value();
    const Result<ExerciseHost> host = ExerciseHost::load(options.attempt.exercise);
    if (!host) {
        return host.error();
    }
    const double step_s = host.value().scene().step_s;
    if (!options.ghost.empty()) {
        Result<Ghost> ghost = Ghost::read(options.ghost, host.value().scene().instruments);
        if (!ghost) {
            return ghost.error();
        }
        prepared.ghost.emplace(std::move(ghost).value());
    }
    Result<Window> window = Window::open("rhexis: " + host.value().identity().value("title", std::string()),
                                         options.width, options.height, options.full_screen);
    if (!window) {
        return window.error();
    }
    Result<Renderer> renderer = Renderer::create_in_window(window.value().width(), window.value().height());
    if (!renderer) {
        return renderer.error();
    }
    Result<HoldScript> holds = HoldScript::load(options.attempt.exercise.root);
    if (!holds) {
        return holds.error();
    }
    Result<Words> words =
        Words::load(options.attempt.exercise.root, setting_of(options, "language"), host.value().scene().instruments);
    if (!words) {
        return words.error();
    }
    Panels panels(window.value(), std::move(words).value(), std::move(prepared.offers), prepared.own);
    MappingFile mapping_file(prepared.mapping_file, prepared.mapping);
    Picture picture(window.value(), panels, std::move(renderer).value(), std::move(holds).value(),
                    {options.stereo, prepared.ghost ? &*prepared.ghost : nullptr, !is_stepped(options)});
    Desk desk;
    Result<std::unique_ptr<EventSource>> made_source = make_source(options, prepared, desk, step_s);
    if (!made_source) {
        return made_source.error();
    }
    const std::unique_ptr<EventSource> source = std::move(made_source).value();
    const PersonOptions of_person{prepared.mapping,
                                  options.pad ? "gamepad" : "mouse",
                                  options.attempt.exercise.root,
                                  static_cast<std::uint64_t>(options.picture_every),
                                  is_stepped(options),
                                  prepared.ghost.has_value()};
    Person person(of_person, *source, desk, prepared.writer ? &*prepared.writer : nullptr);
    AttemptOptions of_attempt = options.attempt;
    of_attempt.guest = &person;
    of_attempt.quiet = true;
    std::optional<Result<AttemptResult>> result;
    std::thread simulation([&] {
        result.emplace(attempt(of_attempt));
        desk.end();
    });
    look_on(options, desk, window.value(), panels, mapping_file, picture, step_s);
    desk.close();
    simulation.join();
    const Status pictured = keep_picture(options, desk, picture, step_s);
    if (!pictured) {
        return pictured.error();
    }
    if (!result->ok()) {
        return result->error();
    }
    const Status kept = prepared.writer ? prepared.writer->finish() : success();
    if (!kept) {
        return kept.error();
    }
    return std::move(*result).value();
}

}  // namespace
}  // namespace rhexis::station

extern "C" __attribute__((visibility("default"))) void rhexis_station_train(
    const rhexis::station::StationOptions& options, rhexis::Result<rhexis::AttemptResult>& result) {
    result = rhexis::station::train(options);
}
