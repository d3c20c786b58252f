// SPDX-License-Identifier: GPL-3.0-or-later
// Figures as tables and as JSON.
#include <cstdio>

#include "tracking/measure/figures.hpp"

namespace rhexis::tracking {
namespace {

constexpr double to_um = 1e3;  // from mm
constexpr double to_ms = 1e3;  // from s

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string whole(std::int64_t value) { return std::to_string(value); }

std::string row(std::initializer_list<std::string> cells) {
    std::string line = "|";
    for (const std::string& cell : cells) {
        line += " " + cell + " |";
    }
    return line + "\n";
}

std::string tip_cells(const ErrorFigures& tip) {
    return number(to_um * tip.mean) + " | " + number(to_um * tip.rms) + " | " + number(to_um * tip.of_95) + " | " +
           number(to_um * tip.of_999) + " | " + number(to_um * tip.worst);
}

double valid_percent(const ErrorFigures& tip) {
    return tip.frames > 0 ? 100.0 * static_cast<double>(tip.valid) / static_cast<double>(tip.frames) : 0.0;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

std::string tip_json(const ErrorFigures& tip) {
    return "\"frames\": " + whole(tip.frames) + ", \"valid\": " + whole(tip.valid) +
           ", \"mean_mm\": " + number(tip.mean) + ", \"rms_mm\": " + number(tip.rms) +
           ", \"of_95_mm\": " + number(tip.of_95) + ", \"of_999_mm\": " + number(tip.of_999) +
           ", \"worst_mm\": " + number(tip.worst);
}

/// Objects of an array, each on a line.
template <typename Items, typename ToText>
std::string array_json(const Items& items, ToText to_text) {
    std::string text = "[";
    bool first = true;
    for (const auto& item : items) {
        text += (first ? "\n    {" : ",\n    {") + to_text(item) + "}";
        first = false;
    }
    return text + "\n  ]";
}

std::string figure_json(const Figure& figure) {
    return "\"quantity\": " + quoted(figure.quantity) + ", \"unit\": " + quoted(figure.unit) +
           ", \"value\": " + number(figure.value) + ", \"mean_of_seeds\": " + number(figure.mean) +
           ", \"worst_seed\": " + std::to_string(figure.worst_seed) + ", \"of_worst_seed\": " + number(figure.worst) +
           (figure.goal ? ", \"goal\": " + number(*figure.goal) : "") +
           ", \"met\": " + (figure.met() ? "true" : "false") + ", \"published\": " + quoted(figure.published) +
           ", \"samples\": " + whole(figure.samples) + ", \"from\": " + quoted(figure.from);
}

std::string spread_json(const Spread& spread) {
    std::string text = "\"quantity\": " + quoted(spread.quantity) + ", \"unit\": " + quoted(spread.unit) +
                       ", \"from\": " + quoted(spread.from) + ", \"samples\": " + whole(spread.samples) +
                       ", \"mean\": " + number(spread.mean) + ", \"rms\": " + number(spread.rms) + ", \"quantiles\": [";
    const char* before = "";
    for (const Spread::Quantile& quantile : spread.curve) {
        char pair[64];
        std::snprintf(pair, sizeof pair, "%s[%.6f, %.5g]", before, quantile.share, quantile.value);
        text += pair;
        before = ", ";
    }
    return text + "]";
}

std::string spread_row(const Spread& spread) {
    // Shares of things that are so or not are told by their mean alone.
    const bool share = spread.unit == "%";
    std::string cells = number(spread.mean) + " | " + (share ? "" : number(spread.rms));
    for (const double value : spread.at) {
        cells += " | " + (share ? std::string() : number(value));
    }
    return row({spread.quantity, spread.from, spread.unit, whole(spread.samples), cells});
}

std::string spreads_table(const std::string& title, const std::vector<Spread>& spreads) {
    std::string text =
        "\n" + title + ":\n\n" +
        row({"quantity", "from", "unit", "samples", "mean", "RMS", "50 %", "90 %", "95 %", "99 %", "99.9 %", "worst"}) +
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    bool any = false;
    for (const Spread& spread : spreads) {
        if (spread.samples > 0) {
            text += spread_row(spread);
            any = true;
        }
    }
    return any ? text : std::string();
}

std::string chart_json(const ChartRow& entry) {
    return "\"detector\": " + quoted(entry.detector) + ", \"cameras\": " + std::to_string(entry.cameras) +
           ", \"markers\": " + std::to_string(entry.markers) + ", \"detect_p50_s\": " + number(entry.detect_p50_s) +
           ", \"track_p50_s\": " + number(entry.track_p50_s) + ", " + tip_json(entry.tip);
}

}  // namespace

std::string figures_markdown(const TrackingFigures& figures) {
    std::string text = row({"quantity", "all seeds", "mean of seeds", "worst seed", "goal", "", "published by others",
                            "samples", "from"}) +
                       "|---|---|---|---|---|---|---|---|---|\n";
    for (const Figure& figure : figures.figures) {
        if (figure.samples > 0) {
            text += row({figure.quantity, number(figure.value) + " " + figure.unit, number(figure.mean),
                         number(figure.worst) + " (" + std::to_string(figure.worst_seed) + ")",
                         figure.goal ? std::string(figure.at_least ? ">= " : "<= ") + number(*figure.goal) : "",
                         !figure.goal   ? ""
                         : figure.met() ? "met"
                                        : "not met",
                         figure.published, whole(figure.samples), figure.from});
        }
    }
    if (!figures.by_cameras.empty()) {
        text += "\nTip errors by how many cameras saw the instrument [µm]:\n\n";
        text += row({"cameras", "from", "mean", "RMS", "95 %", "99.9 %", "worst", "samples"}) +
                "|---|---|---|---|---|---|---|---|\n";
    }
    for (const CamerasFigures& entry : figures.by_cameras) {
        if (entry.tip.valid > 0) {
            text += row({std::to_string(entry.cameras), entry.images ? "images" : "markers", tip_cells(entry.tip),
                         whole(entry.tip.valid)});
        }
    }
    text += spreads_table("The same clips and seeds with images and without", figures.levels);
    text += spreads_table("In the terms of standards", figures.standards);
    if (!figures.chart.empty()) {
        text += "\nAccuracy against compute, the same images of a still clip [µm; ms on one core]:\n\n";
        text += row({"detector", "cameras", "markers", "mean", "RMS", "95 %", "99.9 %", "worst", "valid %", "detect",
                     "track"}) +
                "|---|---|---|---|---|---|---|---|---|---|---|\n";
    }
    for (const ChartRow& entry : figures.chart) {
        text += row({entry.detector, std::to_string(entry.cameras), std::to_string(entry.markers), tip_cells(entry.tip),
                     number(valid_percent(entry.tip)), number(to_ms * entry.detect_p50_s),
                     number(to_ms * entry.track_p50_s)});
    }
    return text;
}

std::string figures_json(const TrackingFigures& figures) {
    std::string text = "{\n  \"first_seed\": " + std::to_string(figures.first_seed) +
                       ",\n  \"seeds\": " + std::to_string(figures.seeds) +
                       ",\n  \"marker_seeds\": " + std::to_string(figures.marker_seeds) + ",\n  \"figures\": ";
    text += array_json(figures.figures, figure_json) + ",\n  \"by_cameras\": ";
    text += array_json(figures.by_cameras, [](const CamerasFigures& entry) {
        return "\"cameras\": " + std::to_string(entry.cameras) +
               ", \"from\": " + quoted(entry.images ? "images" : "markers") + ", " + tip_json(entry.tip);
    });
    text += ",\n  \"levels\": " + array_json(figures.levels, spread_json);
    text += ",\n  \"standards\": " + array_json(figures.standards, spread_json);
    return text + ",\n  \"chart\": " + array_json(figures.chart, chart_json) + "\n}\n";
}

}  // namespace rhexis::tracking
