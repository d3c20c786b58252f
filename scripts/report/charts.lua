-- SPDX-License-Identifier: GPL-3.0-or-later
-- Which charts a report shows: each one for which the exercise measured what it needs.

local chart = require "report.chart"
local markup = require "report.markup"

local charts = {}

-- Measures of one chart; scale turns them into the unit shown.
local wanted = {
    { title = "How deep the groove is, as a share of the lens", unit = "%", range = { 0, 100 }, scale = 100,
        lines = { { "groove.depth_share", "deepest place" }, { "groove.mean_depth_share", "mean along the groove" } } },
    { title = "How long the groove is", unit = "mm", range = { 0, 5 },
        lines = { { "groove.length_mm", "length" }, { "groove.width_mm", "width" } } },
    { title = "Distance of the tip from the posterior capsule", unit = "mm", range = { 0, 3 },
        lines = { { "phaco.tip_posterior_mm", "distance" } }, danger = { from = 0, to = 0.3 } },
    { title = "How far the lens is pushed", unit = "mm", range = { 0, 0.6 },
        lines = { { "lens.displacement_mm", "lens" }, { "bag.displacement_mm", "bag" } },
        danger = { from = 0.5, to = 99 } },
    { title = "Foot pedal", unit = "position", range = { 0, 3 }, lines = { { "phaco.pedal", "pedal" } } },
    { title = "Force of the instrument on the lens", unit = "mN", range = { 0, 1 },
        lines = { { "phaco.force_mN", "force" } } },
    { title = "Brightness of the red reflex", unit = "0 dark, 1 full", range = { 0, 0.2 },
        lines = { { "reflex.tip", "at the tip" }, { "reflex.mean", "over the pupil" } } },
    { title = "Gap between instrument and iris", unit = "mm", range = { 0, 1 },
        lines = { { "iris.gap_mm", "gap" } }, danger = { from = -99, to = 0 } },
    { title = "Trembling of the tip (6 to 12 Hz)", unit = "µm", range = { 0, 100 },
        lines = { { "phaco.tremor_um", "root mean square" } } },
}

local function scaled(values, count, scale)
    if not scale then return values end
    local result = {}
    for i = 1, count do result[i] = type(values[i]) == "number" and scale * values[i] or nil end
    return result
end

local function lines_of(spec, series, count)
    local lines = {}
    for _, line in ipairs(spec.lines) do
        local measure = series.measures[line[1]]
        if measure and type(measure.values) == "table" then
            lines[#lines + 1] = { label = line[2], values = scaled(measure.values, count, spec.scale), count = count }
        end
    end
    return lines
end

local function any_number(lines)
    for _, line in ipairs(lines) do
        for i = 1, line.count do
            if type(line.values[i]) == "number" then return true end
        end
    end
    return false
end

local function figure(w, svg, title, unit)
    w("<figure><h3>", markup.escape(title))
    if unit then w(' <span class="soft small">(', markup.escape(unit), ")</span>") end
    w("</h3>", svg, "</figure>")
end

--- All charts as HTML; "" when there is no series.
function charts.html(report, series)
    local times = series and series.time_s
    if type(times) ~= "table" or #times < 2 or type(series.measures) ~= "table" then return "" end
    local count = #times
    local context = { times = times, last = math.max(1e-3, times[count]), steps = report.steps or {},
        events = report.events or {} }
    local w = markup.writer()
    for _, spec in ipairs(wanted) do
        local lines = lines_of(spec, series, count)
        if #lines > 0 and any_number(lines) then
            figure(w, chart.over_time({ title = spec.title, lines = lines, range = spec.range, danger = spec.danger },
                context), spec.title, spec.unit)
        end
    end
    local m = series.measures
    if m["phaco.tip_x_mm"] and m["phaco.tip_y_mm"] and m["phaco.ultrasound"] then
        local pupil = report.patient and report.patient.pupil_mm or 7.5
        figure(w, chart.way(m["phaco.tip_x_mm"], m["phaco.tip_y_mm"], m["phaco.ultrasound"], count, pupil),
            "Way of the tip, seen from above (the surgeon sits below)")
    end
    return w:text()
end

return charts
