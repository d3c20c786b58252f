-- SPDX-License-Identifier: GPL-3.0-or-later
-- Whether conditions can hold, from their form alone.
local expression = require "engine.expression"
local interval = require "engine.interval"
local kinds = require "engine.kinds"
local measures = require "engine.measures"
local satisfy = require "engine.satisfy"
local support = require "support"

local case, equal = support.case, support.equal

local function parsed(text) return expression.parse(text, "here:1") end
local function known(name) return name == "goal.g" and 4 or nil end
local limits = { time_s = { low = 0, high = 60 }, ["n.count"] = { low = 0, high = math.huge } }
local function bounds(name) return limits[name] end
local function can(text) return satisfy.can_hold(parsed(text), known, bounds) end
local function always(text) return satisfy.always_holds(parsed(text), known, bounds) end
local function grows(name) return name == "n.count" or name == "time_s" end

case("what a part can be follows from what its measures can be", function()
    for _, text in ipairs({ "abs(a.x) < 0", "abs(a.x) + 1 < 1", "sqrt(a.x) < 0", "a.x * 0 ~= 0", "n.count < 0",
        "n.count + time_s < 0", "-n.count > 0", "min(a.x, 3) > 3", "max(a.x, 3) < 3", "time_s / 2 > 31",
        "10 - time_s < -50", "abs(10 - time_s) > 50", "n.count * time_s < 0", "time_s > 90", "goal.g * n.count < 0",
        "a.x > 1 and 10 * a.x < 5", "a.x > a.x", "a.x < 1 and a.x > 2" }) do
        equal(can(text), false, text)
    end
    for _, text in ipairs({ "abs(a.x) <= 0", "abs(a.x - 1) < 1", "sqrt(a.x) <= 0", "n.count <= 0", "a.x * a.x < 0",
        "min(a.x, 3) >= 3", "max(a.x, 3) <= 3", "time_s / n.count > 31", "a.x / 2 < 0", "abs(10 - time_s) >= 50",
        "goal.g * n.count <= 0", "a.x >= a.x", "not (a.x < 1) and not (a.x > 0)" }) do
        equal(can(text), true, text)
    end
end)

case("what has no value never holds, and its contrary always", function()
    for _, text in ipairs({ "a.x > 0/0", "a.x < 1/0", "a.x / 0 > 1", "a.x + 0/0 < 1", "sqrt(0 - 1) < a.x" }) do
        equal(can(text), false, text)
        equal(always("not (" .. text .. ")"), true, text)
    end
end)

case("only clocks are known to have a value at any time", function()
    equal(always("time_s >= 0"), true)
    equal(always("time_s >= 0 or a.x > 1"), true)
    equal(always("n.count >= 0"), false)
    equal(always("abs(a.x) >= 0"), false)
    equal(always("sqrt(time_s - 1) >= 0"), false)
end)

case("what never falls stays as high as a condition needed it", function()
    local function later(first, second)
        return satisfy.can_hold(parsed(second), known, satisfy.after(parsed(first), known, bounds, grows))
    end
    equal(later("n.count > 2", "n.count < 3"), true)
    equal(later("n.count > 2", "n.count <= 2"), false)
    equal(later("n.count >= 2", "n.count <= 2"), true)
    equal(later("n.count >= 2 and a.x > 1", "3 * n.count < 6"), false)
    equal(later("n.count >= 2 or n.count > 4", "n.count < 2"), false)
    equal(later("n.count >= 2 or a.x > 4", "n.count < 2"), true)
    equal(later("a.x >= 2", "a.x < 2"), true, "it may fall")
    equal(later("not (n.count < 2)", "n.count < 1"), true, "it may have had no value")
    equal(later("goal.g < n.count", "n.count < 4"), false)
end)

case("whoever touches has touched", function()
    equal(can("a.touch and a.touches < 1"), false)
    equal(can("a.touch and a.touch_s <= 0"), false)
    equal(can("not a.touch and a.touches < 1"), true)
end)

case("which measures never fall stands in their meaning", function()
    local function grown(name, meaning, unit)
        return measures.grows(name, { meaning = meaning, unit = unit or "1", bool = unit == "bool" })
    end
    equal(grown("iris.touches", "Touches of the iris so far."), true)
    equal(grown("hydro.block_s", "Time so far with the lens 0.5 mm forward or more.", "s"), true)
    equal(grown("beads.drops", "Times that one was let go or lost beside the tray."), true)
    equal(grown("chamber.least_depth_share", "The least it has been so far."), false)
    equal(grown("chamber.lowest_pressure_mmhg", "The lowest it has been so far."), false)
    equal(grown("instruments.jerk_mm_s3", "Jerk of the tips below 2 Hz, without tremor, so far (RMS)."), false)
    equal(grown("iris.prolapse_state", "0: none so far; 1: it is back in the eye; 2: it is out."), false)
    equal(grown("wounds.main_most_peel_mm", "The most that hung off at its inner lip so far."), false)
    equal(grown("chamber.depth_mm", "Depth of the anterior chamber."), false)
    equal(measures.never_negative("instruments.out_s", { unit = "s", meaning = "" }), true)
    equal(measures.never_negative("phaco.tip_depth_mm", { unit = "mm", meaning = "" }), false)
end)

case("kinds are told apart", function()
    local function complaint(text)
        return kinds.complaint(parsed(text), function(name) return name:find("%.on$") ~= nil end)
    end
    for _, text in ipairs({ "a.on", "a.on == b.on", "a.on == true", "not a.on and a.x > 1", "a.x == 1",
        "(a.x > 1) == a.on" }) do
        equal(complaint(text), nil, text)
    end
    for text, part in pairs({ ["a.on == 0"] = "write \"not a.on\"", ["1 == a.on"] = "write \"a.on\"",
        ["a.on == 2"] = "write it alone", ["a.on < b.on"] = "has no size", ["a.x == true"] = "never true or false",
        ["a.x"] = "compare it", ["a.on or a.x - 1"] = "a.x - 1 is a number", ["max(a.on, 1) > 0"] = "reckoned with",
        ["not a.x"] = "compare it" }) do
        local found = complaint(text)
        equal(found ~= nil and found:find(part, 1, true) ~= nil, true, text .. ": " .. tostring(found))
    end
end)

case("intervals of quotients end where the divisor may be 0", function()
    local function of(text) return interval.of(parsed(text).tree, known, bounds) end
    equal(of("6 / (time_s + 2)").high, 3)
    equal(of("6 / time_s").high, math.huge)
    equal(of("a.x * 0").high, 0)
end)
