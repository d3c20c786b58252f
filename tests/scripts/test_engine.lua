-- SPDX-License-Identifier: GPL-3.0-or-later
-- Loading curricula, steps, and errors in scripts.
local support = require "support"

local case, equal, near, fails = support.case, support.equal, support.near, support.fails

case("a curriculum that misspells a field is told the line and the near name", function()
    fails(function() support.demo({ rest = 'tittle = "x",' }) end, "demo/curriculum.lua:7:", "no field 'tittle'",
        "did you mean title")
    fails(function() support.demo({ steps = 'step "a" { don = "tip.depth_mm > 1" }' }) end,
        "demo/curriculum.lua:5:", "step 'a' has no field 'don'", "did you mean done")
    fails(function() support.demo({ errors = 'error_event "e" { when = "tip.touch" }' }) end,
        "demo/curriculum.lua:6:", "error_event 'e' lacks 'advice'")
    fails(function() support.demo({ rest = 'patient = { pupil_mm = 70 },' }) end, "demo/curriculum.lua:7:",
        "pupil_mm = 70 is out of range (3 to 9)")
    fails(function() support.demo({ rest = 'patient = { cataract = "brown" },' }) end, "NO1 to NO6")
    fails(function() support.demo({ rest = 'patient = { age = 0/0 },' }) end, "age must be a number")
    fails(function()
        support.load("return exercise {\n title = 'x', instruments = { 'phaco' }, steps = {},\n"
            .. "tissues = { 'lense' } }")
    end, "curriculum.lua:3:", "did you mean lens")
    fails(function() support.load("return exercise { tissues = { 'lens' }, instruments = { 'phaco' } }") end,
        "curriculum.lua:1:", "exercise lacks")
end)

case("an error event with an unknown item or step is refused", function()
    fails(function()
        support.demo({ errors = 'error_event "e" { when = "tip.touch", advice = "x", items = { "T99" } }',
            rest = 'scoring = osacss { "T9" },' })
    end, "unknown item 'T99'")
    fails(function()
        support.demo({ errors = 'error_event "e" { when = "tip.touch", advice = "x", steps = { "onli" } }' })
    end, "no step 'onli'", "did you mean only")
    fails(function() support.demo({ rest = 'scoring = osacss { "T9x" },' }) end, "unknown item 'T9x'")
end)

case("an unknown measure in a condition is found before the first step", function()
    local exercise = support.demo({ steps = 'step "a" { done = "tip.deth_mm > 1" }' })
    fails(function() support.attempt(exercise, 0.1, function() return {} end) end, "demo/curriculum.lua:5:",
        "unknown measure 'tip.deth_mm'", "did you mean tip.depth_mm")
end)

case("a function that errs names file, line and step", function()
    local exercise = support.demo({ steps = 'step "dig" {\n done = function(eye) return eye.tip.depth_mm > 1 end }' })
    fails(function() support.attempt(exercise, 0.1, function() return {} end) end, "demo/curriculum.lua:6:",
        "in step 'dig'", "tip.depth_mm is not defined at this moment")
    exercise = support.demo({ steps = 'step "dig" { done = function(eye) return eye.tip.dept_mm end }' })
    fails(function() support.attempt(exercise, 0.1, function() return {} end) end, "demo/curriculum.lua:5:",
        "did you mean depth_mm", "in step 'dig'")
end)

case("steps follow each other, and time limits end them undone", function()
    local exercise = support.demo({ steps = [[
        step "one" { done = "tip.depth_mm > 1", hint = "Go deep." },
        step "two" { done = "tip.depth_mm > 9", time_limit_s = 2 },
        step "three" { done = function(eye) return not eye.tool.present end }]] })
    local run, commands = support.attempt(exercise, 8, function(t)
        return { ["tip.depth_mm"] = t, ["tool.present"] = t < 5 }
    end)
    local result = run:result()
    equal(result.completed, false, "completed")
    equal(result.steps[1].completed, true)
    near(result.steps[1].end_s, 1.01, 1e-9)
    equal(result.steps[2].completed, false)
    near(result.steps[2].end_s, 3.01, 1e-9)
    equal(result.steps[3].completed, true)
    near(result.steps[3].end_s, 5.0, 1e-9)
    equal(run.finished, true)
    equal(commands[1].kind, "say")
    equal(commands[1].text, "Go deep.")
    equal(commands[#commands].kind, "finish")
end)

case("the script of a step can wait, speak, set and take pictures", function()
    local exercise = support.demo({ steps = [[
        step "scripted" { script = function(eye, act)
            act.say("first")
            act.wait(0.5)
            act.set("phaco.power_limit", 0.4)
            local met = act.wait_until("tip.depth_mm > 1", 5)
            act.picture("deep", met and "deep now" or "too late")
            met = act.wait_until(function(e) return e.tip.depth_mm < 0 end, 0.3)
            act.say(met and "back" or "not back")
        end }]] })
    local run, commands = support.attempt(exercise, 4, function(t) return { ["tip.depth_mm"] = t } end)
    local seen = {}
    for _, c in ipairs(commands) do
        seen[#seen + 1] = ("%.2f %s %s%s"):format(c.time_s, c.kind, c.text, c.value ~= 0 and c.value or "")
    end
    equal(table.concat(seen, "; "), "0.00 say first; 0.50 set 0.4; 1.01 picture deep now; 1.31 say not back; "
        .. "1.31 picture Step \"scripted\" completed.; 1.31 picture End of the exercise.; "
        .. "1.31 finish all steps have had their turn")
    equal(run:result().completed, true)
end)

case("an error in the script of a step names line and step", function()
    local exercise = support.demo({
        steps = 'step "s" { script = function(eye, act)\n act.wait(0.1)\n local x = nil + 1\nend }' })
    fails(function() support.attempt(exercise, 1, function() return {} end) end, "demo/curriculum.lua:7:",
        "in step 's'")
end)

case("exam mode gives no hints", function()
    local exercise = support.demo({ steps = 'step "a" { done = "tip.depth_mm > 1", hint = "Psst." }',
        rest = 'mode = "exam",' })
    local _, commands = support.attempt(exercise, 0.5, function() return { ["tip.depth_mm"] = 0 } end)
    equal(#commands, 0)
end)

case("`over` ends an exercise whatever step it is in", function()
    local exercise = support.demo({ rest = 'over = { "tool.present", "not tool.present" },' })
    local run = support.attempt(exercise, 3, function(t)
        return { ["tip.depth_mm"] = 0, ["tool.present"] = t > 1 and t < 2 }
    end)
    equal(run.finished, true)
    near(run.time_s, 2, 0.011)
    equal(run:result().completed, false)
end)

case("values from the command line are checked like those of the curriculum", function()
    local language = require "exercise"
    local exercise = support.demo({ rest = 'goals = { length_mm = { 4, from = 1, to = 7 } },' })
    language.set(exercise, "goal.length_mm", "5.5", {})
    equal(exercise.goals.length_mm, 5.5)
    language.set(exercise, "patient.cataract", "NO5", {})
    equal(exercise.patient.nuclear_grade, 5)
    language.set(exercise, "phaco.power_limit", "0.5", { "phaco.power_limit" })
    equal(exercise.settings["phaco.power_limit"], 0.5)
    fails(function() language.set(exercise, "goal.length_mm", "9", {}) end, "out of range (1 to 7)", "length_mm=9")
    fails(function() language.set(exercise, "patient.age", "nan", {}) end, "patient.age", "must be a number")
    fails(function() language.set(exercise, "patient.pupil", "7", {}) end, "did you mean patient.pupil_mm")
    fails(function() language.set(exercise, "mode", "exm", {}) end, "did you mean exam")
end)

case("a step has a picture taken at its moment, once, and only while it runs", function()
    local exercise = support.demo({ steps = [[
        step "in" { done = "tip.depth_mm > 2", picture_when = "tip.depth_mm > 1" },
        step "out" { done = "tip.depth_mm > 4", picture_when = "tip.depth_mm < 1" }]] })
    local _, commands = support.attempt(exercise, 5, function(t) return { ["tip.depth_mm"] = t } end)
    local taken = {}
    for _, command in ipairs(commands) do
        if command.kind == "picture" and command.name:find("^during_") then taken[#taken + 1] = command end
    end
    equal(#taken, 1)
    equal(taken[1].name, "during_in")
    equal(taken[1].text, 'During step "in".')
    near(taken[1].time_s, 1.01, 1e-9)
end)
