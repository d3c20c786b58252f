// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/panels.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include <algorithm>

namespace rhexis::station {
namespace {

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

UserEvent worked(ControlId id, double value = 1.0) { return {EventKind::control, control(id).name, value, 0.0, 0.0}; }

std::string held(const Shown& shown, const Tray& tray, int which) {
    const HandState& hand = shown.hands.hands[static_cast<std::size_t>(which)];
    return hand.instrument < 0 ? "-" : tray.instruments[static_cast<std::size_t>(hand.instrument)].name;
}

void draw_state(const Shown& shown, const Tray& tray, double pictures_per_s) {
    ImGui::SetNextWindowPos({8.0F, 8.0F});
    ImGui::SetNextWindowBgAlpha(0.45F);
    ImGui::Begin("state", nullptr, plain | ImGuiWindowFlags_NoInputs);
    ImGui::Text("%.1f s   pedal %.1f", shown.frame.time_s, shown.hands.pedal);
    ImGui::Text("%s leading: %s", shown.hands.moving == leading ? ">" : " ", held(shown, tray, leading).c_str());
    ImGui::Text("%s other:   %s", shown.hands.moving == other ? ">" : " ", held(shown, tray, other).c_str());
    if (!tray.dials.empty()) {
        const auto at = static_cast<std::size_t>(shown.hands.dial);
        const Dial& dial = tray.dials[at];
        ImGui::Text("%s = %g %s", dial.setting.c_str(), shown.hands.dials[at],
                    dial.unit == "1" ? "" : dial.unit.c_str());
    }
    if (!tray.requests.empty()) {
        ImGui::Text("ask: %s", tray.requests[static_cast<std::size_t>(shown.hands.request)].title.c_str());
    }
    ImGui::Text("%.0f pictures/s", pictures_per_s);
    if (shown.slowed < 0.97) {
        ImGui::TextColored({1.0F, 0.8F, 0.2F, 1.0F}, "slow clock: %.0f %%", 100.0 * shown.slowed);
    }
    ImGui::End();
}

void draw_lines(const Shown& shown) {
    if (shown.lines.empty() && shown.hands.word.empty()) {
        return;
    }
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.5F * io.DisplaySize.x, io.DisplaySize.y - 8.0F}, ImGuiCond_Always, {0.5F, 1.0F});
    ImGui::SetNextWindowBgAlpha(0.55F);
    ImGui::Begin("lines", nullptr, plain | ImGuiWindowFlags_NoInputs);
    ImGui::PushTextWrapPos(0.8F * io.DisplaySize.x);
    for (const std::string& line : shown.lines) {
        ImGui::TextWrapped("%s", line.c_str());
    }
    if (!shown.hands.word.empty()) {
        ImGui::TextColored({1.0F, 0.8F, 0.2F, 1.0F}, "%s", shown.hands.word.c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void draw_help(const Mapping& mapping) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({io.DisplaySize.x - 8.0F, 8.0F}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.8F);
    ImGui::Begin("help", nullptr, plain);
    for (const Control& one : control_table()) {
        const std::string inputs = mapping.inputs_of(one.id);
        if (!inputs.empty()) {
            ImGui::Text("%-18s %s", inputs.c_str(), one.meaning);
        }
    }
    ImGui::End();
}

/// While the clock stands the cursor is free to choose.
void draw_tray(const Shown& shown, const Tray& tray, std::vector<UserEvent>& clicked) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.5F * io.DisplaySize.x, 0.5F * io.DisplaySize.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.85F);
    ImGui::Begin("tray", nullptr, plain);
    ImGui::TextUnformatted("The clock stands.");
    if (ImGui::Button("Go on")) {
        clicked.push_back(worked(ControlId::pause));
    }
    ImGui::Separator();
    if (ImGui::Button("Next instrument")) {
        clicked.push_back(worked(ControlId::next_instrument));
    }
    ImGui::SameLine();
    if (ImGui::Button("Put down")) {
        clicked.push_back(worked(ControlId::put_down));
    }
    ImGui::SameLine();
    if (ImGui::Button("Other hand")) {
        clicked.push_back(worked(ControlId::swap));
    }
    if (!tray.dials.empty()) {
        const auto at = static_cast<std::size_t>(shown.hands.dial);
        if (ImGui::Button("Next dial")) {
            clicked.push_back(worked(ControlId::dial_next));
        }
        ImGui::SameLine();
        if (ImGui::Button("-")) {
            clicked.push_back(worked(ControlId::dial_turn, -1.0));
        }
        ImGui::SameLine();
        if (ImGui::Button("+")) {
            clicked.push_back(worked(ControlId::dial_turn, 1.0));
        }
        ImGui::SameLine();
        ImGui::Text("%s = %g", tray.dials[at].setting.c_str(), shown.hands.dials[at]);
    }
    ImGui::Separator();
    if (ImGui::Button("End the exercise")) {
        clicked.push_back(worked(ControlId::stop));
    }
    ImGui::End();
}

}  // namespace

Panels::Panels(const Window& window) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
    ImGui::StyleColorsDark();
    ImGui_ImplSDL2_InitForOpenGL(window.handle(), window.context());
    ImGui_ImplOpenGL3_Init("#version 330");
}

Panels::~Panels() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
}

std::vector<UserEvent> Panels::draw(const Shown& shown, const Tray& tray, const Mapping& mapping,
                                    double pictures_per_s) {
    std::vector<UserEvent> clicked;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    ImGui::NewFrame();
    draw_state(shown, tray, pictures_per_s);
    draw_lines(shown);
    if (shown.hands.help) {
        draw_help(mapping);
    }
    if (shown.hands.paused) {
        draw_tray(shown, tray, clicked);
    }
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return clicked;
}

}  // namespace rhexis::station
