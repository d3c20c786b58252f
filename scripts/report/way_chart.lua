-- SPDX-License-Identifier: GPL-3.0-or-later
-- The way of a tip, or of the end of a tear, seen from above.

local chart = require "report.chart"
local markup = require "report.markup"
local t = require("report.words").t

local way_chart = {}

local e, number = markup.escape, markup.number

local strong_colour, usual_colour = "#c2570c", "#1f5f8b"

local farthest = 9  -- from the axis; beyond, a tip is not at the eye [mm]

-- Whether a sample is drawn.
local function drawn(way, i)
    local x, y = way.x[i], way.y[i]
    return type(x) == "number" and type(y) == "number" and x * x + y * y <= farthest * farthest
end

local eye = 6.5  -- radius within which a tip is over the eye [mm]

--- Whether any of a way leads over the eye.
function way_chart.reaches_eye(way, count, starts)
    for i = 2, count do
        local line = drawn(way, i - 1) and drawn(way, i) and not starts[i]
        if line and way.x[i] ^ 2 + way.y[i] ^ 2 < eye * eye then return true end
    end
    return false
end

-- Width of the view in which all that is drawn has room, at least `across` [mm].
local function view_width(way, count, across)
    local most = across / 2
    for i = 1, count do
        if drawn(way, i) then most = math.max(most, math.abs(way.x[i]) + 0.3, math.abs(way.y[i]) + 0.3) end
    end
    return 2 * most
end

-- Runs of a way of the same kind, each as one path. It is broken where a place is missing, and where another part of an
-- operation begins.
local function way_paths(w, way, count, starts, place)
    local pen, state, d
    local function flush()
        if d and #d.pieces > 0 then
            w(('<path d="%s" fill="none" stroke="%s" stroke-width="%s" opacity="0.8"/>'):format(d:text(),
                state and strong_colour or usual_colour, state and "1.6" or "1"))
        end
    end
    for i = 1, count do
        local now = way.strong[i] == true
        if starts[i] or not drawn(way, i) then
            flush()
            d, pen = nil, nil
        end
        if drawn(way, i) then
            local x, y = place(way.x[i], way.y[i])
            if d == nil or now ~= state then
                if d then d(("L%.1f %.1f"):format(x, y)) end
                flush()
                d, pen, state = markup.writer(), "M", now
            end
            d(pen or "L", ("%.1f %.1f"):format(x, y))
            pen = "L"
        end
    end
    flush()
end

local function scale_bar(w, size, scale)
    local length = chart.nice_step(60 / scale, 1)
    local x, y = 10, size - 12
    w(('<path class="scale" d="M%d %d v6 h%.1f v-6" fill="none" stroke="#1d2630"/>'):format(x, y - 3, length * scale))
    w(('<text class="halo" x="%.1f" y="%d">%s mm</text>'):format(x + length * scale + 6, y + 5, number(length, 1)))
end

local function circles_drawn(w, circles, middle, scale)
    for i, circle in ipairs(circles) do
        local radius = circle.radius * scale
        w(('<circle cx="%d" cy="%d" r="%.1f" fill="none" stroke="#6d7a86" stroke-dasharray="4 3"/>'):format(middle,
            middle, radius))
        local x = middle + (i % 2 == 1 and -0.72 or 0.72) * radius
        w(('<text class="soft halo" x="%.1f" y="%.1f" text-anchor="%s">%s</text>'):format(x,
            middle - 0.72 * radius - 4, i % 2 == 1 and "end" or "start", e(circle.label)))
    end
end

--- A way over the pupil. way: x, y [mm] and strong (drawn so) by samples, `count` of them; starts: set of the samples
--- that begin a part of an operation; meaning: what strong and usual parts of it are; circles: { radius [mm], label }
--- about the middle, drawn dashed; across: width of the view [mm].
function way_chart.svg(way, count, starts, pupil_mm, meaning, circles, across)
    local w, size = markup.writer(), 360
    local middle, scale = size / 2, size / view_width(way, count, across or 14)
    local function place(px, py) return middle + px * scale, middle - py * scale end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s" '):format(size, size, e(t("Way seen from above"))))
    w('style="max-width:26rem;margin:0 auto">')
    w(('<circle cx="%d" cy="%d" r="%.1f" fill="#f7efe6" stroke="#d6dde4"/>'):format(middle, middle,
        math.min(middle, 5.8 * scale)))
    w(('<circle cx="%d" cy="%d" r="%.1f" fill="#f6d9cf" stroke="#a86f5c"/>'):format(middle, middle,
        pupil_mm / 2 * scale))
    circles_drawn(w, circles or {}, middle, scale)
    way_paths(w, way, count, starts, place)
    scale_bar(w, size, scale)
    w("</svg>")
    chart.legend(w, meaning.strong ~= "" and { { strong_colour, meaning.strong }, { usual_colour, meaning.usual } }
        or { { usual_colour, meaning.usual } })
    return w:text()
end

return way_chart
