-- SPDX-License-Identifier: GPL-3.0-or-later
-- Steps, errors and what was asked of the staff as one drawing over time.

local chart = require "report.chart"
local markup = require "report.markup"
local report_words = require "report.words"

local t, known = report_words.t, report_words.known

local time_line = {}

local e, number = markup.escape, markup.number

local request_row, error_row = "Asked and declared", "Errors, and how long until put right"

-- What was asked of the staff, on a row of its own.
local function request_marks(w, requests, x_of, from, y)
    for _, request in ipairs(requests) do
        local x = x_of(request.time_s)
        w(('<path d="M%.1f %d l6 6 l-6 6 l-6 -6 z" fill="#2f6690"><title>%s, %s</title></path>'):format(x, y - 6,
            e(known(request.title or request.id)), markup.time(request.time_s)))
    end
    w(('<text x="%d" y="%d" text-anchor="end">%s</text>'):format(from - 10, y + 4, e(t(request_row))))
end

-- Room for the longest of the words on the left.
local function label_width(steps, events, requests)
    local longest = math.max(#events > 0 and utf8.len(t(error_row)) or 0,
        #requests > 0 and utf8.len(t(request_row)) or 0)
    for _, step in ipairs(steps) do
        longest = math.max(longest, utf8.len(tostring(known(step.title or step.id))) or 0)
    end
    return math.floor(math.max(120, math.min(440, 24 + 6.9 * longest)))
end

-- At most 60 letters of a title: what there is room for.
local function shortened(title)
    local text = tostring(title)
    if (utf8.len(text) or 0) <= 60 then return text end
    return text:sub(1, utf8.offset(text, 59) - 1) .. "…"
end

--- Steps as bars, errors and their recoveries as marks.
function time_line.svg(steps, events, requests, last)
    local w, rows = markup.writer(), #steps
    local tall = 26 * rows + (#events > 0 and 40 or 14) + (#requests > 0 and 26 or 0) + 26
    local wide, from = 1000, label_width(steps, events, requests)
    local function x_of(time) return from + (wide - from - 20) * math.min(1, time / last) end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(wide, tall,
        e(t("Time line of steps and errors"))))
    for i, step in ipairs(steps) do
        local y = 26 * (i - 1) + 6
        w(('<text x="%d" y="%d" text-anchor="end">%s</text>'):format(from - 10, y + 13,
            e(shortened(known(step.title or step.id)))))
        w(('<rect x="%d" y="%d" width="%d" height="18" rx="4" fill="#eef2f6"/>'):format(from, y, wide - from - 20))
        if step.start_s then
            local x1, x2 = x_of(step.start_s), x_of(step.end_s or last)
            w(('<rect x="%.1f" y="%d" width="%.1f" height="18" rx="4" fill="%s"><title>%s</title></rect>'):format(
                x1, y, math.max(3, x2 - x1), step.completed and "#3a7d44" or "#8795a1",
                e(t("%s to %s", markup.time(step.start_s), markup.time(step.end_s or last)))))
        end
    end
    local y = 26 * rows + 24
    for _, event in ipairs(events) do
        local x, colour = x_of(event.time_s), chart.event_colour(event)
        w(('<line x1="%.1f" x2="%.1f" y1="4" y2="%d" stroke="%s" stroke-width="1.5" stroke-dasharray="4 3"/>'):format(x,
            x, y - 6, colour))
        if event.recovery_s then
            w(('<line x1="%.1f" x2="%.1f" y1="%d" y2="%d" stroke="%s" stroke-width="4"/>'):format(x,
                x_of(event.time_s + event.recovery_s), y, y, colour))
        end
        w(('<circle cx="%.1f" cy="%d" r="6" fill="%s"><title>%s, %s</title></circle>'):format(x, y, colour,
            e(known(event.title or event.id)), markup.time(event.time_s)))
    end
    if #events > 0 then
        w(('<text x="%d" y="%d" text-anchor="end">%s</text>'):format(from - 10, y + 4, e(t(error_row))))
    end
    if #requests > 0 then request_marks(w, requests, x_of, from, tall - 40) end
    local step = chart.nice_step(last, 10)
    for k = 0, math.floor(last / step + 1e-9) do
        w(('<text class="soft" x="%.1f" y="%d" text-anchor="middle">%s s</text>'):format(x_of(k * step), tall - 6,
            number(k * step, 2)))
    end
    w("</svg>")
    return w:text()
end

return time_line
