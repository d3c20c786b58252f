-- SPDX-License-Identifier: GPL-3.0-or-later
-- report.html of an attempt: everything in one file, for the screen and for paper.

local chart = require "report.chart"
local charts = require "report.charts"
local history = require "report.history"
local markup = require "report.markup"
local pictures = require "report.pictures"
local scores = require "report.scores"
local style = require "report.style"
local report_words = require "report.words"

local t = report_words.t

local report_page = {}

local e, number, time = markup.escape, markup.number, markup.time

local function title_of(report)
    return report.title or (report.curriculum and (report.curriculum.title or report.curriculum.id)) or t("Exercise")
end

local function who(report)
    local names = { a = "virtual surgeon of group A (fewer than 50 operations)", b = "virtual surgeon of group B",
        c = "virtual surgeon of group C", d = "virtual surgeon of group D (over 500 operations)",
        novice = "virtual novice (fewer than 50 operations)", expert = "virtual expert (over 500 operations)",
        none = "trainee" }
    local name = names[report.surgeon] or not report.surgeon and "trainee"
    return name and t(name) or report.surgeon
end

local function patient_text(patient)
    if not patient then return nil end
    local parts = {}
    if patient.age then parts[#parts + 1] = t("%s years", number(patient.age, 0)) end
    if patient.nuclear_grade then parts[#parts + 1] = t("nuclear cataract NO%s", number(patient.nuclear_grade, 1)) end
    if (patient.cortical_opacity or 0) > 0 then
        parts[#parts + 1] = t(patient.cortical_opacity >= 1 and "white cortex" or "hazy cortex")
    end
    if patient.pupil_mm then parts[#parts + 1] = t("pupil %s mm", number(patient.pupil_mm, 1)) end
    if patient.side then parts[#parts + 1] = t(patient.side .. " eye") end
    return table.concat(parts, ", ")
end

local function incision_text(o)
    if not o then return nil end
    return t("%s, at %s degrees; the nose lies %s, above lies %s", t(o.incision), number(o.incision_deg, 0), t(o.nose),
        t(o.above)) .. "; " .. t(("surgeon %s-handed"):format(o.handedness))
end

local function mode_text(report)
    if not report.mode then return nil end
    return t(report.mode == "exam" and "exam (no hints)" or "teaching (hints and advice said)")
end

local function header(w, report)
    w('<header><div class="head"><div><p class="soft small">', e(t("rhexis: report of an exercise")), "</p><h1>",
        e(title_of(report)),
        "</h1>")
    if report.summary then w("<p>", e(report.summary), "</p>") end
    if #(report.objectives or {}) > 0 then
        w("<p><b>", e(t("Objectives:")), "</b></p><ul>")
        for _, objective in ipairs(report.objectives) do w("<li>", e(objective), "</li>") end
        w("</ul>")
    end
    w('<ul class="facts">')
    local function fact(name, value)
        if value then w("<li>", e(t(name)), " <b>", e(value), "</b></li>") end
    end
    fact("By", who(report))
    fact("Patient", patient_text(report.patient))
    fact("Incision", incision_text(report.orientation))
    fact("Level", report.level)
    fact("Mode", mode_text(report))
    fact("Time", time(report.duration_s))
    w("</ul></div>", scores.badge(report.osacss), "</div></header>")
end

-- "One error was made, and put right."
local function errors_told(events)
    local right = 0
    for _, event in ipairs(events) do right = right + (event.recovered and 1 or 0) end
    if #events == 0 then return t("No error was made.") end
    if #events == 1 then
        return right == 1 and t("One error was made, and put right.") or t("One error happened; %d put right.", right)
    end
    if right == #events then return t("%d errors were made, and all put right.", right) end
    return t("%d errors happened; %d put right.", #events, right)
end

-- What happened, in a few sentences.
local function story(report)
    local done, undone, turns = 0, {}, 0
    for _, step in ipairs(report.steps or {}) do
        if not step.skipped then turns = turns + 1 end
        if step.completed then
            done = done + 1
        elseif not step.skipped then
            undone[#undone + 1] = "“" .. (step.title or step.id) .. "”"
        end
    end
    local steps = report.completed and t("All %d steps were completed.", turns)
        or t("%d of %d steps were completed%s.", done, turns,
            #undone > 0 and t("; not completed: ") .. table.concat(undone, ", ") or "")
    return steps .. " " .. errors_told(report.events or {})
end

-- Where the bag could not have what was torn.
local function opening_told(w, report)
    for _, part in ipairs(report.parts or { report }) do
        if part.opening_note then
            w("<p>", e(t("“%s” began with a round opening of the bag: what was torn before could not be its opening.",
                part.title or title_of(report))), ' <span class="soft small">(', e(part.opening_note), ")</span></p>")
        end
    end
end

-- Of an operation that was broken off, or of which only some parts were wanted.
local function not_begun_told(w, report)
    local titles = {}
    for i, title in ipairs(report.not_begun or {}) do titles[i] = "“" .. title .. "”" end
    if #titles == 0 then return end
    w('<p class="tb">', e(t("Parts of the operation that were not begun: ")), e(table.concat(titles, ", ")), ".</p>")
end

local function summary(w, report)
    w("<section><h2>", e(t("In short")), "</h2><p>", e(story(report)), "</p>")
    opening_told(w, report)
    not_begun_told(w, report)
    if report.error then
        w('<p class="tb"><b>', e(t("The exercise was stopped by a mistake in its script:")), "</b> ", e(report.error),
            "</p>")
    end
    local advice = report.advice or {}
    if #advice > 0 then
        w("<p><b>", e(t("Next time:")), '</b></p><ol class="advice">')
        for _, line in ipairs(advice) do w("<li>", e(line), "</li>") end
        w("</ol>")
    end
    w("</section>")
end

local outcomes = { recovered = { "put right", "good" }, near_miss = { "near miss", "good" },
    not_recovered = { "not put right in time", "bad" }, open = { "not put right", "bad" } }

local function evidence_text(evidence)
    local names, parts = {}, {}
    for name in pairs(evidence or {}) do names[#names + 1] = name end
    table.sort(names)
    for _, name in ipairs(names) do
        local value = evidence[name]
        if type(value) == "boolean" then value = t(value and "yes" or "no") else value = number(value, 3) end
        parts[#parts + 1] = name .. " " .. value
    end
    return table.concat(parts, " · ")
end

local function consequences_text(consequences)
    local parts, names = {}, {}
    for _, text in ipairs(consequences and consequences.texts or {}) do parts[#parts + 1] = text end
    for name in pairs(consequences and consequences.settings or {}) do names[#names + 1] = name end
    table.sort(names)
    for _, name in ipairs(names) do
        parts[#parts + 1] = t("%s set to %s", name, number(consequences.settings[name], 3))
    end
    return table.concat(parts, " ")
end

local function occurrence(w, event)
    local outcome = outcomes[event.outcome] or outcomes[event.recovered and "recovered" or "not_recovered"]
    w("<li>", e(t("at %s", time(event.time_s))), ' <span class="tag ', outcome[2], '">', e(t(outcome[1])),
        event.recovery_s and e(t(" after %s", time(event.recovery_s))) or "", "</span>")
    local followed = consequences_text(event.consequences)
    if followed ~= "" then
        w('<br><span class="soft small">', e(t("What the exercise let follow: ")), e(followed), "</span>")
    end
    local evidence = evidence_text(event.evidence)
    if evidence ~= "" then w('<br><span class="soft small">', e(t("Measured then: ")), e(evidence), "</span>") end
    w("</li>")
end

-- All occurrences of one error.
local function event_card(w, events)
    local first = events[1]
    w('<div class="event ', first.severity == "minor" and "minor" or "", '"><h3>', e(first.title or first.id), "</h3>")
    if first.cue then w("<p><b>", e(t("What shows it:")), "</b> ", e(first.cue), "</p>") end
    if first.advice then w("<p><b>", e(t("What to do:")), "</b> ", e(first.advice), "</p>") end
    w("<ul>")
    for _, event in ipairs(events) do occurrence(w, event) end
    w("</ul></div>")
end

local function event_cards(w, events)
    local order, by_id = {}, {}
    for _, event in ipairs(events) do
        if not by_id[event.id] then
            by_id[event.id] = {}
            order[#order + 1] = event.id
        end
        table.insert(by_id[event.id], event)
    end
    for _, id in ipairs(order) do event_card(w, by_id[id]) end
end

local function time_line(w, report)
    local steps, events = report.steps or {}, report.events or {}
    w("<section><h2>", e(t("What happened when")), "</h2>")
    if #steps > 0 and (report.duration_s or 0) > 0 then
        w(chart.time_line(steps, events, report.requests or {}, report.duration_s))
        w('<p class="soft small">', e(t("Green: step completed. Grey: not completed.")), "</p>")
    end
    event_cards(w, events)
    w("</section>")
end

-- The video lies beside the page: too large to hold, and some browsers lack its codec.
local function video(w, report)
    local file = report.video
    if type(file) ~= "string" or not file:find("^[%w_-]+%.mp4$") then return end
    local link = ('<a href="%s">%s</a>'):format(file, file)
    w('<section class="video"><h2>', e(t("Video")), '</h2><video controls preload="metadata" src="', file,
        '"></video><p class="soft small">',
        t("If it does not play here, open %s, which lies beside this page, in any player.", link), "</p></section>")
end

local function chart_section(w, report, series)
    local html = charts.html(report, series)
    if html == "" then return end
    w("<section><h2>", e(t("Over time")), '</h2><p class="soft small">', e(t("Dashed lines: errors (red: critical, "
        .. "brown: minor). Red ground: danger. Grey ground: every second step.")), '</p><div class="charts">', html,
        "</div></section>")
end

local function rows(w, pairs_of)
    w("<table>")
    for _, row in ipairs(pairs_of) do
        if row[2] and row[2] ~= "" then w("<tr><th>", e(t(row[1])), "</th><td>", e(row[2]), "</td></tr>") end
    end
    w("</table>")
end

local function goals_text(goals)
    local parts, names = {}, {}
    for name in pairs(goals or {}) do names[#names + 1] = name end
    table.sort(names)
    for _, name in ipairs(names) do parts[#parts + 1] = name .. " " .. number(goals[name], 3) end
    return table.concat(parts, ", ")
end

local function background(w, report)
    local p, c = report.performance or {}, report.curriculum or {}
    w('<section class="background"><h2>', e(t("Patient, machine and simulation")), "</h2>")
    rows(w, {
        { "Patient", patient_text(report.patient) },
        { "Goals of the exercise", goals_text(report.goals) },
        { "Machine", goals_text(report.settings) },
        { "Exercise", c.version and t("%s, version %s", c.id or "", number(c.version, 2)) or c.id },
        { "Chance", report.seed and t("seed %s", tostring(report.seed)) },
        { "Steps of time", p.steps and t("%s, %s ms each on average, %s ms for all but 1 %%, %s repeated",
            number(p.steps, 0), number(p.mean_step_ms, 2), number(p.p99_step_ms, 2), number(p.rollbacks or 0, 0)) },
        { "Computing time", p.cpu_s_per_s and t("%s s per simulated second", number(p.cpu_s_per_s, 3)) },
    })
    local parts = report.simulated or {}
    if #parts > 0 then
        w('<h3 class="after">', e(t("What was simulated")), "</h3><table><tr><th>", e(t("Part")), "</th><th>",
            e(t("Elements")), "</th><th>", e(t("Computing time")), "</th></tr>")
        for _, part in ipairs(parts) do
            w("<tr><td>", e(part.part), "</td><td>", number(part.elements, 0), "</td><td>", number(part.cpu_s, 2),
                " s</td></tr>")
        end
        w("</table>")
    end
    w("</section>")
    if c.sha256 then w("<footer>", e(t("Curriculum %s", c.id)), ": <code>", e(c.sha256), "</code></footer>") end
end

-- What stands below every printed page: which exercise, the page, and that scores are not validated.
local function page_margins(report)
    local function quoted(text) return (text:gsub('[\\"<>&\n]', " ")) end
    return ('@page { @bottom-left { content:"%s"; font-size:8pt; color:#52606d } '
        .. '@bottom-center { content:"%s"; font-size:8pt; color:#52606d } '
        .. '@bottom-right { content:counter(page) " / " counter(pages); font-size:8pt; color:#52606d } }'):format(
        quoted("rhexis, " .. title_of(report)), quoted(t("not clinically validated")))
end

--- report: of report.json; series: of series.json; images: file name in report.pictures to base64 text of a PNG.
--- Returns the whole page.
function report_page.html(report, series, images)
    report_words.use(report.language)
    local w = markup.writer()
    w('<!doctype html><html lang="', e(report_words.language()), '"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1"><title>', e(title_of(report)),
        " – rhexis</title><style>", style, page_margins(report), "</style></head><body><main>")
    header(w, report)
    summary(w, report)
    scores.section(w, report.osacss)
    history.section(w, report)
    time_line(w, report)
    pictures.section(w, report, images or {})
    video(w, report)
    chart_section(w, report, series)
    background(w, report)
    w("</main></body></html>\n")
    return w:text()
end

return report_page
