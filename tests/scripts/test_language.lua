-- SPDX-License-Identifier: GPL-3.0-or-later
-- Steps that wait and branch, levels, consequences, orientation, settings that are checked.
local host = require "engine.host"
local language = require "exercise"
local orientation = require "engine.orientation"
local settings_check = require "engine.settings_check"
local support = require "support"

local case, equal, near, fails = support.case, support.equal, support.near, support.fails

local function deep(t) return { ["tip.depth_mm"] = t, ["tool.present"] = t >= 2 } end

case("a step begins when its condition to enter holds, not before", function()
    local exercise = support.demo({ steps = [[
        step "wait" { enter_when = "tool.present", done = "tip.depth_mm > 0.5", hint = "Now." },
        step "last" { done = "tip.depth_mm > 3" }]],
        errors = 'error_event "deep" { when = "tip.depth_mm > 1", advice = "x", steps = { "wait" }, quiet_s = 60 }' })
    local run, commands = support.attempt(exercise, 4, deep)
    local result = run:result()
    near(result.steps[1].start_s, 2, 1e-9, "entered")
    near(result.steps[1].end_s, 2, 1e-9, "done as soon as it began")
    near(result.steps[2].end_s, 3.01, 1e-9)
    equal(result.completed, true)
    equal(#result.events, 0, "nothing belongs to a step that has not begun")
    local said = 0
    for _, command in ipairs(commands) do said = said + (command.text == "Now." and 1 or 0) end
    equal(said, 0, "the step was done in the moment it began")
end)

case("a step that cannot be entered in time is left out, undone", function()
    local exercise = support.demo({ steps = [[
        step "never" { enter_when = "tip.touch", done = "tip.depth_mm > 0.5", enter_limit_s = 1 },
        step "last" { done = "tip.depth_mm > 3" }]] })
    local result = support.attempt(exercise, 4, deep):result()
    equal(result.steps[1].not_entered, true)
    equal(result.steps[1].start_s, nil)
    equal(result.steps[1].completed, false)
    near(result.steps[2].start_s, 1, 1e-9)
    equal(result.completed, false)
end)

case("a hint can wait; in an exam there is none", function()
    local steps = 'step "only" { done = "tip.depth_mm > 3", hint = "Deeper.", hint_after_s = 1.5 }'
    local function hints(rest)
        local exercise = support.demo({ steps = steps, rest = rest })
        local run, commands = support.attempt(exercise, 4, deep)
        local times = {}
        for _, command in ipairs(commands) do
            if command.text == "Deeper." then times[#times + 1] = command.time_s end
        end
        return times, run:result()
    end
    local times, result = hints("")
    equal(#times, 1)
    near(times[1], 1.5, 1e-9)
    equal(result.hints, true)
    times, result = hints('mode = "exam",')
    equal(#times, 0)
    equal(result.hints, false)
    equal(result.mode, "exam")
end)

case("marks of the step that runs are shown to who operates, in teaching mode", function()
    local steps = [[
        step "one" { enter_when = "tool.present", done = "tip.depth_mm > 3", marks = { { 2, 0, 3 }, { 0, 2, 3.5 } } },
        step "two" { done = "tip.depth_mm > 9" }]]
    local function marks(seconds, rest)
        host.exercise = support.demo({ steps = steps, rest = rest })
        host.run = support.attempt(host.exercise, seconds, deep)
        local found = host.marks()
        host.exercise, host.run = nil, nil
        return found
    end
    equal(#marks(1), 0, "not yet begun")
    equal(#marks(2.5), 2)
    equal(marks(2.5)[2][3], 3.5)
    equal(#marks(4), 0, "the next step has none")
    equal(#marks(2.5, 'mode = "exam",'), 0, "in an exam")
    for _, wrong in ipairs({ "{}", "{ 1, 2, 3 }", "{ { 1, 2 } }", "{ { 1, 2, 0/0 } }", "{ { 1, 2, 300 } }", '"x"' }) do
        fails(function() support.demo({ steps = 'step "a" { done = "tip.touch", marks = ' .. wrong .. " }" }) end,
            "demo/curriculum.lua:5:", "marks must be a list of places { x, y, z } in mm")
    end
end)

case("next and next_late choose the step that follows; what is passed over does not count", function()
    local steps = [[
        step "one" { done = "tip.depth_mm > %g", time_limit_s = 1, next = "three", next_late = "two" },
        step "two" { done = "tip.depth_mm > 2" },
        step "three" { done = "tip.depth_mm > 3" }]]
    local result = support.attempt(support.demo({ steps = steps:format(0.5) }), 4, deep):result()
    equal(result.steps[2].skipped, true)
    equal(result.completed, true)
    result = support.attempt(support.demo({ steps = steps:format(9) }), 4, deep):result()
    equal(result.steps[1].completed, false)
    near(result.steps[2].start_s, 1, 1e-9)
    equal(result.steps[2].completed, true)
    equal(result.completed, false)
    fails(function() support.demo({ steps = 'step "a" { done = "tip.touch", next = "c" },\n'
        .. 'step "b" { done = "tip.touch" }' }) end, "demo/curriculum.lua:5:", "no step 'c'")
    fails(function() support.demo({ steps = 'step "a" { done = "tip.touch" },\n'
        .. 'step "b" { done = "tip.touch", next = "a" }' }) end, "demo/curriculum.lua:6:", "does not come later")
end)

local function with_settings(f)
    settings_check.know({
        { name = "phaco.power_limit", from = 0, to = 1, standard = 1, live = true },
        { name = "implant.triangles", from = 400, to = 8000, standard = 743, live = false },
        { name = "bleeding.pressure", from = 0, to = 80, standard = 0, live = true, tissue = true } })
    local ok, message = pcall(f)
    settings_check.forget()
    if not ok then error(message, 0) end
end

case("an error has the consequences that its educator wrote, once, and the report tells them", function()
    with_settings(function()
        local exercise = support.demo({ rest = 'mode = "exam",', errors = [[error_event "deep" {
            when = "tip.depth_mm > 1", recovered = "tip.depth_mm > 2", advice = "Up.",
            consequences = { "The nurse turns the power down.", ["phaco.power_limit"] = 0.3 } }]],
            steps = 'step "only" { done = "tip.depth_mm > 3" }' })
        local run, commands = support.attempt(exercise, 4, deep)
        local set, said = {}, {}
        for _, command in ipairs(commands) do
            if command.kind == "set" then set[#set + 1] = command end
            if command.kind == "say" then said[#said + 1] = command.text end
        end
        equal(#set, 1)
        equal(set[1].name, "phaco.power_limit")
        equal(set[1].value, 0.3)
        near(set[1].time_s, 1.01, 1e-9)
        equal(#said, 1, "in an exam a consequence is said, advice is not")
        equal(said[1], "The nurse turns the power down.")
        local event = run:result().events[1]
        equal(event.consequences.texts[1], "The nurse turns the power down.")
        equal(event.consequences.settings["phaco.power_limit"], 0.3)
    end)
end)

case("settings are checked where they stand", function()
    with_settings(function()
        fails(function() support.demo({ rest = 'settings = { ["phaco.power_limt"] = 0.3 },' }) end,
            "demo/curriculum.lua:7:", "no setting 'phaco.power_limt'", "did you mean phaco.power_limit")
        fails(function() support.demo({ rest = "settings = { phaco = { power_limit = 3 } }," }) end,
            "demo/curriculum.lua:7:", "out of range (0 to 1)")
        local error_with = 'error_event "e" { when = "tip.touch", advice = "x", consequences = { %s } }'
        fails(function() support.demo({ errors = error_with:format('["implant.triangles"] = 500') }) end,
            "demo/curriculum.lua:6:", "implant.triangles is fixed before the first step")
        fails(function() support.demo({ errors = error_with:format('["bleeding.pressure"] = 40') }) end,
            "demo/curriculum.lua:6:", "bleeding.pressure is the eye's, not the machine's")
        support.demo({ rest = 'requests = { request "Bleed" { settings = { ["bleeding.pressure"] = 40 } } },' })
        fails(function() support.demo({ errors = error_with:format("phaco = { power_limi = 0 }") }) end,
            "demo/curriculum.lua:6:", "did you mean phaco.power_limit")
        fails(function() support.demo({ errors = error_with:format("7") }) end, "consequences hold texts and settings")
    end)
end)

local levels = [[goals = { depth_mm = { 1, from = 0, to = 5 } }, patient = { pupil_mm = 7 },
    levels = {
        easy = { patient = { pupil_mm = 8 }, goals = { depth_mm = 0.5 }, meaning = "wide" },
        hard = { patient = { pupil_mm = 5 }, time_limit_s = 60, mode = "exam" },
    },]]

case("what a good performance needs are positive numbers", function()
    fails(function() support.demo({ rest = 'reference = { path_mm = "far" },' }) end, "demo/curriculum.lua:",
        "reference: path_mm")
    fails(function() support.demo({ rest = "reference = { path_mm = { 7 } }," }) end, "reference: path_mm")
    fails(function() support.demo({ rest = "reference = { path_mm = 0 }," }) end, "out of range")
    equal(support.demo({ rest = "reference = { path_mm = 7 }," }).reference.path_mm, 7)
end)

case("a level changes patient, goals, time and mode; what is set besides goes before it", function()
    local exercise = support.demo({ rest = levels })
    equal(exercise.patient.pupil_mm, 7)
    language.set(exercise, "level", "easy", {})
    equal(exercise.patient.pupil_mm, 8)
    equal(exercise.goals.depth_mm, 0.5)
    equal(exercise.mode, "teaching")
    language.set(exercise, "goal.depth_mm", "2", {})
    equal(exercise.goals.depth_mm, 2)
    exercise = support.demo({ rest = levels })
    language.set(exercise, "level", "hard", {})
    equal(exercise.mode, "exam")
    equal(exercise.time_limit_s, 60)
    equal(support.attempt(exercise, 0.1, deep):result().level, "hard")
    fails(function() language.set(exercise, "level", "esay", {}) end, "no level 'esay'", "did you mean easy")
    fails(function() language.set(support.demo(), "level", "easy", {}) end, "(it has none)")
    fails(function() support.demo({ rest = 'levels = { easy = { pateint = {} } },' }) end, "demo/curriculum.lua:7:",
        "level 'easy' has no field 'pateint' (did you mean patient?)")
    fails(function() support.demo({ rest = 'levels = { easy = { goals = { depth = 1 } } },' }) end,
        "level 'easy': the exercise has no goal 'depth'")
    fails(function() support.demo({ rest = 'levels = { easy = { patient = { pupil_mm = 12 } } },' }) end,
        "out of range (3 to 9)")
end)

case("right and left eye: the temple is where the surgeon sits, unless the incision is elsewhere", function()
    local right = orientation.of({ side = "right" }, "right")
    equal(right.incision_deg, 180)
    equal(right.incision, "temporal")
    equal(right.above, "to the left")
    equal(right.nose, "away")
    local left = orientation.of({ side = "left" }, "left")
    equal(left.incision_deg, 0)
    equal(left.incision, "temporal")
    equal(left.above, "to the right")
    equal(left.nose, "away")
    equal(left.handedness, "left")
    local above = orientation.of({ side = "left", incision_deg = 90 }, "right")
    equal(above.incision, "above")
    equal(above.above, "near")
    equal(above.nose, "to the right")
    equal(orientation.of({ side = "right", incision_deg = 90 }, "right").nose, "to the left")
    equal(orientation.site("right", 135), "upper temporal")
    equal(orientation.site("left", 45), "upper temporal")
end)
