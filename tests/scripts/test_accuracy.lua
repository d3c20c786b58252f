-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error budgets as an exercise writes them; tests/kernel/session/test_accuracy.cpp has what is chosen for them.
local accuracy = require "engine.accuracy"
local language = require "exercise"
local support = require "support"

local case, equal, fails = support.case, support.equal, support.fails

local quantities = {
    { name = "force", unit = "1", from = 1e-6, to = 10, meaning = "of strokes", kept = "lens 0.75" },
    { name = "time", unit = "s", from = 0.001, to = 0.02, meaning = "of events", kept = "0.01" },
}

local function with_quantities(f)
    accuracy.know(quantities)
    local ok, message = pcall(f)
    accuracy.know({})
    if not ok then error(message, 0) end
end

local function demo(given) return support.demo({ rest = ("accuracy = %s,"):format(given) }) end

case("a budget names quantities that there are, within their range", function()
    with_quantities(function()
        equal(demo("{ force = 0.25, time = 0.02 }").accuracy.force, 0.25)
        fails(function() demo("{ forse = 0.25 }") end, "curriculum.lua:", "accuracy has no field 'forse'",
            "did you mean force?")
        fails(function() demo("{ force = -1 }") end, "accuracy: force = -1 is out of range")
        fails(function() demo("{ time = 0.5 }") end, "accuracy: time = 0.5 is out of range")
        fails(function() demo("{ force = 'small' }") end, "accuracy: force must be a number")
        fails(function() demo("0.25") end, "accuracy must be a table")
    end)
end)

case("--set changes a budget, and what stands by hand is known as such", function()
    with_quantities(function()
        local exercise = demo("{}")
        equal(exercise.step_by_hand, false)
        language.set(exercise, "accuracy.force", "0.5", {})
        equal(exercise.accuracy.force, 0.5)
        equal(exercise.accuracy_where, "--set accuracy.force=0.5")
        fails(function() language.set(exercise, "accuracy.forse", "0.5", {}) end, "did you mean accuracy.force")
        fails(function() language.set(exercise, "accuracy.force", "much", {}) end, "must be a number")
        language.set(exercise, "step_s", "0.005", {})
        equal(exercise.step_by_hand, true)
        equal(exercise.step_s, 0.005)
    end)
end)
