-- SPDX-License-Identifier: GPL-3.0-or-later
-- Exercises and reports in French.
local language = require "exercise"
local osacss = require "osacss"
local names = require "report.names"
local report_page = require "report"
local report_words = require "report.words"
local support = require "support"
local texts = require "engine.texts"
local wanted_charts = require "report.wanted_charts"
local records_pages = { agreement = require "records.agreement", curve = require "records.curve",
    form = require "records.form" }

local case, equal, fails = support.case, support.equal, support.fails

local function has(text, part) if not text:find(part, 1, true) then error("lacks \"" .. part .. "\"", 2) end end

local french = [[texts = { fr = { ["Demo"] = "Essai", ["Only"] = "Seule", ["Go up."] = "Montez." } },]]

local function attempt(rest, name)
    local exercise = support.demo({ rest = rest,
        steps = 'step "only" { title = "Only", done = "tip.depth_mm > 3", hint = "Go down." }',
        errors = 'error_event "Deep" { when = "tip.depth_mm > 1", recovered = "tip.depth_mm > 2", advice = "Go up." }'
    })
    language.set(exercise, "language", name, {})
    texts.translate(exercise)
    local run, commands = support.attempt(exercise, 4, function(t) return { ["tip.depth_mm"] = t } end)
    return run:result(), commands, exercise
end

case("an exercise speaks the language of the run; what is missing stays English; ids do not change", function()
    local result, commands, exercise = attempt(french, "fr")
    equal(result.title, "Essai")
    equal(result.language, "fr")
    equal(result.steps[1].id, "only")
    equal(result.steps[1].title, "Seule")
    equal(result.events[1].advice, "Montez.")
    equal(result.events[1].title, "Deep")
    local captions = {}
    for _, command in ipairs(commands) do captions[#captions + 1] = command.text end
    has(table.concat(captions, "\n"), "Go down.")
    has(table.concat(captions, "\n"), "Erreur : Deep.")
    has(table.concat(captions, "\n"), "Étape « Seule » accomplie.")
    has(table.concat(captions, "\n"), "Corrigé après 1.0 s : Deep.")
    equal(texts.has("fr", exercise, "Only"), true)
    equal(texts.has("fr", exercise, "Deep"), false)
    equal(attempt(french, "en").title, "Demo")
end)

case("an unknown language and ill-formed texts are refused", function()
    fails(function() attempt(french, "xx") end, "--language xx", "there are no texts in 'xx'")
    fails(function() attempt('texts = { french = { a = "b" } },', "en") end, "demo/curriculum.lua:7:",
        "'french' is no language of two small letters")
    fails(function() attempt('texts = { fr = { "b" } },', "en") end, "texts must be pairs")
end)

case("all that the rubric says is there in French", function()
    local none = { texts = {} }
    local function wanted(text)
        if text and not texts.has("fr", none, text) then error("no French for \"" .. text .. "\"", 2) end
    end
    for _, item in ipairs(osacss.items) do
        wanted(item.name)
        wanted(item.not_scored)
        for _, measure in ipairs(item.measures) do
            for _, key in ipairs({ "name", "better", "too_low", "too_high", "source" }) do wanted(measure[key]) end
        end
    end
end)

case("all that a report calls measures, settings and goals is there in French", function()
    for _, list in ipairs({ names.own, names.of_instrument, names.goals, names.simulated }) do
        for _, meaning in pairs(list) do
            if not texts.has("fr", { texts = {} }, meaning) then error("no French for \"" .. meaning .. "\"") end
        end
    end
end)

-- As kernel/tools/instruments.cpp has them.
local instruments = { "cannula", "capsule_hook", "cutter", "cystotome", "drape", "forceps", "hook", "hydration_cannula",
    "ia_tip", "injector", "keratome", "lens_forceps", "needle_holder", "phaco", "probe", "ring", "saline_cannula",
    "side_port_blade", "spatula", "speculum", "sponge", "triamcinolone" }

local function page(lang)
    local event = { id = "e", title = "Erreur", step = "a", time_s = 1, severity = "minor", outcome = "recovered",
        recovered = true, recovery_s = 0.5, advice = "x", cue = "y", evidence = { ["iris.touch"] = true },
        consequences = { texts = {}, settings = { ["phaco.power_limit"] = 0.3 } } }
    local lost = { id = "f", title = "Autre", step = "a", time_s = 2, severity = "critical", outcome = "not_recovered",
        recovered = false, evidence = {} }
    local values = { 0.1, 0.2, 0.3 }
    local measures, spectra = {}, {}
    for _, chart in ipairs(wanted_charts) do
        for _, line in ipairs(chart.lines) do measures[line[1]] = { values = values } end
    end
    for _, name in ipairs({ "rhexis.tip_angle_deg", "forceps.holding", "phaco.ultrasound" }) do
        measures[name] = { values = values }
    end
    for _, name in ipairs(instruments) do
        for _, what in ipairs({ ".tip_x_mm", ".tip_y_mm", ".tremor_um" }) do
            measures[name .. what] = { values = values }
        end
        spectra[name] = { hz = { 1, 4, 8 }, um_per_sqrt_hz = { 9, 5, 2 } }
    end
    return report_page.html({ language = lang, title = "Essai", surgeon = "d", seed = 3, completed = false,
        mode = "exam", hints = false, level = "hard", objectives = { "Voir" }, duration_s = 3,
        orientation = { eye = "left", incision_deg = 0, incision = "temporal", handedness = "left", nose = "away",
            above = "to the right" },
        patient = { age = 70, nuclear_grade = 3, cortical_opacity = 1, pupil_mm = 7, side = "left" },
        history = { { date = "2026-01-02", score = 3, max = 5, passed = true, items = { T5 = 3 } } }, pass = 0.7,
        cohort = { group = "G", mean = 4, sd = 0.5, items = { T5 = 4 } },
        requests = { { id = "r", title = "Prêt", time_s = 1 } },
        curriculum = { id = "essai", version = 1, sha256 = "0" }, goals = { radius_mm = 2.6 }, advice = { "x" },
        error = "essai/curriculum.lua:3: faute", video = "video.mp4",
        steps = { { id = "a", title = "A", completed = true, start_s = 0, end_s = 1 },
            { id = "b", title = "B", completed = false, start_s = 1, end_s = 3 } },
        events = { event, lost },
        osacss = { total = 4, max = 5, scaled = 0.75, standing = { like = { "d" }, n = 8 }, items = {
            { id = "T5", name = "N", score = 4, reasons = { "r" }, measures = { { id = "m", name = "M", value = 1,
                unit = "mm", score = 4, threshold_source = "proposal" } } },
            { id = "T6", name = "O", reasons = {} } } },
        pictures = { { file = "frames/a.png", name = "start", caption = "Before the first step.", time_s = 0 } },
        simulated = { { part = "lens", elements = 5, cpu_s = 1 } },
        performance = { steps = 3, mean_step_ms = 1, p99_step_ms = 2, rollbacks = 0, cpu_s_per_s = 0.1 } },
        { time_s = { 0, 1, 2 }, measures = measures, spectra = spectra }, { ["frames/a.png"] = "QUJD" })
end

case("a report in French has no English word of its own left", function()
    local html = page("fr")
    equal(table.concat(report_words.missing, " | "), "")
    for _, part in ipairs({ '<html lang="fr">', "Note, critère par critère", "En bref", "œil gauche",
        "chirurgien gaucher", "examen (sans conseils)", "Une étape sur 2", "2 erreurs, dont une corrigée.",
        "Avant la première étape.", "comme les chirurgiens virtuels du groupe d",
        "Déroulement", "non corrigée à temps", "Remplissage de la chambre" }) do
        has(html, part)
    end
    for _, part in ipairs({ "Score, item", "In short", "What happened", "Next time", "not scored" }) do
        if html:find(part, 1, true) then error("still English: " .. part) end
    end
    local english = page("en")
    has(english, '<html lang="en">')
    has(english, "Score, item by item")
    has(english, "surgeon left-handed")
end)

-- As bindings/records/agreement.cpp and comparison.cpp give them, and gates.cpp.
local no_figure = { "nothing that both have scored", "only one attempt that both have scored",
    "too few raters: two at least", "nothing that all have scored", "only one attempt that all have scored",
    "too few judges", "all scores are the same", "the attempts do not differ" }
local no_pass = { "not completed", "an error of the exercise's script ended it", "below the pass mark",
    "it began at a later moment", "with aids",
    "in another mode than the gate asks for", "a critical error was not put right" }

local function curve_data(n, open_after)
    local attempts = { { date = "2026-01-02T03:04:05Z", scaled = 0.9, completed = true, passed = true, why = "" } }
    for _, why in ipairs(no_pass) do
        table.insert(attempts, { date = "x", scaled = 0.5, completed = why ~= no_pass[1], passed = false, why = why })
    end
    return { exercise = "essai", title = "Essai", pass = 0.7, in_a_row = n, open_after = open_after,
        time_to_gate_s = 60, first = 0.2, peak = 0.9, attempts = attempts }
end

local function agreement_data(attempts, raters)
    local limits = { n = 3, bias = -0.5, sd = 0.4, low = -1.28, high = 0.28 }
    local icc = { n = 3, k = 2, single = 0.71, average = 0.83 }
    local rows = {}
    for i, why in ipairs(no_figure) do
        rows[i] = { item = osacss.items[i].id, name = "Draping", raters = { icc = { why = why }, pairs = {} },
            simulator = { icc = { why = why }, limits = { why = why }, points = {} } }
    end
    rows[#rows + 1] = { item = "total", name = "Mean points per item x 20", raters = { icc = icc, pairs = {
        { a = "R1", b = "R2", limits = limits }, { a = "R1", b = "R3", limits = { why = no_figure[1] } } } },
        simulator = { icc = icc, limits = limits, points = { { 50, -10 } } } }
    return { attempts = attempts, raters = raters, left_out = { raters[#raters] }, rows = rows }
end

case("pages about stored attempts in French have no English word left", function()
    local pages = {
        { "curve", "Courbes d&#39;apprentissage de P07", { trainee = "P07", courses = { curve_data(2, 0),
            curve_data(1, 0), curve_data(2, 1), curve_data(2, 5) } } },
        { "form", "Évaluation 1 sur 2", { case = "abc", number = 1, of = 2, parts = 1, videos = { "video.mp4" },
            title = "Essai", items = { "T1" } } },
        { "form", "Partie 2 sur 2", { case = "abc", number = 1, of = 2, parts = 2, videos = { "1.mp4", "2.mp4" } } },
        { "agreement", "Accord entre simulateur et évaluateurs", agreement_data(1, { "R1" }) },
        { "agreement", "2 essais évalués, 2 évaluateurs", agreement_data(2, { "R1", "R2" }) },
    }
    for _, one in ipairs(pages) do
        local name, part, data = table.unpack(one)
        data.language = "fr"
        local html = records_pages[name].html(data)
        equal(table.concat(report_words.missing, " | "), "")
        support.check_balance(html)
        has(html, part)
        has(html, '<html lang="fr">')
        local seen = html:gsub("<style>.-</style>", ""):gsub("<script>.-</script>", ""):gsub("<[^>]*>", "")
        for _, english in ipairs({ "Draping", "points per item", "attempt", "rater", "scored" }) do
            if seen:find(english, 1, true) then error(name .. ": still English: " .. english) end
        end
    end
end)
