-- SPDX-License-Identifier: GPL-3.0-or-later
-- The life of an error event.
local support = require "support"

local case, equal, near = support.case, support.equal, support.near

local event = [[error_event "too deep" {
    when = "tip.depth_mm > 2",
    recovered = "tip.depth_mm < 1",
    deadline_s = 2,
    harm = "tip.touch",
    evidence = { "tip.speed_mm_s" },
    advice = "Up.", items = { "T9" } }]]

local function events_of(at, seconds, declared)
    local exercise = support.demo({ steps = 'step "only" { done = "tip.depth_mm > 100" }', errors = declared or event })
    local run, commands = support.attempt(exercise, seconds or 10, at)
    return run:result().events, run, commands
end

local function depth(t, from, to)
    return { ["tip.depth_mm"] = t >= from and t < to and 3 or 0.5, ["tip.speed_mm_s"] = 7, ["tip.touch"] = false }
end

case("a provoked error that is put right in time is recovered, with evidence", function()
    local events, run = events_of(function(t) return depth(t, 2, 3.5) end)
    equal(#events, 1)
    equal(events[1].id, "too_deep")
    equal(events[1].step, "only")
    near(events[1].time_s, 2, 1e-9)
    equal(events[1].recovered, true)
    equal(events[1].outcome, "recovered")
    near(events[1].recovery_s, 1.5, 1e-9)
    equal(events[1].evidence["tip.depth_mm"], 3)
    equal(events[1].evidence["tip.speed_mm_s"], 7)
    equal(run.finished, nil, "an error does not end the exercise")
end)

case("what holds at the start is given until it has ceased once, and what comes after is the operator's", function()
    local function at(t) return (t < 1.5 or t >= 5 and t < 6) and depth(0, 0, 1)
        or depth(0, 1, 2) end
    local events = events_of(at)
    equal(#events, 2)
    equal(events[1].given, true)
    equal(events[1].outcome, "recovered")
    equal(events[2].given, nil)
    equal(events_of(function(t) return depth(t, 0.02, 1.5) end)[1].given, nil, "what comes a moment later is made")
    local touched = event:gsub('when = "tip.depth_mm > 2"', 'when = "tip.depth_mm > 2 and tool.present", '
        .. 'given = "tip.depth_mm > 2"')
    local function comes_later(t)
        local values = depth(t, 0, 4)
        values["tool.present"] = t >= 2
        return values
    end
    local later = events_of(comes_later, 10, touched)
    near(later[1].time_s, 2, 1e-9)
    equal(later[1].given, true, "what the eye had before the tool came")
end)

case("who takes the instruments out for good before all is done has given up", function()
    local function result(at, rest)
        local schema = { table.unpack(support.schema) }
        schema[#schema + 1] = { name = "instruments.out_s", unit = "s", meaning = "" }
        local exercise = support.demo({ steps = 'step "open" { title = "Open it", done = "tip.depth_mm > 5" }',
            rest = rest or 'over = "instruments.out_s > 2",' })
        return support.attempt(exercise, 6, at, schema):result()
    end
    local given_up = result(function(t)
        return { ["tip.depth_mm"] = 0, ["tip.touch"] = false, ["instruments.out_s"] = math.max(0, t - 1) }
    end)
    equal(#given_up.events, 1)
    equal(given_up.events[1].title, "Given up")
    equal(given_up.events[1].severity, "critical")
    equal(given_up.events[1].recovered, false)
    equal(given_up.advice == nil, false)
    local finished = result(function(t)
        return { ["tip.depth_mm"] = t > 0.5 and 6 or 0, ["tip.touch"] = false,
            ["instruments.out_s"] = math.max(0, t - 1) }
    end)
    equal(#finished.events, 0)
    local out_of_time = result(function()
        return { ["tip.depth_mm"] = 0, ["tip.touch"] = false, ["instruments.out_s"] = 0 }
    end, "time_limit_s = 4,")
    equal(#out_of_time.events, 0, "an instrument in the eye has not given up")
end)

case("where recovery must last, passing through it does not count, and what began in time does", function()
    local held = event:gsub("deadline_s = 2", "deadline_s = 2, recovered_hold_s = 0.5")
    local function dip(length)
        return function(t)
            local right = t >= 3.8 and t < 3.8 + length
            return { ["tip.depth_mm"] = (t >= 2 and t < 8 and not right) and 3 or 0.5, ["tip.speed_mm_s"] = 7,
                ["tip.touch"] = false }
        end
    end
    equal(events_of(dip(0.3), 10, held)[1].outcome, "not_recovered")
    local lasting = events_of(dip(0.8), 10, held)
    equal(lasting[1].outcome, "recovered")
    near(lasting[1].recovery_s, 2.3, 0.02)
end)

case("an error that is not put right in time is not recovered, even if it is later", function()
    local events = events_of(function(t) return depth(t, 2, 5) end)
    equal(#events, 1)
    equal(events[1].outcome, "not_recovered")
    equal(events[1].recovered, false)
end)

case("an error put right at once without harm is a near miss; with harm it is not", function()
    local events = events_of(function(t) return depth(t, 2, 2.4) end)
    equal(events[1].outcome, "near_miss")
    events = events_of(function(t)
        local values = depth(t, 2, 2.4)
        values["tip.touch"] = t > 2.1 and t < 2.2
        return values
    end)
    equal(events[1].outcome, "recovered")
    equal(events[1].harmed, true)
end)

case("the silent twin: the same attempt just below the threshold raises nothing", function()
    local events = events_of(function(t)
        local values = depth(t, 2, 3.5)
        values["tip.depth_mm"] = math.min(1.99, values["tip.depth_mm"])
        return values
    end)
    equal(#events, 0)
end)

case("an undefined measure raises nothing", function()
    equal(#events_of(function() return {} end), 0)
end)

case("a trembling measure is one event, two separate errors are two", function()
    local events = events_of(function(t)
        return { ["tip.depth_mm"] = (t > 2 and t < 4 and math.floor(t * 20) % 2 == 0) and 3 or 0.5 }
    end)
    equal(#events, 1, "trembling")
    events = events_of(function(t) return depth(t % 4, 2, 3) end, 9)
    equal(#events, 2, "separate")
end)

case("hold_s lets short crossings pass", function()
    local declared = 'error_event "long" { when = "tip.depth_mm > 2", hold_s = 0.5, advice = "x" }'
    equal(#events_of(function(t) return depth(t, 2, 2.4) end, 5, declared), 0)
    equal(#events_of(function(t) return depth(t, 2, 2.6) end, 5, declared), 1)
end)

case("recovery may ask for an order", function()
    local declared = [[error_event "e" { when = "tip.depth_mm > 2", advice = "x", deadline_s = 5,
        recovered = { "tip.speed_mm_s < 1", "tip.depth_mm < 1" } }]]
    local events = events_of(function(t)
        local values = depth(t, 2, 3)
        values["tip.speed_mm_s"] = (t > 4 and t < 4.5) and 0 or 5
        return values
    end, 10, declared)
    near(events[1].recovery_s, 2.01, 0.011)
end)

case("events can be limited to steps, and end the exercise only if asked to", function()
    local exercise = support.demo({ steps = [[step "one" { done = "tip.depth_mm > 1" },
        step "two" { done = "tip.depth_mm > 100" }]],
        errors = [[error_event "touch" { when = "tip.touch", advice = "x", steps = { "two" },
            ends_exercise = true }]] })
    local run = support.attempt(exercise, 10, function(t)
        return { ["tip.depth_mm"] = t > 4 and 2 or 0, ["tip.touch"] = (t > 1 and t < 2) or (t > 6 and t < 7) }
    end)
    local events = run:result().events
    equal(#events, 1)
    equal(events[1].step, "two")
    near(run.time_s, 6.01, 0.011)
    equal(run:result().reason, "error: touch")
end)

case("an error that is open when the exercise ends was not put right", function()
    local exercise = support.demo({ rest = "time_limit_s = 3,", steps = 'step "a" { done = "tip.depth_mm > 100" }',
        errors = event })
    local run = support.attempt(exercise, 5, function(t) return depth(t, 2, 9) end)
    equal(run:result().events[1].outcome, "not_recovered")
end)

case("an error and its recovery leave pictures, and advice is said", function()
    local _, _, commands = events_of(function(t) return depth(t, 2, 3.5) end)
    local kinds = {}
    for _, command in ipairs(commands) do kinds[#kinds + 1] = command.kind .. " " .. command.name end
    equal(table.concat(kinds, ", "), "picture error_too_deep, say , picture recovered_too_deep")
end)
