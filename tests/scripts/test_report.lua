-- SPDX-License-Identifier: GPL-3.0-or-later
-- The page made of a report: complete, escaped, well formed, and possible with little.
local markup = require "report.markup"
local osacss = require "osacss"
local pictures = require "report.pictures"
local quantity = require "report.quantity"
local report = require "report"
local report_words = require "report.words"
local support = require "support"
local typography = require "report.typography"

local case, equal, check_balance = support.case, support.equal, support.check_balance

local joined = "\u{A0}"

-- No line of a page breaks before %.
local function holds(html, text) support.holds(html, (text:gsub(" %%", joined .. "%%"))) end

local function lacks(html, text)
    if html:find(text, 1, true) then error("the page has \"" .. text .. "\"", 2) end
end

-- What a reader sees: no tags, no attributes.
local function visible(html)
    return (html:gsub("<style>.-</style>", ""):gsub("<[^>]*>", ""))
end

local function full()
    return {
        schema = 1, title = "Groove <b>", summary = "Dig & be gentle.", surgeon = "novice", seed = 7,
        curriculum = { id = "groove", version = 1, sha256 = "abc" },
        patient = { age = 68, nuclear_grade = 3, pupil_mm = 7.5, side = "right" },
        completed = false, duration_s = 12, goals = { length_mm = 4 },
        steps = { { id = "a", title = "Go \"in\"", completed = true, start_s = 0, end_s = 5 },
            { id = "b", title = "Out", completed = false, start_s = 5, end_s = 12 }, { id = "c", completed = false } },
        events = { { id = "deep", title = "Too <deep>", time_s = 6, severity = "critical", outcome = "recovered",
            recovered = true, recovery_s = 0.8, advice = "Up & away.", cue = "Glow.", items = { "T9" },
            evidence = { ["tip.x_mm"] = 0.25, ["tip.touch"] = true } },
            { id = "iris", title = "Iris", time_s = 8, severity = "minor", outcome = "not_recovered", recovered = false,
            advice = "Careful.", items = {}, evidence = {} } },
        advice = { "Do <less>." },
        osacss = { rubric = "OSACSS", total = 7.5, max = 10, scaled = 0.69,
            standing = { like = { "b", "c" }, n = 9 }, items = {
            { id = "T9", name = "Nucleus", score = 3, reasons = { "Too deep: at most 3 points." }, capped_by = {},
                measures = { { id = "T9.m", name = "Depth", value = 55, unit = "%", score = 2.5,
                    threshold_source = "proposal" } } },
            { id = "T1", name = "Draping", reasons = { "Not scored." }, measures = {}, capped_by = {} } } },
        pictures = { { file = "frames/001.png", caption = "After <it>", time_s = 3 }, { file = "gone.png" } },
        simulated = { { part = "lens", elements = 3000, cpu_s = 1.5 } },
        performance = { steps = 1200, cpu_s_per_s = 0.3, mean_step_ms = 3, p99_step_ms = 4, rollbacks = 0 },
    }
end

local function series()
    local times, depth, x, y, on = {}, {}, {}, {}, {}
    for i = 1, 50 do
        times[i] = 0.2 * i
        if i % 10 ~= 0 then depth[i], x[i], y[i] = 0.01 * i, 0.1, 0.1 * i end
        on[i] = i % 5 == 0 and 1 or 0
    end
    return { time_s = times, measures = { ["groove.depth_share"] = { unit = "1", values = depth },
        ["phaco.tip_x_mm"] = { unit = "mm", values = x }, ["phaco.tip_y_mm"] = { unit = "mm", values = y },
        ["phaco.ultrasound"] = { unit = "bool", values = on } } }
end

case("a video beside the report can be played and opened, and only a plain name is one", function()
    local told = full()
    if report.html(told, series(), {}):find("<video", 1, true) then error("a video where there is none") end
    told.video = "video.mp4"
    local html = report.html(told, series(), {})
    check_balance(html)
    holds(html, 'src="video.mp4"')
    holds(html, '<a href="video.mp4">')
    for _, name in ipairs({ 'x.mp4"><script>', "../../etc/video.mp4", "http://far/away.mp4", "video.avi" }) do
        told.video = name
        if report.html(told, series(), {}):find("<video", 1, true) then error("taken for a video: " .. name) end
    end
end)

case("a full report holds score, reasons, errors, pictures and charts, all escaped", function()
    local html = report.html(full(), series(), { ["frames/001.png"] = "aGVsbG8=" })
    check_balance(html)
    for _, text in ipairs({ "Groove &lt;b&gt;", "Dig &amp; be gentle.", "7.5",
        "like virtual surgeons of groups b and c",
        "Too deep: at most 3 points.", "Too &lt;deep&gt;", "Up &amp; away.", "put right after 0.8 s",
        "not put right in time", "Do &lt;less&gt;.",
        "data:image/png;base64,aGVsbG8=", "After &lt;it&gt;", "not been validated clinically", "<svg",
        '<span class="quantity" title="tip.x_mm">tip x <b>0.25\u{A0}mm</b></span>', "One of 3 steps was completed",
        "3000", "seed 7", "NO3" }) do
        holds(html, text)
    end
    equal(html:find("<deep>", 1, true), nil)
    equal(html:find("<script", 1, true), nil)
    equal(html:find("https?://", 1), nil, "reaches for the network")
end)

case("earlier attempts and a cohort are compared with, where there are any and they can be read", function()
    local told = full()
    told.completed = true
    equal(report.html(told, series(), {}):find("earlier attempts", 1, true), nil)
    told.history = { { date = "2026-01-02", score = 4, max = 10, passed = false, items = { T9 = 2 } },
        { date = "<b>", score = 7, max = 10, passed = true, items = { T9 = 2.5 } }, { score = "x" }, 7 }
    told.cohort = { group = "experts & co", n = 7, mean = 9, sd = 0.5, items = { T9 = 4.5 } }
    local html = report.html(told, series(), {})
    check_balance(html)
    for _, text in ipairs({ "Compared with earlier attempts and with others", "Attempt 3. The best so far",
        "experts &amp; co, 7 trainees", "88 % ± 6 of the scale", "2026-01-02: 25 % of the scale",
        "62 % of the scale, passed", '<span class="tg">+0.5</span>', "<td>4.5</td>" }) do holds(html, text) end
    equal(html:find("<b>:", 1, true), nil)
    told.osacss.total = 3
    html = report.html(told, series(), {})
    holds(html, "The best so far had 62 % of the scale, this one 12 %.")
    told.history, told.cohort = "broken", 5
    check_balance(report.html(told, series(), {}))
end)

case("a spectrum of tremor is drawn, and what would have been better stands beside each measure", function()
    local told, over = full(), series()
    told.osacss.items[1].measures[1].better = "Dig <on>."
    told.osacss.items[1].measures[1].time_s = 61
    told.osacss.items[1].anchor = "fair & square"
    over.spectra = { phaco = { hz = { 1, 4, 8, 12 }, um_per_sqrt_hz = { 900, 5, 40, 8 }, windows = 3 } }
    local html = report.html(told, over, {})
    check_balance(html)
    for _, text in ipairs({ "Spectrum of tremor", "Dig &lt;on&gt;.", "1 min 01 s", "fair &amp; square",
        '<span class="src">proposal</span>', "not clinically validated" }) do holds(html, text) end
end)

case("a report of an attempt that was stopped early still makes a page", function()
    local html = report.html({ schema = 1, error = "groove/curriculum.lua:3: oh <no>", completed = false, steps = {},
        events = {}, measures = {}, pictures = {} }, { time_s = {}, measures = {} }, {})
    check_balance(html)
    holds(html, "groove/curriculum.lua:3: oh &lt;no&gt;")
    holds(html, "not scored")
    check_balance(report.html({}, nil, nil))
end)

case("a picture that is no base64 text is left out", function()
    local html = report.html(full(), series(), { ["frames/001.png"] = '"><script>alert(1)</script>' })
    equal(html:find("alert", 1, true), nil)
end)

case("of very many pictures the first of each kind are held in order, and the page tells of the others", function()
    local told, images = { pictures = {} }, {}
    local function add(name)
        local index = #told.pictures + 1
        told.pictures[index] = { file = index .. ".png", name = name, caption = name .. " " .. index, time_s = index }
        images[index .. ".png"] = name == "end" and "dGhlIGVuZA==" or "aGVsbG8="
    end
    add("start")
    for i = 1, 100 do
        add("error_slip")
        if i % 2 == 0 then add("recovered_slip") end
        if i == 90 then add("error_rare") end
    end
    add("end")
    local html = report.html(told, nil, images)
    check_balance(html)
    equal(select(2, html:gsub("<img ", "")), pictures.most)
    holds(html, ("The other %d of %d lie in"):format(#told.pictures - pictures.most, #told.pictures))
    local from = 1
    for _, caption in ipairs({ "start 1", "error_slip 2", "error_slip 3", "recovered_slip 4", "error_rare 137",
        "end 153" }) do
        local _, to = html:find('alt="' .. caption .. '"', from, true)
        if not to then error("not there, or not in its order: " .. caption) end
        from = to
    end
    for index in html:gmatch('alt="recovered_slip (%d+)"') do
        holds(html, ('alt="error_slip %d"'):format(tonumber(index) - 1))
    end
    told.pictures = table.move(told.pictures, 1, pictures.most, 1, {})
    html = report.html(told, nil, images)
    equal(select(2, html:gsub("<img ", "")), pictures.most)
    equal(html:find("lie in", 1, true), nil)
end)

case("the end is not shown twice where it looks as the last step did", function()
    local told = { pictures = { { file = "1.png", name = "step_out", caption = "Out", time_s = 3 },
        { file = "2.png", name = "end", caption = "End", time_s = 3 } } }
    equal(select(2, report.html(told, nil, { ["1.png"] = "QUJD", ["2.png"] = "QUJD" }):gsub("<img ", "")), 1)
    equal(select(2, report.html(told, nil, { ["1.png"] = "QUJD", ["2.png"] = "QUJE" }):gsub("<img ", "")), 2)
end)

case("a long title is shortened in the time line, and a chart whose lines never change is left out", function()
    local told = full()
    told.steps[1].title = ("é"):rep(80)
    local over = series()
    over.measures["lens.displacement_mm"] = { unit = "mm", values = { 0, 0, 0 } }
    local html = report.html(told, over, {})
    check_balance(html)
    holds(html, ("é"):rep(58) .. "…</text>")
    holds(html, "How deep the groove is")
    equal(html:find("How far the lens is pushed", 1, true), nil)
end)

case("measures, settings and goals are told by meaning and unit, and their names stay out of sight", function()
    local told, over = full(), series()
    told.events[1].evidence = { ["chamber.pressure_mmhg"] = 12.3, ["wounds.leak_ul_s"] = 1.25,
        ["rhexis.closed"] = false, ["groove.depth_share"] = 0.553, ["phaco.force_mN"] = 3,
        ["lens.displacement_mm"] = 0.0412, ["iris.touch"] = 1, ["mine.big_thing"] = 2, ["tip.angle_deg"] = 30 }
    told.events[1].consequences = { texts = {}, settings = { ["phaco.power_limit"] = 0.3 } }
    told.settings = { ["machine.bottle_cm"] = 75, ["cartridge.tucked"] = 0 }
    told.goals = { length_mm = 4, my_goal_mm = 2 }
    over.measures["tip.angle_deg"] = { unit = "degrees", meaning = "Angle of the tip.", values = {} }
    local html = report.html(told, over, {})
    check_balance(html)
    local seen = visible(html)
    for _, text in ipairs({ "pressure in the eye 12.3_mmHg", "leak of all wounds 1.25_µl/s",
        "the tear has come round no", "depth of the groove, of the lens's thickness 55.3_%", "phaco: force 3_mN",
        "shift of the lens 0.041_mm", "an instrument touches the iris yes", "mine big thing 2",
        "angle of the tip 30°",
        "limit of the ultrasound power set to 30_%", "height of the bottle 75_cm",
        "haptics folded onto the optic no", "length of the groove 4_mm", "my goal 2_mm" }) do
        holds(seen, markup.escape((text:gsub("_", joined))))
    end
    for _, name in ipairs({ "chamber.pressure", "_mmhg", "wounds.leak", "machine.", "phaco.power", "length_mm",
        "big_thing" }) do lacks(seen, name) end
    holds(html, 'title="chamber.pressure_mmhg"')
end)

case("units are written as people write them, and a yes or no of a rubric as yes or no", function()
    report_words.use("en")
    equal(quantity.unit("ul/s"), "µl/s")
    equal(quantity.unit("1"), "")
    equal(quantity.rewritten("5 ul/s (5 points at 2.50 x), 30 degrees, 60 degrees C on, 2 xyz, 4 mm^3"),
        ("5_µl/s (5 points at 2.50_×), 30°, 60_°C on, 2 xyz, 4_mm³"):gsub("_", joined))
    equal(quantity.asked("Pedal tested (1: yes)"), "Pedal tested")
    equal(quantity.asked("Roundness (1: a circle)"), nil)
    local told = full()
    told.osacss.items = { { id = "T1", name = "x", score = 3, capped_by = {}, reasons = { "as it was" },
        measures = { { id = "T1.pedal", name = "Pedal tested by then (1: yes)", unit = "1", value = 0, score = 1,
            text = "Pedal tested by then (1: yes): 0 (5 points at 1, 3 at 0, 1 at 0)", better = "Press it." } } } }
    local html = report.html(told, series(), {})
    holds(html, "<li>Pedal tested by then: no. Press it.</li>")
    holds(html, "<td>Pedal tested by then</td><td>no</td>")
    lacks(visible(html), "(1)")
end)

case("reasons are told again from what they are made of: one point, and times as people say them", function()
    local told = full()
    told.osacss.items = { { id = "T9", name = "Sculpting", score = 1, reasons = { "a", "b" }, measures = {},
        capped_by = {
        { event = "burn", title = "Burn", outcome = "not_recovered", cap = 1, time_s = 125 },
        { event = "iris", title = "Iris touched", outcome = "recovered", cap = 4, time_s = 5.6 },
        { event = "iris", title = "Iris touched", outcome = "recovered", cap = 4, time_s = 7 } } } }
    local html = report.html(told, series(), {})
    holds(html, "Burn at 2 min 05 s, not put right in time: at most 1 point.")
    holds(html, "Iris touched at 5.6 s and once more, put right: at most 4 points.")
end)

case("a page can be in another language than its run: items by their ids, measures, reasons and errors", function()
    local told, own = full(), nil
    for _, item in ipairs(osacss.items) do own = item.id == "T2" and item or own end
    local measure = own.measures[1]
    told.language = "fr"
    told.osacss.items = { { id = "T2", name = "Incision and paracentesis", score = 3, capped_by = {}, reasons = { "x" },
        measures = { { id = measure.id, name = measure.name, unit = "mm", value = 1.48, score = 3.9,
            better = measure.better, threshold_source = measure.source,
            text = measure.name .. ": 1.48 mm (5 points at 1.75 to 2.25 mm, 3 at 1.25 or 2.75 mm, 1 at 1.00 mm)" } } } }
    told.steps, told.pictures = {}, { { file = "a.png", caption = 'Step "Cut" completed.', time_s = 1 } }
    local html = visible(report.html(told, series(), { ["a.png"] = "QUJD" }))
    for _, text in ipairs({ "Incision et paracentèse",
        "comme les chirurgiens virtuels des groupes b et c", "Étape « Cut » accomplie.",
        "Longueur du tunnel de l'incision principale : 1,48 mm (5 points pour 1,75 à 2,25 mm, 3 pour 1,25 ou "
            .. "2,75 mm, 1 pour 1,00 mm). À peu près aussi long que large : 2 mm." }) do
        holds((html:gsub(joined, " ")), markup.escape(text))
    end
    lacks(html, "paracentesis")
end)

case("the badge says on how many items the score rests and whose it is like; not of who began in the middle", function()
    local told = full()
    told.completed = true
    local html = report.html(told, series(), {})
    holds(html, "rests on 1 of 20 items")
    holds(html, '<span class="band fair">like virtual surgeons of groups b and c</span>')
    holds(html, "this exercise was completed 9 times by virtual surgeons of group b and c")
    told.osacss.standing = { none = "too few items" }
    holds(report.html(told, series(), {}), '<span class="band none">no comparison: too few items</span>')
    lacks(html, "in the middle")
    told.begun_at, told.parts = "cortex", { { id = "cortex", title = "Cortex <out>", duration_s = 12 } }
    html = report.html(told, series(), {})
    check_balance(html)
    holds(html, "This operation was begun in the middle, with “Cortex &lt;out&gt;”.")
    holds(html, "no comparison: begun in the middle")
    lacks(html, "like virtual surgeons")
    told.begun_at, told.parts = "half.rhxs", nil
    holds(report.html(told, series(), {}), "This exercise was begun in the middle: half.rhxs.")
end)

case("what happened is told in sentences that fit one, some and all", function()
    local told = full()
    local function story(errors, right, done, steps, completed)
        told.events, told.steps, told.completed = {}, {}, completed
        for i = 1, errors do
            told.events[i] = { id = "e", title = "E", time_s = 1, severity = "minor", recovered = i <= right,
                outcome = i <= right and "recovered" or "not_recovered" }
        end
        for i = 1, steps do told.steps[i] = { id = "s" .. i, title = "S" .. i, completed = i <= done } end
        return visible(report.html(told, nil, {})):gsub(joined, " ")
    end
    holds(story(0, 0, 3, 3, true), "All 3 steps were completed. No error was made.")
    holds(story(1, 0, 1, 1, true), "The only step was completed. One error was made, and not put right.")
    holds(story(1, 1, 0, 2, false), "None of the 2 steps was completed. One error was made, and put right.")
    holds(story(2, 1, 2, 3, false), "2 of 3 steps were completed; not completed: “S3”. 2 errors were made, and one of "
        .. "them put right.")
    holds(story(2, 0, 1, 3, false), "One of 3 steps was completed; these were not completed: “S2”, “S3”. 2 errors were "
        .. "made, and none put right.")
    told.language = "fr"
    holds(story(1, 0, 1, 1, true), "La seule étape a été accomplie. Une erreur, non corrigée.")
    equal(report_words.count(0, "%d trainee", "%d trainees", 0), "0 interne")
    holds(story(3, 2, 2, 3, false), "2 étapes sur 3 ont été accomplies ; non accomplie : « S3 ». 3 erreurs, dont 2 "
        .. "corrigées.")
end)

case("errors are named in short, the gravest first, and what was given is not among them", function()
    local told = full()
    told.events = {
        { id = "m", title = "Iris <touched>", time_s = 1, severity = "minor", recovered = true, outcome = "recovered" },
        { id = "m", title = "Iris <touched>", time_s = 2, severity = "minor", recovered = false, outcome = "open" },
        { id = "c", title = "Burn", time_s = 3, severity = "critical", recovered = false, outcome = "not_recovered" },
        { id = "g", title = "Prolapse", time_s = 0, severity = "critical", recovered = true, outcome = "recovered",
            given = true } }
    local html = report.html(told, series(), {})
    check_balance(html)
    holds(html, "3 errors were made, and one of them put right.")
    holds(html, "Errors: “Burn” (not put right), “Iris &lt;touched&gt;” (2 times; 1 of 2 put right).")
    holds(html, "The exercise began with: “Prolapse” (put right).")
    holds(html, "given at the start")
    told.language = "fr"
    local french = visible(report.html(told, series(), {})):gsub(joined, " ")
    holds(french, markup.escape("L'exercice a commencé par : « Prolapse » (corrigée)."))
end)

case("scores are compared as shares of the scale, with pass, numbers and what was not completed", function()
    local told = full()
    told.osacss.total, told.osacss.max, told.pass = 2, 10, 0.725
    told.history = { { date = "2026-01-02", score = 10, max = 10, completed = false, items = {} } }
    local html = report.html(told, series(), {})
    check_balance(html)
    holds(html, "Attempt 2. 0 % of the scale for what was done: not completed, and not compared.")
    holds(html, "2026-01-02: 100 % of the scale, not completed</title>")
    holds(html, "now: 0 % of the scale, not completed</title>")
    holds(html, ">pass mark</text>")
    holds(html, ">attempt</text>")
    for number = 1, 2 do holds(html, (' text-anchor="middle">%d</text>'):format(number)) end
    lacks(html, "<th>Cohort</th>")
    told.history, told.pass = nil, nil
    told.cohort = { n = 1, mean = 100, max = 100, items = {} }
    html = report.html(told, series(), {})
    holds(html, "The cohort (1 trainee) has 100 % of the scale.")
    lacks(html, "<th>Last time</th>")
    lacks(html, ">pass mark</text>")
    told.completed = true
    told.history = { { date = "2026-01-02", score = 10, max = 10, completed = false, items = {} } }
    holds(report.html(told, series(), {}), "The first that was completed, with 0 % of the scale.")
    told.history[1].completed = true
    holds(report.html(told, series(), {}), "The best so far had 100 % of the scale, this one 0 %.")
end)

case("a French page has decimal commas, « » and spaces that do not break, and styles stay as they are", function()
    equal(typography.french("à 5.6 s : “oui” ; 30 % (2.5 mm) ?"),
        ("à 5,6_s_: «_oui_»_; 30_% (2,5_mm)_?"):gsub("_", joined))
    local page = '<style>a{b:1.5}</style><p style="width:1.5%">1.5 mm</p><code>1.5 mm</code>'
    equal(typography.page(page, "fr"), ('<style>a{b:1.5}</style><p style="width:1.5%%">1,5_mm</p><code>1.5 mm</code>')
        :gsub("%%%%", "%%"):gsub("_", joined))
    equal(typography.page(page, "en"), page)
    local told = full()
    told.language = "fr"
    local html = report.html(told, series(), {})
    check_balance(html)
    holds(html, 'style="width:60.0%"')
    holds(html, "<b>7,5</b>")
    holds(html, "0,8" .. joined .. "s")
    if visible(html):find("%d%.%d") then error("a decimal point: " .. visible(html):match(".?.?%d%.%d.?.?.?")) end
    equal(report_words.language(), "fr")
    equal(markup.number(2.5), "2,5")
    report_words.use("en")
end)

-- A page with measures by name, each a list of values over the seconds 0, 1, 2, ...
local function charted(told, lists)
    local over = { time_s = {}, measures = {} }
    for name, values in pairs(lists) do
        over.measures[name] = { unit = "mm", values = values }
        for i in pairs(values) do
            for k = 1, i do over.time_s[k] = k - 1 end
        end
    end
    return report.html(told, over, {})
end

case("a chart that is for an item is left out where that item is not judged", function()
    local told = full()
    local lines = { ["groove.depth_share"] = { 0, 0.1, 0.2 } }
    for _, item in ipairs(told.osacss.items) do
        if item.id == "T9" then item.score = nil end
    end
    lacks(charted(told, lines), "How deep the groove is")
    told.osacss = nil
    holds(charted(told, lines), "How deep the groove is")
end)

case("one line needs no legend, two have one, and counted things have no unit", function()
    local told = full()
    local html = charted(told, { ["groove.depth_share"] = { 0, 0.1, 0.2 } })
    holds(html, "How deep the groove is")
    lacks(html, 'class="legend"')
    html = charted(told, { ["groove.depth_share"] = { 0, 0.1, 0.2 }, ["groove.mean_depth_share"] = { 0, 0.1, 0.1 } })
    holds(html, 'class="legend"')
    html = charted(told, { ["beads.placed"] = { 0, 1, 2 } })
    holds(html, "<h3>Beads in the tray</h3>")
    holds(charted(told, { ["forceps.tremor_um"] = { 1, 2, 3 } }), "Trembling of the tip (6 to 12 Hz): forceps")
end)

case("a way has a scale, all of it that is at the eye is in view, and one elsewhere is left out", function()
    local told = full()
    local html = charted(told, { ["cannula.tip_x_mm"] = { 0, 0, 0 }, ["cannula.tip_y_mm"] = { -8.5, -3, 1 } })
    holds(html, "Way of the instrument: cannula")
    holds(html, '<path class="scale"')
    holds(html, ">5 mm</text>")
    local _, y = html:match('<path d="M([%d.]+) ([%d.]+)L')
    if not y or tonumber(y) > 360 then error("the way leaves the view: " .. tostring(y)) end
    lacks(html, 'class="legend"')
    lacks(charted(told, { ["cannula.tip_x_mm"] = { 0, 1, 2 }, ["cannula.tip_y_mm"] = { -14, -14, -15 } }),
        "Way of the instrument")
    lacks(charted(told, { ["cannula.tip_x_mm"] = { [1] = 0, [3] = 1 }, ["cannula.tip_y_mm"] = { [1] = 0, [3] = 1 } }),
        "Way of the instrument")
    lacks(charted(told, { ["rhexis.tip_x_mm"] = { 0, 1, 2 }, ["rhexis.tip_y_mm"] = { 0, 1, 1 } }),
        "Way of the instrument")
end)

case("a line breaks where another part of an operation begins, and shows the parts that have it", function()
    local told = full()
    told.events, told.steps = {}, {}
    told.parts = { { id = "a", duration_s = 3 }, { id = "b", duration_s = 3 }, { id = "c", duration_s = 3 } }
    local all = charted(told, { ["lens.displacement_mm"] = { 0, 0.1, 0.2, 0.3, 0.1, 0.2, 0, 0.1, 0.2 } })
    local path = all:match('<path d="(M[^"]+)" fill="none" stroke="#1f5f8b"')
    equal(select(2, path:gsub("M", "")), 3, "pieces")
    equal(select(2, all:gsub('class="part"', "")), 2, "beginnings of parts")
    holds(all, "Grey lines: another part of the operation begins.")
    local later = charted(told, { ["reflex.tip"] = { [7] = 0.1, [8] = 0.2, [9] = 0.3 } })
    holds(later, 'text-anchor="middle">6</text>')
    lacks(later, 'text-anchor="middle">5</text>')
    local way = charted(told, { ["cannula.tip_x_mm"] = { 0, 1, 1, 0, 1, 1 },
        ["cannula.tip_y_mm"] = { 0, 0, 1, 0, 0, 1 } })
    equal(select(2, way:gsub('stroke="#1f5f8b" stroke%-width="1"', "")), 2, "pieces of the way")
    told.parts = nil
    path = charted(told, { ["lens.displacement_mm"] = { 0, 0.1, 0.2, 0.3 } })
        :match('<path d="(M[^"]+)" fill="none" stroke="#1f5f8b"')
    equal(select(2, path:gsub("M", "")), 1, "pieces")
end)

case("wide tables scroll within the page", function()
    local html = report.html(full(), series(), {})
    for _, class in ipairs({ "items", "measures" }) do holds(html, '<div class="scroll"><table class="' .. class) end
    holds(html, '<div class="scroll timeline"><svg')
end)

case("numbers and times are written as people do", function()
    equal(markup.number(3.10, 2), "3.1")
    equal(markup.number(-0.001, 2), "0")
    equal(markup.number(100, 2), "100")
    equal(markup.number(-1.25, 2), "−1.25")
    equal(markup.number(nil, 2), "–")
    equal(markup.time(12.34), "12.3 s")
    equal(markup.time(125), "2 min 05 s")
    equal(markup.escape([[<a href="x">'&]]), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;")
end)
