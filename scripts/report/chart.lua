-- SPDX-License-Identifier: GPL-3.0-or-later
-- Charts as SVG: lines over time with steps and errors marked, a time line, and the way of the tip seen from above.

local markup = require "report.markup"
local translated = require("report.words").t

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

-- One path; a gap where the measure was not defined.
local function path_of(times, line, x_of, y_of)
    local w, pen = markup.writer(), "M"
    for i = 1, line.count do
        local v = line.values[i]
        if type(v) == "number" and type(times[i]) == "number" then
            w(pen, ("%.1f %.1f"):format(x_of(times[i]), y_of(v)))
            pen = "L"
        else
            pen = "M"
        end
    end
    return w:text()
end

local function bands(w, steps, x_of)
    for i, step in ipairs(steps) do
        if step.start_s and step.end_s and i % 2 == 0 then
            w(('<rect x="%.1f" y="%d" width="%.1f" height="%d" fill="#eef2f6"/>'):format(x_of(step.start_s), top,
                math.max(0, x_of(step.end_s) - x_of(step.start_s)), height - top - bottom))
        end
    end
end

local function event_colour(event) return event.severity == "minor" and "#a86500" or "#b3261e" end

local function event_marks(w, events, x_of, y1, y2)
    for _, event in ipairs(events) do
        w(('<line x1="%.1f" x2="%.1f" y1="%d" y2="%d" stroke="%s" stroke-width="1.5" stroke-dasharray="4 3">'):format(
            x_of(event.time_s), x_of(event.time_s), y1, y2, event_colour(event)))
        w("<title>", e(event.title or event.id), ", ", markup.time(event.time_s), "</title></line>")
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
local function time_axis(w, last, x_of, y, unit)
    local step = nice_step(last, 8)
    local most = math.floor(last / step + 1e-9)
    for k = 0, most do
        local text = number(k * step, 2) .. (k == most and " " .. (unit or "s") or "")
        local near_edge = k == most and k > 0 and x_of(k * step) > width - right - 12
        w(('<text class="soft" x="%.1f" y="%d" text-anchor="%s">%s</text>'):format(
            near_edge and width - 2 or x_of(k * step), y, near_edge and "end" or "middle", text))
    end
end

-- Below the drawing, as text that wraps. marks: list of { colour, what it means }.
local function legend(w, marks)
    w('<p class="legend">')
    for _, mark in ipairs(marks) do
        w('<span><i style="background:', mark[1], '"></i>', e(mark[2]), "</span>")
    end
    w("</p>")
end

--- Lines over time. spec: { title, lines = { { label, values, count } }, range, danger = { from, to, label },
--- band = { from, to } of the axis across }.
--- context: { times, last, steps, events, unit = of the axis across, s if missing }.
function chart.over_time(spec, context)
    local w = markup.writer()
    local low, high = extent(spec.lines, spec.range)
    local function x_of(t) return left + (width - left - right) * t / context.last end
    local function y_of(v) return height - bottom - (height - top - bottom) * (v - low) / (high - low) end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(width, height, e(spec.title)))
    bands(w, context.steps, x_of)
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
    event_marks(w, context.events, x_of, top, height - bottom)
    for i, line in ipairs(spec.lines) do
        w(('<path d="%s" fill="none" stroke="%s" stroke-width="1.8"/>'):format(
            path_of(context.times, line, x_of, y_of), palette[i]))
    end
    time_axis(w, context.last, x_of, height - 8, context.unit)
    w("</svg>")
    local marks = {}
    for i, line in ipairs(spec.lines) do marks[i] = { palette[i], line.label } end
    legend(w, marks)
    return w:text()
end

local request_row, error_row = "Asked and declared", "Errors, and how long until put right"

-- What was asked of the staff, on a row of its own.
local function request_marks(w, requests, x_of, from, y)
    for _, request in ipairs(requests) do
        local x = x_of(request.time_s)
        w(('<path d="M%.1f %d l6 6 l-6 6 l-6 -6 z" fill="#2f6690"><title>%s, %s</title></path>'):format(x, y - 6,
            e(request.title or request.id), markup.time(request.time_s)))
    end
    w(('<text x="%d" y="%d" text-anchor="end">%s</text>'):format(from - 10, y + 4, e(translated(request_row))))
end

-- Room for the longest of the words on the left.
local function label_width(steps, events, requests)
    local longest = math.max(#events > 0 and utf8.len(translated(error_row)) or 0,
        #requests > 0 and utf8.len(translated(request_row)) or 0)
    for _, step in ipairs(steps) do longest = math.max(longest, utf8.len(tostring(step.title or step.id)) or 0) end
    return math.floor(math.max(120, math.min(440, 24 + 6.9 * longest)))
end

-- At most 60 letters of a title: what there is room for.
local function shortened(title)
    local text = tostring(title)
    if (utf8.len(text) or 0) <= 60 then return text end
    return text:sub(1, utf8.offset(text, 59) - 1) .. "…"
end

--- Steps as bars, errors and their recoveries as marks.
function chart.time_line(steps, events, requests, last)
    local w, rows = markup.writer(), #steps
    local tall = 26 * rows + (#events > 0 and 40 or 14) + (#requests > 0 and 26 or 0) + 26
    local wide, from = 1000, label_width(steps, events, requests)
    local function x_of(t) return from + (wide - from - 20) * math.min(1, t / last) end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(wide, tall,
        e(translated("Time line of steps and errors"))))
    for i, step in ipairs(steps) do
        local y = 26 * (i - 1) + 6
        w(('<text x="%d" y="%d" text-anchor="end">%s</text>'):format(from - 10, y + 13,
            e(shortened(step.title or step.id))))
        w(('<rect x="%d" y="%d" width="%d" height="18" rx="4" fill="#eef2f6"/>'):format(from, y, wide - from - 20))
        if step.start_s then
            local x1, x2 = x_of(step.start_s), x_of(step.end_s or last)
            w(('<rect x="%.1f" y="%d" width="%.1f" height="18" rx="4" fill="%s"><title>%s</title></rect>'):format(
                x1, y, math.max(3, x2 - x1), step.completed and "#3a7d44" or "#8795a1",
                e(translated("%s to %s", markup.time(step.start_s), markup.time(step.end_s or last)))))
        end
    end
    local y = 26 * rows + 24
    for _, event in ipairs(events) do
        local x, colour = x_of(event.time_s), event_colour(event)
        w(('<line x1="%.1f" x2="%.1f" y1="4" y2="%d" stroke="%s" stroke-width="1.5" stroke-dasharray="4 3"/>'):format(x,
            x, y - 6, colour))
        if event.recovery_s then
            w(('<line x1="%.1f" x2="%.1f" y1="%d" y2="%d" stroke="%s" stroke-width="4"/>'):format(x,
                x_of(event.time_s + event.recovery_s), y, y, colour))
        end
        w(('<circle cx="%.1f" cy="%d" r="6" fill="%s"><title>%s, %s</title></circle>'):format(x, y, colour,
            e(event.title or event.id), markup.time(event.time_s)))
    end
    if #events > 0 then
        w(('<text x="%d" y="%d" text-anchor="end">%s</text>'):format(from - 10, y + 4, e(translated(error_row))))
    end
    if #requests > 0 then request_marks(w, requests, x_of, from, tall - 40) end
    local step = nice_step(last, 10)
    for k = 0, math.floor(last / step + 1e-9) do
        w(('<text class="soft" x="%.1f" y="%d" text-anchor="middle">%s s</text>'):format(x_of(k * step), tall - 6,
            number(k * step, 2)))
    end
    w("</svg>")
    return w:text()
end

local strong_colour, usual_colour = "#c2570c", "#1f5f8b"

-- Runs of a way of the same kind, each as one path. It is broken where a place is missing.
local function way_paths(w, way, count, place)
    local pen, state, d
    local function flush()
        if d and #d.pieces > 0 then
            w(('<path d="%s" fill="none" stroke="%s" stroke-width="%s" opacity="0.8"/>'):format(d:text(),
                state and strong_colour or usual_colour, state and "1.6" or "1"))
        end
    end
    for i = 1, count do
        local xi, yi, now = way.x[i], way.y[i], way.strong[i] == true
        if type(xi) ~= "number" or type(yi) ~= "number" then
            flush()
            d, pen = nil, nil
        else
            if d == nil or now ~= state then
                if d then d(("L%.1f %.1f"):format(place(xi, yi))) end
                flush()
                d, pen, state = markup.writer(), "M", now
            end
            d(pen or "L", ("%.1f %.1f"):format(place(xi, yi)))
            pen = "L"
        end
    end
    flush()
end

--- A way seen from above, over the pupil. way: x, y [mm] and strong (drawn so) by samples, `count` of them; meaning:
--- what strong and usual parts of it are; circles: { radius [mm], label } about the middle, drawn dashed; across: width
--- of the view [mm].
function chart.way(way, count, pupil_mm, meaning, circles, across)
    local w, size = markup.writer(), 360
    local scale = size / (across or 14)
    local middle = size / 2
    local function place(px, py) return middle + px * scale, middle - py * scale end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s" '):format(size, size,
        e(translated("Way seen from above"))))
    w('style="max-width:26rem;margin:0 auto">')
    w(('<circle cx="%d" cy="%d" r="%.1f" fill="#f7efe6" stroke="#d6dde4"/>'):format(middle, middle,
        math.min(middle, 5.8 * scale)))
    w(('<circle cx="%d" cy="%d" r="%.1f" fill="#f6d9cf" stroke="#a86f5c"/>'):format(middle, middle,
        pupil_mm / 2 * scale))
    for i, circle in ipairs(circles or {}) do
        local radius = circle.radius * scale
        w(('<circle cx="%d" cy="%d" r="%.1f" fill="none" stroke="#6d7a86" stroke-dasharray="4 3"/>'):format(middle,
            middle, radius))
        local x = middle + (i % 2 == 1 and -0.72 or 0.72) * radius
        w(('<text class="soft halo" x="%.1f" y="%.1f" text-anchor="%s">%s</text>'):format(x,
            middle - 0.72 * radius - 4, i % 2 == 1 and "end" or "start", markup.escape(circle.label)))
    end
    way_paths(w, way, count, place)
    w("</svg>")
    legend(w, meaning.strong ~= "" and { { strong_colour, meaning.strong }, { usual_colour, meaning.usual } }
        or { { usual_colour, meaning.usual } })
    return w:text()
end

return chart
