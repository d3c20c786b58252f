// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre/debriefing/debriefing_panels.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "flow/globe.hpp"

namespace rhexis::station {
namespace {

constexpr ImGuiWindowFlags panel_flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
constexpr float side = side_width;
constexpr float bottom = line_height;
constexpr double way_s = 2.0;  ///< of a way, from where the tip is
constexpr double before_mark_s = 1.0;

struct MarkLook {
    ImVec4 colour;
    const char* sign;  ///< shapes differ, not colours alone
    const char* name;
};

MarkLook look_of(MarkKind kind) {
    switch (kind) {
        case MarkKind::error:
            return {{1.0F, 0.45F, 0.35F, 1.0F}, "x", "error"};
        case MarkKind::put_right:
            return {{0.45F, 0.95F, 0.65F, 1.0F}, "v", "put right"};
        case MarkKind::warning:
            return {{1.0F, 0.8F, 0.2F, 1.0F}, "!", "warning"};
        case MarkKind::note:
            return {{0.5F, 0.75F, 1.0F, 1.0F}, "#", "note"};
        case MarkKind::injected:
            return {{0.85F, 0.65F, 1.0F, 1.0F}, "*", "let happen"};
        default:
            return {{0.75F, 0.75F, 0.75F, 1.0F}, "|", "step"};
    }
}

std::string tenths(double value) { return short_number(std::round(10.0 * value) / 10.0); }

/// A way as dots, each of the next larger.
void draw_way(const PlayedMoment& moment, const View& view, const std::vector<Vec3>& way, ImVec4 colour) {
    for (const Vec3& room : way) {
        const Frame& frame = moment.frame;
        const Vec3 place = frame.globe ? to_eye(*frame.model->globe, *frame.globe, room) : room;
        const Vec2 pixel = pixel_of(view, place);
        ImGui::GetBackgroundDrawList()->AddCircleFilled({static_cast<float>(pixel.x()), static_cast<float>(pixel.y())},
                                                        2.5F, ImGui::ColorConvertFloat4ToU32(colour));
    }
}

}  // namespace

bool DebriefingPanels::holds_cursor() const { return ImGui::GetIO().WantCaptureMouse; }

/// Where this hand goes on to, blue, and where an expert's went from about here, yellow.
void DebriefingPanels::draw_ways(const PlayedMoment& moment, const View& view, const Ghost& own,
                                 const Ghost* expert) const {
    for (std::size_t i = 0; i < moment.frame.tools.size(); ++i) {
        const ToolState& tool = moment.frame.tools[i];
        if (!tool.present) {
            continue;
        }
        const int instrument = static_cast<int>(i);
        draw_way(moment, view, own.ahead(instrument, tool.pose.position, way_s), {0.45F, 0.7F, 1.0F, 0.9F});
        if (expert != nullptr) {
            draw_way(moment, view, expert->ahead(instrument, tool.pose.position, way_s), {1.0F, 0.85F, 0.25F, 0.9F});
        }
    }
}

/// The time line: steps as bands, marks with their signs, where it stands.
void DebriefingPanels::draw_line(const DebriefingState& state, DebriefingWish& wish) const {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0F, size.y - bottom});
    ImGui::SetNextWindowSize({size.x - side, bottom});
    ImGui::SetNextWindowBgAlpha(0.8F);
    ImGui::Begin("line", nullptr, panel_flags);
    if (ImGui::Button(words_(state.plays ? "Pause" : "Play").c_str())) {
        wish.plays = !state.plays;
    }
    for (const double speed : {0.25, 0.5, 1.0, 2.0}) {
        ImGui::SameLine();
        if (ImGui::RadioButton((short_number(speed) + "x").c_str(), state.speed == speed)) {
            wish.speed = speed;
        }
    }
    ImGui::SameLine();
    ImGui::Text("  %s / %s s", tenths(state.time_s).c_str(), tenths(state.end_s).c_str());
    auto time_s = static_cast<float>(state.time_s);
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::SliderFloat("##time", &time_s, 0.0F, static_cast<float>(state.end_s), "")) {
        wish.time_s = time_s;
        wish.plays = false;
    }
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    ImDrawList& drawn = *ImGui::GetWindowDrawList();
    for (const StoryMark& mark : story_.marks) {
        const double share = state.end_s > 0.0 ? std::clamp(mark.time_s / state.end_s, 0.0, 1.0) : 0.0;
        const float x = from.x + static_cast<float>(share) * (to.x - from.x);
        const MarkLook look = look_of(mark.kind);
        const ImU32 colour = ImGui::ColorConvertFloat4ToU32(look.colour);
        drawn.AddLine({x, from.y}, {x, to.y}, colour, mark.kind == MarkKind::step ? 1.0F : 2.0F);
        if (mark.kind != MarkKind::step) {
            drawn.AddText({x - 4.0F, to.y + 1.0F}, colour, look.sign);
        }
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        if (std::abs(mouse.x - x) < 4.0F && mouse.y > from.y && mouse.y < to.y + 16.0F) {
            ImGui::SetTooltip("%s s  %s: %s", tenths(mark.time_s).c_str(), words_(look.name).c_str(),
                              mark.title.c_str());
        }
    }
    ImGui::End();
}

/// What happened, to jump to.
void DebriefingPanels::draw_marks(const DebriefingState& state, DebriefingWish& wish) const {
    ImGui::TextDisabled("%s", words_("What happened").c_str());
    if (!story_.fault.empty()) {
        ImGui::TextWrapped("%s", story_.fault.c_str());
    }
    const StoryMark* now = nullptr;
    for (const StoryMark& mark : story_.marks) {
        now = mark.time_s <= state.time_s + before_mark_s + 0.05 ? &mark : now;
    }
    for (const StoryMark& mark : story_.marks) {
        ImGui::PushID(&mark);
        const MarkLook look = look_of(mark.kind);
        ImGui::PushStyleColor(ImGuiCol_Text, look.colour);
        const std::string line = tenths(mark.time_s) + " s  " + look.sign + " " + mark.title;
        if (ImGui::Selectable(line.c_str(), &mark == now)) {
            wish.time_s = std::max(0.0, mark.time_s - before_mark_s);
        }
        ImGui::PopStyleColor();
        if (&mark == now && !mark.text.empty()) {
            ImGui::TextWrapped("%s", mark.text.c_str());
        }
        ImGui::PopID();
    }
}

/// Each item with why it earned what it did, and what would have made it a four.
void DebriefingPanels::draw_items() const {
    if (story_.items.empty()) {
        return;
    }
    ImGui::Separator();
    ImGui::Text("OSACSS %s / %s", tenths(story_.total).c_str(), tenths(story_.max).c_str());
    for (const StoryItem& item : story_.items) {
        const std::string points = item.score < 0.0 ? "-" : tenths(item.score);
        const bool low = item.score >= 0.0 && item.score < 4.0;
        const std::string head = item.id + "  " + points + "  " + item.name + "###" + item.id;
        if (!ImGui::TreeNodeEx(head.c_str(), low ? ImGuiTreeNodeFlags_DefaultOpen : 0)) {
            continue;
        }
        for (const std::string& reason : item.reasons) {
            ImGui::TextWrapped("%s", reason.c_str());
        }
        if (!item.to_four.empty()) {
            ImGui::TextColored({0.45F, 0.95F, 0.65F, 1.0F}, "%s", words_("How to get a 4").c_str());
            for (const std::string& way : item.to_four) {
                ImGui::TextWrapped("%s", way.c_str());
            }
        }
        ImGui::TreePop();
    }
}

void DebriefingPanels::draw_state(const DebriefingState& state, const PlayedMoment* moment, bool has_expert,
                                  const std::string& notice, DebriefingWish& wish) const {
    ImGui::SetNextWindowPos({8.0F, 8.0F});
    ImGui::SetNextWindowBgAlpha(0.5F);
    ImGui::Begin("state", nullptr, panel_flags | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::TextUnformatted(story_.title.c_str());
    if (moment == nullptr && notice.empty()) {
        ImGui::TextUnformatted(words_("simulating ...").c_str());
    } else if (moment != nullptr) {
        const double behind_s = state.time_s - moment->frame.time_s;
        if (std::abs(behind_s) > 0.3) {
            ImGui::Text("%s %s s", words_("simulating ...").c_str(), tenths(moment->frame.time_s).c_str());
        }
        for (const HandForce& force : moment->forces) {
            if (force.mN > 0.05 && !force.instrument.empty()) {
                ImGui::Text("%s %s mN", words_.instrument(force.instrument).c_str(), tenths(force.mN).c_str());
            }
        }
        if (moment->machine.there) {
            ImGui::Text("%s %s   %s mmHg", words_("pedal").c_str(), tenths(moment->machine.pedal).c_str(),
                        short_number(std::round(std::max(0.0, moment->machine.vacuum_mmhg))).c_str());
        }
    }
    if (has_expert) {
        bool shows = state.shows_ghost;
        if (ImGui::Checkbox(words_("the expert's way (yellow), yours (blue)").c_str(), &shows)) {
            wish.toggles_ghost = true;
        }
    }
    if (state.free_camera && ImGui::Button(words_("Back to the microscope").c_str())) {
        wish.resets_camera = true;
    }
    if (!notice.empty()) {
        ImGui::PushTextWrapPos(0.5F * ImGui::GetIO().DisplaySize.x);
        ImGui::TextColored({1.0F, 0.8F, 0.2F, 1.0F}, "%s", notice.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

DebriefingWish DebriefingPanels::draw(const DebriefingState& state, const PlayedMoment* moment, const View& view,
                                      const Ghost& own, const Ghost* expert, const std::string& notice) {
    DebriefingWish wish;
    overlay_.begin();
    if (moment != nullptr && state.shows_ghost) {
        draw_ways(*moment, view, own, expert);
    }
    draw_state(state, moment, expert != nullptr, notice, wish);
    draw_line(state, wish);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x - side, 0.0F});
    ImGui::SetNextWindowSize({side, size.y});
    ImGui::SetNextWindowBgAlpha(0.8F);
    ImGui::Begin("story", nullptr, panel_flags);
    draw_marks(state, wish);
    draw_items();
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextDisabled("%s", words_("Space plays, left and right one second, N and B the next and the last mark, "
                                     "right button turns the camera, wheel zooms, R back, H the expert's way")
                                  .c_str());
    ImGui::PopTextWrapPos();
    ImGui::End();
    overlay_.end();
    return wish;
}

}  // namespace rhexis::station
