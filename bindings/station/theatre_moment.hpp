// SPDX-License-Identifier: GPL-3.0-or-later
// station -> theatre's monitor: what it shows of one moment. Each moment is whole, so that one that is lost, or a
// monitor that comes later, misses nothing; what it does not know is empty.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rhexis::station {

/// As scripts/engine/run.lua tells them: state "done", "now", "to come", "undone" or "left out".
struct TheatreStep {
    std::string title;
    std::string state;
    std::string hint;
};

struct TheatreEvent {
    std::string title;
    std::string advice;
    double time_s = 0.0;
    std::string outcome;  ///< "open", "recovered", "near_miss", "not_recovered"
    std::string severity;
};

struct TheatreWarning {
    std::string title;
    std::string advice;
};

/// Of the patient; scripted.
struct Vitals {
    double heart_per_min = 0.0;
    double systolic_mmhg = 0.0;
    double diastolic_mmhg = 0.0;
    double saturation_percent = 0.0;
    double beat = 0.0;  ///< how far the heart is through its beat, 0 to 1
};

/// The phaco machine's panel. What the scene does not have is below 0.
struct MachinePanel {
    bool there = false;
    double pedal = -1.0;
    double power = -1.0;        ///< of ultrasound, share of full
    double vacuum_mmhg = -1.0;  ///< in the tubing
    double flow_ml_min = -1.0;
    double bottle_cm = -1.0;
    double cde = -1.0;            ///< [% s]
    double infusion = -1.0;       ///< 0: shut, kinked or empty
    double occlusion = -1.0;      ///< share of the mouth that is shut
    double chamber_share = -1.0;  ///< depth of the chamber, share of that at the start
    double depth_lost = 0.0;      ///< share of it lost within the last second
};

struct HandForce {
    std::string instrument;
    std::string meaning;  ///< on what it acts, as the measure says
    double mN = 0.0;
};

struct DeviceHealth {
    std::string name;  ///< "keyboard and mouse", "pad", "pedal"
    bool there = true;
};

struct TheatreItem {
    std::string id;
    std::string name;
    double score = -1.0;  ///< below 0: not scored yet
};

struct TheatreScore {
    std::vector<TheatreItem> items;
    double total = 0.0;
    double max = 0.0;
};

struct TheatreNote {
    double time_s = 0.0;
    std::string text;
};

struct TheatreInjection {
    std::string id;
    std::string title;
    bool runs = false;
};

struct TheatreMoment {
    int version = 1;
    std::string exercise;
    double time_s = 0.0;
    bool waits = false;  ///< the clock stands
    bool paused = false;
    bool ended = false;
    bool exam = false;
    bool warns = false;  ///< the trainee is shown warnings
    double slowed = 1.0;
    double pictures_per_s = 0.0;
    std::vector<TheatreStep> steps;
    std::vector<TheatreEvent> events;
    std::vector<TheatreWarning> warnings;
    Vitals vitals;
    MachinePanel machine;
    std::vector<HandForce> forces;
    std::vector<DeviceHealth> devices;
    TheatreScore score;
    std::vector<std::string> lines;  ///< what was said to the trainee of late
    std::vector<TheatreNote> notes;
    std::vector<TheatreInjection> injections;
    std::vector<std::string> levels;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TheatreStep, title, state, hint)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TheatreEvent, title, advice, time_s, outcome, severity)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TheatreWarning, title, advice)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Vitals, heart_per_min, systolic_mmhg, diastolic_mmhg,
                                                saturation_percent, beat)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(MachinePanel, there, pedal, power, vacuum_mmhg, flow_ml_min, bottle_cm,
                                                cde, infusion, occlusion, chamber_share, depth_lost)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(HandForce, instrument, meaning, mN)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(DeviceHealth, name, there)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TheatreItem, id, name, score)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TheatreScore, items, total, max)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TheatreNote, time_s, text)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TheatreInjection, id, title, runs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(TheatreMoment, version, exercise, time_s, waits, paused, ended, exam,
                                                warns, slowed, pictures_per_s, steps, events, warnings, vitals, machine,
                                                forces, devices, score, lines, notes, injections, levels)

}  // namespace rhexis::station
