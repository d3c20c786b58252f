-- SPDX-License-Identifier: GPL-3.0-or-later
-- Exercises and reports in French.
local language = require "exercise"
local osacss = require "osacss"
local report_page = require "report"
local report_words = require "report.words"
local support = require "support"
local texts = require "engine.texts"

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

-- The items that capsulorhexis and iol_injection score.
local scored = { "T3", "T4", "T5", "T13", "G2", "G3", "G4", "G5", "G6" }

case("all that the rubric says of the items of capsulorhexis and implant is there in French", function()
    local none = { texts = {} }
    local function wanted(text)
        if text and not texts.has("fr", none, text) then error("no French for \"" .. text .. "\"", 2) end
    end
    for _, id in ipairs(scored) do
        local item = osacss.by_id[id]
        wanted(item.name)
        wanted(item.not_scored)
        for _, measure in ipairs(item.measures) do
            for _, key in ipairs({ "name", "better", "too_low", "too_high" }) do wanted(measure[key]) end
        end
    end
    for _, band in ipairs(osacss.bands) do
        wanted(band.name)
        wanted(band.meaning)
    end
end)

local function page(lang)
    local event = { id = "e", title = "Erreur", step = "a", time_s = 1, severity = "minor", outcome = "recovered",
        recovered = true, recovery_s = 0.5, advice = "x", cue = "y", evidence = { ["iris.touch"] = true },
        consequences = { texts = {}, settings = { ["phaco.power_limit"] = 0.3 } } }
    local lost = { id = "f", title = "Autre", step = "a", time_s = 2, severity = "critical", outcome = "not_recovered",
        recovered = false, evidence = {} }
    local values = { 0.1, 0.2, 0.3 }
    local measures = {}
    for _, name in ipairs({ "iris.gap_mm", "rhexis.tip_radius_mm", "rhexis.tip_angle_deg", "rhexis.turned_deg",
        "forceps.holding", "viscoelastic.fill", "forceps.force_mN", "implant.delivered", "implant.unfolded",
        "implant.decentration_mm", "implant.tilt_deg", "bag.rim_stretch", "injector.force_mN", "reflex.tip",
        "reflex.mean" }) do measures[name] = { values = values } end
    return report_page.html({ language = lang, title = "Essai", surgeon = "d", seed = 3, completed = false,
        mode = "exam", hints = false, level = "hard", objectives = { "Voir" }, duration_s = 3,
        orientation = { eye = "left", incision_deg = 0, incision = "temporal", handedness = "left", nose = "away",
            above = "to the right" },
        patient = { age = 70, nuclear_grade = 3, cortical_opacity = 1, pupil_mm = 7, side = "left" },
        curriculum = { id = "essai", version = 1, sha256 = "0" }, goals = { radius_mm = 2.6 }, advice = { "x" },
        error = "essai/curriculum.lua:3: faute", video = "video.mp4",
        steps = { { id = "a", title = "A", completed = true, start_s = 0, end_s = 1 },
            { id = "b", title = "B", completed = false, start_s = 1, end_s = 3 } },
        events = { event, lost },
        osacss = { total = 4, max = 5, scaled = 0.75, band = "autonome", band_meaning = "z", items = {
            { id = "T5", name = "N", score = 4, reasons = { "r" }, measures = { { id = "m", name = "M", value = 1,
                unit = "mm", score = 4, threshold_source = "proposal" } } },
            { id = "T6", name = "O", reasons = {} } } },
        pictures = { { file = "frames/a.png", name = "start", caption = "Before the first step.", time_s = 0 } },
        simulated = { { part = "lens", elements = 5, cpu_s = 1 } },
        performance = { steps = 3, mean_step_ms = 1, p99_step_ms = 2, rollbacks = 0, cpu_s_per_s = 0.1 } },
        { time_s = { 0, 1, 2 }, measures = measures }, { ["frames/a.png"] = "QUJD" })
end

case("a report in French has no English word of its own left", function()
    local html = page("fr")
    equal(table.concat(report_words.missing, " | "), "")
    for _, part in ipairs({ '<html lang="fr">', "Note, critère par critère", "En bref", "œil gauche",
        "chirurgien gaucher", "examen (sans conseils)", "1 étapes sur 2", "2 erreurs, dont 1 corrigées.",
        "Avant le premier instant.", "Déroulement", "non corrigée à temps", "Remplissage de la chambre" }) do
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
