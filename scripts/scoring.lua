-- SPDX-License-Identifier: GPL-3.0-or-later
-- Scores an attempt by a rubric. A rubric is data (see osacss.lua): items with measures, thresholds and caps. A
-- centre's own rubric is another such table: return scoring.rubric { ... }.

local collect = require "engine.collect"
local expression = require "engine.expression"
local fields = require "engine.fields"
local to_four = require "engine.to_four"
local words = require "engine.words"

local scoring = {}

-- The rubric's words in the language of the attempt.
local function t(text) return text end

--- f: gives a text in the language of the attempt.
function scoring.translate_with(f) t = f end

local measure_rules = {
    id = { kind = "text", required = true },
    name = { kind = "text", required = true },   -- what it is, for the reader of a report
    of = { kind = "text", required = true },     -- the quantity or condition that is watched
    take = { kind = "text", required = true, choices = { "max", "min", "mean", "rms", "deviation", "first",
        "last", "total", "time", "longest", "share", "count" } },  -- what is made of it over the attempt
    during = { kind = "text" },                  -- only while this holds
    hold_s = { kind = "number", from = 0 },      -- time, share: only stretches as long as this
    quiet_s = { kind = "number", from = 0 },     -- count: rest needed before it counts again
    per = { kind = "text" },                     -- name of a reference number: the result is told as a multiple of it;
                                                 -- an exercise without that number is not judged by the measure
    if_never = { kind = "number" },              -- the value when it never was defined; without it: not scored
    given = { kind = "text" },                   -- where this holds at the first observation the eye came with what is
                                                 -- measured, and the measure is not judged
    whole = { kind = "yes_no" },                 -- tells of all of the work: of an attempt that was not completed it
                                                 -- counts only where it costs points already
    not_with = { kind = "texts" },               -- inputs (see `input` of an exercise) that do not show it: not judged
    pace = { kind = "yes_no" },                  -- tells of how fast hands are: not judged where simulated time ran
                                                 -- slower than the clock
    unit = { kind = "text", required = true },
    digits = { kind = "number", default = 1, from = 0, to = 4, whole = true },
    curve = { kind = "table", required = true }, -- { {value, score}, ... } made of five, three, one
    weight = { kind = "number", default = 1, from = 0 },
    source = { kind = "text", required = true }, -- ground for the thresholds
    better = { kind = "text" },                  -- what would have been better
    too_low = { kind = "text" },                 -- the same, where too little and too much differ
    too_high = { kind = "text" },
}

local function points(low, high) return { low = low, high = high } end

-- five = 1.0 stands for one value, five = { 80, 90 } for a range with a worse side on either hand.
local function side(value)
    if type(value) == "table" then return points(value[1], value[2]) end
    return points(value, nil)
end

-- Thresholds as a curve of { value, score }, ascending in value. Where several have the same value, the better counts.
local function curve_of(given, levels)
    local curve = {}
    for _, name in ipairs(words.keys(levels)) do
        local at = side(given[name])
        curve[#curve + 1] = { at.low, levels[name] }
        if at.high then curve[#curve + 1] = { at.high, levels[name] } end
    end
    table.sort(curve, function(a, b)
        if a[1] ~= b[1] then return a[1] < b[1] end
        return a[2] > b[2]
    end)
    return curve
end

local usual_levels = { five = 5, three = 3, one = 1 }

-- Names of the thresholds, the best first.
local function level_names(levels)
    local names = words.keys(levels)
    table.sort(names, function(a, b) return levels[a] > levels[b] end)
    return names
end

local function listed(names)
    return table.concat(names, ", ", 1, #names - 1) .. " and " .. names[#names]
end

local function read_measure(given, item, levels)
    local plain = {}
    for key, value in pairs(given) do
        if not levels[key] then plain[key] = value end
    end
    local names = level_names(levels)
    for _, name in ipairs(names) do
        if given[name] == nil then
            words.fail(words.where(), ("item %s, measure %s: %s must all be given"):format(item, tostring(given.id),
                listed(names)))
        end
    end
    plain.curve = curve_of(given, levels)
    local measure = fields.read(plain, measure_rules, ("item %s, measure '%s'"):format(item, tostring(given.id)))
    measure.thresholds = {}
    for i, name in ipairs(names) do measure.thresholds[i] = { points = levels[name], value = given[name] } end
    local where = words.where() .. ": item " .. item .. ", measure " .. measure.id
    measure.of = expression.parse(measure.of, where)
    measure.during = measure.during and expression.parse(measure.during, where)
    measure.given = measure.given and expression.parse(measure.given, where)
    return measure
end

local function every_item(rubric)
    local ids = {}
    for i, item in ipairs(rubric.items) do ids[i] = item.id end
    return { rubric = rubric, items = ids }
end

-- rubric { "T9", "G4" } are some of its items, rubric.all all of them.
local selecting = {}

function selecting.__call(rubric, wanted)
    local known, seen = words.keys(rubric.by_id), {}
    if type(wanted) ~= "table" then
        words.fail(words.where("scoring"), "a rubric is followed by a list of items, like { \"T9\", \"G4\" }")
    end
    for _, id in ipairs(wanted) do
        if not rubric.by_id[id] then
            words.fail(words.where("scoring", nil), ("unknown item '%s'%s"):format(tostring(id),
                words.hint(tostring(id), known)))
        end
        if seen[id] then words.fail(words.where("scoring"), ("item '%s' is listed twice"):format(id)) end
        seen[id] = true
    end
    return { rubric = rubric, items = wanted }
end

local may_lack = { caps = true, source = true, name = true, rubric = true }

function selecting.__index(rubric, key)
    if key == "all" then return every_item(rubric) end
    if may_lack[key] then return nil end
    words.fail(words.where("scoring", nil), ("a rubric has no '%s'%s"):format(tostring(key),
        words.hint(tostring(key), { "all" })))
end

-- Watches of `begun`: whether what an item judges was begun at all.
local function read_begun(item)
    local texts = type(item.begun) == "string" and { item.begun } or item.begun or {}
    local list = {}
    for i, text in ipairs(texts) do
        list[i] = { id = ("%s.begun_%d"):format(item.id, i), take = "max",
            of = expression.parse(text, words.where() .. ": item " .. item.id .. ", begun") }
    end
    return list
end

local function read_items(rubric)
    for _, item in ipairs(rubric.items) do
        item.measures = item.measures or {}
        item.begun = read_begun(item)
        for i, measure in ipairs(item.measures) do item.measures[i] = read_measure(measure, item.id, rubric.levels) end
        rubric.by_id[item.id] = item
    end
end

local rubric_fields = { name = true, source = true, items = true, caps = true, levels = true }

--- Checks and completes a rubric { name, items = { { id, name, measures }, ... }, caps }. Calling the rubric
--- with a list of item ids gives what an exercise writes as `scoring`. levels: points of the thresholds that measures
--- give, { five = 5, three = 3, one = 1 } if missing; the least of them is the least that an item can have.
--- An item may have anchors, { [points] = what a performance of that level looks like }; errors_of, ids of items of
--- OSACSS: it judges where an exercise scores one of those, and errors that count against those count against it;
--- begun, a condition or a list of them, of which one must have held for the work to have been begun: an item whose
--- work was not has the least points. Where an exercise knows none of them it is not asked.
function scoring.rubric(given)
    for _, key in ipairs(words.keys(given)) do
        if not rubric_fields[key] then
            words.fail(words.where(), ("a rubric has no field '%s'%s"):format(tostring(key), words.hint(tostring(key),
                words.keys(rubric_fields))))
        end
    end
    local rubric = { name = given.name, source = given.source, items = given.items, caps = given.caps,
        levels = given.levels or usual_levels, least = 5, by_id = {} }
    for _, points_of in pairs(rubric.levels) do rubric.least = math.min(rubric.least, points_of) end
    local file, line = words.outside()
    words.at(file, line, read_items, rubric)  -- mistakes are named where the rubric stands
    return setmetatable(rubric, selecting)
end

--- Score of a value on a curve: linear between its points, level beyond them.
function scoring.interpolate(curve, value)
    if value <= curve[1][1] then return curve[1][2] end
    for i = 2, #curve do
        local a, b = curve[i - 1], curve[i]
        if value <= b[1] then
            if b[1] == a[1] then return b[2] end
            return a[2] + (b[2] - a[2]) * (value - a[1]) / (b[1] - a[1])
        end
    end
    return curve[#curve][2]
end

local function number(value, digits) return (("%." .. digits .. "f"):format(value):gsub("^%-(0%.?0*)$", "%1")) end

-- A threshold is told with the digits that it needs: 0.5 is not 0, whatever the digits of what was measured.
local function digits_of(value, digits)
    while digits < 6 and math.abs(tonumber(number(value, digits)) - value) > 1e-9 do digits = digits + 1 end
    return digits
end

local function amount(measure, value, digits)
    local text = number(value, digits or measure.digits)
    return measure.unit == "1" and text or text .. " " .. measure.unit
end

local function exact(measure, value) return amount(measure, value, digits_of(value, measure.digits)) end

local function pair_text(measure, pattern, pair)
    return t(pattern):format(number(pair[1], digits_of(pair[1], measure.digits)), exact(measure, pair[2]))
end

local function threshold_text(measure, threshold)
    if type(threshold) ~= "table" then return exact(measure, threshold) end
    return pair_text(measure, "%s to %s", threshold)
end

-- "5 points at 0.2 mm, 3 at 0.5 mm, 1 at 1.0 mm"
local function scale_text(measure)
    local parts = {}
    for i, threshold in ipairs(measure.thresholds) do
        local value = threshold.value
        local text = type(value) == "table" and i > 1
            and pair_text(measure, "%s or %s", value)
            or threshold_text(measure, value)
        parts[i] = t(i == 1 and "%d points at %s" or "%d at %s"):format(threshold.points, text)
    end
    return table.concat(parts, ", ")
end

-- What would have been better, of a value that lost points.
local function advice_of(measure, value)
    local five = measure.thresholds[1].value
    local low = type(five) == "table" and five[1] or five
    if value < low and measure.too_low then return measure.too_low end
    if value > low and measure.too_high then return measure.too_high end
    return measure.better
end

local Sheet = {}
Sheet.__index = Sheet

-- since_s: time that passed before the eye's own began.
local function resolver(eye, reference, since_s)
    return function(name)
        if name == "time_s" then return function() return since_s + eye.time_s end end
        local key = name:match("^reference%.(.+)$")
        if key then
            local value = reference[key]
            if value == nil then return nil, {} end
            return function() return value end
        end
        return eye:resolve(name)
    end
end

-- missing: the exercise does not simulate what the measure needs.
local function open_measure(measure, resolve)
    local open = { measure = measure, missing = true,
        collector = collect[measure.take]({ hold_s = measure.hold_s, quiet_s = measure.quiet_s }) }
    if not expression.known(measure.of, resolve) then return open end
    if measure.during and not expression.known(measure.during, resolve) then return open end
    open.missing = false
    open.of = expression.bind(measure.of, resolve)
    open.during = measure.during and expression.bind(measure.during, resolve)
    if measure.given and expression.known(measure.given, resolve) then
        open.there = expression.bind(measure.given, resolve)
    end
    return open
end

-- Whether this exercise or an earlier part of the operation tells of a measure.
local function told(open) return open.seen_before or not open.missing end

-- Goes on where a measure of an earlier part had come to.
local function take_up(open, state)
    if not state then return end
    for key, value in pairs(state) do open.collector.state[key] = value end
    open.given, open.collector.state.given = state.given, nil
    open.seen_before = true
end

--- Opens a score sheet. selection: what the exercise wrote as scoring; reference: its named reference numbers; dt: step
--- of time [s]. Of a part of an operation: before: { time_s, measures }, of the sheet that it goes on with
--- (Sheet:carried); watched: set of the items that this part tells of.
function scoring.sheet(selection, eye, reference, dt, before, watched)
    local self = setmetatable({ rubric = selection.rubric, dt = dt, lines = {}, open = {}, reference = reference,
        eye = eye, since_s = before and before.time_s or 0, begun = before ~= nil and before.time_s > 0 }, Sheet)
    local resolve = resolver(eye, reference, self.since_s)
    for i, id in ipairs(selection.items) do
        local item = selection.rubric.by_id[id]
        local function opened(measure)
            local open = open_measure(measure, resolve)
            if watched and not watched[id] then open.missing = true end
            if before then take_up(open, before.measures[measure.id]) end
            if not open.missing then table.insert(self.open, open) end
            return open
        end
        local line = { item = item, open = {}, begun = {} }
        for k, measure in ipairs(item.measures) do line.open[k] = opened(measure) end
        for k, measure in ipairs(item.begun) do line.begun[k] = opened(measure) end
        self.lines[i] = line
    end
    return self
end

-- All that is watched of an item.
local function watches_of(line)
    local list = {}
    for _, open in ipairs(line.open) do list[#list + 1] = open end
    for _, open in ipairs(line.begun) do list[#list + 1] = open end
    return list
end

--- What of the sheet this scene cannot tell: list of { item, measures = list of { measure, complaint }, none = no
--- measure of the item is watched }.
function Sheet:untold()
    local list = {}
    for i, line in ipairs(self.lines) do
        local untold = { item = line.item, measures = {}, none = true }
        for _, open in ipairs(line.open) do
            if open.missing then
                local measure, resolve = open.measure, resolver(self.eye, self.reference, 0)
                local complaint = expression.complaint(measure.of, resolve)
                    or measure.during and expression.complaint(measure.during, resolve)
                table.insert(untold.measures, { measure = measure, complaint = complaint })
            else
                untold.none = false
            end
        end
        list[i] = untold
    end
    return list
end

--- Takes the observation that the eye holds now.
function Sheet:tick(time_s)
    for _, open in ipairs(self.open) do
        if not self.begun and open.there and open.there() then open.given = true end
    end
    self.begun = true
    for _, open in ipairs(self.open) do
        if not open.during or open.during() then
            local value = open.of()
            if value ~= nil then open.collector.add(value, self.dt, self.since_s + time_s) end
        end
    end
end

--- Goes on where the sheet of the same attempt had come to before its exercise was changed. measures: of Sheet:carried.
function Sheet:take_up(measures)
    self.begun = true
    for _, line in ipairs(self.lines) do
        for _, open in ipairs(watches_of(line)) do
            if not open.missing then take_up(open, measures[open.measure.id]) end
        end
    end
end

--- What a sheet needs that goes on with this one in the next part of an operation: { time_s, measures }.
function Sheet:carried(time_s)
    local measures = words.as_object({})
    for _, line in ipairs(self.lines) do
        for _, open in ipairs(watches_of(line)) do
            if told(open) then
                local collector, state = open.collector, words.as_object({})
                local now = collector.carry and collector.carry() or collector.state
                for key, value in pairs(now) do state[key] = value end
                state.given = open.given
                measures[open.measure.id] = state
            end
        end
    end
    return { time_s = self.since_s + time_s, measures = measures }
end

local full_points = 4.995  -- from here on a measure shows as 5

local function round(value, digits) return tonumber(("%." .. digits .. "f"):format(value)) end

-- Why the way in which an attempt was made hides a measure; nil: it does not. how: of Sheet:score.
local function hidden(measure, how)
    for _, input in ipairs(measure.not_with or {}) do
        if input == how.input then return "input" end
    end
    return measure.pace and how.slowed and "pace" or nil
end

local function measured(open, reference)
    local measure = open.measure
    if open.given or not told(open) then return nil end
    local value, at = open.collector.result()
    if value == nil then value = measure.if_never end
    if value == nil then return nil end
    if measure.per then
        if not reference[measure.per] then return nil end
        value = value / reference[measure.per]
    end
    local score = scoring.interpolate(measure.curve, value)
    local result = { id = measure.id, name = t(measure.name), value = round(value, 6), unit = measure.unit,
        score = round(score, 2), weight = measure.weight, threshold_source = measure.source, time_s = at,
        text = t("%s: %s (%s)"):format(t(measure.name), amount(measure, value), scale_text(measure)) }
    if score <= full_points then result.better = t(advice_of(measure, value)) end
    return result
end

-- Whether an event counts against an item.
local function concerns(event, item)
    for _, id in ipairs(event.items) do
        if id == item.id then return true end
        for _, other in ipairs(item.errors_of or {}) do
            if id == other then return true end
        end
    end
    return false
end

--- What an event leaves of an item that it concerns; nil: all of it. What was given and is put right without harm was
--- the task.
function scoring.cap_of(caps, event)
    if event.given and event.recovered and not event.harmed then return nil end
    local of_severity = caps[event.severity]
    return of_severity and of_severity[event.outcome]
end

-- The lowest cap that the events put on an item, and what put it there.
local function caps_on(rubric, item, events)
    local cap, by = 5, {}
    for _, event in ipairs(events) do
        local value = scoring.cap_of(rubric.caps, event)
        if value and value < 5 and concerns(event, item) then
            cap = math.min(cap, value)
            by[#by + 1] = { event = event.id, title = event.title, outcome = event.outcome, cap = value,
                time_s = event.time_s }
        end
    end
    return cap, by
end

local outcomes = { near_miss = "a near miss, put right at once", recovered = "put right",
    not_recovered = "not put right in time", open = "not put right yet" }

-- "Iris touched at 5.6 s and 2 times more, put right: at most 4 points."
local function cap_reason(by, same)
    local more = ""
    if same == 1 then more = t(" and once more") elseif same > 1 then more = t(" and %d times more"):format(same) end
    local text = by.cap == 1 and t("%s at %.1f s%s, %s: at most %d point.")
        or t("%s at %.1f s%s, %s: at most %d points.")
    return text:format(by.title, by.time_s, more, t(outcomes[by.outcome]), by.cap)
end

local function cap_reasons(list, capped_by)
    local seen, same = {}, {}
    for _, by in ipairs(capped_by) do
        local key = by.event .. "/" .. by.outcome
        if same[key] == nil then seen[#seen + 1] = by end
        same[key] = (same[key] or -1) + 1
    end
    for _, by in ipairs(seen) do list[#list + 1] = cap_reason(by, same[by.event .. "/" .. by.outcome]) end
end

local function reasons(result, cap)
    local list = {}
    cap_reasons(list, result.capped_by)
    for _, measure in ipairs(result.measures) do
        if measure.score <= full_points then
            list[#list + 1] = measure.text .. (measure.better and ". " .. measure.better or ".")
        end
    end
    if #list == 0 and cap == 5 then list[1] = t("All measures in the range for full points.") end
    return list
end

-- Whether the exercise tells of an item whose work was never begun.
local function idle(line)
    local judged, asked = false, false
    for _, open in ipairs(line.open) do judged = judged or told(open) end
    for _, open in ipairs(line.begun) do
        if open.collector.result() == 1 then return false end
        asked = asked or told(open)
    end
    return judged and asked
end

-- Measures that are not judged, for the eye came with what they tell of; nil: none.
local function given_measures(line)
    local list = {}
    for _, open in ipairs(line.open) do
        if open.given then list[#list + 1] = { id = open.measure.id, name = t(open.measure.name) } end
    end
    return #list > 0 and list or nil
end

-- Measures that are not judged, for the attempt was made in a way that hides them; nil: none.
local function hidden_measures(line, how)
    local list = {}
    for _, open in ipairs(line.open) do
        local why = hidden(open.measure, how)
        if why and told(open) then
            list[#list + 1] = { id = open.measure.id, name = t(open.measure.name), why = why }
        end
    end
    return #list > 0 and list or nil
end

-- What stands in place of the measures of an item whose work was not begun.
local function not_begun(item, rubric)
    return { id = item.id .. ".begun", name = t("Begun (1: yes)"), value = 0, unit = "1", score = rubric.least,
        weight = 1, threshold_source = t("the least level of the rubric: not achieved"),
        text = t("What this item judges was not begun"), better = t("Go on to it: what is not done earns the least.") }
end

-- The measures that count of an item, each with its points.
local function counting(line, rubric, reference, completed, how)
    if idle(line) then return { not_begun(line.item, rubric) } end
    local list = {}
    for _, open in ipairs(line.open) do
        local measure = not hidden(open.measure, how) and measured(open, reference)
        local too_early = open.measure.whole and not completed and measure and measure.score > full_points
        if measure and not too_early then list[#list + 1] = measure end
    end
    return list
end

local function score_item(line, rubric, events, reference, completed, how)
    local item = line.item
    local result = { id = item.id, name = t(item.name), measures = counting(line, rubric, reference, completed, how) }
    local sum, weight = 0, 0
    for _, measure in ipairs(result.measures) do
        sum, weight = sum + measure.weight * measure.score, weight + measure.weight
    end
    local cap, by = caps_on(rubric, item, events)
    result.capped_by, result.given, result.hidden = by, given_measures(line), hidden_measures(line, how)
    if weight > 0 then
        result.score = round(math.max(rubric.least, math.min(cap, sum / weight)), 2)
        result.reasons = reasons(result, cap)
        result.anchor = item.anchors and item.anchors[math.floor(result.score + 0.5)]
        result.to_four = to_four.of(result, line.open, amount, t)
    else
        result.reasons = { t("Not scored: ") .. t(result.hidden and "what it was operated with does not show it."
            or item.not_scored or "nothing that this attempt showed tells of it.") }
    end
    return result
end

--- The score as far as the attempt has come: items, total, max = 5 per item scored, scaled: share of the way
--- from the least to the most points, (total - n) / (4 n) where items have 1 to 5; caps: what errors leave of an item,
--- as the rubric has it. how: { input = what it was operated with, slowed = simulated time ran slower than the clock },
--- or nil.
function Sheet:score(events, completed, how)
    local result = { rubric = self.rubric.name, least = self.rubric.least, caps = self.rubric.caps, items = {},
        total = 0, max = 0 }
    local n = 0
    for i, line in ipairs(self.lines) do
        result.items[i] = score_item(line, self.rubric, events, self.reference, completed, how or {})
        local score = result.items[i].score
        if score then n, result.total = n + 1, result.total + score end
    end
    result.total, result.max = round(result.total, 2), 5 * n
    if n > 0 then
        local least = self.rubric.least
        result.scaled = round((result.total - least * n) / ((5 - least) * n), 4)
    end
    return result
end

--- All measures by id.
function Sheet:measures()
    local values = words.as_object({})
    for _, line in ipairs(self.lines) do
        for _, open in ipairs(line.open) do
            local measure = measured(open, self.reference)
            if measure then values[measure.id] = measure.value end
        end
    end
    return values
end

--- Up to five sentences: see engine/advice.lua.
scoring.advice = require "engine.advice"

return scoring
