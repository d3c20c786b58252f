-- SPDX-License-Identifier: GPL-3.0-or-later
-- Charts as SVG: lines over time with steps and errors marked.

local markup = require "report.markup"
local report_words = require "report.words"

local known = report_words.known

local chart = {}

local e, number = markup.escape, markup.number
local palette = { "#1f5f8b", "#c2570c", "#3a7d44" }
local width, height, left, right, top, bottom = 560, 214, 50, 12, 12, 30

-- A step of 1, 2 or 5 times a power of ten that cuts `span` into at most `most` parts.
local function nice_step(span, most)
    if span <= 0 then return 1 end
    local rough = span / most
    local magnitude = 10.0 ^ math.floor(math.log(rough, 10))
    for _, factor in ipairs({ 1, 2, 5, 10 }) do
        if factor * magnitude >= rough - 1e-12 then return factor * magnitude end
    end
    return 10 * magnitude
end

local function extent(lines, fixed)
    local low, high = fixed and fixed[1] or math.huge, fixed and fixed[2] or -math.huge
    for _, line in ipairs(lines) do
        for i = 1, line.count do
            local v = line.values[i]
            if type(v) == "number" then low, high = math.min(low, v), math.max(high, v) end
        end
    end
    if low > high then low, high = 0, 1 end
    if high - low < 1e-9 then high = low + 1 end
    return low, high
end

-- One path; a gap where the measure was not defined, and where another part of an operation begins.
local function path_of(times, starts, line, x_of, y_of)
    local w, pen = markup.writer(), "M"
    for i = 1, line.count do
        local v = line.values[i]
        if starts[i] then pen = "M" end
        if type(v) == "number" and type(times[i]) == "number" then
            w(pen, ("%.1f %.1f"):format(x_of(times[i]), y_of(v)))
            pen = "L"
        else
            pen = "M"
        end
    end
    return w:text()
end

local function bands(w, context, x_of)
    for i, step in ipairs(context.steps) do
        if step.start_s and step.end_s and i % 2 == 0 then
            local x1 = x_of(math.max(context.first, step.start_s))
            local x2 = x_of(math.min(context.last, step.end_s))
            if x2 > x1 then
                w(('<rect x="%.1f" y="%d" width="%.1f" height="%d" fill="#eef2f6"/>'):format(x1, top, x2 - x1,
                    height - top - bottom))
            end
        end
    end
end

-- Where another part of an operation begins.
local function part_marks(w, context, x_of)
    for _, time in ipairs(context.part_starts) do
        if time > context.first and time < context.last then
            w(('<line class="part" x1="%.1f" x2="%.1f" y1="%d" y2="%d" stroke="#8795a1"/>'):format(x_of(time),
                x_of(time), top, height - bottom))
        end
    end
end

local function event_colour(event) return event.severity == "minor" and "#a86500" or "#b3261e" end

local function event_marks(w, context, x_of, y1, y2)
    for _, event in ipairs(context.events) do
        if event.time_s >= context.first and event.time_s <= context.last then
            w(('<line x1="%.1f" x2="%.1f" y1="%d" y2="%d" stroke="%s" stroke-width="1.5" stroke-dasharray="4 3">')
                :format(x_of(event.time_s), x_of(event.time_s), y1, y2, event_colour(event)))
            w("<title>", e(known(event.title or event.id)), ", ", markup.time(event.time_s), "</title></line>")
        end
    end
end

local function grid(w, low, high, y_of, digits)
    local step = nice_step(high - low, 5)
    for k = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) do
        local y = y_of(k * step)
        w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="#d6dde4"/>'):format(left, width - right, y, y))
        w(('<text class="soft" x="%d" y="%.1f" text-anchor="end">%s</text>'):format(left - 6, y + 4,
            number(k * step, digits)))
    end
end

-- The unit stands at the last number.
local function time_axis(w, first, last, x_of, y, unit)
    local step = nice_step(last - first, 8)
    local most = math.floor(last / step + 1e-9)
    for k = math.ceil(first / step - 1e-9), most do
        local text = number(k * step, 2) .. (k == most and "\u{A0}" .. (unit or "s") or "")
        local near_edge = k == most and k > 0 and x_of(k * step) > width - right - 12
        w(('<text class="soft" x="%.1f" y="%d" text-anchor="%s">%s</text>'):format(
            near_edge and width - 2 or x_of(k * step), y, near_edge and "end" or "middle", text))
    end
end

-- Below the drawing, as text that wraps. marks: list of { colour, what it means }; one alone needs no telling.
local function legend(w, marks)
    if #marks < 2 then return end
    w('<p class="legend">')
    for _, mark in ipairs(marks) do
        w('<span><i style="background:', mark[1], '"></i>', e(mark[2]), "</span>")
    end
    w("</p>")
end

--- Lines over time. spec: { title, lines = { { label, values, count } }, range, danger = { from, to, label },
--- band = { from, to } of the axis across }.
--- context: { times, first, last, steps, events, part_starts = times, starts = set of the samples that begin a part,
--- unit = of the axis across, s if missing }.
function chart.over_time(spec, context)
    local w = markup.writer()
    local low, high = extent(spec.lines, spec.range)
    local span = context.last - context.first
    local function x_of(t) return left + (width - left - right) * (t - context.first) / span end
    local function y_of(v) return height - bottom - (height - top - bottom) * (v - low) / (high - low) end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(width, height, e(spec.title)))
    bands(w, context, x_of)
    if spec.band then
        w(('<rect x="%.1f" y="%d" width="%.1f" height="%d" fill="#1f5f8b" opacity="0.1"/>'):format(x_of(spec.band[1]),
            top, x_of(spec.band[2]) - x_of(spec.band[1]), height - top - bottom))
    end
    if spec.danger then
        local y1, y2 = y_of(math.min(high, spec.danger.to)), y_of(math.max(low, spec.danger.from))
        if y2 > y1 then
            w(('<rect x="%d" y="%.1f" width="%d" height="%.1f" fill="#b3261e" opacity="0.13"/>'):format(left, y1,
                width - left - right, y2 - y1))
        end
    end
    grid(w, low, high, y_of, 3)
    part_marks(w, context, x_of)
    event_marks(w, context, x_of, top, height - bottom)
    for i, line in ipairs(spec.lines) do
        w(('<path d="%s" fill="none" stroke="%s" stroke-width="1.8"/>'):format(
            path_of(context.times, context.starts, line, x_of, y_of), palette[i]))
    end
    time_axis(w, context.first, context.last, x_of, height - 8, context.unit)
    w("</svg>")
    local marks = {}
    for i, line in ipairs(spec.lines) do marks[i] = { palette[i], line.label } end
    legend(w, marks)
    return w:text()
end

chart.nice_step, chart.legend, chart.event_colour = nice_step, legend, event_colour

return chart
