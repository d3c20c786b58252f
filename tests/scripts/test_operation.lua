-- SPDX-License-Identifier: GPL-3.0-or-later
-- Scores that reach over the parts of an operation.
local collect = require "engine.collect"
local scoring = require "scoring"
local support = require "support"
local Eye = require "engine.eye"

local case, equal, near = support.case, support.equal, support.near

-- A quantity that goes up and down, with stretches above 1.
local function sample(i) return 1 + math.sin(0.37 * i) + 0.3 * math.sin(2.1 * i) end

local ways = { "max", "min", "last", "mean", "rms", "time", "share", "count" }

local function added(collector, from, to, condition)
    for i = from, to do
        local value = sample(i)
        if condition then value = value > 1 end
        collector.add(value, 0.1, 0.1 * i)
    end
end

case("a collector that begins with the state of another goes on as that one would", function()
    for _, way in ipairs(ways) do
        local condition = way == "time" or way == "share" or way == "count"
        local options = { hold_s = 0.3, quiet_s = 0.2 }
        local whole, first, second = collect[way](options), collect[way](options), collect[way](options)
        added(whole, 1, 200, condition)
        added(first, 1, 77, condition)
        for key, value in pairs(first.state) do second.state[key] = value end
        added(second, 78, 200, condition)
        local expected, at = whole.result()
        local value, second_at = second.result()
        near(value, expected, 1e-12, way)
        equal(second_at, at, way)
    end
end)

case("a total adds up what each part counts from nothing", function()
    local first, second = collect.total(), collect.total()
    equal(first.result(), nil)
    first.add(3, 0.1, 1)
    first.add(5, 0.1, 2)
    equal(first.result(), 5)
    for key, value in pairs(first.carry()) do second.state[key] = value end
    equal(second.result(), 5)
    second.add(0, 0.1, 3)
    second.add(2, 0.1, 4)
    equal(second.result(), 7)
end)

local function measure(given)
    local result = { id = "m", name = "depth", of = "tip.depth_mm", take = "max", unit = "mm", five = 1, three = 2,
        one = 4, source = "test", better = "Less." }
    for key, value in pairs(given or {}) do result[key] = value end
    return result
end

local function rubric(measures)
    return scoring.rubric { name = "test", caps = { critical = {}, minor = {} }, items = {
        { id = "I1", name = "first", measures = measures } } }
end

-- Two sheets, one after the other: each list of depths is a part.
local function score(given, parts, watched)
    local before, sheet = nil, nil
    for k, depths in ipairs(parts) do
        local eye = Eye.new(support.schema, {})
        sheet = scoring.sheet(rubric({ given })({ "I1" }), eye, { entries = 4 }, 0.5, before or { time_s = 0,
            measures = {} }, watched and watched[k])
        for i, depth in ipairs(depths) do
            eye:look(i * 0.5, { depth, 1, 0, 1 }, 0)
            sheet:tick(i * 0.5)
        end
        before = sheet:carried(#depths * 0.5)
    end
    return sheet:score({}).items[1].measures[1]
end

case("a sheet goes on with that of the part before, on one clock", function()
    local result = score(measure(), { { 1, 3, 2 }, { 2, 2 } })
    equal(result.value, 3)
    equal(result.time_s, 1.0)
    result = score(measure(), { { 1, 2 }, { 3 } })
    equal(result.value, 3)
    equal(result.time_s, 1.5)
    equal(score(measure { of = "time_s", take = "last" }, { { 1, 2 }, { 3 } }).value, 1.5)
end)

case("a part that does not tell of an item leaves it as it was", function()
    equal(score(measure(), { { 1, 2 }, { 3 } }, { { I1 = true }, {} }).value, 2)
    equal(score(measure(), { { 1, 2 }, { 3 } }, { {}, { I1 = true } }).value, 3)
    equal(score(measure(), { { 1, 2 }, { 3 } }, { {}, {} }), nil)
end)

case("a result can be a multiple of what was planned", function()
    equal(score(measure { per = "entries" }, { { 2, 8 } }).value, 2)
    equal(score(measure { per = "unknown" }, { { 2, 8 } }), nil)
end)
