-- SPDX-License-Identifier: GPL-3.0-or-later
-- report.html of an attempt: everything in one file, for the screen and for paper.

local accuracy = require "report.accuracy"
local charts = require "report.charts"
local events = require "report.events"
local history = require "report.history"
local markup = require "report.markup"
local names = require "report.names"
local pictures = require "report.pictures"
local quantity = require "report.quantity"
local scores = require "report.scores"
local story = require "report.story"
local style = require "report.style"
local typography = require "report.typography"
local report_words = require "report.words"

local t, known = report_words.t, report_words.known

local report_page = {}

local e, number, time = markup.escape, markup.number, markup.time

local function title_of(report)
    return known(report.title or (report.curriculum and (report.curriculum.title or report.curriculum.id)))
        or t("Exercise")
end

local function who(report)
    local surgeons = { a = "virtual surgeon of group A (fewer than 50 operations)", b = "virtual surgeon of group B",
        c = "virtual surgeon of group C", d = "virtual surgeon of group D (over 500 operations)",
        novice = "virtual novice (fewer than 50 operations)", expert = "virtual expert (over 500 operations)",
        none = "trainee", person = "trainee" }
    local name = surgeons[report.surgeon] or not report.surgeon and "trainee"
    local devices = { mouse = "with a mouse", gamepad = "with a gamepad", vrpn = "with tracked instruments" }
    local with = report.surgeon == "person" and devices[report.input] and t(" (" .. devices[report.input] .. ")") or ""
    return (name and t(name) or report.surgeon) .. with
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
        t(o.above)) .. t("; ") .. t(("surgeon %s-handed"):format(o.handedness))
end

local function mode_text(report)
    if not report.mode then return nil end
    return t(report.mode == "exam" and "exam (no hints)" or "teaching (hints and advice said)")
end

local function header(w, report)
    w('<header><div class="head"><div><p class="soft small">', e(t("rhexis: report of an exercise")), "</p><h1>",
        e(title_of(report)),
        "</h1>")
    if report.summary then w("<p>", e(known(report.summary)), "</p>") end
    if #(report.objectives or {}) > 0 then
        w("<p><b>", e(t("Objectives:")), "</b></p><ul>")
        for _, objective in ipairs(report.objectives) do w("<li>", e(known(objective)), "</li>") end
        w("</ul>")
    end
    w('<ul class="facts">')
    local function fact(name, value)
        if value then w("<li>", e(t(name)), " <b>", e(value), "</b></li>") end
    end
    fact("By", who(report))
    fact("Patient", patient_text(report.patient))
    fact("Incision", incision_text(report.orientation))
    fact("Level", known(report.level))
    fact("Mode", mode_text(report))
    fact("Time", time(report.duration_s))
    w("</ul></div>", scores.badge(report), "</div></header>")
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
        .. "brown: minor). Red ground: danger. Grey ground: every second step.")), " ",
        #(report.parts or {}) > 1 and e(t("Grey lines: another part of the operation begins.")) or "",
        '</p><div class="charts">', html, "</div></section>")
end

local function rows(w, pairs_of)
    w('<table class="facts-table">')
    for _, row in ipairs(pairs_of) do
        local html = row.html or row[2] and e(row[2]) or ""
        if html ~= "" then w("<tr><th>", e(t(row[1])), "</th><td>", html, "</td></tr>") end
    end
    w("</table>")
end

local function simulated_name(part)
    return names.simulated[part] and t(names.simulated[part]) or (known(tostring(part)):gsub("_", " "))
end

local function background(w, report)
    local p, c = report.performance or {}, report.curriculum or {}
    w('<section class="background"><h2>', e(t("Patient, machine and simulation")), "</h2>")
    rows(w, {
        { "Patient", patient_text(report.patient) },
        { "Goals of the exercise", html = quantity.all(report.goals, quantity.goal) },
        { "Machine", html = quantity.all(report.settings, quantity.measure) },
        { "Exercise", c.version and t("%s, version %s", title_of(report), number(c.version, 2)) or c.id },
        { "Chance", report.seed and t("seed %s", tostring(report.seed)) },
        { "Steps of time", p.steps and t("%s, %s ms each on average, %s ms for all but 1 %%, %s repeated",
            number(p.steps, 0), number(p.mean_step_ms, 2), number(p.p99_step_ms, 2), number(p.rollbacks or 0, 0)) },
        { "Computing time", p.cpu_s_per_s and t("%s s per simulated second", number(p.cpu_s_per_s, 3)) },
    })
    local parts = report.simulated or {}
    if #parts > 0 then
        w('<h3 class="after">', e(t("What was simulated")), '</h3><div class="scroll"><table><tr><th>', e(t("Part")),
            "</th><th>", e(t("Elements")), "</th><th>", e(t("Computing time")), "</th></tr>")
        for _, part in ipairs(parts) do
            w("<tr><td>", e(simulated_name(part.part)), "</td><td>",
                part.elements ~= 0 and number(part.elements, 0) or "–", "</td><td>", number(part.cpu_s, 2),
                " s</td></tr>")
        end
        w("</table></div>")
    end
    accuracy.section(w, report)
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
    quantity.use(series and series.measures)
    local w = markup.writer()
    w('<!doctype html><html lang="', e(report_words.language()), '"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1"><title>', e(title_of(report)),
        " – rhexis</title><style>", style, page_margins(report), "</style></head><body><main>")
    header(w, report)
    story.section(w, report)
    scores.section(w, report)
    history.section(w, report)
    events.section(w, report)
    pictures.section(w, report, images or {})
    video(w, report)
    chart_section(w, report, series)
    background(w, report)
    w("</main></body></html>\n")
    return typography.page(w:text(), report_words.language())
end

return report_page
