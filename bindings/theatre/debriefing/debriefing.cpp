// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis replay --window: a recording is looked at again, by who operated and who teaches.
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/clock.hpp"
#include "render/image_file.hpp"
#include "render/renderer.hpp"
#include "station/station.hpp"
#include "station/window/fitted_renderer.hpp"
#include "station/window/read_window.hpp"
#include "theatre/debriefing/debriefing_panels.hpp"
#include "theatre/debriefing/free_camera.hpp"
#include "trial/rescore.hpp"

namespace rhexis::station {
namespace {

constexpr double turn_deg = 180.0;  ///< of the camera, per height of the window
constexpr double zoom_per_notch = 1.15;
constexpr double key_step_s = 1.0;
constexpr double mark_lead_s = 1.0;  ///< before a mark, to see how it came
constexpr double poll_s = 0.01;

/// What the exercise says of it; without one the picture still plays.
Story judged(const Recording& recording, const DebriefingOptions& options) {
    ExerciseOptions of_exercise = judge_of(recording, recording.header.curriculum, options.root);
    if (!options.language.empty()) {
        of_exercise.set["language"] = options.language;
    }
    const Result<Rescore> rescored = rescore(recording, of_exercise);
    Story story;
    if (rescored) {
        story = story_of(rescored.value().result);
        story.fault = rescored.value().script_error;
    } else {
        story.title = recording.header.curriculum;
        story.fault = rescored.error().text();
    }
    return story;
}

/// What keys and the cursor do over the picture.
class Controls {
public:
    explicit Controls(const Story& story) : story_(story) {}

    void take(const UserEvent& event, bool over_panel, DebriefingState& state, FreeCamera& camera) {
        const bool down = event.value > 0.5;
        if (event.kind == EventKind::key && down) {
            press(event.name, state, camera);
        } else if (event.kind == EventKind::button && event.name == "right") {
            turns_ = down && !over_panel;
        } else if (event.kind == EventKind::wheel && !over_panel) {
            camera.zoom(std::pow(zoom_per_notch, event.value));
        } else if (event.kind == EventKind::pointer) {
            if (turns_) {
                camera.turn(-turn_deg * (event.x - x_), -turn_deg * (event.y - y_));
            }
            x_ = event.x;
            y_ = event.y;
        }
    }

private:
    void press(const std::string& key, DebriefingState& state, FreeCamera& camera) const {
        if (key == "Space") {
            state.plays = !state.plays;
        } else if (key == "Left" || key == "Right") {
            state.time_s += key == "Left" ? -key_step_s : key_step_s;
        } else if (key == "N" || key == "B") {
            jump(key == "N", state);
        } else if (key == "R") {
            camera.reset();
        } else if (key == "H") {
            state.shows_ghost = !state.shows_ghost;
        }
    }

    void jump(bool forward, DebriefingState& state) const {
        const double now_s = state.time_s + mark_lead_s;
        constexpr double same_s = 0.05;
        std::optional<double> to;
        for (const StoryMark& mark : story_.marks) {
            if (forward ? mark.time_s > now_s + same_s : mark.time_s < now_s - same_s) {
                to = forward && to ? *to : mark.time_s;
            }
        }
        if (to) {
            state.time_s = std::max(0.0, *to - mark_lead_s);
        }
    }

    const Story& story_;
    bool turns_ = false;
    double x_ = 0.0;
    double y_ = 0.0;
};

void grant(const DebriefingWish& wish, DebriefingState& state, FreeCamera& camera) {
    state.time_s = wish.time_s.value_or(state.time_s);
    state.plays = wish.plays.value_or(state.plays);
    state.speed = wish.speed.value_or(state.speed);
    state.shows_ghost = state.shows_ghost != wish.toggles_ghost;
    if (wish.resets_camera) {
        camera.reset();
    }
}

struct DebriefingParts {
    Story story;
    Words words;
    Ghost own;
    std::optional<Ghost> expert;
    std::string notice;
};

Result<DebriefingParts> prepare_debriefing(const Recording& recording, const DebriefingOptions& options) {
    const std::vector<std::string>& instruments = recording.header.scene.instruments;
    Result<Words> words = Words::load(options.root, options.language, instruments);
    if (!words) {
        return words.error();
    }
    Result<Ghost> own = Ghost::read(options.recording, instruments);
    if (!own) {
        return own.error();
    }
    DebriefingParts prepared{judged(recording, options), std::move(words).value(), std::move(own).value(), std::nullopt,
                             ""};
    if (!options.ghost.empty()) {
        Result<Ghost> expert = Ghost::read(options.ghost, instruments);
        if (!expert) {
            return expert.error();
        }
        prepared.expert.emplace(std::move(expert).value());
    }
    prepared.notice = recording.whole ? "" : recording.fault;
    return prepared;
}

/// What lists and time line leave.
ScreenArea picture_area(int width, int height) {
    return {0, line_height, std::max(64, width - side_width), std::max(64, height - line_height)};
}

class Debriefing {
public:
    /// All of it outlives the debriefing.
    Debriefing(const DebriefingOptions& options, const Recording& recording, DebriefingParts& prepared, Window& window,
               FittedRenderer renderer)
        : options_(options),
          prepared_(prepared),
          window_(window),
          renderer_(std::move(renderer)),
          panels_(window, prepared.words, prepared.story, recording.header.scene.instruments),
          player_(recording),
          controls_(panels_.story()),
          step_s_(recording.header.scene.step_s),
          begun_s_(wall_seconds()),
          before_s_(begun_s_) {
        state_.end_s = recording.steps.back().observation.time_s;
        state_.time_s = std::clamp(options.at_s, 0.0, state_.end_s);
        camera_.turn(options.right_deg, options.up_deg);
    }

    Status run() {
        while (heed_devices()) {
            go_on();
            const std::shared_ptr<const PlayedMoment> moment = player_.newest();
            draw(moment.get());
            if (is_enough(moment.get())) {
                break;
            }
            window_.present();
        }
        return options_.screenshot.empty() ? success() : write_png(read_window(window_), options_.screenshot);
    }

private:
    /// False: the window is closed.
    bool heed_devices() {
        bool open = true;
        for (const UserEvent& event : window_.poll(poll_s)) {
            const bool escape = event.kind == EventKind::key && event.name == "Escape";
            open = open && event.kind != EventKind::quit && !escape;
            controls_.take(event, panels_.holds_cursor(), state_, camera_);
        }
        return open;
    }

    void go_on() {
        const double now_s = wall_seconds();
        if (state_.plays) {
            state_.time_s += state_.speed * (now_s - before_s_);
            state_.plays = state_.time_s < state_.end_s;
        }
        before_s_ = now_s;
        state_.time_s = std::clamp(state_.time_s, 0.0, state_.end_s);
        state_.free_camera = camera_.is_free();
        player_.go_to(static_cast<std::uint64_t>(std::llround(state_.time_s / step_s_)));
    }

    void draw(const PlayedMoment* moment) {
        const int width = window_.width();
        const int height = window_.height();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, width, height);
        const ScreenArea area = picture_area(width, height);
        renderer_.fit(area.width, area.height, 1.0, wall_seconds());
        glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        View view;
        if (moment != nullptr) {
            const Frame& frame = moment->frame;
            const Camera seen = camera_.of(microscope_camera(frame));
            renderer_.show(frame, seen, area, Stereo::off);
            view = frame.eye ? view_through_cornea(seen, area.width, area.height, *frame.eye)
                             : view_in_air(seen, area.width, area.height);
        }
        const std::string fault = player_.fault();
        grant(panels_.draw(state_, moment, view, prepared_.own, prepared_.expert ? &*prepared_.expert : nullptr,
                           fault.empty() ? prepared_.notice : fault),
              state_, camera_);
    }

    [[nodiscard]] bool is_enough(const PlayedMoment* moment) const {
        const bool there = moment != nullptr && std::abs(moment->frame.time_s - state_.time_s) < 1.5 * step_s_;
        return options_.seconds > 0.0 && wall_seconds() - begun_s_ > options_.seconds &&
               (there || state_.plays || !player_.fault().empty());
    }

    const DebriefingOptions& options_;
    DebriefingParts& prepared_;
    Window& window_;
    FittedRenderer renderer_;
    DebriefingPanels panels_;
    Player player_;
    Controls controls_;
    FreeCamera camera_;
    DebriefingState state_;
    double step_s_;
    double begun_s_;
    double before_s_;
};

Status debrief(const DebriefingOptions& options) {
    const Result<Recording> recording = read_recording(options.recording);
    if (!recording) {
        return recording.error();
    }
    if (recording.value().steps.empty()) {
        return Error{"the recording holds no step", options.recording, "one of an attempt"};
    }
    Result<DebriefingParts> prepared = prepare_debriefing(recording.value(), options);
    if (!prepared) {
        return prepared.error();
    }
    Result<Window> window =
        Window::open("rhexis: " + prepared.value().story.title, options.width, options.height, options.full_screen);
    if (!window) {
        return window.error();
    }
    if (const Status drawable = window.value().draw_here(); !drawable) {
        return drawable;
    }
    const ScreenArea area = picture_area(window.value().width(), window.value().height());
    Result<FittedRenderer> renderer = FittedRenderer::create(area.width, area.height);
    if (!renderer) {
        return renderer.error();
    }
    return Debriefing(options, recording.value(), prepared.value(), window.value(), std::move(renderer).value()).run();
}

}  // namespace
}  // namespace rhexis::station

extern "C" __attribute__((visibility("default"))) void rhexis_station_debrief(
    const rhexis::station::DebriefingOptions& options, rhexis::Status& status) {
    status = rhexis::station::debrief(options);
}
