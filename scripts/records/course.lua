-- SPDX-License-Identifier: GPL-3.0-or-later
-- Where the trainees of a course are: one row each, one column for each lesson.
--
-- data: course, title, titles = exercise -> title, trainees = list of { trainee, next, lessons = list of { exercise,
--       state = "passed", "open" or "closed", waits_for, attempts, peak, in_a_row, needed_in_a_row, open_after } };
--       shares of the scale, 0 to 1; language

local markup = require "report.markup"
local page = require "records.page"
local report_words = require "report.words"

local course = {}

local t = report_words.t
local e, number = markup.escape, markup.number

local style = [[
td.lesson { text-align: center; white-space: nowrap; }
td.passed { background: #dff1e6; }
td.closed { color: #8795a1; }
td.next { outline: 2px solid #2463a6; outline-offset: -2px; }
]]

local signs = { passed = "✓", open = "○", closed = "–" }

-- What a cell says in words, for who points at it or hears the page.
local function told(lesson, titles)
    if lesson.state == "passed" then return t("passed") end
    if lesson.state == "open" then return t("%d of %d passes in a row", lesson.in_a_row, lesson.needed_in_a_row) end
    local names = {}
    for i, name in ipairs(lesson.waits_for) do names[i] = titles[name] or name end
    return t("closed until these are passed: %s", table.concat(names, ", "))
end

local function cell(w, lesson, titles, is_next)
    w('<td class="lesson ', lesson.state, is_next and " next" or "", '" title="', e(told(lesson, titles)), '">',
        signs[lesson.state])
    if lesson.attempts > 0 then
        w("<br><small>", lesson.attempts, "×", lesson.peak and (" " .. number(100 * lesson.peak, 0) .. " %") or "",
            "</small>")
    end
    w("</td>")
end

local function body(w, data)
    w("<header><h1>", e(t(data.title)), "</h1></header><p>", e(t("✓ passed, ○ open, – closed; under it, attempts and "
        .. "the best score. The framed lesson comes next.")), "</p>")
    if #data.trainees == 0 then
        w("<p>", e(t("Nothing is stored yet.")), "</p>")
        return
    end
    local lessons = data.trainees[1].lessons
    page.wide_table(w, 8 + 6 * #lessons, function()
        w("<tr><th>", e(t("trainee")), "</th>")
        for _, lesson in ipairs(lessons) do w("<th>", e(data.titles[lesson.exercise] or lesson.exercise), "</th>") end
        w("</tr>")
        for _, own in ipairs(data.trainees) do
            w("<tr><th>", e(own.trainee), "</th>")
            for _, lesson in ipairs(own.lessons) do cell(w, lesson, data.titles, lesson.exercise == own.next) end
            w("</tr>")
        end
    end)
end

--- The whole page.
function course.html(data)
    report_words.use(data.language)
    return page.html(t(data.title), function(w) body(w, data) end, style)
end

return course
