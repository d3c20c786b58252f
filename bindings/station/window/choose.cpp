// SPDX-License-Identifier: GPL-3.0-or-later
// The menu before an exercise: what to do, on whom, how hard, and whether hands and pictures are ready.
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/clock.hpp"
#include "base/numbers.hpp"
#include "station/menu.hpp"
#include "station/window/overlay.hpp"
#include "station/window/window.hpp"
#include "station/words.hpp"

namespace rhexis::station {
namespace {

constexpr int width = 900;
constexpr int height = 620;

/// What is chosen so far, and what was found out meanwhile.
struct Choosing {
    int exercise = 0;
    int patient = 0;  ///< 0: as the exercise says
    int level = 0;    ///< 0: as it is
    bool pad = false;
    bool pad_there = false;
    bool pedal_there = false;
    double pictures_per_s = 0.0;
    bool begin = false;
    bool leave = false;
};

/// The first lesson that nobody tried here.
int first_new(const Menu& menu) {
    const auto found = std::find_if(menu.exercises.begin(), menu.exercises.end(),
                                    [](const MenuExercise& one) { return one.last.empty(); });
    return found == menu.exercises.end() ? 0 : static_cast<int>(found - menu.exercises.begin());
}

void draw_list(const Menu& menu, const Words& words, Choosing& now) {
    ImGui::BeginChild("exercises", {0.42F * ImGui::GetContentRegionAvail().x, 0.0F}, true);
    for (int i = 0; i < static_cast<int>(menu.exercises.size()); ++i) {
        const MenuExercise& one = menu.exercises[static_cast<std::size_t>(i)];
        if (i == 0 || one.lesson != menu.exercises[static_cast<std::size_t>(i - 1)].lesson) {
            ImGui::TextDisabled("%s", words(one.lesson ? "Lessons, in this order" : "Drills").c_str());
        }
        ImGui::PushID(i);
        if (ImGui::Selectable(one.title.c_str(), now.exercise == i, ImGuiSelectableFlags_AllowDoubleClick)) {
            now.exercise = i;
            now.level = 0;
            now.begin = ImGui::IsMouseDoubleClicked(0);
        }
        if (i == now.exercise && ImGui::IsWindowAppearing()) {
            ImGui::SetItemDefaultFocus();
        }
        ImGui::PopID();
    }
    ImGui::EndChild();
}

void draw_levels(const MenuExercise& exercise, const Words& words, Choosing& now) {
    const auto& levels = exercise.levels;
    const std::string shown = now.level == 0 ? words("as it is") : levels[static_cast<std::size_t>(now.level - 1)];
    if (levels.empty() || !ImGui::BeginCombo(words("Difficulty").c_str(), shown.c_str())) {
        return;
    }
    for (int i = 0; i <= static_cast<int>(levels.size()); ++i) {
        const std::string name = i == 0 ? words("as it is") : levels[static_cast<std::size_t>(i - 1)];
        if (ImGui::Selectable(name.c_str(), now.level == i)) {
            now.level = i;
        }
    }
    ImGui::EndCombo();
}

void draw_patients(const Menu& menu, const Words& words, Choosing& now) {
    const auto note = [&](int i) {
        return i == 0 ? words("as the exercise says") : menu.patients[static_cast<std::size_t>(i - 1)].note;
    };
    if (!ImGui::BeginCombo(words("Patient").c_str(), note(now.patient).c_str())) {
        return;
    }
    for (int i = 0; i <= static_cast<int>(menu.patients.size()); ++i) {
        if (ImGui::Selectable(note(i).c_str(), now.patient == i)) {
            now.patient = i;
        }
    }
    ImGui::EndCombo();
}

void draw_check(const Words& words, Choosing& now) {
    ImGui::Separator();
    ImGui::TextUnformatted(words("This machine").c_str());
    ImGui::BulletText("%s",
                      words("%s pictures/s of this menu", {short_number(std::round(now.pictures_per_s))}).c_str());
    ImGui::BulletText("%s", words(now.pad_there ? "gamepad: found" : "gamepad: none").c_str());
    ImGui::BulletText("%s",
                      words(now.pedal_there ? "pedal: found" : "pedal: none; keys 0 to 3 and Space press it").c_str());
    if (ImGui::RadioButton(words("Mouse and keys").c_str(), !now.pad)) {
        now.pad = false;
    }
    ImGui::SameLine();
    if (ImGui::RadioButton(words("Gamepad").c_str(), now.pad)) {
        now.pad = true;
    }
}

void draw_chosen(const Menu& menu, const Words& words, Choosing& now) {
    const MenuExercise& one = menu.exercises[static_cast<std::size_t>(now.exercise)];
    ImGui::BeginChild("chosen", {0.0F, 0.0F}, true);
    ImGui::TextWrapped("%s", one.title.c_str());
    ImGui::TextDisabled("rhexis train %s", one.name.c_str());
    for (const std::string& objective : one.objectives) {
        ImGui::Bullet();
        ImGui::TextWrapped("%s", objective.c_str());
    }
    ImGui::TextWrapped("%s", words("Last time: %s", {one.last.empty() ? words("not yet") : one.last}).c_str());
    ImGui::Separator();
    draw_patients(menu, words, now);
    draw_levels(one, words, now);
    draw_check(words, now);
    ImGui::Separator();
    ImGui::TextWrapped("%s",
                       words("In the exercise: F1 shows all keys; E takes an instrument, F brings the hand to it, the "
                             "mouse moves its tip and the wheel its depth; 1, 2, 3 press the pedal; P stops the "
                             "clock.")
                           .c_str());
    // at one place, whatever the exercise has to say
    const ImVec2 size(110.0F, 32.0F);
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), ImGui::GetWindowHeight() - size.y - 12.0F));
    now.begin = ImGui::Button(words("Begin").c_str(), size) || now.begin;
    ImGui::SameLine();
    now.leave = ImGui::Button(words("Leave").c_str(), size);
    ImGui::EndChild();
}

void draw(const Menu& menu, const Words& words, Choosing& now) {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.0F, 0.0F});
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::Begin("rhexis", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    draw_list(menu, words, now);
    ImGui::SameLine();
    draw_chosen(menu, words, now);
    ImGui::End();
}

void heed(const std::vector<UserEvent>& events, Choosing& now) {
    for (const UserEvent& event : events) {
        now.leave = now.leave || event.kind == EventKind::quit ||
                    (event.kind == EventKind::key && event.name == "Escape" && event.value > 0.5);
        if (event.kind == EventKind::device) {
            (event.name == "pad" ? now.pad_there : now.pedal_there) = event.value > 0.5;
        }
    }
}

Result<MenuChoice> choose(const Menu& menu) {
    Result<Window> window = Window::open("rhexis", width, height, false);
    if (!window) {
        return window.error();
    }
    if (const Status drawable = window.value().draw_here(); !drawable) {
        return drawable.error();
    }
    Overlay overlay(window.value());
    const Result<Words> words = Words::load(menu.root, menu.language, {});
    if (!words) {
        return words.error();
    }
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard | ImGuiConfigFlags_NavEnableGamepad;
    Choosing now;
    now.exercise = first_new(menu);
    double began = wall_seconds();
    int pictures = 0;
    while (!now.begin && !now.leave) {
        heed(window.value().poll(), now);
        glViewport(0, 0, window.value().width(), window.value().height());
        glClearColor(0.05F, 0.06F, 0.07F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
        overlay.begin();
        draw(menu, words.value(), now);
        overlay.end();
        window.value().present();
        if (++pictures % 20 == 0) {
            now.pictures_per_s = 20.0 / std::max(1e-6, wall_seconds() - began);
            began = wall_seconds();
        }
    }
    if (!now.begin) {
        return MenuChoice{};
    }
    const MenuExercise& one = menu.exercises[static_cast<std::size_t>(now.exercise)];
    return MenuChoice{one.name, now.patient == 0 ? "" : menu.patients[static_cast<std::size_t>(now.patient - 1)].file,
                      now.level == 0 ? "" : one.levels[static_cast<std::size_t>(now.level - 1)], now.pad};
}

}  // namespace
}  // namespace rhexis::station

extern "C" __attribute__((visibility("default"))) void rhexis_station_choose(
    const rhexis::station::Menu& menu, rhexis::Result<rhexis::station::MenuChoice>& choice) {
    choice = rhexis::station::choose(menu);
}
