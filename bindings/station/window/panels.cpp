// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/window/panels.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/clock.hpp"
#include "base/numbers.hpp"

namespace rhexis::station {
namespace {

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
const ImVec4 warning{1.0F, 0.8F, 0.2F, 1.0F};
const ImVec4 to_learn{0.5F, 1.0F, 0.6F, 1.0F};
constexpr double notice_s = 6.0;
constexpr double pushed = 0.6;  ///< of an axis that is to work a control

UserEvent worked(ControlId id, double value = 1.0) { return {EventKind::control, control(id).name, value}; }

double number(std::size_t i) { return static_cast<double>(i); }

std::string dial_text(const Dial& dial, double value) {
    return short_number(value) + (dial.unit == "1" ? "" : " " + dial.unit);
}

void draw_help(const Mapping& mapping, const Words& words) {
    std::vector<std::pair<std::string, std::string>> rows;
    for (const Control& one : control_table()) {
        if (std::string inputs = mapping.inputs_at_hand(one.id); !inputs.empty()) {
            rows.emplace_back(std::move(inputs), words(one.meaning));
        }
    }
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({size.x - 8.0F, size.y - 8.0F}, ImGuiCond_Always, {1.0F, 1.0F});
    ImGui::SetNextWindowBgAlpha(0.9F);
    ImGui::Begin("help", nullptr, plain);
    ImGui::SetWindowFontScale(
        std::min(1.0F, (size.y - 40.0F) / (static_cast<float>(rows.size()) * ImGui::GetTextLineHeightWithSpacing())));
    if (ImGui::BeginTable("controls", 2, ImGuiTableFlags_SizingFixedFit)) {
        for (const auto& [inputs, meaning] : rows) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(inputs.c_str());
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(meaning.c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

/// A place of the scene in the window, as the hand that moves sees it.
ImVec2 in_window(const Shown& shown, const Vec3& place) {
    const HandState& hand = shown.hands.hands[static_cast<std::size_t>(shown.hands.moving)];
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const Cursor cursor = shown.around.sight.cursor_on(place, hand.inside);
    return {0.5F * size.x + static_cast<float>(cursor.x()) * size.y,
            0.5F * size.y - static_cast<float>(cursor.y()) * size.y};
}

/// Pixels of a length at a place.
float pixels_of(const Shown& shown, const Vec3& place, double mm) {
    return std::abs(in_window(shown, place + Vec3(mm, 0.0, 0.0)).x - in_window(shown, place).x);
}

/// Where the tip is to be: a ring, or a way; and how much higher or lower, which a picture from above does not show.
void draw_marks(const Shown& shown, const Words& words) {
    constexpr double ring_mm = 0.35;
    constexpr double same_height_mm = 0.25;
    const HandState& hand = shown.hands.hands[static_cast<std::size_t>(shown.hands.moving)];
    const Vec3* nearest = &shown.marks.front();
    std::vector<ImVec2> way;
    for (const Vec3& place : shown.marks) {
        way.push_back(in_window(shown, place));
        if ((place - hand.tip).head<2>().norm() < (*nearest - hand.tip).head<2>().norm()) {
            nearest = &place;
        }
    }
    ImDrawList& drawn = *ImGui::GetBackgroundDrawList();
    const ImU32 colour = ImGui::ColorConvertFloat4ToU32(to_learn);
    if (way.size() == 1) {
        drawn.AddCircle(way.front(), pixels_of(shown, *nearest, ring_mm), colour, 0, 2.0F);
    } else {
        drawn.AddPolyline(way.data(), static_cast<int>(way.size()), colour, ImDrawFlags_None, 2.0F);
    }
    const double higher = nearest->z() - hand.tip.z();
    if (hand.instrument >= 0 && std::abs(higher) > same_height_mm) {
        const std::string mm = short_number(0.1 * std::round(10.0 * std::abs(higher)));
        const ImVec2 at = in_window(shown, *nearest);
        drawn.AddText({at.x + pixels_of(shown, *nearest, ring_mm) + 6.0F, at.y}, colour,
                      words(higher > 0.0 ? "%s mm higher" : "%s mm lower", {mm}).c_str());
    }
}

/// Where an expert's tip went on from about here: the nearer its depth, the whiter; below it blue, above it yellow.
void draw_ghost(const Shown& shown, const Ghost& ghost) {
    const HandState& hand = shown.hands.hands[static_cast<std::size_t>(shown.hands.moving)];
    constexpr double shown_s = 3.0;
    constexpr double far_mm = 1.0;
    for (const Vec3& place : ghost.ahead(hand.instrument, hand.tip, shown_s)) {
        const auto higher = static_cast<float>(std::clamp((place.z() - hand.tip.z()) / far_mm, -1.0, 1.0));
        const ImVec4 colour(1.0F - std::max(0.0F, -higher), 1.0F - 0.3F * std::abs(higher),
                            1.0F - std::max(0.0F, higher), 0.8F);
        ImGui::GetBackgroundDrawList()->AddCircleFilled(in_window(shown, place), 3.0F,
                                                        ImGui::ColorConvertFloat4ToU32(colour));
    }
}

/// How hard tissue is pressed, which no hand feels here: an arc around the tip, the longer and the brighter the harder.
void draw_force(const Shown& shown) {
    constexpr double shown_from_mN = 2.0;
    constexpr double full_mN = 40.0;
    constexpr float radius = 26.0F;
    constexpr float turn = 6.2832F;
    for (const HandState& hand : shown.hands.hands) {
        if (hand.instrument < 0 || !hand.inside) {
            continue;
        }
        const std::string& name = shown.stand->instruments[static_cast<std::size_t>(hand.instrument)].name;
        double most_mN = 0.0;
        for (const HandForce& force : shown.forces) {
            most_mN = force.instrument == name ? std::max(most_mN, force.mN) : most_mN;
        }
        const auto share = static_cast<float>(std::min(1.0, most_mN / full_mN));
        if (most_mN < shown_from_mN) {
            continue;
        }
        ImDrawList& drawn = *ImGui::GetBackgroundDrawList();
        drawn.PathArcTo(in_window(shown, hand.tip), radius, -0.25F * turn, (share - 0.25F) * turn, 48);
        drawn.PathStroke(ImGui::ColorConvertFloat4ToU32({share, 0.45F + 0.4F * share, 1.0F - 0.8F * share, 0.85F}),
                         ImDrawFlags_None, 2.0F + 3.0F * share);
    }
}

/// Where the cursor has to come to, for the clock waits for it.
void draw_meeting_place(const Shown& shown) {
    const HandState& hand = shown.hands.hands[static_cast<std::size_t>(shown.hands.moving)];
    ImGui::GetBackgroundDrawList()->AddCircle(in_window(shown, hand.tip),
                                              std::max(5.0F, pixels_of(shown, hand.tip, meets_within)),
                                              ImGui::ColorConvertFloat4ToU32(to_learn), 0, 2.0F);
}

/// Where the instrument of a hand is seen while it waits to be met; none: it is not seen.
std::optional<Pose> seen_for(const Shown& shown, const HandState& hand) {
    if (hand.instrument < 0) {
        return std::nullopt;
    }
    std::optional<Pose> seen = shown.hands.tracked->seen[static_cast<std::size_t>(hand.instrument)];
    if (seen) {
        seen->position += shown.hands.tracked->shift;
    }
    return seen;
}

/// What each hand has to meet, and where it is: its tip, and its shaft as far as it shows.
void draw_tracked_places(const Shown& shown) {
    constexpr float tip_radius = 3.0F;
    constexpr double shaft_mm = 6.0;
    ImDrawList& drawn = *ImGui::GetBackgroundDrawList();
    const ImU32 colour = ImGui::ColorConvertFloat4ToU32(to_learn);
    for (const HandState& hand : shown.hands.hands) {
        if (hand.instrument < 0) {
            continue;
        }
        drawn.AddCircle(in_window(shown, hand.tip), std::max(5.0F, pixels_of(shown, hand.tip, meets_within_mm)), colour,
                        0, 2.0F);
        if (const std::optional<Pose> seen = seen_for(shown, hand)) {
            drawn.AddCircleFilled(in_window(shown, seen->position), tip_radius, colour);
            drawn.AddLine(in_window(shown, seen->position), in_window(shown, seen->to_world({0.0, 0.0, shaft_mm})),
                          colour, 1.5F);
        }
    }
}

/// What a picture from above does not show: how much higher, and how far to turn, the roll included.
std::string way_to(const HandState& hand, const Pose& seen, const Words& words) {
    const double higher = hand.tip.z() - seen.position.z();
    std::string text =
        words(higher > 0.0 ? "%s mm higher" : "%s mm lower", {short_number(0.1 * std::round(10.0 * std::abs(higher)))});
    const double turn = degrees_between(hand.orientation, seen.orientation);
    if (turn > meets_within_deg) {
        text += ", " + words("%s degrees to turn", {short_number(std::round(turn))});
    }
    return text;
}

/// What a press of a key, a button or an axis says of an input: its name, and -1 where the other way was pushed.
std::optional<std::pair<std::string, double>> input_of(const UserEvent& event, ControlKind kind) {
    if (event.kind == EventKind::wheel && kind == ControlKind::notch) {
        return std::pair(source_of(event), event.value < 0.0 ? -1.0 : 1.0);
    }
    const bool pressed =
        (event.kind == EventKind::key || event.kind == EventKind::button || event.kind == EventKind::press) &&
        event.value > 0.5;
    if (pressed) {
        return std::pair(source_of(event), 1.0);
    }
    if (event.kind == EventKind::axis && std::abs(event.value) > pushed) {
        return std::pair(source_of(event), event.value < 0.0 ? -1.0 : 1.0);
    }
    return std::nullopt;
}

/// The control is worked by this input, and no more by another of its device.
std::vector<UserEvent> bound(const Mapping& mapping, const Control& to, const std::string& source, double sign) {
    std::vector<UserEvent> events;
    const std::string device = source.substr(0, source.find('.') + 1);
    for (const auto& [input, binding] : mapping.bindings()) {
        if (binding.control == &to && binding.sign == sign && input.starts_with(device) && input != source) {
            events.push_back({EventKind::bind, input});
        }
    }
    events.push_back(
        {EventKind::bind, source, 0.0, 0.0, 0.0, std::string(sign < 0.0 ? "-" : "") + std::string(to.name)});
    return events;
}

}  // namespace

Panels::Panels(Window& window, Words words, std::vector<MappingOffer> offers, std::string own)
    : overlay_(window), words_(std::move(words)), offers_(std::move(offers)), own_(std::move(own)) {}

void Panels::notice(const std::string& text) {
    notice_ = text;
    notice_until_s_ = wall_seconds() + notice_s;
}

std::string Panels::held(const Shown& shown, int which) const {
    const int instrument = shown.hands.hands[static_cast<std::size_t>(which)].instrument;
    return instrument < 0 ? "-"
                          : words_.instrument(shown.stand->instruments[static_cast<std::size_t>(instrument)].name);
}

void Panels::draw_state(const Shown& shown, const DrawingRate& rate) const {
    const Stand& stand = *shown.stand;
    ImGui::SetNextWindowPos({8.0F, 8.0F});
    ImGui::SetNextWindowBgAlpha(0.45F);
    ImGui::Begin("state", nullptr, plain | ImGuiWindowFlags_NoInputs);
    ImGui::Text("%.1f s   %s %.1f", shown.frame.time_s, words_("pedal").c_str(), shown.hands.pedal);
    for (const auto& [which, name] : {std::pair(leading, "leading hand"), {other, "other hand"}}) {
        ImGui::Text("%s%s: %s", shown.hands.moving == which ? "> " : "   ", words_(name).c_str(),
                    held(shown, which).c_str());
    }
    if (!stand.dials.empty()) {
        const auto at = static_cast<std::size_t>(shown.hands.dial);
        ImGui::Text("%s: %s", words_.setting(stand.dials[at].setting).c_str(),
                    dial_text(stand.dials[at], shown.hands.dials[at]).c_str());
    }
    if (!stand.requests.empty()) {
        ImGui::Text("%s: %s", words_("ask").c_str(),
                    stand.requests[static_cast<std::size_t>(shown.hands.request)].title.c_str());
    }
    if (rate.size < 1.0) {
        ImGui::TextUnformatted(words_("%s pictures/s, at %s % of the size",
                                      {short_number(std::round(rate.pictures_per_s)), short_number(100.0 * rate.size)})
                                   .c_str());
    } else {
        ImGui::TextUnformatted(words_("%s pictures/s", {short_number(std::round(rate.pictures_per_s))}).c_str());
    }
    if (shown.slowed < 0.97) {
        ImGui::TextColored(warning, "%s",
                           words_("slow clock: %s %", {short_number(std::round(100.0 * shown.slowed))}).c_str());
    }
    ImGui::End();
}

/// Why the clock stands, where instruments are seen by a tracking system.
void Panels::draw_standstill(const Shown& shown) const {
    const Standstill& why = shown.hands.tracked->why;
    if (!why.text.empty()) {
        ImGui::TextColored(warning, "%s", words_(why.text, {words_.instrument(why.of)}).c_str());
    }
    for (const HandState& hand : shown.hands.hands) {
        if (const std::optional<Pose> seen = seen_for(shown, hand)) {
            const std::string& name = shown.stand->instruments[static_cast<std::size_t>(hand.instrument)].name;
            ImGui::TextColored(to_learn, "%s: %s", words_.instrument(name).c_str(),
                               way_to(hand, *seen, words_).c_str());
        }
    }
}

void Panels::draw_lines(const Shown& shown, const std::optional<std::string>& next) const {
    const bool noticed = wall_seconds() < notice_until_s_;
    const bool stands = shown.hands.tracked && shown.waits && !shown.hands.paused;
    if (!next && !stands && shown.warnings.empty() && shown.lines.empty() && shown.hands.word.empty() && !noticed) {
        return;
    }
    const ImGuiIO& io = ImGui::GetIO();
    // beside the round field, and away from the wounds on the surgeon's side
    ImGui::SetNextWindowPos({io.DisplaySize.x - 8.0F, 8.0F}, ImGuiCond_Always, {1.0F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.55F);
    ImGui::Begin("lines", nullptr, plain | ImGuiWindowFlags_NoInputs);
    ImGui::PushTextWrapPos(0.3F * io.DisplaySize.x);
    if (next) {
        ImGui::TextColored(to_learn, "%s", next->c_str());
    }
    if (stands) {
        draw_standstill(shown);
    }
    for (const std::string& one : shown.warnings) {
        ImGui::TextColored(warning, "! %s", one.c_str());
    }
    for (const std::string& line : shown.lines) {
        ImGui::TextWrapped("%s", line.c_str());
    }
    if (!shown.hands.word.empty()) {
        ImGui::TextColored(warning, "%s", words_(shown.hands.word).c_str());
    }
    if (noticed) {
        ImGui::TextColored(warning, "%s", notice_.c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void Panels::draw_instruments(const Shown& shown, std::vector<UserEvent>& clicked) const {
    const Stand& stand = *shown.stand;
    const HandState& hand = shown.hands.hands[static_cast<std::size_t>(shown.hands.moving)];
    ImGui::TextDisabled(
        "%s",
        words_(shown.hands.moving == leading ? "Take with the leading hand" : "Take with the other hand").c_str());
    for (std::size_t i = 0; i < stand.instruments.size(); ++i) {
        if (!stand.instruments[i].hand_held) {
            continue;
        }
        const std::string label = words_.instrument(stand.instruments[i].name) + "##" + std::to_string(i);
        if (ImGui::Selectable(label.c_str(), hand.instrument == static_cast<int>(i))) {
            clicked.push_back(worked(ControlId::take_instrument, number(i)));
        }
    }
    if (ImGui::Button(words_("Put down").c_str())) {
        clicked.push_back(worked(ControlId::put_down));
    }
    ImGui::SameLine();
    if (ImGui::Button(words_("Other hand").c_str())) {
        clicked.push_back(worked(ControlId::swap));
    }
}

void Panels::draw_dials(const Shown& shown, std::vector<UserEvent>& clicked) const {
    const Stand& stand = *shown.stand;
    if (stand.dials.empty()) {
        return;
    }
    ImGui::TextDisabled("%s", words_("The machine").c_str());
    if (!ImGui::BeginTable("dials", 3, ImGuiTableFlags_SizingFixedFit)) {
        return;
    }
    for (std::size_t i = 0; i < stand.dials.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(words_.setting(stand.dials[i].setting).c_str());
        ImGui::TableNextColumn();
        for (const double notch : {-1.0, 1.0}) {
            if (ImGui::SmallButton(notch < 0.0 ? " - " : " + ")) {
                clicked.push_back(worked(ControlId::choose_dial, number(i)));
                clicked.push_back(worked(ControlId::dial_turn, notch));
            }
            ImGui::SameLine();
        }
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(dial_text(stand.dials[i], shown.hands.dials[i]).c_str());
        ImGui::PopID();
    }
    ImGui::EndTable();
}

void Panels::draw_requests(const Shown& shown, std::vector<UserEvent>& clicked) const {
    const std::vector<Request>& requests = shown.stand->requests;
    if (requests.empty()) {
        return;
    }
    ImGui::TextDisabled("%s", words_("Ask the staff").c_str());
    for (std::size_t i = 0; i < requests.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::Button(requests[i].title.c_str())) {
            clicked.push_back(worked(ControlId::choose_request, number(i)));
            clicked.push_back(worked(ControlId::request));
        }
        ImGui::PopID();
    }
}

/// Those that are offered, and the file in which a person's own is kept.
void Panels::draw_offers(const Mapping& now, std::vector<UserEvent>& clicked) {
    for (const MappingOffer& offer : offers_) {
        if (ImGui::Button(words_(offer.title).c_str())) {
            const std::vector<UserEvent> changes = now.changes_to(offer.mapping);
            clicked.insert(clicked.end(), changes.begin(), changes.end());
        }
        ImGui::SameLine();
    }
    if (!own_.empty() && ImGui::Button(words_("Keep as mine").c_str())) {
        keep_as_own(now);
    }
    ImGui::NewLine();
}

void Panels::keep_as_own(const Mapping& mapping) {
    const Status kept = write_mapping(mapping, own_);
    notice(kept ? words_("kept in %s", {own_}) : kept.error().text());
}

void Panels::draw_keys(const Shown& shown, std::vector<UserEvent>& clicked) {
    const Mapping& mapping = *shown.hands.mapping;
    draw_offers(mapping, clicked);
    ImGui::TextDisabled("%s", asked_ ? words_("Press what shall work it; Escape leaves it as it is").c_str()
                                     : words_("Click what shall be worked otherwise").c_str());
    ImGui::BeginChild("keys", {0.0F, 0.55F * ImGui::GetIO().DisplaySize.y});
    if (ImGui::BeginTable("inputs", 2, ImGuiTableFlags_SizingStretchProp)) {
        for (const Control& one : control_table()) {
            if (one.kind == ControlKind::place || one.kind == ControlKind::choice) {
                continue;
            }
            const bool both_ways = one.kind == ControlKind::rate || one.kind == ControlKind::notch;
            for (const bool turned : {false, true}) {
                if (turned && !both_ways) {
                    continue;
                }
                ImGui::TableNextColumn();
                const std::string meaning = words_(one.meaning) + (turned ? " (-)" : both_ways ? " (+)" : "");
                const std::string label = meaning + "##" + one.name + (turned ? "-" : "");
                if (ImGui::Selectable(label.c_str(), asked_ == one.id && asked_turned_ == turned)) {
                    asked_ = one.id;
                    asked_turned_ = turned;
                }
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(mapping.inputs_of(one.id, both_ways ? (turned ? -1.0 : 1.0) : 0.0).c_str());
            }
        }
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

/// While the clock stands the cursor is free to choose.
void Panels::draw_break(const Shown& shown, std::vector<UserEvent>& clicked) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5F * size.x, 0.5F * size.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowBgAlpha(0.9F);
    ImGui::SetNextWindowSizeConstraints({std::min(520.0F, size.x), 0.0F}, {size.x, size.y});
    ImGui::Begin("break", nullptr, plain);
    ImGui::TextUnformatted(words_("The clock stands.").c_str());
    const auto button = [&](const char* title, ControlId id) {
        if (ImGui::Button(words_(title).c_str())) {
            clicked.push_back(worked(id));
        }
    };
    button("Go on", ControlId::pause);
    ImGui::SameLine();
    button("End the exercise", ControlId::stop);
    button("Keep this moment", ControlId::keep_moment);
    ImGui::SameLine();
    button("Try again from there", ControlId::try_again);
    ImGui::SameLine();
    button("Expert's way", ControlId::ghost);
    if (ImGui::BeginTabBar("tabs")) {
        if (ImGui::BeginTabItem(words_("Stand").c_str())) {
            draw_instruments(shown, clicked);
            draw_dials(shown, clicked);
            draw_requests(shown, clicked);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem(words_("Keys").c_str())) {
            draw_keys(shown, clicked);
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
}

std::vector<UserEvent> Panels::draw(const Shown& shown, const Ghost* ghost, const DrawingRate& rate) {
    std::vector<UserEvent> clicked;
    overlay_.begin();
    if (!shown.marks.empty()) {
        draw_marks(shown, words_);
    }
    if (shown.hands.ghost && ghost != nullptr) {
        draw_ghost(shown, *ghost);
    }
    draw_force(shown);
    if (shown.hands.tracked && shown.waits) {
        draw_tracked_places(shown);
    } else if (shown.waits && !shown.hands.paused &&
               shown.hands.hands[static_cast<std::size_t>(shown.hands.moving)].instrument >= 0) {
        draw_meeting_place(shown);
    }
    draw_state(shown, rate);
    draw_lines(shown, guide_.next(shown.hands, *shown.stand, words_));
    if (shown.hands.help) {
        draw_help(*shown.hands.mapping, words_);
    }
    if (shown.hands.paused) {
        draw_break(shown, clicked);
    } else {
        asked_.reset();
    }
    mapping_ = shown.hands.mapping;
    overlay_.end();
    return clicked;
}

std::optional<std::vector<UserEvent>> Panels::captured(const UserEvent& event) {
    if (!asked_ || !mapping_) {
        return std::nullopt;
    }
    if (event.kind == EventKind::key && event.name == "Escape") {
        asked_.reset();
        return std::vector<UserEvent>{};
    }
    const Control& wanted = control(*asked_);
    const auto input = input_of(event, wanted.kind);
    if (!input) {
        return std::nullopt;
    }
    asked_.reset();
    return bound(*mapping_, wanted, input->first, asked_turned_ ? -input->second : input->second);
}

}  // namespace rhexis::station
