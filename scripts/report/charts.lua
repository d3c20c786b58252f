-- SPDX-License-Identifier: GPL-3.0-or-later
-- Which charts a report shows: each one for which the exercise measured what it needs.

local chart = require "report.chart"
local markup = require "report.markup"
local t = require("report.words").t

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
    { title = "End of the tear: how far from the middle", unit = "mm", range = { 0, 4 },
        lines = { { "rhexis.tip_radius_mm", "distance" } }, danger = { from = 3.37, to = 99 } },
    { title = "How far the tear has come round", unit = "degrees", range = { 0, 360 },
        lines = { { "rhexis.turned_deg", "angle" } } },
    { title = "How full the chamber is", unit = "%", range = { 0, 110 }, scale = 100,
        lines = { { "viscoelastic.fill", "viscoelastic" } } },
    { title = "Pull of the forceps", unit = "mN", range = { 0, 20 },
        lines = { { "forceps.force_mN", "force" } } },
    { title = "How far the implant is out, and how far it is unfolded", unit = "%", range = { 0, 100 }, scale = 100,
        lines = { { "implant.delivered", "out of the nozzle" }, { "implant.unfolded", "unfolded" } } },
    { title = "How far the implant lies from the bag's axis", unit = "mm", range = { 0, 1 },
        lines = { { "implant.decentration_mm", "distance" } }, danger = { from = 0.5, to = 99 } },
    { title = "How far the implant is tilted", unit = "degrees", range = { 0, 10 },
        lines = { { "implant.tilt_deg", "tilt" } }, danger = { from = 5, to = 180 } },
    { title = "How far the edge of the opening is stretched, of its length", unit = "1", range = { 1, 1.3 },
        lines = { { "bag.rim_stretch", "most stretched eighth" } }, danger = { from = 1.25, to = 99 } },
    { title = "Force on the plunger", unit = "N", range = { 0, 1 }, scale = 1e-3,
        lines = { { "injector.force_mN", "force" } } },
    { title = "Depth of the chamber", unit = "% of its depth at the start", range = { 0, 110 }, scale = 100,
        lines = { { "chamber.depth_share", "depth" } }, danger = { from = -99, to = 70 } },
    { title = "Pressure in the eye", unit = "mmHg", range = { 0, 60 },
        lines = { { "chamber.pressure_mmhg", "pressure" } }, danger = { from = -99, to = 5 } },
    { title = "Pressure in the eye", unit = "mmHg", range = { 0, 60 },
        lines = { { "viscoelastic.pressure_mmhg", "pressure" } }, danger = { from = 60, to = 999 } },
    { title = "Vacuum in the tubing", unit = "mmHg", range = { 0, 100 },
        lines = { { "panel.vacuum_mmhg", "vacuum" } } },
    { title = "Ultrasound given so far (CDE)", unit = "% s", range = { 0, 1 },
        lines = { { "phaco.cde", "cumulative dissipated energy" } } },
    { title = "Way of all tips so far", unit = "mm", range = { 0, 10 },
        lines = { { "instruments.path_mm", "way" } } },
    { title = "Trembling of the tip (6 to 12 Hz)", unit = "µm", range = { 0, 100 },
        lines = { { "phaco.tremor_um", "phaco" }, { "spatula.tremor_um", "second instrument" } } },
    { title = "Trembling of the tip (6 to 12 Hz)", unit = "µm", range = { 0, 100 },
        lines = { { "cystotome.tremor_um", "needle" }, { "forceps.tremor_um", "forceps" } } },
    { title = "Trembling of the tip (6 to 12 Hz)", unit = "µm", range = { 0, 100 },
        lines = { { "injector.tremor_um", "injector" }, { "hook.tremor_um", "hook" } } },
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
            local values = scaled(measure.values, count, spec.scale)
            lines[#lines + 1] = { label = t(line[2]), values = values, count = count }
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

-- Instruments besides the phaco probe whose ways are drawn, and what tells that they hold something.
local other_tips = { { "cystotome", "needle" }, { "forceps", "forceps", "forceps.holding" },
    { "spatula", "second instrument" }, { "hook", "hook" }, { "injector", "injector" }, { "probe", "probe" } }

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
                lines[#lines + 1] = { label = (names[i]:gsub("_", " ")), values = values, count = #hz }
            end
        end
        if hz then
            local title = "Spectrum of tremor (blue ground: 6 to 12 Hz)"
            figure(w, chart.over_time({ title = title, lines = lines, range = { 0, 10 }, band = { 6, 12 } },
                { times = hz, last = hz[#hz], steps = {}, events = {}, unit = "Hz" }), title, "µm/√Hz")
        end
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
        if #lines > 0 and any_number(lines) then
            local title = t(spec.title)
            figure(w, chart.over_time({ title = title, lines = lines, range = spec.range, danger = spec.danger },
                context), title, spec.unit:find("^%l+$") and #spec.unit > 2 and t(spec.unit) or spec.unit)
        end
    end
    spectra(w, series)
    local pupil = report.patient and report.patient.pupil_mm or 7.5
    local function way(title, ...)
        figure(w, chart.way(...), t("%s, seen from above (the surgeon sits below)", t(title)))
    end
    local tip = way_of_tip(series.measures, count)
    if tip then way("Way of the tip", tip, count, pupil, { strong = t("with ultrasound"), usual = t("without") }) end
    for _, other in ipairs(other_tips) do
        local found = way_of(series.measures, count, other[1], other[3])
        if found then
            way("Way of the " .. other[2], found, count, pupil, { strong = other[3] and t("holding") or "",
                usual = t("way") })
        end
    end
    local tear = way_of_tear(series.measures, count)
    if tear then
        way("Way of the tear", tear, count, pupil, { strong = t("led by the forceps"), usual = t("cut") },
            planned_circles(report.goals), 1.2 * pupil)
    end
    return w:text()
end

return charts
