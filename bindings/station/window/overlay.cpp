// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/overlay.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <backends/imgui_impl_sdl.h>
#include <imgui.h>

#include <array>
#include <filesystem>

namespace rhexis::station {
namespace {

constexpr const char* font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float font_pixels = 15.0F;

/// Latin letters with all accents, ligatures, dashes, quotation marks and points; pairs end with 0.
constexpr std::array<ImWchar, 7> letters = {0x20, 0x17F, 0x2010, 0x2026, 0x20AC, 0x20AC, 0};

/// Dear ImGui's own has no letters beyond Latin 1; it does where that font is not installed.
void load_font() {
    std::error_code unknown;
    if (std::filesystem::exists(font, unknown)) {
        ImGui::GetIO().Fonts->AddFontFromFileTTF(font, font_pixels, nullptr, letters.data());
    }
}

}  // namespace

Overlay::Overlay(Window& window) : window_(window) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
    ImGui::StyleColorsDark();
    load_font();
    ImGui_ImplSDL2_InitForOpenGL(window.handle(), window.context());
    ImGui_ImplOpenGL3_Init("#version 330");
}

Overlay::~Overlay() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
}

void Overlay::begin() {
    for (const SDL_Event& event : window_.take_raw()) {
        ImGui_ImplSDL2_ProcessEvent(&event);
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplSDL2_NewFrame();
    ImGui::NewFrame();
}

void Overlay::end() const {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace rhexis::station
