// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/window.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

namespace rhexis::station {
namespace {

constexpr double axis_range = 32767.0;
constexpr double axis_grain = 0.002;  ///< of an axis: less is noise

Error no_window(const std::string& what) {
    return Error{"no window: " + what + ": " + SDL_GetError(), "",
                 "a display (DISPLAY or WAYLAND_DISPLAY) and OpenGL 3.3; rhexis run needs neither"};
}

const char* mouse_button(int button) {
    switch (button) {
        case SDL_BUTTON_LEFT:
            return "left";
        case SDL_BUTTON_MIDDLE:
            return "middle";
        case SDL_BUTTON_RIGHT:
            return "right";
        case SDL_BUTTON_X1:
            return "back";
        default:
            return "forward";
    }
}

}  // namespace

struct Window::Parts {
    SDL_Window* window = nullptr;
    SDL_GLContext context = nullptr;
    std::map<SDL_JoystickID, SDL_GameController*> pads;
    std::map<SDL_JoystickID, SDL_Joystick*> pedals;
    std::map<std::string, double> axes;  ///< last told
    std::mutex raw_mutex;
    std::vector<SDL_Event> raw;  ///< for panels
    bool cursor_taken = false;
    double cursor_x = 0.0;  ///< where it is, or would be: heights of the window from its middle
    double cursor_y = 0.0;

    Parts() = default;
    ~Parts() {
        for (const auto& [id, pad] : pads) {
            SDL_GameControllerClose(pad);
        }
        for (const auto& [id, pedal] : pedals) {
            SDL_JoystickClose(pedal);
        }
        if (context != nullptr) {
            SDL_GL_DeleteContext(context);
        }
        if (window != nullptr) {
            SDL_DestroyWindow(window);
        }
        SDL_Quit();
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void keep_raw(const SDL_Event& event);
    void read(const SDL_Event& event, std::vector<UserEvent>& list);
    void add_device(int index, std::vector<UserEvent>& list);
    void remove_device(SDL_JoystickID id, std::vector<UserEvent>& list);
    void take_another(std::vector<UserEvent>& list);
    void axis(const std::string& name, double value, std::vector<UserEvent>& list);
};

Result<Window> Window::open(const std::string& title, int width, int height, bool full_screen) {
    SDL_SetHint(SDL_HINT_VIDEO_X11_FORCE_EGL, "1");
    SDL_SetHint(SDL_HINT_VIDEO_HIGHDPI_DISABLED, "1");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "0");
    if (SDL_Init(SDL_INIT_VIDEO | SDL_INIT_GAMECONTROLLER | SDL_INIT_JOYSTICK) != 0) {
        return no_window("SDL cannot begin");
    }
    std::unique_ptr<Parts> parts = std::make_unique<Parts>();
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
    const Uint32 flags = SDL_WINDOW_OPENGL |
                         (full_screen ? SDL_WINDOW_FULLSCREEN_DESKTOP | SDL_WINDOW_BORDERLESS : SDL_WINDOW_RESIZABLE);
    parts->window =
        SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height, flags);
    if (parts->window == nullptr) {
        return no_window("it cannot be opened");
    }
    return Window(std::move(parts));
}

Window::Window(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Window::~Window() = default;
Window::Window(Window&&) noexcept = default;

void Window::Parts::axis(const std::string& name, double value, std::vector<UserEvent>& list) {
    double& before = axes[name];
    if (std::abs(value - before) > axis_grain || ((value == 0.0 || std::abs(value) >= 1.0) && value != before)) {
        before = value;
        list.push_back({EventKind::axis, name, value, 0.0, 0.0});
    }
}

void Window::Parts::add_device(int index, std::vector<UserEvent>& list) {
    const bool pad = SDL_IsGameController(index) == SDL_TRUE;
    if (pad && pads.empty()) {  // of several equal ones the first counts
        if (SDL_GameController* opened = SDL_GameControllerOpen(index)) {
            pads[SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(opened))] = opened;
            list.push_back({EventKind::device, "pad", 1.0, 0.0, 0.0});
        }
    } else if (!pad && pedals.empty()) {
        if (SDL_Joystick* opened = SDL_JoystickOpen(index)) {
            pedals[SDL_JoystickInstanceID(opened)] = opened;
            list.push_back({EventKind::device, "pedal", 1.0, 0.0, 0.0});
        }
    }
}

void Window::Parts::remove_device(SDL_JoystickID id, std::vector<UserEvent>& list) {
    if (const auto pad = pads.find(id); pad != pads.end()) {
        SDL_GameControllerClose(pad->second);
        pads.erase(pad);
        list.push_back({EventKind::device, "pad", 0.0, 0.0, 0.0});
        take_another(list);
    } else if (const auto pedal = pedals.find(id); pedal != pedals.end()) {
        SDL_JoystickClose(pedal->second);
        pedals.erase(pedal);
        list.push_back({EventKind::device, "pedal", 0.0, 0.0, 0.0});
        take_another(list);
    }
}

/// In the place of one that has gone.
void Window::Parts::take_another(std::vector<UserEvent>& list) {
    for (int i = 0; i < SDL_NumJoysticks(); ++i) {
        add_device(i, list);
    }
}

/// Of those that panels know, so many as a frozen picture may leave lying.
void Window::Parts::keep_raw(const SDL_Event& event) {
    constexpr std::size_t most = 1000;
    const bool of_panels = event.type == SDL_MOUSEWHEEL || event.type == SDL_MOUSEBUTTONDOWN ||
                           event.type == SDL_MOUSEBUTTONUP || event.type == SDL_MOUSEMOTION ||
                           event.type == SDL_KEYDOWN || event.type == SDL_KEYUP || event.type == SDL_TEXTINPUT ||
                           event.type == SDL_WINDOWEVENT;
    const std::lock_guard lock(raw_mutex);
    if (of_panels && raw.size() < most) {
        raw.push_back(event);
    }
}

void Window::Parts::read(const SDL_Event& event, std::vector<UserEvent>& list) {
    const auto add = [&](EventKind kind, const std::string& name, double value, double x = 0.0, double y = 0.0) {
        list.push_back({kind, name, value, x, y});
    };
    switch (event.type) {
        case SDL_QUIT:
            add(EventKind::quit, "", 0.0);
            break;
        case SDL_KEYDOWN:
        case SDL_KEYUP:
            if (event.key.repeat == 0) {
                add(EventKind::key, SDL_GetKeyName(event.key.keysym.sym), event.type == SDL_KEYDOWN ? 1.0 : 0.0);
            }
            break;
        case SDL_MOUSEMOTION: {
            int w = 1;
            int h = 1;
            SDL_GetWindowSize(window, &w, &h);
            if (cursor_taken) {
                cursor_x += static_cast<double>(event.motion.xrel) / h;
                cursor_y -= static_cast<double>(event.motion.yrel) / h;
            } else {
                cursor_x = (event.motion.x + 0.5 - 0.5 * w) / h;
                cursor_y = (0.5 * h - event.motion.y - 0.5) / h;
            }
            add(EventKind::pointer, "", 0.0, cursor_x, cursor_y);
            break;
        }
        case SDL_MOUSEBUTTONDOWN:
        case SDL_MOUSEBUTTONUP:
            add(EventKind::button, mouse_button(event.button.button), event.type == SDL_MOUSEBUTTONDOWN ? 1.0 : 0.0);
            break;
        case SDL_MOUSEWHEEL:
            add(EventKind::wheel, "", event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -event.wheel.y : event.wheel.y);
            break;
        case SDL_WINDOWEVENT:
            if (event.window.event == SDL_WINDOWEVENT_FOCUS_GAINED ||
                event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) {
                add(EventKind::focus, "", event.window.event == SDL_WINDOWEVENT_FOCUS_GAINED ? 1.0 : 0.0);
            }
            break;
        case SDL_JOYDEVICEADDED:
            add_device(event.jdevice.which, list);
            break;
        case SDL_JOYDEVICEREMOVED:
            remove_device(event.jdevice.which, list);
            break;
        case SDL_CONTROLLERAXISMOTION:
            if (pads.contains(event.caxis.which)) {
                axis(std::string("pad.") +
                         SDL_GameControllerGetStringForAxis(static_cast<SDL_GameControllerAxis>(event.caxis.axis)),
                     std::max(-1.0, event.caxis.value / axis_range), list);
            }
            break;
        case SDL_CONTROLLERBUTTONDOWN:
        case SDL_CONTROLLERBUTTONUP:
            if (pads.contains(event.cbutton.which)) {
                add(EventKind::press,
                    std::string("pad.") + SDL_GameControllerGetStringForButton(
                                              static_cast<SDL_GameControllerButton>(event.cbutton.button)),
                    event.type == SDL_CONTROLLERBUTTONDOWN ? 1.0 : 0.0);
            }
            break;
        case SDL_JOYAXISMOTION:
            if (pedals.contains(event.jaxis.which)) {
                axis("pedal." + std::to_string(event.jaxis.axis), std::max(-1.0, event.jaxis.value / axis_range), list);
            }
            break;
        case SDL_JOYBUTTONDOWN:
        case SDL_JOYBUTTONUP:
            if (pedals.contains(event.jbutton.which)) {
                add(EventKind::press, "pedal.button" + std::to_string(event.jbutton.button),
                    event.type == SDL_JOYBUTTONDOWN ? 1.0 : 0.0);
            }
            break;
        default:
            break;
    }
}

std::vector<UserEvent> Window::poll(double longest_s) {
    std::vector<UserEvent> list;
    SDL_Event event;
    const int longest_ms = static_cast<int>(1e3 * longest_s);
    bool any = longest_ms > 0 ? SDL_WaitEventTimeout(&event, longest_ms) != 0 : SDL_PollEvent(&event) != 0;
    for (; any; any = SDL_PollEvent(&event) != 0) {
        parts_->keep_raw(event);
        parts_->read(event, list);
    }
    return list;
}

std::vector<SDL_Event> Window::take_raw() {
    const std::lock_guard lock(parts_->raw_mutex);
    return std::exchange(parts_->raw, {});
}

Status Window::draw_here() {
    parts_->context = SDL_GL_CreateContext(parts_->window);
    if (parts_->context == nullptr) {
        return no_window("there is no OpenGL 3.3 for it");
    }
    SDL_GL_SetSwapInterval(1);
    return success();
}

void Window::let_go() { SDL_GL_DeleteContext(std::exchange(parts_->context, nullptr)); }

int Window::width() const {
    int w = 0;
    SDL_GL_GetDrawableSize(parts_->window, &w, nullptr);
    return w;
}

int Window::height() const {
    int h = 0;
    SDL_GL_GetDrawableSize(parts_->window, nullptr, &h);
    return h;
}

void Window::present() { SDL_GL_SwapWindow(parts_->window); }

void Window::take_cursor(bool taken) {
    Parts& p = *parts_;
    if (taken == p.cursor_taken || SDL_SetRelativeMouseMode(taken ? SDL_TRUE : SDL_FALSE) != 0) {
        return;
    }
    p.cursor_taken = taken;
    if (!taken) {  // it appears where it was led to, or at the edge
        int w = 1;
        int h = 1;
        SDL_GetWindowSize(p.window, &w, &h);
        SDL_WarpMouseInWindow(p.window, std::clamp(static_cast<int>(p.cursor_x * h + 0.5 * w), 0, w - 1),
                              std::clamp(static_cast<int>(0.5 * h - p.cursor_y * h), 0, h - 1));
    }
}

SDL_Window* Window::handle() const { return parts_->window; }
void* Window::context() const { return parts_->context; }

}  // namespace rhexis::station
