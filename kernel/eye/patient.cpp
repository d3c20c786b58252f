// SPDX-License-Identifier: GPL-3.0-or-later
#include "eye/patient.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/near_names.hpp"
#include "base/numbers.hpp"
#include "base/text_file.hpp"

namespace rhexis {

namespace {

struct NumberField {
    const char* name;
    double Patient::*value;
    double low;
    double high;
    const char* unit;
};

constexpr std::array<NumberField, 4> number_fields{{
    {"age", &Patient::age, 20.0, 95.0, " years"},
    {"nuclear_grade", &Patient::nuclear_grade, 1.0, 6.0, ""},
    {"cortical_opacity", &Patient::cortical_opacity, 0.0, 1.0, ""},
    {"pupil_mm", &Patient::pupil_mm, 3.0, 9.0, " mm"},
}};

constexpr int fewest_tetrahedra = 500;
constexpr int most_tetrahedra = 24000;

constexpr std::size_t longest_file = 1 << 20;  ///< [bytes]

std::vector<std::string> field_names() {
    std::vector<std::string> names;
    for (const NumberField& field : number_fields) {
        names.emplace_back(field.name);
    }
    names.insert(names.end(), {"side", "tetrahedra", "note"});
    return names;
}

Status set_field(const std::string& name, const nlohmann::json& value, Patient& patient) {
    for (const NumberField& field : number_fields) {
        if (name == field.name) {
            if (!value.is_number()) {
                return Error{name + " is not a number", "", range_text(field.low, field.high, field.unit)};
            }
            patient.*field.value = value.get<double>();
            return success();
        }
    }
    if (name == "side" || name == "note") {
        if (!value.is_string()) {
            return Error{name + " is not a text", "", name == "side" ? "\"right\" or \"left\"" : "any text"};
        }
        if (name == "side") {
            patient.side = value.get<std::string>();
        }
        return success();
    }
    if (name == "tetrahedra") {
        const bool fits = value.is_number_integer() && value.get<double>() >= 0.0 && value.get<double>() <= 1e9;
        if (!fits) {
            return Error{"tetrahedra is not a whole number", "", range_text(fewest_tetrahedra, most_tetrahedra)};
        }
        patient.tetrahedra = value.get<int>();
        return success();
    }
    const std::vector<std::string> names = field_names();
    std::string known;
    for (const std::string& field : names) {
        known.append(known.empty() ? "one of " : ", ").append(field);
    }
    return Error{"unknown field \"" + name + "\"" + did_you_mean(name, names), "", known};
}

std::size_t line_of(const std::string& text, std::size_t byte) {
    const std::size_t end = std::min(byte, text.size());
    return 1 +
           static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
}

Result<nlohmann::json> parse(const std::string& text, const std::string& path) {
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        return Error{"is not JSON", path + ":" + std::to_string(line_of(text, error.byte > 0 ? error.byte - 1 : 0)),
                     "an object such as {\"age\": 68, \"nuclear_grade\": 3}"};
    } catch (const nlohmann::json::out_of_range&) {
        return Error{"holds a number beyond all range", path, "at most 1e308"};
    }
}

}  // namespace

Status check(const Patient& patient) {
    for (const NumberField& field : number_fields) {
        Status status = check_range(field.name, patient.*field.value, field.low, field.high, "patient", field.unit);
        if (!status.ok()) {
            return status;
        }
    }
    if (patient.side != "right" && patient.side != "left") {
        return Error{"side is \"" + patient.side + "\"", "patient", "\"right\" or \"left\""};
    }
    if (patient.tetrahedra < fewest_tetrahedra || patient.tetrahedra > most_tetrahedra) {
        return Error{"tetrahedra is " + std::to_string(patient.tetrahedra), "patient",
                     range_text(fewest_tetrahedra, most_tetrahedra)};
    }
    return success();
}

Result<Patient> read_patient(const std::string& path) {
    const Result<std::string> text = read_text_file(path, longest_file);
    if (!text.ok()) {
        return text.error();
    }
    const Result<nlohmann::json> json = parse(text.value(), path);
    if (!json.ok()) {
        return json.error();
    }
    if (!json.value().is_object()) {
        return Error{"is not a JSON object", path, "an object such as {\"age\": 68, \"nuclear_grade\": 3}"};
    }
    Patient patient;
    for (const auto& [name, value] : json.value().items()) {
        if (const Status status = set_field(name, value, patient); !status.ok()) {
            return Error{status.error().what, path, status.error().allowed};
        }
    }
    if (const Status status = check(patient); !status.ok()) {
        return Error{status.error().what, path, status.error().allowed};
    }
    return patient;
}

}  // namespace rhexis
