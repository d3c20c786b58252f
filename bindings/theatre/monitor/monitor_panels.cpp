// SPDX-License-Identifier: GPL-3.0-or-later
#include "theatre/monitor/monitor_panels.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/clock.hpp"
#include "base/numbers.hpp"

namespace rhexis::station {
namespace {

constexpr ImGuiWindowFlags frame_flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
// Apart for eyes that do not tell red from green: lightness differs as well as hue, and words say the same.
const ImVec4 heart_colour{0.45F, 0.95F, 0.55F, 1.0F};
const ImVec4 pressure_colour{1.0F, 0.55F, 0.35F, 1.0F};
const ImVec4 oxygen_colour{0.45F, 0.75F, 1.0F, 1.0F};
const ImVec4 warning_colour{1.0F, 0.8F, 0.2F, 1.0F};
const ImVec4 alarm_colour{1.0F, 0.45F, 0.4F, 1.0F};
const ImVec4 calm_colour{0.6F, 0.85F, 0.95F, 1.0F};
constexpr float of_bars = 0.5F;  ///< of a colour's light, so that white letters are read on it
constexpr double told_for_s = 6.0;
constexpr std::size_t force_samples = 160;
constexpr float large = 1.9F;

std::string whole(double value) { return short_number(std::round(value)); }
std::string tenth(double value) { return short_number(std::round(10.0 * value) / 10.0); }

UserEvent asked_for(const char* what, const std::string& which = "", double value = 0.0) {
    return {EventKind::staff, what, value, 0.0, 0.0, which};
}

void heading(const std::string& text) {
    ImGui::TextColored(calm_colour, "%s", text.c_str());
    ImGui::Separator();
}

/// A part of the screen, in shares of it.
bool begin_part(const char* name, float x, float y, float w, float h) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    constexpr float top = 46.0F;
    const float height = size.y - top;
    ImGui::SetNextWindowPos({x * size.x + 4.0F, top + y * height + 2.0F});
    ImGui::SetNextWindowSize({w * size.x - 8.0F, h * height - 4.0F});
    return ImGui::Begin(name, nullptr, frame_flags & ~ImGuiWindowFlags_NoScrollbar);
}

void bar(const std::string& label, double share, const std::string& text, const ImVec4& colour) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(label.c_str());
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, {of_bars * colour.x, of_bars * colour.y, of_bars * colour.z, 1.0F});
    ImGui::ProgressBar(static_cast<float>(std::clamp(share, 0.0, 1.0)), {-1.0F, 0.0F}, text.c_str());
    ImGui::PopStyleColor();
}

}  // namespace

void MonitorPanels::take(const TheatreMoment& moment) {
    if (moment_ && moment.time_s < moment_->time_s) {
        forces_.clear();
    }
    traces_.add(moment.time_s, moment.vitals);
    for (const HandForce& force : moment.forces) {
        std::vector<float>& past = forces_[force.instrument + force.meaning];
        past.push_back(static_cast<float>(force.mN));
        if (past.size() > force_samples) {
            past.erase(past.begin());
        }
    }
    moment_ = moment;
}

void MonitorPanels::notice(const std::string& text) {
    notice_ = text;
    notice_until_s_ = wall_seconds() + told_for_s;
}

/// One line over everything: what is operated, how it stands, and whether there is news at all.
void MonitorPanels::draw_head(News news, double silent_s, const std::string& address) const {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({4.0F, 4.0F});
    ImGui::SetNextWindowSize({size.x - 8.0F, 40.0F});
    ImGui::Begin("head", nullptr, frame_flags);
    if (moment_) {
        ImGui::Text("%s   %s s", moment_->exercise.c_str(), tenth(moment_->time_s).c_str());
        const char* state = moment_->ended    ? "the attempt has ended"
                            : moment_->paused ? "paused"
                            : moment_->waits  ? "the clock waits for the hand"
                                              : "";
        ImGui::SameLine();
        ImGui::TextColored(calm_colour, "  %s", *state == '\0' ? "" : words_(state).c_str());
    }
    const bool ended = moment_ && moment_->ended;
    ImGui::SameLine();
    if (news == News::none) {
        ImGui::TextColored(warning_colour, "%s", words_("no station at %s yet", {address}).c_str());
    } else if (news == News::stalled && !ended) {
        ImGui::TextColored(
            warning_colour, "%s",
            words_("nothing has come for %s s: the station is busy, suspended or gone", {whole(silent_s)}).c_str());
    } else if (news == News::strange) {
        ImGui::TextColored(warning_colour, "%s", words_("a station of another version speaks there").c_str());
    }
    if (moment_) {
        for (const TheatreWarning& one : moment_->warnings) {
            ImGui::SameLine();
            ImGui::TextColored(warning_colour, "  ! %s", one.title.c_str());
        }
    }
    if (wall_seconds() < notice_until_s_) {
        ImGui::SameLine();
        ImGui::TextColored(warning_colour, "  %s", notice_.c_str());
    }
    ImGui::End();
}

void MonitorPanels::draw_vitals() const {
    const Vitals& vitals = moment_->vitals;
    const float height = std::max(30.0F, ImGui::GetContentRegionAvail().y / 3.0F - 8.0F);
    const auto curve = [&](const ImVec4& colour, const std::string& label, const std::string& value, auto&& height_at) {
        const float width = ImGui::GetContentRegionAvail().x;
        const ImVec2 from = ImGui::GetCursorScreenPos();
        const float drawn = 0.66F * width;
        std::vector<ImVec2> line;
        const double end_s = traces_.samples().empty() ? 0.0 : traces_.samples().back().time_s;
        for (const Traces::Sample& sample : traces_.samples()) {
            const double share = 1.0 - (end_s - sample.time_s) / Traces::span_s;
            line.push_back({from.x + static_cast<float>(share) * drawn,
                            from.y + height * (0.95F - 0.9F * static_cast<float>(height_at(sample)))});
        }
        ImGui::GetWindowDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()),
                                                ImGui::ColorConvertFloat4ToU32(colour), ImDrawFlags_None, 1.6F);
        ImGui::SetCursorScreenPos({from.x + drawn + 10.0F, from.y + 2.0F});
        ImGui::TextColored(colour, "%s", label.c_str());
        ImGui::SetCursorScreenPos({from.x + drawn + 10.0F, from.y + 2.0F + ImGui::GetTextLineHeight()});
        ImGui::SetWindowFontScale(large);
        ImGui::TextColored(colour, "%s", value.c_str());
        ImGui::SetWindowFontScale(1.0F);
        ImGui::SetCursorScreenPos({from.x, from.y + height + 4.0F});
    };
    curve(heart_colour, words_("heart, per min"), whole(vitals.heart_per_min),
          [](const Traces::Sample& one) { return ecg_at(one.beat); });
    curve(pressure_colour, words_("pressure, mmHg"), whole(vitals.systolic_mmhg) + "/" + whole(vitals.diastolic_mmhg),
          [](const Traces::Sample& one) {
              const double mmhg = one.diastolic_mmhg + (one.systolic_mmhg - one.diastolic_mmhg) * pulse_at(one.beat);
              return (mmhg - 40.0) / 180.0;
          });
    curve(oxygen_colour, words_("saturation, %"), whole(vitals.saturation_percent),
          [](const Traces::Sample& one) { return 0.1 + 0.8 * pulse_at(one.beat); });
}

void MonitorPanels::draw_machine() const {
    const MachinePanel& machine = moment_->machine;
    heading(words_("The machine"));
    if (!machine.there) {
        ImGui::TextDisabled("%s", words_("none in this exercise").c_str());
        return;
    }
    if (ImGui::BeginTable("machine", 2, ImGuiTableFlags_SizingStretchProp)) {
        bar(words_("pedal"), machine.pedal / 3.0, tenth(machine.pedal), calm_colour);
        if (machine.power >= 0.0) {
            bar(words_("power"), machine.power, whole(100.0 * machine.power) + " %", warning_colour);
        }
        if (machine.vacuum_mmhg >= 0.0) {
            bar(words_("vacuum"), machine.vacuum_mmhg / 650.0, whole(machine.vacuum_mmhg) + " mmHg", oxygen_colour);
            bar(words_("flow"), machine.flow_ml_min / 60.0, whole(machine.flow_ml_min) + " ml/min", oxygen_colour);
        }
        if (machine.occlusion >= 0.0) {
            bar(words_("tip shut"), machine.occlusion, whole(100.0 * machine.occlusion) + " %", calm_colour);
        }
        if (machine.chamber_share >= 0.0) {
            const bool shallow = machine.chamber_share < 0.6;
            bar(words_("chamber"), machine.chamber_share, whole(100.0 * machine.chamber_share) + " %",
                shallow ? alarm_colour : heart_colour);
        }
        bar(words_("bottle"), machine.bottle_cm / 150.0,
            machine.infusion == 0.0 ? words_("no infusion") : whole(machine.bottle_cm) + " cm",
            machine.infusion == 0.0 ? alarm_colour : heart_colour);
        ImGui::EndTable();
    }
    if (machine.cde >= 0.0) {
        ImGui::Text("CDE %s %% s", tenth(machine.cde).c_str());
    }
}

void MonitorPanels::draw_steps() const {
    heading(words_("Steps"));
    for (const TheatreStep& step : moment_->steps) {
        const bool now = step.state == "now";
        const char* mark = step.state == "done" ? "[x]" : now ? " > " : step.state == "to come" ? "[ ]" : "[-]";
        const ImVec4& colour = now                    ? calm_colour
                               : step.state == "done" ? heart_colour
                                                      : ImGui::GetStyle().Colors[ImGuiCol_TextDisabled];
        ImGui::TextColored(colour, "%s %s", mark, step.title.c_str());
        if (now && !step.hint.empty() && !moment_->exam) {
            ImGui::Indent();
            ImGui::TextWrapped("%s", step.hint.c_str());
            ImGui::Unindent();
        }
    }
}

void MonitorPanels::draw_events() const {
    heading(words_("Events and advice"));
    for (const TheatreWarning& one : moment_->warnings) {
        ImGui::TextColored(warning_colour, "! %s", one.title.c_str());
        ImGui::TextWrapped("%s", one.advice.c_str());
    }
    for (auto event = moment_->events.rbegin(); event != moment_->events.rend(); ++event) {
        const bool open = event->outcome == "open";
        const bool right = event->outcome == "recovered" || event->outcome == "near_miss";
        ImGui::TextColored(open    ? alarm_colour
                           : right ? heart_colour
                                   : warning_colour,
                           "%s s  %s: %s", tenth(event->time_s).c_str(), event->title.c_str(),
                           words_(open    ? "open"
                                  : right ? "put right"
                                          : "not put right")
                               .c_str());
        if (open) {
            ImGui::TextWrapped("%s", event->advice.c_str());
        }
    }
    for (const TheatreNote& note : moment_->notes) {
        ImGui::TextColored(oxygen_colour, "%s s  %s", tenth(note.time_s).c_str(), note.text.c_str());
    }
    if (!moment_->lines.empty()) {
        ImGui::Separator();
        for (const std::string& line : moment_->lines) {
            ImGui::TextWrapped("%s", line.c_str());
        }
    }
}

void MonitorPanels::draw_score() const {
    const TheatreScore& score = moment_->score;
    heading(words_("OSACSS so far"));
    if (score.items.empty()) {
        ImGui::TextDisabled("%s", words_("not scored").c_str());
        return;
    }
    ImGui::Text("%s / %s", tenth(score.total).c_str(), tenth(score.max).c_str());
    if (ImGui::BeginTable("score", 3, ImGuiTableFlags_SizingStretchProp)) {
        ImGui::TableSetupColumn("id", ImGuiTableColumnFlags_WidthFixed, 34.0F);
        ImGui::TableSetupColumn("name");
        ImGui::TableSetupColumn("points", ImGuiTableColumnFlags_WidthFixed, 90.0F);
        for (const TheatreItem& item : score.items) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(item.id.c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(item.name.c_str());
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_PlotHistogram, {0.25F, 0.45F, 0.55F, 1.0F});
            ImGui::ProgressBar(static_cast<float>(std::max(0.0, item.score) / 5.0), {-1.0F, 0.0F},
                               item.score < 0.0 ? "-" : tenth(item.score).c_str());
            ImGui::PopStyleColor();
        }
        ImGui::EndTable();
    }
}

void MonitorPanels::draw_forces() const {
    heading(words_("Force of each hand, mN"));
    const float width = ImGui::GetContentRegionAvail().x;
    for (std::size_t i = 0; i < moment_->forces.size(); ++i) {
        const HandForce& force = moment_->forces[i];
        const std::string who = force.instrument.empty() ? "" : words_.instrument(force.instrument) + ": ";
        const std::vector<float>& past = forces_.at(force.instrument + force.meaning);
        const float most = std::max(10.0F, *std::max_element(past.begin(), past.end()));
        ImGui::PushID(static_cast<int>(i));
        ImGui::PlotLines("##force", past.data(), static_cast<int>(past.size()), 0, tenth(force.mN).c_str(), 0.0F, most,
                         {0.3F * width, 26.0F});
        ImGui::PopID();
        ImGui::SameLine();
        ImGui::TextWrapped("%s%s", who.c_str(), words_(force.meaning).c_str());
    }
    if (moment_->forces.empty()) {
        ImGui::TextDisabled("%s", words_("no instrument in the eye").c_str());
    }
}

void MonitorPanels::draw_health() const {
    heading(words_("The station"));
    ImGui::TextUnformatted(words_("%s pictures/s", {whole(moment_->pictures_per_s)}).c_str());
    if (moment_->slowed < 0.97) {
        ImGui::TextColored(warning_colour, "%s", words_("slow clock: %s %", {whole(100.0 * moment_->slowed)}).c_str());
    }
    for (const DeviceHealth& one : moment_->devices) {
        ImGui::TextColored(one.there ? heart_colour : alarm_colour, "%s: %s", words_(one.name).c_str(),
                           words_(one.there ? "there" : "gone").c_str());
    }
}

void MonitorPanels::draw_instructor(std::vector<UserEvent>& asked) {
    heading(words_("Instructor"));
    if (ImGui::Button(words_(moment_->paused ? "Go on" : "Pause").c_str())) {
        asked.push_back(asked_for(moment_->paused ? "go_on" : "pause"));
    }
    for (const double back_s : {5.0, 15.0, 60.0}) {
        ImGui::SameLine();
        if (ImGui::Button(words_("back %s s", {whole(back_s)}).c_str())) {
            asked.push_back(asked_for("rewind", "", back_s));
        }
    }
    bool warns = moment_->warns;
    if (!moment_->exam && ImGui::Checkbox(words_("the trainee is warned too").c_str(), &warns)) {
        asked.push_back(asked_for("warn", "", warns ? 1.0 : 0.0));
    }
    for (const TheatreInjection& one : moment_->injections) {
        ImGui::PushID(one.id.c_str());
        bool runs = one.runs;
        if (ImGui::Checkbox(one.title.c_str(), &runs)) {
            asked.push_back(asked_for(runs ? "inject" : "put_right", one.id));
        }
        ImGui::PopID();
    }
    for (const std::string& level : moment_->levels) {
        if (ImGui::Button(level.c_str())) {
            asked.push_back(asked_for("level", level));
        }
        ImGui::SameLine();
    }
    if (!moment_->levels.empty()) {
        ImGui::TextDisabled("%s", words_("Difficulty").c_str());
    }
    ImGui::SetNextItemWidth(-90.0F);
    const bool entered = ImGui::InputText("##note", note_.data(), note_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::SameLine();
    if ((ImGui::Button(words_("Pin note").c_str()) || entered) && note_[0] != '\0') {
        asked.push_back(asked_for("note", note_.data()));
        note_.fill('\0');
    }
}

std::vector<UserEvent> MonitorPanels::draw(News news, double silent_s, const std::string& address) {
    std::vector<UserEvent> asked;
    overlay_.begin();
    draw_head(news, silent_s, address);
    if (moment_) {
        const auto part = [&](const char* name, float x, float y, float w, float h, auto&& draw) {
            if (begin_part(name, x, y, w, h)) {
                draw();
            }
            ImGui::End();
        };
        part("vitals", 0.0F, 0.0F, 0.34F, 0.42F, [&] { draw_vitals(); });
        part("machine", 0.0F, 0.42F, 0.34F, 0.34F, [&] { draw_machine(); });
        part("forces", 0.0F, 0.76F, 0.34F, 0.24F, [&] { draw_forces(); });
        part("steps", 0.34F, 0.0F, 0.33F, 0.42F, [&] { draw_steps(); });
        part("events", 0.34F, 0.42F, 0.33F, 0.58F, [&] { draw_events(); });
        part("score", 0.67F, 0.0F, 0.33F, 0.42F, [&] { draw_score(); });
        part("instructor", 0.67F, 0.42F, 0.33F, 0.42F, [&] { draw_instructor(asked); });
        part("health", 0.67F, 0.84F, 0.33F, 0.16F, [&] { draw_health(); });
    }
    overlay_.end();
    return asked;
}

}  // namespace rhexis::station
