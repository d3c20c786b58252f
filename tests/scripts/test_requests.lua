-- SPDX-License-Identifier: GPL-3.0-or-later
-- What is asked of the staff: how it is written, what follows, who may say it.
local operator = require "surgeons.operator"
local settings_check = require "engine.settings_check"
local support = require "support"

local case, equal, near, fails = support.case, support.equal, support.near, support.fails

local settings = {
    { name = "machine.bottle_cm", from = 0, to = 150, standard = 75, live = true },
    { name = "zonules.strength", from = 0.05, to = 2, standard = 1, live = false },
}

local function with_settings(f)
    settings_check.know(settings)
    local ok, message = pcall(f)
    settings_check.forget()
    if not ok then error(message, 0) end
end

local bottle = [[requests = {
    request "Bottle down" { settings = { ["machine.bottle_cm"] = 50 }, meaning = "lower", answer = "At 50." },
    request "Weak zonules declared" {},
},]]

local function nothing() return {} end

case("a request takes effect when it is heard: settings, answer, condition, record", function()
    local exercise = support.demo({ rest = bottle, steps = 'step "a" { done = "requested.bottle_down" }' })
    local run, commands = support.attempt(exercise, 0.1, nothing, nil, { [4] = { "bottle_down" } })
    local set, said
    for _, command in ipairs(commands) do
        if command.kind == "set" then set = command end
        if command.kind == "say" and command.text == "At 50." then said = command end
    end
    equal(set.name, "machine.bottle_cm")
    equal(set.value, 50)
    near(set.time_s, 0.04, 1e-9, "time of the setting")
    near(said.time_s, 0.04, 1e-9, "time of the answer")
    local result = run:result()
    equal(result.completed, true)
    equal(#result.requests, 1)
    equal(result.requests[1].id, "bottle_down")
    equal(result.requests[1].title, "Bottle down")
    equal(result.requests[1].settings["machine.bottle_cm"], 50)
    near(result.requests[1].time_s, 0.04, 1e-9)
end)

case("functions ask by the words of the request, and what was not asked has not been", function()
    local exercise = support.demo({ rest = bottle, steps = [[step "a" { done = function(eye)
        return eye.requested("Weak zonules declared") and not eye.requested.bottle_down
    end }]] })
    equal(support.attempt(exercise, 0.1, nothing):result().completed, false)
    equal(support.attempt(exercise, 0.1, nothing, nil, { [2] = { "weak_zonules_declared" } }):result().completed, true)
    equal(support.attempt(exercise, 0.1, nothing, nil, { [2] = { "of_another_exercise" } }):result().completed, false)
end)

case("what was asked for before an error puts nothing right, what is asked for after it does", function()
    local exercise = support.demo({ rest = bottle, steps = 'step "a" { done = "requested.bottle_down and time_s > 1" }',
        errors = [[error_event "Too deep" { when = "tip.depth_mm > 2", recovered = "requested.bottle_down",
            deadline_s = 0.5, near_miss_s = 0, advice = "Down." }]] })
    local function deep(t) return { ["tip.depth_mm"] = t > 0.1 and 3 or 0 } end
    local function outcome(asked)
        local result = support.attempt(exercise, 2, deep, nil, asked):result()
        equal(result.completed, true, "conditions of steps know of it all the same")
        return result.events[1].outcome
    end
    equal(outcome({ [5] = { "bottle_down" } }), "not_recovered")
    equal(outcome({ [30] = { "bottle_down" } }), "recovered")
    equal(outcome({ [5] = { "bottle_down" }, [30] = { "bottle_down" } }), "recovered")
end)

case("a request that is written wrong is told the line and what is allowed", function()
    with_settings(function()
        fails(function() support.demo({ rest = 'requests = { request "a" { setings = {} } },' }) end,
            "demo/curriculum.lua:7:", "request 'a' has no field 'setings'", "did you mean settings")
        fails(function()
            support.demo({ rest = 'requests = { request "a" { settings = { ["machine.botle_cm"] = 50 } } },' })
        end, "demo/curriculum.lua:7:", "no setting 'machine.botle_cm'", "did you mean machine.bottle_cm")
        fails(function()
            support.demo({ rest = 'requests = { request "a" { settings = { ["zonules.strength"] = 1 } } },' })
        end, "demo/curriculum.lua:7:", "zonules.strength is fixed before the first step")
        fails(function()
            support.demo({ rest = 'requests = { request "a" { settings = { ["machine.bottle_cm"] = 500 } } },' })
        end, "out of range (0 to 150)")
        fails(function() support.demo({ rest = 'requests = { request "a" {}, request "A" {} },' }) end,
            "request 'A' is there twice")
        fails(function() support.demo({ rest = 'requests = { "a" },' }) end, "entry 1 is no request")
    end)
end)

case("a condition that misspells a request is told the near one", function()
    local exercise = support.demo({ rest = bottle, steps = 'step "a" { done = "requested.botle_down" }' })
    fails(function() support.attempt(exercise, 0.1, nothing) end, "demo/curriculum.lua:5:",
        "unknown measure 'requested.botle_down'", "did you mean requested.bottle_down")
    exercise = support.demo({ rest = bottle, steps = [[step "a" { done = function(eye)
        return eye.requested("Botle down") end }]] })
    fails(function() support.attempt(exercise, 0.1, nothing) end, "no request 'Botle down'", "did you mean Bottle down")
    exercise = support.demo({ steps = 'step "a" { done = function(eye) return eye.requested("x") end }' })
    fails(function() support.attempt(exercise, 0.1, nothing) end, "no request 'x' (it has none)")
end)

local function operate(plan, declared)
    local person = operator.start(plan, "d", 1, 0.01, { "phaco" }, nil, declared)
    local all = {}
    for i = 1, 60 do
        local _, asked = person:operate({ time_s = 0.01 * i, tools = {}, landmarks = {}, pedal = 0, power = 0,
            vacuum_mmhg = 0, flow_ml_min = 0, tip_brightness = 0, reflex_brightness = 0 })
        for _, command in ipairs(asked) do all[#all + 1] = command end
    end
    return all
end

case("a plan asks once, and is told when it asks for what there is not", function()
    local declared = { { id = "bottle_down", title = "Bottle down", name = "Bottle down" } }
    local asked = operate(function(me)
        me.wait(0.2)
        me.request("Bottle down")
    end, declared)
    equal(#asked, 1)
    equal(asked[1].kind, "request")
    equal(asked[1].name, "bottle_down")
    fails(function() operate(function(me) me.request("Bottle dwn") end, declared) end, "no request 'Bottle dwn'",
        "did you mean Bottle down")
end)
