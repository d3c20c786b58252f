-- SPDX-License-Identifier: GPL-3.0-or-later
-- Pages about stored attempts: complete, escaped, well formed.
local agreement = require "records.agreement"
local anchors = require "records.anchors"
local curve = require "records.curve"
local form = require "records.form"
local osacss = require "osacss"
local page = require "records.page"
local support = require "support"
local typography = require "report.typography"

local case, equal, check_balance, holds = support.case, support.equal, support.check_balance, support.holds

case("every item of OSACSS has a choice of five and N/A in the form, and anchors for 1, 3 and 5", function()
    local html = form.html { case = "abc123", number = 2, of = 7, videos = { "part_1/video.mp4", "part_2/video.mp4" } }
    check_balance(html)
    holds(html, "Rating 2 of 7")
    holds(html, 'data-case="abc123"')
    for _, file in ipairs({ "part_1/video.mp4", "part_2/video.mp4" }) do
        holds(html, ('<video controls preload="metadata" src="%s">'):format(file))
    end
    equal(#osacss.items, 20)
    for _, item in ipairs(osacss.items) do
        local _, choices = html:gsub('type="radio" name="' .. item.id .. '"', "")
        equal(choices, 6)
        for _, points in ipairs { 1, 3, 5 } do
            assert(type(anchors[item.id][points]) == "string", item.id)
        end
    end
    equal(form.html { case = "abc", number = 1, of = 1 }:find("<video", 1, true), nil)
end)

local function lacks(text, part) equal(text:find(part, 1, true), nil, part) end

local function preset(html, id) return html:find('name="' .. id .. '" value="na" checked', 1, true) ~= nil end

case("a form is worded for what is shown, and names the exercise", function()
    local html = form.html { case = "abc", number = 1, of = 2, parts = 1, title = "Incision <1>", videos = { "v.mp4" } }
    check_balance(html)
    holds(html, "Incision &lt;1&gt;")
    holds(html, "Watch the replay of this exercise to its end.")
    lacks(html, "operation, one after")
    html = form.html { case = "abc", number = 1, of = 2, parts = 3, title = "Cataract operation",
        videos = { "a.mp4", "b.mp4", "c.mp4" } }
    holds(html, "Watch all parts of the operation, one after the other.")
    html = form.html { case = "abc", number = 1, of = 2, parts = 1, title = "Incision" }  -- nothing here to watch
    lacks(html, "Watch")
end)

case("items that the exercise does not judge are set to N/A in its form", function()
    local html = form.html { case = "abc", number = 1, of = 2, items = { "T2", "G3" } }
    for id, expected in pairs { T2 = false, G3 = false, T1 = true, G6 = true } do
        equal(preset(html, id), expected, id)
    end
    local folded = html:match("<details>.*</details>")
    local _, notes = folded:gsub(' value="na" checked', "")
    equal(notes, 18)
    holds(folded, "(18, set to N/A): open them where you have something to say")
    for _, id in ipairs { "T2", "G3" } do lacks(folded, 'id="' .. id .. '"') end
    for _, items in ipairs { { "X1", "X2" }, {} } do  -- of a rubric of other items nothing is known
        html = form.html { case = "abc", number = 1, of = 2, items = items }
        equal(preset(html, "T1"), false)
        lacks(html, "<details>")
    end
    equal(preset(form.html { case = "abc", number = 1, of = 2 }, "T1"), false)
    html = form.html { case = "abc", number = 1, of = 2, items = { "T2" }, language = "fr" }
    holds(html, "S.\u{A0}o.")
    lacks(html, "S. o.")
    lacks(html, "s. o.")
end)

case("a learning curve has a dot for each attempt, and says when the gate opened", function()
    local course = { exercise = "groove", title = "Groove <b>", pass = 0.725, in_a_row = 2, open_after = 3,
        time_to_gate_s = 180, first = 0.2, peak = 0.9, attempts = {} }
    for i = 1, 40 do
        course.attempts[i] = { date = "2026-01-0" .. i % 9, scaled = math.min(0.9, i / 30), completed = true,
            passed = i > 1 }
    end
    local html = curve.html { trainee = "P&07", courses = { course } }
    check_balance(html)
    for _, text in ipairs { "P&amp;07", "Groove &lt;b&gt;", "after 3 attempts and 3 min 00 s",
        "First 20\u{A0}%, best 90\u{A0}%" } do holds(html, text) end
    local _, dots = html:gsub("<circle[^>]*><title>", "")
    equal(dots, 40)
    course.attempts, course.open_after = { course.attempts[1] }, 0
    html = curve.html { trainee = "P07", courses = { course } }
    check_balance(html)
    holds(html, "The gate is closed: it opens after 2 passes in a row, of at least 72.5\u{A0}% each.")
    course.in_a_row = 1
    holds(curve.html { trainee = "P07", courses = { course } }, "it opens after 1 pass, of at least 72.5\u{A0}%.")
    course.open_after = 1
    holds(curve.html { trainee = "P07", courses = { course } }, "after 1 attempt and 3 min 00 s")
    course.peak = nil
    holds(curve.html { trainee = "P07", courses = { course } }, "First 20\u{A0}%, none completed yet.")
    holds(curve.html { trainee = "P07", courses = { course }, language = "fr" }, "aucun terminé pour l")
end)

case("a point that is no pass says why, and the legend what its mark means", function()
    local course = { exercise = "groove", title = "Groove", pass = 0.7, in_a_row = 2, open_after = 0, first = 0.9,
        peak = 0.9, attempts = {
            { date = "2026-03-01T09:30:00Z", scaled = 0.9, completed = false, passed = false, why = "not completed" },
            { date = "2026-03-02T09:30:00Z", scaled = 0.8, completed = true, passed = false,
                why = "a critical error was not put right" } } }
    local html = curve.html { trainee = "P07", courses = { course } }
    check_balance(html)
    holds(html, "<title>2026-03-01 09:30 UTC: 90\u{A0}%, not completed</title>")
    holds(html, "<title>2026-03-02 09:30 UTC: 80\u{A0}%, not passed: a critical error was not put right</title>")
    local shown = html:match('<p class="marks">.-</p>')
    holds(shown, "not passed")
    holds(shown, "not completed")
    lacks(shown, "> passed")
    course.attempts[1] = { date = "x", scaled = 0.9, completed = true, passed = true, why = "" }
    shown = curve.html { trainee = "P07", courses = { course } }:match('<p class="marks">.-</p>')
    holds(shown, "> passed")
    lacks(shown, "not completed")
end)

case("agreement: a chart for each item with limits, a reason where there are none", function()
    local limits = { n = 3, bias = -0.5, sd = 0.4, low = -1.28, high = 0.28 }
    local points = { { 3, -0.5 }, { 3, -0.5 }, { 4.5, -0.9 } }
    local icc = { n = 3, k = 2, single = 0.71, average = 0.83 }
    local data = { attempts = 3, raters = { "R<1>", "R2" }, rows = {
        { item = "X5", name = "Tear & so on", raters = { icc = icc, pairs = {} },
            simulator = { icc = icc, limits = limits, points = points } },
        { item = "T9", name = "", raters = { icc = { why = "all scores are the same" }, pairs = {} },
            simulator = { icc = { why = "x" }, points = {},
                limits = { why = "only one attempt that both have scored" } } },
        { item = "total", name = "Total", raters = { icc = icc, pairs = { { a = "R<1>", b = "R2", limits = limits } } },
            simulator = { icc = icc, limits = limits, points = { { 50, -10 }, { 60, 3 } } } } } }
    local html = agreement.html(data)
    check_balance(html)
    for _, text in ipairs { "Tear &amp; so on", "R&lt;1&gt;, R2", "<td>0.71</td>", "all scores are the same",
        "−1.96 SD −1.28", "bias −0.5", "only one attempt", "2 of mean 3, difference −0.5" } do holds(html, text) end
    local _, charts = html:gsub("<svg", "")
    equal(charts, 2)
    limits.bias, limits.low, limits.high, limits.sd = 0, 0, 0, 0
    check_balance(agreement.html(data))
end)

case("agreement: how many attempts and raters, items in the language of the page, tables that scroll", function()
    local limits = { why = "only one attempt that both have scored" }
    local function row(item, name)
        return { item = item, name = name, raters = { icc = { why = "too few raters: two at least" }, pairs = {} },
            simulator = { icc = { why = "only one attempt that all have scored" }, limits = limits, points = {} } }
    end
    local data = { attempts = 1, raters = { "R1" }, rows = { row("T1", "Champ opératoire"), row("X9", "Other"),
        row("total", "Mean points per item x 20") } }
    local html = agreement.html(data)
    for _, text in ipairs { "1 rated attempt, 1 rater: R1.", "<td>Draping</td>", "<td>Other</td>",
        "<td>Mean points per item × 20</td>", '<div class="scroll" tabindex="0"><table style="min-width:44rem">',
        ".scroll { overflow-x:auto; }" } do holds(html, text) end
    -- why there are no limits stands under them, not in the narrow column of n
    holds(html, '<td></td><td><span class="soft small">only one attempt that both have scored</span></td><td></td>')
    data.attempts, data.raters = 2, { "R1", "R2" }
    holds(agreement.html(data), "2 rated attempts, 2 raters: R1, R2.")
    data.language, data.rows[1].name = "fr", "Draping"
    html = agreement.html(data)
    holds(html, "2 essais évalués, 2 évaluateurs\u{A0}: R1, R2.")
    holds(html, "<td>Champ opératoire</td>")
    lacks(html, "Draping")
    data.attempts, data.raters = 1, { "R1" }
    holds(agreement.html(data), "1 essai évalué, 1 évaluateur\u{A0}: R1.")
end)

case("no line breaks before %, in French nor before : ; ? !, and styles and scripts stay as they are", function()
    local html = '<style>a :b { c:d }</style><p title="a : b">a : b ; c ? d ! 5 % <b>e :</b></p>'
        .. "<script>a ? b : c</script>"
    equal(typography.page(html, "en"), (html:gsub("5 %%", "5\u{A0}%%")))
    equal(typography.page(html, "fr"), '<style>a :b { c:d }</style><p title="a : b">'
        .. ("a_: b_; c_? d_! 5_% <b>e_:</b>"):gsub("_", "\u{A0}") .. "</p><script>a ? b : c</script>")
    local page_html = form.html { case = "a", number = 1, of = 1, language = "fr" }
    local seen = page_html:gsub("<style>.-</style>", ""):gsub("<script>.-</script>", ""):gsub("<[^>]*>", "")
    equal(seen:find(" [:;?!%%]"), nil)
end)

case("ticks read well", function()
    for _, range in ipairs { { 1, 5 }, { 20, 100 }, { -0.3, 0.3 }, { -40, 40 } } do
        local ticks = page.ticks(range[1], range[2])
        assert(#ticks >= 3 and #ticks <= 9, #ticks)
        assert(ticks[1] >= range[1] - 1e-9 and ticks[#ticks] <= range[2] + 1e-9)
    end
end)
