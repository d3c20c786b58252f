-- SPDX-License-Identifier: GPL-3.0-or-later
-- Warnings, the patient's constants, what would have been a four, and what an instructor may let happen.
local support = require "support"

local Eye = require "engine.eye"
local injections = require "engine.injections"
local to_four = require "engine.to_four"
local vitals = require "engine.vitals"
local warnings = require "engine.warnings"

local case, equal, near = support.case, support.equal, support.near

local rule = { id = "deep", title = "Deep", advice = "Up.", of = "tip.touch", signs = {
    { when = "tool.present", rises = "tip.depth_mm", to = 3, over_s = 0.2, within_s = 1 },
    { when = "tip.speed_mm_s > 90" } } }

local dt = 0.01

-- Watches so long what at(t) gives: depth, touch, present. The warnings.
local function watched(at, seconds, own)
    local eye = Eye.new(support.schema, {})
    local watch, log = warnings.watch(own or rule, eye), { came = {} }
    for i = 0, math.floor(seconds / dt) do
        local depth, touch, present = at(i * dt)
        eye:look(i * dt, { depth or 0 / 0, 0, touch and 1 or 0, present == false and 0 or 1 }, 0)
        watch:tick(i * dt, log, function(text) return text end)
    end
    return log
end

case("what heads for its limit is warned of in time, and what stays away is not", function()
    local log = watched(function(t) return t end, 4)  -- 1 mm/s: there at 3 s
    equal(#log, 1)
    near(log[1].time_s, 2.05, 0.011, "one second before, when it has shown for a moment")
    equal(log[1].title, "Deep")
    near(log[1].evidence["tip.depth_mm"], 2.05, 0.011)
    equal(#watched(function() return 2.9 end, 4), 0, "near, but at rest")
    equal(#watched(function(t) return 3 - t end, 4), 0, "on its way back")
    equal(#watched(function(t) return t, false, false end, 4), 0, "what else must hold does not")
    equal(#watched(function(t) return t < 2 and t or nil end, 4), 0, "it is not defined any more")
    equal(#watched(function(t) return t % 0.03 < 0.01 and 9 or 0 end, 4), 0, "a trembling number for no moment")
end)

case("a warning is told once, again after it has ceased, and not once it has come", function()
    local log = watched(function(t) return (t < 4 or t > 8 and t < 9 or t > 20) and 3.5 or 0 end, 24)
    equal(#log, 2, "what ceases for four seconds is the same still")
    near(log[2].time_s, 20.05, 0.03)
    log = watched(function(t) return t, t > 2.6 end, 6)
    equal(#log, 1)
    near(log[1].came_s, 2.61, 0.02)
    equal(#log.came, 1)
    near(log.came[1].warned_s, 0.56, 0.03)
    equal(watched(function(t) return 0, t > 1 end, 2).came[1].warned_s, nil, "it came without a word")
    equal(watched(function(t) return t, t > 14 end, 16)[1].came_s, nil, "what comes much later came by something else")
    equal(#watched(function(t) return t, true end, 6), 0, "it is there already")
end)

case("a scene without the measures of a rule is not watched by it", function()
    local eye = Eye.new(support.schema, {})
    local function watches(sign, of)
        return warnings.watch({ id = "x", of = of or "tip.touch", signs = { sign } }, eye) ~= nil
    end
    equal(watches({ when = "other.thing > 1" }), false)
    equal(watches({ when = "tool.present", rises = "tip.depth_mm", to = "goal.none" }), false)
    equal(watches({ when = "tool.present" }, "other.thing > 1"), false)
    equal(watches({ when = "tool.present" }), true)
end)

local own = { heart_per_min = 60, reactions = { { when = { "tip.touch" }, after_s = 1, heart_per_min = 20 } } }

case("the patient's constants follow what happens, and come back", function()
    local exercise = support.demo({ rest = [[vitals = { heart_per_min = 60,
        reactions = { { when = "tip.touch", after_s = 1, heart_per_min = 20 } } },]] })
    equal(exercise.vitals.heart_per_min, own.heart_per_min)
    local eye = Eye.new(support.schema, {})
    local patient = vitals.new(exercise.vitals, eye)
    local beats, before = 0, 0
    local function go_on(from, to, touch)
        for i = math.floor(from / dt), math.floor(to / dt) do
            eye:look(i * dt, { 0, 0, touch and 1 or 0, 1 }, 0)
            patient:tick(i * dt)
            local beat = patient:now().beat
            if beat < before then beats = beats + 1 end
            before = beat
        end
    end
    go_on(0, 10, false)
    near(patient:now().heart_per_min, 60, 0.1)
    equal(beats == 9 or beats == 10, true, "a beat a second")
    go_on(10, 18, true)
    near(patient:now().heart_per_min, 80, 0.1)
    near(patient:now().systolic_mmhg, 138, 0.1, "another constant stays")
    go_on(18, 26, false)
    near(patient:now().heart_per_min, 60, 0.1)
    support.fails(function() support.demo({ rest = "vitals = { pulse = 60 }," }) end, "no field 'pulse'")
    local absurd = 'vitals = { reactions = { { when = "tip.touch" , heart_per_min = 999 } } },'
    support.fails(function() support.demo({ rest = absurd }) end, "heart_per_min")
end)

case("what would have been a four asks as little as it takes", function()
    local open = { { measure = { id = "time", curve = { { 10, 5 }, { 20, 3 }, { 40, 1 } } } },
        { measure = { id = "path", curve = { { 0, 5 }, { 8, 1 } } } } }
    local function way_of(score)
        local function amount(_, value) return ("%g"):format(value) end
        return to_four.of(score, open, amount, function(text) return text end)
    end
    local function item(time, time_score, path, path_score, capped)
        return { score = math.min((time_score + path_score) / 2, capped and capped[1].cap or 5),
            capped_by = capped or {}, measures = {
                { id = "time", name = "Time", unit = "s", value = time, score = time_score, weight = 1 },
                { id = "path", name = "Path", unit = "mm", value = path, score = path_score, weight = 1 } } }
    end
    local way = way_of(item(20, 3, 2, 4))
    equal(#way.measures, 1, "one of them is enough")
    equal(way.measures[1].id, "time")
    equal(way.measures[1].text, "Time: 15 instead of 20.")
    near(way.measures[1].wanted, 15, 1e-9, "4 points there make the mean a four")
    way = way_of(item(40, 1, 8, 1))
    equal(#way.measures, 2)
    equal(way.measures[1].id, "path", "5 points of one")
    near(way.measures[1].wanted, 0, 1e-9)
    near(way.measures[2].wanted, 20, 1e-9, "and 3 of the other")
    way = way_of(item(10, 5, 0, 5, { { event = "touch", title = "Touched", cap = 2, time_s = 3 },
        { event = "touch", title = "Touched", cap = 2, time_s = 9 } }))
    equal(#way.errors, 1)
    equal(#way.measures, 0)
    equal(way_of(item(10, 5, 2, 4)), nil)
    equal(way_of({ capped_by = {}, measures = {} }), nil)
end)

case("an instructor may let happen what the scene has, and no outcome", function()
    local eye = Eye.new({ { name = "chamber.infusion_ml_min", unit = "ml/min", meaning = "" } }, {})
    local ids = {}
    for _, one in ipairs(injections.listing(eye, {})) do ids[one.id] = one end
    equal(ids.blocked_line.settings[1].name, "machine.infusion")
    equal(ids.choroidal_bleed, nil, "there is no choroid")
    equal(#ids.cough.head > 3, true)
    for _, one in pairs(ids) do
        for _, setting in ipairs(one.settings) do
            equal(setting.name:find("^machine%.") ~= nil or setting.name:find("^suprachoroidal%.") ~= nil, true,
                setting.name)
        end
    end
end)
