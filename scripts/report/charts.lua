-- SPDX-License-Identifier: GPL-3.0-or-later
-- Which charts a report shows: each one for which the exercise measured what it needs.

local chart = require "report.chart"
local instruments = require "report.instruments"
local markup = require "report.markup"
local parts_of = require "report.parts"
local report_words = require "report.words"
local wanted = require "report.wanted_charts"
local way_chart = require "report.way_chart"

local t = report_words.t

local charts = {}

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
            local values = scaled(measure.values, count, spec.scale)
            lines[#lines + 1] = { label = t(line[2]), values = values, count = count }
        end
    end
    return lines
end

-- Whether there is anything to see: a line that never leaves its first value tells nothing.
local function varies(lines)
    for _, line in ipairs(lines) do
        local first
        for i = 1, line.count do
            local value = line.values[i]
            if type(value) == "number" then
                if first and value ~= first then return true end
                first = first or value
            end
        end
    end
    return false
end

local function figure(w, svg, title, unit, class)
    w("<figure", class and (' class="%s"'):format(class) or "", "><h3>", markup.escape(title))
    if unit then w(' <span class="soft small unit">(', markup.escape(unit), ")</span>") end
    w("</h3>", svg, "</figure>")
end

-- Lists of a measure's values, or nil where the exercise has not all of these measures.
local function values_of(measures, ...)
    local lists = {}
    for i, name in ipairs({ ... }) do
        local measure = measures[name]
        if not measure or type(measure.values) ~= "table" then return nil end
        lists[i] = measure.values
    end
    return table.unpack(lists)
end

local function way_of_tip(measures, count)
    local x, y, ultrasound = values_of(measures, "phaco.tip_x_mm", "phaco.tip_y_mm", "phaco.ultrasound")
    if not x then return nil end
    local strong = {}
    for i = 1, count do strong[i] = type(ultrasound[i]) == "number" and ultrasound[i] > 0 end
    return { x = x, y = y, strong = strong }
end

-- What tells that an instrument holds something.
local holding_of = { forceps = "forceps.holding" }

-- Instruments of which a measure is there, "%s.tip_x_mm", in the order of their names.
local function instruments_with(measures, ending)
    local names = {}
    for measure in pairs(measures) do
        local name = measure:match("^([%l_%d]+)%." .. ending .. "$")
        if name and instruments.inside(name) then names[#names + 1] = name end
    end
    table.sort(names)
    return names
end

local function way_of(measures, count, name, holding)
    local x, y = values_of(measures, name .. ".tip_x_mm", name .. ".tip_y_mm")
    if not x then return nil end
    local held, strong, any = holding and values_of(measures, holding), {}, false
    for i = 1, count do
        strong[i] = held and (held[i] == true or held[i] == 1) or false
        any = any or type(x[i]) == "number"
    end
    return any and { x = x, y = y, strong = strong } or nil
end

-- Where there is one line only, the title says whose it is.
local function titled(title, lines) return #lines == 1 and t("%s: %s", title, lines[1].label) or title end

-- Slow, voluntary movement would dwarf tremor.
local function spectrum_line(name, spectrum)
    local values = {}
    for k, hz in ipairs(spectrum.hz) do values[k] = hz >= 3 and spectrum.um_per_sqrt_hz[k] or nil end
    return { label = instruments.name(name), values = values, count = #spectrum.hz, hz = spectrum.hz }
end

-- How strongly every tip trembles at which frequency, two at most in one chart.
local function spectra(w, series)
    local names, found = {}, {}
    for name in pairs(type(series.spectra) == "table" and series.spectra or {}) do names[#names + 1] = name end
    table.sort(names)
    for _, name in ipairs(names) do
        local spectrum = series.spectra[name]
        if instruments.inside(name) and type(spectrum.hz) == "table" and type(spectrum.um_per_sqrt_hz) == "table" then
            local line = spectrum_line(name, spectrum)
            if varies { line } then found[#found + 1] = line end
        end
    end
    for from = 1, #found, 2 do
        local lines = { found[from], found[from + 1] }
        local title, hz = titled(t("Spectrum of tremor (blue ground: 6 to 12 Hz)"), lines), lines[1].hz
        figure(w, chart.over_time({ title = title, lines = lines, range = { 0, 10 }, band = { 6, 12 } },
            { times = hz, first = 0, last = hz[#hz], steps = {}, events = {}, part_starts = {}, starts = {},
                unit = "Hz" }), title, "µm/√Hz")
    end
end

-- A line over the parts of an operation in which there is something of it.
local function over_time(w, context, title, unit, spec)
    local first, last = parts_of.range(context, spec.lines)
    local own = setmetatable({ first = first, last = last }, { __index = context })
    spec.title = title
    figure(w, chart.over_time(spec, own), title, unit)
end

local function first_told(line)
    for i = 1, line.count do
        if type(line.values[i]) == "number" then return i end
    end
    return line.count
end

-- Trembling over time, in the order in which instruments were taken, two at most in one chart.
local function trembling(w, measures, count, context)
    local lines = {}
    for _, name in ipairs(instruments_with(measures, "tremor_um")) do
        local values = values_of(measures, name .. ".tremor_um")
        local line = { label = instruments.name(name), values = values, count = count }
        if values and varies { line } then lines[#lines + 1] = line end
    end
    table.sort(lines, function(a, b)
        local first, second = first_told(a), first_told(b)
        if first ~= second then return first < second end
        return a.label < b.label
    end)
    for from = 1, #lines, 2 do
        local two = { lines[from], lines[from + 1] }
        over_time(w, context, titled(t("Trembling of the tip (6 to 12 Hz)"), two), "µm",
            { lines = two, range = { 0, 100 } })
    end
end

local farthest_jump = 1.5  -- of the tear's end from one sample to the next; beyond, another end has gone on [mm]

local function way_of_tear(measures, count)
    local radius, angle, holding = values_of(measures, "rhexis.tip_radius_mm", "rhexis.tip_angle_deg",
        "forceps.holding")
    if not radius then return nil end
    local way = { x = {}, y = {}, strong = {} }
    local last_x, last_y
    for i = 1, count do
        if type(radius[i]) == "number" and type(angle[i]) == "number" then
            local x, y = radius[i] * math.cos(math.rad(angle[i])), radius[i] * math.sin(math.rad(angle[i]))
            if not last_x or math.abs(x - last_x) + math.abs(y - last_y) < farthest_jump then
                way.x[i], way.y[i] = x, y
            end
            way.strong[i] = holding[i] == true or holding[i] == 1
            last_x, last_y = x, y
        end
    end
    return last_x and way or nil
end

local function planned_circles(goals)
    local circles = { { radius = 3.0, label = t("optic") } }
    if goals and type(goals.radius_mm) == "number" then
        table.insert(circles, 1, { radius = goals.radius_mm, label = t("planned") })
    end
    return circles
end

-- Ways of tips and of the tear.
local function ways(w, report, measures, context)
    local count, pupil = #context.times, report.patient and report.patient.pupil_mm or 7.5
    local function way(title, found, ...)
        if not found or not way_chart.reaches_eye(found, count, context.starts) then return end
        figure(w, way_chart.svg(found, count, context.starts, pupil, ...),
            t("%s, seen from above (the surgeon sits below)", title), nil, "way")
    end
    local tip = way_of_tip(measures, count)
    way(t("Way of the tip"), tip, { strong = t("with ultrasound"), usual = t("without") })
    for _, name in ipairs(instruments_with(measures, "tip_x_mm")) do
        if not (tip and name == "phaco") then
            way(t("Way of the instrument: %s", instruments.name(name)), way_of(measures, count, name, holding_of[name]),
                { strong = holding_of[name] and t("holding") or "", usual = t("way") })
        end
    end
    way(t("Way of the tear"), way_of_tear(measures, count), { strong = t("led by the forceps"), usual = t("cut") },
        planned_circles(report.goals), 1.2 * pupil)
end

-- Whether the item that a chart is for is judged; of a report without a rubric each chart is drawn.
local function is_asked_for(spec, report)
    if not spec.item or not report.osacss then return true end
    for _, item in ipairs(report.osacss.items or {}) do
        if item.id == spec.item then return item.score ~= nil end
    end
    return false
end

--- All charts as HTML; "" when there is no series.
function charts.html(report, series)
    local times = series and series.time_s
    if type(times) ~= "table" or #times < 2 or type(series.measures) ~= "table" then return "" end
    local count = #times
    local context = { times = times, first = 0, last = math.max(1e-3, times[count]), steps = report.steps or {},
        events = report.events or {} }
    parts_of.mark(context, report.parts)
    local w = markup.writer()
    for _, spec in ipairs(wanted) do
        local lines = lines_of(spec, series, count)
        if #lines > 0 and varies(lines) and is_asked_for(spec, report) then
            over_time(w, context, t(spec.title), spec.unit and report_words.known(spec.unit),
                { lines = lines, range = spec.range, danger = spec.danger })
        end
    end
    trembling(w, series.measures, count, context)
    spectra(w, series)
    ways(w, report, series.measures, context)
    return w:text()
end

return charts
