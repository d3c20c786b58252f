// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/theatre.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace rhexis::station {
namespace {

int index_of(const ObservationSchema& schema, const std::string& name) {
    const auto found =
        std::find_if(schema.begin(), schema.end(), [&](const MeasureInfo& one) { return one.name == name; });
    return found == schema.end() ? -1 : static_cast<int>(found - schema.begin());
}

/// Below 0: it is not measured, or not defined now.
double value_of(const Session& session, int measure) {
    if (measure < 0) {
        return -1.0;
    }
    const double value = session.observation().values[static_cast<std::size_t>(measure)];
    return std::isnan(value) ? -1.0 : value;
}

double setting_of(const Session& session, const char* name) {
    const auto found = session.settings().find(name);
    return found == session.settings().end() ? -1.0 : found->second;
}

}  // namespace

std::string usual_theatre() {
    const char* own = std::getenv("XDG_RUNTIME_DIR");
    std::error_code unknown;
    const std::string folder = own != nullptr && std::filesystem::is_directory(own, unknown)
                                   ? std::string(own)
                                   : std::filesystem::temp_directory_path(unknown).string();
    return "ipc://" + folder + "/rhexis-theatre-" + std::to_string(::getuid()) + "/feed";
}

PanelReader::PanelReader(const ObservationSchema& schema, const std::vector<std::string>& instruments)
    : vacuum_(index_of(schema, "panel.vacuum_mmhg")),
      flow_(index_of(schema, "panel.flow_ml_min")),
      chamber_share_(index_of(schema, "chamber.depth_share")),
      depth_lost_(index_of(schema, "chamber.depth_lost_share")) {
    for (const std::string& name : instruments) {
        const auto of = [&](const char* field) { return index_of(schema, name + "." + field); };
        const int present = of("present");
        for (const char* field : {"force_mN", "hold_mN"}) {
            if (const int measure = of(field); measure >= 0) {
                forces_.push_back({name, schema[static_cast<std::size_t>(measure)].meaning, measure, present});
            }
        }
        if (of("pedal") >= 0) {
            machines_.push_back({name, present, of("pedal"), of("power"), of("cde"), of("occlusion")});
        }
    }
    if (const int measure = index_of(schema, "capsule.force_mN"); measure >= 0) {
        forces_.push_back({"", "Force of instruments on the posterior capsule.", measure, -1});
    }
}

MachinePanel PanelReader::panel(const Session& session) const {
    MachinePanel panel;
    panel.there = !machines_.empty();
    if (!panel.there) {
        return panel;
    }
    const auto in_use = std::find_if(machines_.begin(), machines_.end(),
                                     [&](const Machine& one) { return value_of(session, one.present) > 0.5; });
    const Machine& machine = in_use == machines_.end() ? machines_.front() : *in_use;
    panel.pedal = std::max(0.0, value_of(session, machine.pedal));
    panel.power = value_of(session, machine.power);
    panel.cde = value_of(session, machine.cde);
    panel.occlusion = value_of(session, machine.occlusion);
    panel.vacuum_mmhg = value_of(session, vacuum_);
    panel.flow_ml_min = value_of(session, flow_);
    panel.chamber_share = value_of(session, chamber_share_);
    panel.depth_lost = std::max(0.0, value_of(session, depth_lost_));
    panel.bottle_cm = setting_of(session, "machine.bottle_cm");
    panel.infusion = setting_of(session, "machine.infusion");
    return panel;
}

std::vector<HandForce> PanelReader::forces(const Session& session) const {
    std::vector<HandForce> list;
    for (const Force& one : forces_) {
        if (one.present < 0 || value_of(session, one.present) > 0.5) {
            list.push_back({one.instrument, one.meaning, std::max(0.0, value_of(session, one.measure))});
        }
    }
    return list;
}

Status tell_exercise(ExerciseHost& host, bool score, TheatreMoment& moment) {
    const Result<nlohmann::json> told = host.theatre(score);
    if (!told) {
        return told.error();
    }
    const nlohmann::json& json = told.value();
    if (!json.is_object()) {
        return success();
    }
    json.at("steps").get_to(moment.steps);
    json.at("events").get_to(moment.events);
    json.at("warnings").get_to(moment.warnings);
    json.at("vitals").get_to(moment.vitals);
    json.at("notes").get_to(moment.notes);
    if (json.contains("score")) {
        json.at("score").get_to(moment.score);
    }
    return success();
}

}  // namespace rhexis::station
