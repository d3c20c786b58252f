// SPDX-License-Identifier: GPL-3.0-or-later
// rhexis monitor: looks at a station's moments, in a window, as lines of JSON, or only to ask for something.
#include <epoxy/gl.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <utility>

#include "base/clock.hpp"
#include "render/image_file.hpp"
#include "station/station.hpp"
#include "station/window/read_window.hpp"
#include "theatre/link.hpp"
#include "theatre/monitor/monitor_panels.hpp"

namespace rhexis::station {
namespace {

constexpr double every_s = 0.05;  ///< between two pictures of the monitor
constexpr double stalled_after_s = 2.0;
constexpr double asks_for_s = 3.0;  ///< so long for a station that takes a request

/// "inject cough", "rewind 10", "note any text" as an event.
Result<UserEvent> request_of(const std::string& text) {
    const std::size_t space = text.find(' ');
    UserEvent event{EventKind::staff, text.substr(0, space), 0.0, 0.0, 0.0, ""};
    const std::string rest = space == std::string::npos ? "" : text.substr(space + 1);
    const std::string& what = event.name;
    const bool number = what == "rewind" || what == "warn";
    const bool word = what == "inject" || what == "put_right" || what == "level" || what == "note";
    const bool alone = what == "pause" || what == "go_on";
    char* end = nullptr;
    event.value = number ? std::strtod(rest.c_str(), &end) : 0.0;
    const bool good_number = number && !rest.empty() && *end == '\0' && std::isfinite(event.value);
    if (!(good_number || (word && !rest.empty()) || (alone && rest.empty()))) {
        return Error{"--ask '" + text + "' is nothing that can be asked for", "",
                     "inject ID, put_right ID, level NAME, note TEXT, rewind SECONDS, pause, go_on, warn 0 or 1"};
    }
    event.control = word ? rest : "";
    return event;
}

Status ask_once(const MonitorOptions& options, TheatreView& view) {
    const Result<UserEvent> request = request_of(options.request);
    if (!request) {
        return request.error();
    }
    if (!view.ask(request.value(), asks_for_s)) {
        return Error{"no station took it", options.address, "rhexis train --monitor, or --theatre ADDRESS for both"};
    }
    return success();
}

/// When it is enough.
class Span {
public:
    explicit Span(const MonitorOptions& options) : options_(options), begun_s_(wall_seconds()) {}
    [[nodiscard]] bool over(bool ended) const {
        return (options_.once && ended) || (options_.seconds > 0.0 && wall_seconds() - begun_s_ > options_.seconds);
    }

private:
    const MonitorOptions& options_;
    double begun_s_;
};

Status print_all(const MonitorOptions& options, TheatreView& view) {
    const Span span(options);
    bool ended = false;
    while (!span.over(ended) && std::cout) {
        if (const std::optional<TheatreMoment> moment = view.newest(every_s)) {
            std::cout << nlohmann::json(*moment).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)
                      << std::endl;
            ended = moment->ended;
        }
    }
    return success();
}

Status show_all(const MonitorOptions& options, TheatreView& view) {
    Result<Words> words = Words::load(options.root, options.language, {});
    if (!words) {
        return words.error();
    }
    const std::string title = words.value()("theatre's monitor");
    Result<Window> window = Window::open("rhexis: " + title, options.width, options.height, false);
    if (!window) {
        return window.error();
    }
    if (const Status drawable = window.value().draw_here(); !drawable) {
        return drawable;
    }
    MonitorPanels panels(window.value(), std::move(words).value());
    const Span span(options);
    News news = News::none;
    double last_s = wall_seconds();
    bool ended = false;
    Image image;
    for (bool open = true; open;) {
        if (const std::optional<TheatreMoment> moment = view.newest(every_s)) {
            panels.take(*moment);
            ended = moment->ended;
            news = News::fresh;
            last_s = wall_seconds();
        } else if (view.strange()) {
            news = News::strange;
        } else if (news == News::fresh && wall_seconds() - last_s > stalled_after_s) {
            news = News::stalled;
        }
        for (const UserEvent& event : window.value().poll()) {
            open = open && event.kind != EventKind::quit;
        }
        open = open && !span.over(ended);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, window.value().width(), window.value().height());
        glClearColor(0.02F, 0.03F, 0.04F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        for (const UserEvent& asked : panels.draw(news, wall_seconds() - last_s, options.address)) {
            if (!view.ask(asked, 0.0)) {
                panels.notice("no station takes it");
            }
        }
        if (!open && !options.screenshot.empty()) {
            image = read_window(window.value());
        }
        window.value().present();
    }
    return options.screenshot.empty() ? success() : write_png(image, options.screenshot);
}

Status monitor(const MonitorOptions& options) {
    Result<std::unique_ptr<TheatreView>> view = TheatreView::open(options.address);
    if (!view) {
        return view.error();
    }
    if (!options.request.empty()) {
        return ask_once(options, *view.value());
    }
    return options.json ? print_all(options, *view.value()) : show_all(options, *view.value());
}

}  // namespace
}  // namespace rhexis::station

extern "C" __attribute__((visibility("default"))) void rhexis_station_monitor(
    const rhexis::station::MonitorOptions& options, rhexis::Status& status) {
    status = rhexis::station::monitor(options);
}
