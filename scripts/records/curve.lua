-- SPDX-License-Identifier: GPL-3.0-or-later
-- Learning curves of one trainee: a chart for each exercise.
--
-- data: trainee, courses = list of { exercise, title, pass, in_a_row, open_after, time_to_gate_s, first, peak,
--       attempts = list of { date, scaled, passed, duration_s } }; shares of the scale, 0 to 1; language

local markup = require "report.markup"
local page = require "records.page"
local report_words = require "report.words"

local t = report_words.t

local curve = {}

local e, number = markup.escape, markup.number
local wide, tall, left, right, top, bottom = 620, 250, 46, 16, 16, 40

local function chart(w, course)
    local n = #course.attempts
    local function x_of(i) return left + 14 + (wide - left - right - 28) * (n > 1 and (i - 1) / (n - 1) or 0.5) end
    local function y_of(share) return tall - bottom - (tall - top - bottom) * share end
    w(('<svg viewBox="0 0 %d %d" role="img" aria-label="%s">'):format(wide, tall,
        e(t("Scores of all attempts"))))
    for share = 0, 1.001, 0.25 do
        w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="#d6dde4"/>'):format(left, wide - right, y_of(share),
            y_of(share)))
        w(('<text class="soft" x="%d" y="%.1f" text-anchor="end">%d %%</text>'):format(left - 6, y_of(share) + 4,
            math.floor(100 * share + 0.5)))
    end
    w(('<line x1="%d" x2="%d" y1="%.1f" y2="%.1f" stroke="#1e7d4f" stroke-width="1.5" stroke-dasharray="6 4"/>')
        :format(left, wide - right, y_of(course.pass), y_of(course.pass)))
    w(('<text x="%d" y="%.1f" text-anchor="end" fill="#1e7d4f">%s</text>'):format(wide - right - 2,
        y_of(course.pass) - 4, e(t("pass"))))
    local path = markup.writer()
    for i, attempt in ipairs(course.attempts) do
        path(i == 1 and "M" or "L", ("%.1f %.1f "):format(x_of(i), y_of(attempt.scaled)))
    end
    w('<path d="', path:text(), '" fill="none" stroke="#8795a1" stroke-width="1.5"/>')
    local every = math.max(1, math.ceil(n / 20))
    for i, attempt in ipairs(course.attempts) do
        local colour = attempt.passed and "#1e7d4f" or "#6d7a86"
        w(('<circle cx="%.1f" cy="%.1f" r="5" fill="%s" stroke="%s" stroke-width="2"><title>%s: %s %%%s</title>'
            .. "</circle>"):format(x_of(i), y_of(attempt.scaled), attempt.passed and colour or "#fff", colour,
            e(attempt.date), number(100 * attempt.scaled, 0), attempt.passed and e(t(", passed")) or ""))
        if (i - 1) % every == 0 then
            w(('<text class="soft" x="%.1f" y="%d" text-anchor="middle">%d</text>'):format(x_of(i), tall - 22, i))
        end
    end
    if course.open_after > 0 then
        local x = x_of(course.open_after)
        w(('<line x1="%.1f" x2="%.1f" y1="%d" y2="%d" stroke="#1e7d4f"/>'):format(x, x, top, tall - bottom))
    end
    w(('<text class="soft" x="%d" y="%d">%s</text></svg>'):format(left, tall - 4, e(t("attempt"))))
end

local function section(w, course)
    w("<section><h2>", e(course.title ~= "" and course.title or course.exercise), "</h2>")
    w("<p>", e(t("First %s %%, best %s %%.", number(100 * course.first, 0), number(100 * course.peak, 0))), " ")
    if course.open_after > 0 then
        w(e(t("The gate opened after %d attempts and %s of operating.", course.open_after,
            markup.time(course.time_to_gate_s))))
    else
        w(e(t("The gate is closed: it opens after %d passes in a row, of at least %s %% each.", course.in_a_row,
            number(100 * course.pass, 1))))
    end
    w('</p><div class="curve">')
    chart(w, course)
    w('</div><p class="soft small">', e(t("Shares of the scale: 0 % if every item has its least points, 100 % if every "
        .. "one has its most. Filled: passed.")), " <b>", e(t("Not clinically validated.")), "</b></p></section>")
end

--- The whole page.
function curve.html(data)
    report_words.use(data.language)
    local title = t("Learning curves of %s", data.trainee)
    return page.html(title, function(w)
        w("<header><h1>", e(title), "</h1></header>")
        for _, course in ipairs(data.courses) do section(w, course) end
    end)
end

return curve
