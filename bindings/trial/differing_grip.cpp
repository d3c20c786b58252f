// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/differing_grip.hpp"

#include <algorithm>
#include <cmath>

namespace rhexis {
namespace {

constexpr double longest_apart_s = 0.1;
constexpr double shut_share = 0.95;  // of a mouth, from which on it holds. Proposal

bool ends_with_any(const std::string& name, std::initializer_list<const char*> endings) {
    return std::any_of(endings.begin(), endings.end(), [&name](const char* ending) { return name.ends_with(ending); });
}

}  // namespace

std::optional<DifferingGrip::Kind> DifferingGrip::kind_of(const MeasureInfo& info) {
    if (ends_with_any(info.name, {"rhexis.torn_mm", "iris.torn_mm", "zonules.torn_deg", "crack.faces"})) {
        return Kind::more_than_at_start;
    }
    if (ends_with_any(info.name, {"fragments.count", "rhexis.punctures"})) {
        return Kind::count;
    }
    if (info.unit == "bool" && ends_with_any(info.name, {".holding", ".held", ".captured", "rhexis.closed",
                                                         "rhexis.run_out", "capsule.open", "bag.rim_split"})) {
        return Kind::yes;
    }
    return info.name.ends_with(".occlusion") ? std::optional(Kind::shut) : std::nullopt;
}

DifferingGrip::DifferingGrip(const ObservationSchema& schema, const std::vector<double>& first,
                             const std::vector<double>& second) {
    for (std::size_t i = 0; i < schema.size(); ++i) {
        if (const std::optional<Kind> kind = kind_of(schema[i])) {
            signs_.push_back({i, schema[i].name, *kind, first[i], second[i]});
        }
    }
}

double DifferingGrip::seen(const Sign& sign, double value, double start) {
    switch (sign.kind) {
        case Kind::more_than_at_start:
            return value > start ? 1.0 : 0.0;
        case Kind::yes:
            return value > 0.5 ? 1.0 : 0.0;
        case Kind::count:
            return std::isnan(value) ? 0.0 : value;
        case Kind::shut:
            return value >= shut_share ? 1.0 : 0.0;
    }
    return 0.0;
}

std::optional<GripDifference> DifferingGrip::look(double time_s, const std::vector<double>& first,
                                                  const std::vector<double>& second) {
    std::optional<GripDifference> earliest;
    for (Sign& sign : signs_) {
        const double here = first[sign.measure];
        const double there = second[sign.measure];
        if (seen(sign, here, sign.first_start) == seen(sign, there, sign.second_start)) {
            sign.since.reset();
            continue;
        }
        if (!sign.since) {
            sign.since = GripDifference{time_s, sign.name, here, there};
        }
        const bool lasts = time_s - sign.since->time_s > longest_apart_s;
        if (lasts && (!earliest || sign.since->time_s < earliest->time_s)) {
            earliest = sign.since;
        }
    }
    return earliest;
}

bool DifferingGrip::in_doubt() const {
    return std::any_of(signs_.begin(), signs_.end(), [](const Sign& sign) { return sign.since.has_value(); });
}

}  // namespace rhexis
