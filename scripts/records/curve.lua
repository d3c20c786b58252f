-- SPDX-License-Identifier: GPL-3.0-or-later
-- Learning curves of one trainee: a chart for each exercise.
--
-- data: trainee, courses = list of { exercise, title, pass, in_a_row, open_after, time_to_gate_s, first, peak,
--       attempts = list of { date, scaled, completed, passed, why, duration_s } }; shares of the scale, 0 to 1; why:
--       it is no pass; language

local markup = require "report.markup"
local page = require "records.page"
local report_words = require "report.words"

local t = report_words.t

local curve = {}

local e, number = markup.escape, markup.number
local wide, tall, left, right, top, bottom = 620, 250, 46, 16, 16, 40
local good, other = "#1e7d4f", "#6d7a86"

-- Filled: passed. Hollow: not passed. Hollow with a cross: not completed.
local function kind_of(attempt)
    if attempt.passed then return "passed" end
    return attempt.completed and "not passed" or "not completed"
end

local function mark(w, kind, x, y, told)
    local colour = kind == "passed" and good or other
    w(('<circle cx="%.1f" cy="%.1f" r="5" fill="%s" stroke="%s" stroke-width="2">'):format(x, y,
        kind == "passed" and colour or "#fff", colour), told and "<title>" .. e(told) .. "</title>" or "", "</circle>")
    if kind ~= "not completed" then return end
    w(('<path d="M%.1f %.1fl6 6m0 -6l-6 6" stroke="%s" stroke-width="1.5" pointer-events="none"/>'):format(x - 3, y - 3,
        colour))
end

-- "2026-03-01 09:30 UTC: 82 %, not passed: a critical error was not put right"
local function told_of(attempt)
    local kind = kind_of(attempt)
    local state = t(kind)
    if kind == "not passed" and attempt.why and attempt.why ~= "" then state = state .. ": " .. t(attempt.why) end
    return t("%s: %s %%, %s", page.moment(attempt.date), number(100 * attempt.scaled, 0), state)
end

local function scale(w, course, y_of)
    for share = 0, 1.001, 0.25 do
        w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="#d6dde4"/>'):format(left, wide - right, y_of(share),
            y_of(share)))
        w(('<text class="soft" x="%d" y="%.1f" text-anchor="end">%d %%</text>'):format(left - 6, y_of(share) + 4,
            math.floor(100 * share + 0.5)))
    end
    w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="%s" stroke-width="1.5" stroke-dasharray="6 4"/>')
        :format(left, wide - right, y_of(course.pass), y_of(course.pass), good))
end

local function chart(w, course)
    local n = #course.attempts
    local function x_of(i) return left + 14 + (wide - left - right - 28) * (n > 1 and (i - 1) / (n - 1) or 0.5) end
    local function y_of(share) return tall - bottom - (tall - top - bottom) * share end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(wide, tall,
        e(t("Scores of all attempts"))))
    scale(w, course, y_of)
    if course.open_after > 0 then
        local x = x_of(course.open_after)
        w(('<line x1="%.1f" x2="%.1f" y1="%d" y2="%d" stroke="%s"/>'):format(x, x, top, tall - bottom, good))
    end
    local path = markup.writer()
    for i, attempt in ipairs(course.attempts) do
        path(i == 1 and "M" or "L", ("%.1f %.1f "):format(x_of(i), y_of(attempt.scaled)))
    end
    w('<path d="', path:text(), '" fill="none" stroke="#8795a1" stroke-width="1.5"/>')
    local every = math.max(1, math.ceil(n / 20))
    for i, attempt in ipairs(course.attempts) do
        mark(w, kind_of(attempt), x_of(i), y_of(attempt.scaled), told_of(attempt))
        if (i - 1) % every == 0 then
            w(('<text class="soft" x="%.1f" y="%d" text-anchor="middle">%d</text>'):format(x_of(i), tall - 22, i))
        end
    end
    w(('<text class="soft" x="%d" y="%d">%s</text></svg>'):format(left, tall - 4, e(t("attempt"))))
end

-- What the marks and lines of this chart mean; only those that it has.
local function legend(w, course)
    local function entry(drawn, text)
        w('<span><svg viewBox="0 0 22 14">', drawn, "</svg> ", e(text), "</span>")
    end
    local has = {}
    for _, attempt in ipairs(course.attempts) do has[kind_of(attempt)] = true end
    w('<p class="marks">')
    for _, kind in ipairs { "passed", "not passed", "not completed" } do
        local drawn = markup.writer()
        mark(drawn, kind, 11, 7)
        if has[kind] then entry(drawn:text(), t(kind)) end
    end
    local line = '<line x1="%d" x2="%d" y1="%d" y2="%d" stroke="' .. good .. '" stroke-width="1.5"%s/>'
    entry(line:format(0, 22, 7, 7, ' stroke-dasharray="6 4"'), t("pass mark"))
    if course.open_after > 0 then entry(line:format(11, 11, 0, 14, ""), t("the gate opened")) end
    w("</p>")
end

local function gate_text(course)
    if course.open_after > 0 then
        return report_words.count(course.open_after, "The gate opened after %d attempt and %s of operating.",
            "The gate opened after %d attempts and %s of operating.", course.open_after,
            markup.time(course.time_to_gate_s))
    end
    return report_words.count(course.in_a_row, "The gate is closed: it opens after %d pass, of at least %s %%.",
        "The gate is closed: it opens after %d passes in a row, of at least %s %% each.", course.in_a_row,
        number(100 * course.pass, 1))
end

local function first_and_best(course)
    local first = number(100 * course.first, 0)
    return course.peak and t("First %s %%, best %s %%.", first, number(100 * course.peak, 0))
        or t("First %s %%, none completed yet.", first)
end

local function section(w, course)
    w("<section><h2>", e(course.title ~= "" and course.title or course.exercise), "</h2>")
    w("<p>", e(first_and_best(course)), " ",
        e(gate_text(course)), '</p><div class="curve">')
    chart(w, course)
    legend(w, course)
    w('</div><p class="soft small">', e(t("Shares of the scale: 0 % if every item has its least points, 100 % if every "
        .. "one has its most.")), " <b>", e(t("Not clinically validated.")), "</b></p></section>")
end

local style = [[
.marks { display:flex; flex-wrap:wrap; gap:.1rem 1.2rem; font-size:.84rem; }
.marks span { white-space:nowrap; }
.marks svg { display:inline-block; width:22px; height:14px; vertical-align:-2px; }
]]

--- The whole page.
function curve.html(data)
    report_words.use(data.language)
    local title = t("Learning curves of %s", data.trainee)
    return page.html(title, function(w)
        w("<header><h1>", e(title), "</h1></header>")
        for _, course in ipairs(data.courses) do section(w, course) end
    end, style)
end

return curve
