// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>

#include "base/numbers.hpp"
#include "physics/fluid/chamber_flow.hpp"

namespace rhexis {

namespace {

template <typename Of>
struct Field {
    const char* name;
    double Of::*value;
    double low;
    double high;
    const char* unit;
};

template <typename Of, std::size_t n>
Status check_fields(const char* where, const Of& of, const std::array<Field<Of>, n>& fields) {
    for (const Field<Of>& field : fields) {
        Status status = check_range(field.name, of.*field.value, field.low, field.high, where, field.unit);
        if (!status.ok()) {
            return status;
        }
    }
    return success();
}

constexpr const char* state_name = "chamber state";
constexpr const char* per_pascal = " mm^3/Pa";
constexpr const char* resistance = " Pa s/mm^3";

constexpr std::array<Field<ChamberModel>, 15> model_fields{{
    {"eye_compliance", &ChamberModel::eye_compliance, 0.0015, 0.075, per_pascal},
    {"eye_stiffening", &ChamberModel::eye_stiffening, 0.0, 1.0, ""},
    {"collapse_pressure", &ChamberModel::collapse_pressure, 100.0, 2000.0, " Pa"},
    {"tube_compliance", &ChamberModel::tube_compliance, 0.0005, 0.05, per_pascal},
    {"infusion_resistance", &ChamberModel::infusion_resistance, 1.0, 100.0, resistance},
    {"tip_resistance", &ChamberModel::tip_resistance, 0.5, 200.0, resistance},
    {"tube_resistance", &ChamberModel::tube_resistance, 0.0, 200.0, resistance},
    {"leak_conductance", &ChamberModel::leak_conductance, 0.0, 0.5, " mm^3/(s Pa)"},
    {"pump_band", &ChamberModel::pump_band, 100.0, 5000.0, " Pa"},
    {"vent_resistance", &ChamberModel::vent_resistance, 1.0, 1000.0, resistance},
    {"fluid_density", &ChamberModel::fluid_density, 0.0009, 0.0011, " g/mm^3"},
    {"rest_pressure", &ChamberModel::rest_pressure, 500.0, 10000.0, " Pa"},
    {"area", &ChamberModel::area, 20.0, 300.0, " mm^2"},
    {"diaphragm_share", &ChamberModel::diaphragm_share, 0.0, 1.0, ""},
    {"half_hole_area", &ChamberModel::half_hole_area, 0.01, 100.0, " mm^2"},
}};

constexpr std::array<Field<ChamberControl>, 5> control_fields{{
    {"bottle_height", &ChamberControl::bottle_height, 0.0, 1500.0, " mm"},
    {"pump_flow", &ChamberControl::pump_flow, 0.0, 1000.0, " mm^3/s"},
    {"vacuum_limit", &ChamberControl::vacuum_limit, 0.0, 94000.0, " Pa"},
    {"tip_open", &ChamberControl::tip_open, 0.0, 1.0, ""},
    {"wound_open", &ChamberControl::wound_open, 0.0, 30.0, ""},
}};

constexpr double highest_pressure = 100000.0;  ///< of either tank, above or below atmospheric [Pa]
constexpr double most_moved = 1e9;             ///< [mm^3]
constexpr std::array<Field<ChamberTotals>, 4> totals_fields{{
    {"infused", &ChamberTotals::infused, -most_moved, most_moved, " mm^3"},
    {"vented", &ChamberTotals::vented, -most_moved, most_moved, " mm^3"},
    {"aspirated", &ChamberTotals::aspirated, -most_moved, most_moved, " mm^3"},
    {"leaked", &ChamberTotals::leaked, -most_moved, most_moved, " mm^3"},
}};
constexpr std::array<Field<WoundState>, 2> wound_fields{{
    {"temperature", &WoundState::temperature, 0.0, 500.0, " degrees C"},
    {"hot_s", &WoundState::hot_s, 0.0, most_moved, " s"},
}};

}  // namespace

Status check(const ChamberModel& model) { return check_fields("chamber", model, model_fields); }

Status check(const ChamberControl& control) { return check_fields("chamber control", control, control_fields); }

Status check(const ChamberModel& model, const ChamberState& state) {
    const ChamberState low = chamber_state(model, -highest_pressure, -highest_pressure);
    const ChamberState high = chamber_state(model, highest_pressure, highest_pressure);
    Status status = check_range("eye_volume", state.eye_volume, low.eye_volume, high.eye_volume, state_name, " mm^3");
    if (status.ok()) {
        status = check_range("tube_volume", state.tube_volume, low.tube_volume, high.tube_volume, state_name, " mm^3");
    }
    if (status.ok()) {
        status = check_fields(state_name, state.totals, totals_fields);
    }
    return status.ok() ? check_fields("wound", state.wound, wound_fields) : status;
}

Status check_chamber_step(double dt) {
    if (dt > 0.0 && dt <= 0.1) {
        return success();
    }
    return Error{std::string("step is ").append(short_number(dt)), "chamber", "above 0 to 0.1 s"};
}

}  // namespace rhexis
