-- SPDX-License-Identifier: GPL-3.0-or-later
-- The page made of a report: complete, escaped, well formed, and possible with little.
local markup = require "report.markup"
local pictures = require "report.pictures"
local report = require "report"
local support = require "support"

local case, equal, check_balance, holds = support.case, support.equal, support.check_balance, support.holds

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
        osacss = { rubric = "OSACSS", total = 7.5, max = 10, scaled = 0.69, band = "supervised", items = {
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
    for _, text in ipairs({ "Groove &lt;b&gt;", "Dig &amp; be gentle.", "7.5", "supervised",
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
