-- SPDX-License-Identifier: GPL-3.0-or-later
-- Pages about stored attempts: complete, escaped, well formed.
local agreement = require "records.agreement"
local anchors = require "records.anchors"
local curve = require "records.curve"
local form = require "records.form"
local osacss = require "osacss"
local page = require "records.page"
local support = require "support"

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

case("a learning curve has a dot for each attempt, and says when the gate opened", function()
    local course = { exercise = "groove", title = "Groove <b>", pass = 0.725, in_a_row = 2, open_after = 3,
        time_to_gate_s = 180, first = 0.2, peak = 0.9, attempts = {} }
    for i = 1, 40 do
        course.attempts[i] = { date = "2026-01-0" .. i % 9, scaled = math.min(0.9, i / 30), passed = i > 1 }
    end
    local html = curve.html { trainee = "P&07", courses = { course } }
    check_balance(html)
    for _, text in ipairs { "P&amp;07", "Groove &lt;b&gt;", "after 3 attempts and 3 min 00 s",
        "First 20 %, best 90 %" } do holds(html, text) end
    local _, dots = html:gsub("<circle", "")
    equal(dots, 40)
    course.attempts, course.open_after = { course.attempts[1] }, 0
    html = curve.html { trainee = "P07", courses = { course } }
    check_balance(html)
    holds(html, "The gate is closed: it opens after 2 passes in a row, of at least 72.5 % each.")
end)

case("agreement: a chart for each item with limits, a reason where there are none", function()
    local limits = { n = 3, bias = -0.5, sd = 0.4, low = -1.28, high = 0.28 }
    local points = { { 3, -0.5 }, { 3, -0.5 }, { 4.5, -0.9 } }
    local icc = { n = 3, k = 2, single = 0.71, average = 0.83 }
    local data = { attempts = 3, raters = { "R<1>", "R2" }, rows = {
        { item = "T5", name = "Tear & so on", raters = { icc = icc, pairs = {} },
            simulator = { icc = icc, limits = limits, points = points } },
        { item = "T9", name = "", raters = { icc = { why = "all scores are the same" }, pairs = {} },
            simulator = { icc = { why = "x" }, limits = { why = "only one attempt" }, points = {} } },
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

case("ticks read well", function()
    for _, range in ipairs { { 1, 5 }, { 20, 100 }, { -0.3, 0.3 }, { -40, 40 } } do
        local ticks = page.ticks(range[1], range[2])
        assert(#ticks >= 3 and #ticks <= 9, #ticks)
        assert(ticks[1] >= range[1] - 1e-9 and ticks[#ticks] <= range[2] + 1e-9)
    end
end)
