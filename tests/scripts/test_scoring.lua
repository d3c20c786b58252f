-- SPDX-License-Identifier: GPL-3.0-or-later
-- Scores: interpolation, caps, items that do not apply, and the shape of the rubric.
local osacss = require "osacss"
local scoring = require "scoring"
local support = require "support"
local Eye = require "engine.eye"

local case, equal, near, fails = support.case, support.equal, support.near, support.fails

local caps = { critical = { not_recovered = 1, open = 1, recovered = 3, near_miss = 4 },
    minor = { not_recovered = 3, open = 3, recovered = 4, near_miss = 5 } }

local function rubric(measures)
    return scoring.rubric { name = "test", caps = caps, items = {
        { id = "I1", name = "first", measures = measures },
        { id = "I2", name = "second", not_scored = "not here." },
    } }
end

local function depth_measure(given)
    local measure = { id = "m", name = "depth", of = "tip.depth_mm", take = "max", unit = "mm", five = 1, three = 2,
        one = 4, source = "test", better = "Less." }
    for key, value in pairs(given or {}) do measure[key] = value end
    return measure
end

local function score(measures, depths, events)
    local eye = Eye.new(support.schema, {})
    local sheet = scoring.sheet(rubric(measures)({ "I1", "I2" }), eye, { depth = 2 }, 0.5)
    for i, depth in ipairs(depths) do
        eye:look(i * 0.5, { depth, 1, 0, 1 }, 0)
        sheet:tick(i * 0.5)
    end
    return sheet:score(events or {})
end

case("a measure scores linearly between its thresholds and stays level beyond", function()
    for _, pair in ipairs({ { 0, 5 }, { 1, 5 }, { 1.5, 4 }, { 2, 3 }, { 3, 2 }, { 4, 1 }, { 9, 1 } }) do
        near(score({ depth_measure() }, { pair[1] }).items[1].score, pair[2], 1e-9, "at " .. pair[1])
    end
end)

case("a range is worse on both sides", function()
    local measure = { five = { 80, 90 }, three = 60, one = { 40, 95 }, take = "last" }
    for _, pair in ipairs({ { 85, 5 }, { 80, 5 }, { 70, 4 }, { 60, 3 }, { 50, 2 }, { 40, 1 }, { 10, 1 }, { 92.5, 3 },
        { 95, 1 }, { 99, 1 } }) do
        near(score({ depth_measure(measure) }, { pair[1] }).items[1].score, pair[2], 1e-9, "at " .. pair[1])
    end
end)

case("an item is the weighted mean of its measures", function()
    local low = depth_measure({ id = "low", take = "min", weight = 3 })
    local result = score({ depth_measure(), low }, { 4, 1 })
    near(result.items[1].score, (1 * 1 + 3 * 5) / 4, 1e-9)
end)

case("items without a measure are left out and the scale shrinks", function()
    local result = score({ depth_measure() }, { 2 })
    equal(result.items[2].score, nil)
    equal(result.items[2].reasons[1], "Not scored: not here.")
    equal(result.max, 5)
    near(result.total, 3, 1e-9)
    near(result.scaled, 0.5, 1e-9)
end)

case("a measure of what is not simulated is left out, one that never was defined too unless it says", function()
    local other = depth_measure({ id = "other", of = "phaco.power", five = 0, three = 1, one = 2 })
    near(score({ depth_measure(), other }, { 2 }).items[1].score, 3, 1e-9)
    equal(score({ depth_measure() }, { 0 / 0 }).items[1].score, nil)
    near(score({ depth_measure({ if_never = 4 }) }, { 0 / 0 }).items[1].score, 1, 1e-9)
end)

-- tip.depth_mm is what the item is about, and is there from the first step on.
local function begun_score(begun, depths, completed)
    local eye = Eye.new(support.schema, {})
    local judged = scoring.rubric { name = "test", caps = caps, items = {
        { id = "I1", name = "first", begun = begun, measures = {
            depth_measure({ take = "last" }), depth_measure({ id = "all", take = "last", whole = true }) } } } }
    local sheet = scoring.sheet(judged({ "I1" }), eye, {}, 0.5)
    for i, depth in ipairs(depths) do
        eye:look(i * 0.5, { depth, 1, 0, 1 }, 0)
        sheet:tick(i * 0.5)
    end
    return sheet:score({}, completed ~= false).items[1]
end

case("an item whose work was not begun has the least points, and says so", function()
    local item = begun_score("tip.depth_mm > 0.5", { 0, 0 })
    equal(item.score, 1)
    equal(#item.measures, 1)
    equal(item.measures[1].id, "I1.begun")
    equal(item.measures[1].value, 0)
    equal(item.reasons[1]:find("not begun", 1, true) ~= nil, true)
    equal(begun_score("tip.depth_mm > 0.5", { 0, 0.7, 0 }).score, 5)
    equal(begun_score({ "nothing.here", "tip.depth_mm > 0.5" }, { 0, 0 }).score, 1)
    equal(begun_score("nothing.here > 1", { 0, 0 }).score, 5, "not asked where it is not known")
end)

case("what tells of all of the work counts of an unfinished attempt only where it costs points", function()
    equal(#begun_score(nil, { 0 }, true).measures, 2)
    equal(#begun_score(nil, { 0 }, false).measures, 1)
    equal(#begun_score(nil, { 2 }, false).measures, 2)
end)

case("what an input does not show, and how fast hands were in slowed time, is not judged", function()
    local function judged_with(how)
        local eye = Eye.new(support.schema, {})
        local sheet = scoring.sheet(rubric({ depth_measure({ id = "shown", take = "last" }),
            depth_measure({ id = "trembling", take = "last", not_with = { "mouse" } }),
            depth_measure({ id = "speed", take = "last", pace = true }) })({ "I1" }), eye, {}, 0.5)
        eye:look(0.5, { 1, 1, 0, 1 }, 0)
        sheet:tick(0.5)
        local item = sheet:score({}, true, how).items[1]
        local ids = {}
        for _, measure in ipairs(item.measures) do ids[#ids + 1] = measure.id end
        return table.concat(ids, " "), item
    end
    equal(judged_with(nil), "shown trembling speed")
    equal(judged_with({ input = "hands" }), "shown trembling speed")
    equal(judged_with({ input = "gamepad" }), "shown trembling speed")
    equal(judged_with({ input = "mouse" }), "shown speed")
    local ids, item = judged_with({ input = "mouse", slowed = true })
    equal(ids, "shown")
    equal(item.hidden[1].why, "input")
    equal(item.hidden[2].why, "pace")
end)

case("a condition is 1 or 0 where a number is made of it", function()
    for take, value in pairs({ max = 1, min = 0, last = 0, mean = 0.25, rms = 0.5, time = 0.5, share = 25,
        count = 1 }) do
        for _, of in ipairs({ "tip.depth_mm > 2", "tip.depth_mm > 2 or false" }) do
            local result = score({ depth_measure({ of = of, take = take }) }, { 0, 3, 1, 1 })
            near(result.items[1].measures[1].value, value, 1e-6, take)
        end
    end
    local touch = depth_measure({ of = "tip.touch", take = "max", five = 0, three = 0.5, one = 1 })
    near(score({ touch }, { 0 }).items[1].measures[1].value, 0, 1e-9)
end)

case("events cap their items by what became of them", function()
    local function capped(severity, outcome)
        return score({ depth_measure() }, { 0 }, { { id = "e", title = "E", severity = severity, outcome = outcome,
            items = { "I1" }, time_s = 1 } }).items[1]
    end
    equal(capped("critical", "not_recovered").score, 1)
    equal(capped("critical", "recovered").score, 3)
    equal(capped("critical", "near_miss").score, 4)
    equal(capped("minor", "not_recovered").score, 3)
    equal(capped("minor", "recovered").score, 4)
    equal(capped("minor", "near_miss").score, 5)
    local item = capped("critical", "recovered")
    equal(item.capped_by[1].event, "e")
    equal(item.reasons[1], "E at 1.0 s, put right: at most 3 points.")
end)

case("the same error again is told once, with how often", function()
    local events = {}
    for i = 1, 3 do
        events[i] = { id = "e", title = "E", severity = "minor", outcome = "recovered", items = { "I1" }, time_s = i }
    end
    local item = score({ depth_measure() }, { 0 }, events).items[1]
    equal(#item.capped_by, 3)
    equal(item.reasons[1], "E at 1.0 s and 2 times more, put right: at most 4 points.")
end)

case("a cap never raises a score", function()
    local item = score({ depth_measure() }, { 4 }, { { id = "e", title = "E", severity = "critical",
        outcome = "recovered", items = { "I1" }, time_s = 1 } }).items[1]
    equal(item.score, 1)
end)

case("lost points are explained with value, thresholds and what would have been better", function()
    local item = score({ depth_measure() }, { 2 }).items[1]
    equal(item.reasons[1], "depth: 2.0 mm (5 points at 1.0 mm, 3 at 2.0 mm, 1 at 4.0 mm). Less.")
    equal(item.measures[1].threshold_source, "test")
    near(item.measures[1].time_s, 0.5, 1e-9)
end)

case("thresholds are told with the digits that they need", function()
    local item = score({ depth_measure { unit = "1", digits = 0, five = 1, three = 0.5, one = 0 } }, { 0.6 }).items[1]
    equal(item.measures[1].text, "depth: 1 (5 points at 1, 3 at 0.5, 1 at 0)")
    item = score({ depth_measure { digits = 1, five = { 2, 2.25 }, three = { 1, 1 / 3 + 3 }, one = { 0, 5 } } }, { 4 })
        .items[1]
    equal(item.measures[1].text, "depth: 4.0 mm (5 points at 2.0 to 2.25 mm, 3 at 1.0 or 3.333333 mm, "
        .. "1 at 0.0 or 5.0 mm)")
end)

case("collectors: mean, rms, time, share, count over an attempt", function()
    local function value(take, depths, more)
        local given = { take = take }
        for key, v in pairs(more or {}) do given[key] = v end
        return score({ depth_measure(given) }, depths).items[1].measures[1].value
    end
    near(value("mean", { 1, 2, 6 }), 3, 1e-9)
    near(value("rms", { 3, 4 }), math.sqrt(12.5), 1e-6)
    near(value("min", { 3, 1, 2 }), 1, 1e-9)
    near(value("last", { 3, 1, 2 }), 2, 1e-9)
    near(value("time", { 3, 1, 3 }, { of = "tip.depth_mm > 2" }), 1, 1e-9)
    near(value("share", { 3, 1, 3, 1 }, { of = "tip.depth_mm > 2" }), 50, 1e-9)
    near(value("share", { 3, 1, 3, 3 }, { of = "tip.depth_mm > 2", hold_s = 1 }), 50, 1e-9)
    equal(value("count", { 3, 1, 3, 3 }, { of = "tip.depth_mm > 2" }), 2)
    equal(value("count", { 3, 1, 3, 1, 1, 1, 3 }, { of = "tip.depth_mm > 2", quiet_s = 1 }), 2, "with rest")
    near(value("max", { 3, 1, 9 }, { during = "tip.depth_mm < 5" }), 3, 1e-9)
    near(value("last", { 3 }, { of = "tip.depth_mm / reference.depth" }), 1.5, 1e-9)
    near(value("deviation", { 1, 3, 1, 3 }), 1, 1e-9)
    near(value("first", { 1, 3, 4 }, { during = "tip.depth_mm > 2" }), 3, 1e-9)
    near(value("longest", { 3, 1, 3, 3, 3, 1, 3 }, { of = "tip.depth_mm > 2" }), 1.5, 1e-9)
end)

case("per divides by a reference of the exercise; without one the measure is left out with its weight", function()
    local own = depth_measure({ id = "own", take = "last", per = "depth", five = 1, three = 2, one = 3 })
    local item = score({ own }, { 3 }).items[1]
    near(item.measures[1].value, 1.5, 1e-9)
    near(item.score, 4, 1e-9)
    local none = depth_measure({ id = "none", take = "last", per = "length", five = 0, three = 0.1, one = 0.2 })
    item = score({ own, none }, { 3 }).items[1]
    equal(#item.measures, 1)
    near(item.score, 4, 1e-9)
    equal(score({ none }, { 3 }).items[1].score, nil)
end)

case("all of a rubric are its items in its order; anything else that it lacks is told", function()
    local own = rubric { depth_measure() }
    equal(table.concat(own.all.items, " "), "I1 I2")
    equal(own.all.rubric, own)
    fails(function() return own.al end, "'al'", "all")
end)

case("a faulty rubric names item and measure", function()
    fails(function() rubric({ depth_measure({ take = "biggest" }) }) end, "I1", "'m'", "biggest")
    fails(function()
        local measure = depth_measure()
        measure.five = nil
        rubric({ measure })
    end, "item I1, measure m: five, three and one")
    fails(function() rubric({ depth_measure({ of = "tip.depth_mm <" }) }) end, "measure m", "missing")
end)

case("a rubric may have levels of its own, anchors, and errors of other items", function()
    local own = scoring.rubric { name = "own", levels = { five = 5, four = 4, three = 3, two = 2 }, caps = caps,
        items = {
        { id = "P1", name = "first", errors_of = { "T9" }, anchors = { [2] = "poor", [4] = "fair", [5] = "good" },
            measures = { { id = "P1.m", name = "depth", of = "tip.depth_mm", take = "max", unit = "mm", five = 1,
                four = 2, three = 3, two = 5, source = "test", better = "Less." } } } } }
    local function result(depth, events)
        local eye = Eye.new(support.schema, {})
        local sheet = scoring.sheet(own({ "P1" }), eye, {}, 0.5)
        eye:look(0.5, { depth, 1, 0, 1 }, 0)
        sheet:tick(0.5)
        return sheet:score(events or {}, true)
    end
    for _, pair in ipairs({ { 0, 5, 1 }, { 2, 4, 2 / 3 }, { 4, 2.5, 1 / 6 }, { 9, 2, 0 } }) do
        near(result(pair[1]).items[1].score, pair[2], 1e-9, "at " .. pair[1])
        near(result(pair[1]).scaled, pair[3], 1e-3, "at " .. pair[1])
    end
    equal(result(2).items[1].anchor, "fair")
    equal(result(2).items[1].reasons[1],
        "depth: 2.0 mm (5 points at 1.0 mm, 4 at 2.0 mm, 3 at 3.0 mm, 2 at 5.0 mm). Less.")
    local event = { id = "e", title = "E", severity = "critical", outcome = "not_recovered", items = { "T9" },
        time_s = 1 }
    equal(result(0, { event }).items[1].score, 2, "a cap of 1 is less than there is")
    event.items = { "T8" }
    equal(result(0, { event }).items[1].score, 5)
end)

case("what was given caps nothing when it is met, and does when it is met badly or not at all", function()
    local function points(event)
        event.id, event.title, event.severity, event.items, event.time_s = "e", "E", "critical", { "I1" }, 0
        return score({ depth_measure() }, { 0 }, { event }).items[1].score
    end
    equal(points { outcome = "recovered", recovered = true }, 3)
    equal(points { outcome = "recovered", recovered = true, given = true }, 5)
    equal(points { outcome = "recovered", recovered = true, given = true, harmed = true }, 3)
    equal(points { outcome = "not_recovered", recovered = false, given = true }, 1)
end)

case("advice goes by severity, what was not put right first, and not by what was given and met", function()
    local function event(advice, severity, outcome, given)
        return { id = advice, title = advice, severity = severity, items = {}, time_s = 0, outcome = outcome,
            recovered = outcome == "recovered", advice = advice, given = given }
    end
    local list = scoring.advice({ items = {} }, { event("minor left", "minor", "not_recovered"),
        event("grave mended", "critical", "recovered"), event("grave left", "critical", "not_recovered"),
        event("given", "critical", "recovered", true) })
    equal(table.concat(list, ", "), "grave left, grave mended, minor left")
end)

case("whose scores a score is like: only of the same exercise, done in the same way, on the same items", function()
    local standing = require "engine.standing"
    local function items(...)
        local list = {}
        for i, id in ipairs({ ... }) do list[i] = { id = id, score = 4 } end
        return list
    end
    local cohort = { rubric = "OSACSS", items = { "T1", "T2", "G1" }, seeds = { 401, 406 }, cuts = {
        { from = 0, groups = { "a" }, n = 5 }, { from = 0.6, groups = { "b", "c" }, n = 11 },
        { from = 0.9, groups = { "d" }, n = 6 } } }
    local function like(scaled)
        return table.concat(standing.of({ rubric = "OSACSS", items = items("T1", "T2", "G1"), scaled = scaled }, true,
            cohort).like, " ")
    end
    equal(like(0.59), "a")
    equal(like(0.6), "b c")
    equal(like(0.95), "d")
    local function why(change, completed, of, changed)
        local judged = { rubric = "OSACSS", items = items("T1", "T2", "G1"), scaled = 0.7 }
        for key, value in pairs(change or {}) do judged[key] = value end
        return standing.of(judged, completed ~= false, of, changed).none
    end
    equal(why(nil, true, nil), "no cohort")
    equal(why(nil, false, cohort), "not completed")
    equal(why(nil, true, cohort, true), "another task")
    equal(why({ rubric = "ICO-OSCAR" }, true, cohort), "another rubric")
    equal(why({ items = items("T1", "T2") }, true, cohort), "too few items")
    equal(why({ items = items("T1", "T2", "G2") }, true, cohort), "other items")
    cohort.cuts = { { from = 0, groups = { "a", "b", "c", "d" }, n = 22 } }
    equal(why(nil, true, cohort), "not told apart")
    cohort.stale = true
    equal(why(nil, true, cohort), "another exercise")
    equal(standing.is_another_task("language"), false)
    equal(standing.is_another_task("patient.side"), false)
    equal(standing.is_another_task("surgeon.recovery"), false)
    equal(standing.is_another_task("patient.cataract"), true)
    equal(standing.is_another_task("level"), true)
end)

case("a rubric with a field that there is not is told so", function()
    fails(function() scoring.rubric { name = "x", caps = caps, items = {}, bands = {} } end, "no field 'bands'")
end)

case("OSACSS has its twenty items, and every measure says where its thresholds come from", function()
    local ids = {}
    for _, item in ipairs(osacss.items) do ids[#ids + 1] = item.id end
    equal(table.concat(ids, " "), "T1 T2 T3 T4 T5 T6 T7 T8 T9 T10 T11 T12 T13 T14 G1 G2 G3 G4 G5 G6")
    for _, item in ipairs(osacss.items) do
        equal(#item.measures > 0 or item.not_scored ~= nil, true, item.id)
        for _, measure in ipairs(item.measures) do
            equal(measure.id:sub(1, #item.id + 1), item.id .. ".", measure.id)
            equal(#measure.source > 0, true, measure.id)
        end
    end
end)

case("advice begins with errors that were not put right, then with what cost most", function()
    local events = { { id = "e", title = "E", severity = "minor", outcome = "recovered", items = {}, time_s = 1,
        advice = "Second." }, { id = "f", title = "F", severity = "critical", outcome = "not_recovered", items = {},
        time_s = 2, advice = "First." } }
    local result = score({ depth_measure() }, { 4 }, events)
    equal(table.concat(scoring.advice(result, events), " "), "First. Second. Less.")
end)
