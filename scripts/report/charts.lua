-- SPDX-License-Identifier: GPL-3.0-or-later
-- Which charts a report shows: each one for which the exercise measured what it needs.

local chart = require "report.chart"
local markup = require "report.markup"
local wanted = require "report.wanted_charts"
local report_words = require "report.words"

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

-- What an instrument is called where that is not its name, what tells that it holds something, and those that stay
-- outside of the eye.
local called = { cystotome = "needle", spatula = "second instrument" }
local holding_of = { forceps = "forceps.holding" }
local outside = { drape = true, speculum = true }

local function name_of(instrument) return t(called[instrument] or (instrument:gsub("_", " "))) end

-- Instruments of which a measure is there, "%s.tip_x_mm", in the order of their names.
local function instruments_with(measures, ending)
    local names = {}
    for measure in pairs(measures) do
        local name = measure:match("^([%l_%d]+)%." .. ending .. "$")
        if name and not outside[name] then names[#names + 1] = name end
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

-- How strongly every tip trembles at which frequency, two at most in one chart.
local function spectra(w, series)
    local names = {}
    for name in pairs(type(series.spectra) == "table" and series.spectra or {}) do names[#names + 1] = name end
    table.sort(names)
    for from = 1, #names, 2 do
        local lines, hz = {}, nil
        for i = from, math.min(#names, from + 1) do
            local spectrum = series.spectra[names[i]]
            if type(spectrum.hz) == "table" and type(spectrum.um_per_sqrt_hz) == "table" then
                hz = spectrum.hz
                local values = {}  -- slow, voluntary movement would dwarf tremor
                for k = 1, #hz do values[k] = hz[k] >= 3 and spectrum.um_per_sqrt_hz[k] or nil end
                lines[#lines + 1] = { label = name_of(names[i]), values = values, count = #hz }
            end
        end
        if hz then
            local title = t("Spectrum of tremor (blue ground: 6 to 12 Hz)")
            figure(w, chart.over_time({ title = title, lines = lines, range = { 0, 10 }, band = { 6, 12 } },
                { times = hz, last = hz[#hz], steps = {}, events = {}, unit = "Hz" }), title, "µm/√Hz")
        end
    end
end

-- Trembling over time, two instruments at most in one chart.
local function trembling(w, measures, count, context)
    local lines = {}
    for _, name in ipairs(instruments_with(measures, "tremor_um")) do
        local line = { label = name_of(name), values = values_of(measures, name .. ".tremor_um"), count = count }
        if line.values and varies { line } then lines[#lines + 1] = line end
    end
    for from = 1, #lines, 2 do
        local title = t("Trembling of the tip (6 to 12 Hz)")
        figure(w, chart.over_time({ title = title, lines = { lines[from], lines[from + 1] }, range = { 0, 100 } },
            context), title, "µm")
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
        if #lines > 0 and varies(lines) then
            local title = t(spec.title)
            figure(w, chart.over_time({ title = title, lines = lines, range = spec.range, danger = spec.danger },
                context), title, report_words.known(spec.unit))
        end
    end
    trembling(w, series.measures, count, context)
    spectra(w, series)
    local pupil = report.patient and report.patient.pupil_mm or 7.5
    local function way(title, ...)
        figure(w, chart.way(...), t("%s, seen from above (the surgeon sits below)", title), nil, "way")
    end
    local tip = way_of_tip(series.measures, count)
    if tip then way(t("Way of the tip"), tip, count, pupil, { strong = t("with ultrasound"), usual = t("without") }) end
    for _, name in ipairs(instruments_with(series.measures, "tip_x_mm")) do
        local found = not (tip and name == "phaco") and way_of(series.measures, count, name, holding_of[name])
        if found then
            way(t("Way of the instrument: %s", name_of(name)), found, count, pupil,
                { strong = holding_of[name] and t("holding") or "", usual = t("way") })
        end
    end
    local tear = way_of_tear(series.measures, count)
    if tear then
        way(t("Way of the tear"), tear, count, pupil, { strong = t("led by the forceps"), usual = t("cut") },
            planned_circles(report.goals), 1.2 * pupil)
    end
    return w:text()
end

return charts
