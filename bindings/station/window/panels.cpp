// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/panels.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace rhexis::station {
namespace {

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

UserEvent worked(ControlId id, double value = 1.0) { return {EventKind::control, control(id).name, value, 0.0, 0.0}; }

std::string held(const Shown& shown, const Stand& stand, int which) {
    const HandState& hand = shown.hands.hands[static_cast<std::size_t>(which)];
    return hand.instrument < 0 ? "-" : stand.instruments[static_cast<std::size_t>(hand.instrument)].name;
}

void draw_state(const Shown& shown, const Stand& stand, const DrawingRate& rate) {
    ImGui::SetNextWindowPos({8.0F, 8.0F});
    ImGui::SetNextWindowBgAlpha(0.45F);
    ImGui::Begin("state", nullptr, plain | ImGuiWindowFlags_NoInputs);
    ImGui::Text("%.1f s   pedal %.1f", shown.frame.time_s, shown.hands.pedal);
    ImGui::Text("%s leading: %s", shown.hands.moving == leading ? ">" : " ", held(shown, stand, leading).c_str());
    ImGui::Text("%s other:   %s", shown.hands.moving == other ? ">" : " ", held(shown, stand, other).c_str());
    if (!stand.dials.empty()) {
        const auto at = static_cast<std::size_t>(shown.hands.dial);
        const Dial& dial = stand.dials[at];
        ImGui::Text("%s = %g %s", dial.setting.c_str(), shown.hands.dials[at],
                    dial.unit == "1" ? "" : dial.unit.c_str());
    }
    if (!stand.requests.empty()) {
        ImGui::Text("ask: %s", stand.requests[static_cast<std::size_t>(shown.hands.request)].title.c_str());
    }
    if (rate.size < 1.0) {
        ImGui::Text("%.0f pictures/s, at %.0f %% of the size", rate.pictures_per_s, 100.0 * rate.size);
    } else {
        ImGui::Text("%.0f pictures/s", rate.pictures_per_s);
    }
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

/// What is worked by the devices that are there: of a pad nothing where there is none.
std::string shown_inputs(const Mapping& mapping, ControlId id) {
    const bool pad = mapping.inputs_of(ControlId::tip).empty();
    std::string shown;
    std::istringstream inputs(mapping.inputs_of(id));
    for (std::string one; std::getline(inputs, one, ',');) {
        one.erase(0, one.find_first_not_of(' '));
        if (pad || (!one.starts_with("pad.") && !one.starts_with("pedal."))) {
            shown += (shown.empty() ? "" : ", ") + one;
        }
    }
    return shown;
}

void draw_help(const Mapping& mapping) {
    std::vector<std::pair<std::string, const char*>> rows;
    for (const Control& one : control_table()) {
        if (std::string inputs = shown_inputs(mapping, one.id); !inputs.empty()) {
            rows.emplace_back(std::move(inputs), one.meaning);
        }
    }
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x - 8.0F, 8.0F}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.9F);
    ImGui::Begin("help", nullptr, plain);
    ImGui::SetWindowFontScale(
        std::min(1.0F, (size.y - 40.0F) / (static_cast<float>(rows.size()) * ImGui::GetTextLineHeightWithSpacing())));
    if (ImGui::BeginTable("controls", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const auto& [inputs, meaning] : rows) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(inputs.c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(meaning);
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

/// Where an expert's tip went on from about here: the nearer its depth, the whiter; below it blue, above it yellow.
void draw_ghost(const Shown& shown, const Ghost& ghost) {
    const HandState& hand = shown.hands.hands[static_cast<std::size_t>(shown.hands.moving)];
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    constexpr double shown_s = 3.0;
    constexpr double far_mm = 1.0;
    for (const Vec3& place : ghost.ahead(hand.instrument, hand.tip, shown_s)) {
        const Cursor cursor = shown.around.sight.cursor_on(place, hand.inside);
        const auto higher = static_cast<float>(std::clamp((place.z() - hand.tip.z()) / far_mm, -1.0, 1.0));
        const ImVec4 colour(1.0F - std::max(0.0F, -higher), 1.0F - 0.3F * std::abs(higher),
                            1.0F - std::max(0.0F, higher), 0.8F);
        ImGui::GetBackgroundDrawList()->AddCircleFilled({0.5F * size.x + static_cast<float>(cursor.x()) * size.y,
                                                         0.5F * size.y - static_cast<float>(cursor.y()) * size.y},
                                                        3.0F, ImGui::ColorConvertFloat4ToU32(colour));
    }
}

void draw_next(const std::string& text) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.5F * io.DisplaySize.x, 8.0F}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.6F);
    const ImVec2 wide = ImGui::CalcTextSize(text.c_str());
    ImGui::SetNextWindowSize({wide.x + 20.0F, wide.y + 18.0F});
    ImGui::Begin("next", nullptr, plain | ImGuiWindowFlags_NoInputs);
    ImGui::TextColored({0.5F, 1.0F, 0.6F, 1.0F}, "%s", text.c_str());
    ImGui::End();
}

/// While the clock stands the cursor is free to choose.
void draw_stand(const Shown& shown, const Stand& stand, std::vector<UserEvent>& clicked) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.5F * io.DisplaySize.x, 0.5F * io.DisplaySize.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.85F);
    ImGui::Begin("stand", nullptr, plain);
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
    if (!stand.dials.empty()) {
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
        ImGui::Text("%s = %g", stand.dials[at].setting.c_str(), shown.hands.dials[at]);
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

std::vector<UserEvent> Panels::draw(const Shown& shown, const Mapping& mapping, const Ghost* ghost,
                                    const DrawingRate& rate) {
    const Stand& stand = *shown.stand;
    std::vector<UserEvent> clicked;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    ImGui::NewFrame();
    if (shown.hands.ghost && ghost != nullptr) {
        draw_ghost(shown, *ghost);
    }
    if (const std::optional<std::string> next = guide_.next(shown.hands, stand, mapping)) {
        draw_next(*next);
    }
    draw_state(shown, stand, rate);
    draw_lines(shown);
    if (shown.hands.help) {
        draw_help(mapping);
    }
    if (shown.hands.paused) {
        draw_stand(shown, stand, clicked);
    }
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return clicked;
}

}  // namespace rhexis::station
