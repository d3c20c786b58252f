-- SPDX-License-Identifier: GPL-3.0-or-later
-- One attempt at an exercise: takes an observation per step of time, gives commands, and in the end the result.

local Eye = require "engine.eye"
local Whole = require "engine.whole"
local condition = require "engine.condition"
local events = require "engine.events"
local orientation = require "engine.orientation"
local scoring = require "scoring"
local standard_warnings = require "theatre.warnings"
local steps = require "engine.steps"
local vitals = require "engine.vitals"
local warnings = require "engine.warnings"
local words = require "engine.words"

local Run = {}
Run.__index = Run

-- What the parts of the engine may do to the outside: all of it becomes commands.
local function actions(self)
    local act = {}
    local function queue(kind, name, value, text)
        table.insert(self.commands, { kind = kind, name = name, value = value, text = text })
    end
    function act.say(text) queue("say", "", 0, text) end
    function act.hint(text)
        if self.exercise.mode == "teaching" then act.say(text) end
    end
    function act.picture(name, caption) queue("picture", name, 0, caption) end
    function act.set(name, value) queue("set", name, value, "") end
    function act.finish(reason) queue("finish", "", 0, reason) end
    function act.step_ended(record)
        local how = record.completed and "completed" or "not completed"
        act.picture("step_" .. record.id, self.t("Step \"%s\" " .. how .. "."):format(record.title))
    end
    function act.during(record)
        act.picture("during_" .. record.id, self.t("During step \"%s\"."):format(record.title))
    end
    return act
end

local function event_log(self)
    local log = { events = self.events }
    function log.raised(record, declared)
        self.act.picture("error_" .. record.id, self.t("Error: %s."):format(record.title))
        self.act.hint(declared.advice)
        for _, text in ipairs(declared.consequences.texts) do self.act.say(text) end
        for _, name in ipairs(words.keys(declared.consequences.settings)) do
            self.act.set(name, declared.consequences.settings[name])
        end
        if declared.ends_exercise then self.reason = ("error: %s"):format(record.title) end
    end
    function log.closed(record)
        if record.recovered then
            self.act.picture("recovered_" .. record.id, self.t("Put right after %.1f s: %s."):format(
                record.recovery_s, record.title))
        end
    end
    return log
end

--- schema: list of { name, unit, meaning }; exercise: from exercise { ... }.
function Run.new(exercise, schema)
    local self = setmetatable({ exercise = exercise, events = {}, asked = {}, aids = {}, notes = {}, commands = {},
        time_s = 0 }, Run)
    self.t = exercise.translated or function(text) return text end
    scoring.translate_with(self.t)
    self.eye = Eye.new(schema, exercise.goals, exercise.requests)
    self.act = actions(self)
    self.log = event_log(self)
    self.warned, self.warnings = { came = {} }, {}
    for _, rule in ipairs(standard_warnings) do table.insert(self.warnings, warnings.watch(rule, self.eye)) end
    self.eye.used = {}  -- those that are watched in every scene are no exercise's
    self.steps = steps.prepare(exercise.steps, self.eye, self.act)
    self.watches = {}
    local task = not (exercise.whole and exercise.whole.before.parts)
    for i, declared in ipairs(exercise.errors) do self.watches[i] = events.watch(declared, self.eye, task) end
    self.over = exercise.over and words.try(condition.bind, exercise.over, self.eye, "in 'over'")
    if exercise.scoring then
        self.sheet = words.try(scoring.sheet, exercise.scoring, self.eye, exercise.reference, exercise.step_s)
    end
    if exercise.whole then
        self.whole = words.try(Whole.new, exercise.whole, exercise.scoring, self.eye, exercise.step_s)
    end
    return self
end

-- Who takes the instruments out for good before all is done has given up, which no tissue tells of.
local function note_given_up(self)
    local undone = self.steps:first_undone()
    if not undone or self.eye.info["instruments.out_s"] and self.eye:value("instruments.out_s") == 0 then return end
    local title = self.t("Given up")
    table.insert(self.events, { id = "given_up", title = title, step = undone.id, time_s = self.time_s,
        severity = "critical", items = {}, evidence = words.as_object({}), recovered = false,
        outcome = "not_recovered", harmed = false,
        advice = self.t("\"%s\" was not done: go on with it before the instruments leave for good."):format(
            undone.title),
        consequences = words.as_object({ texts = {}, settings = words.as_object({}) }) })
end

local function finish(self, reason)
    self.finished, self.reason = true, reason
    if reason == "over" then note_given_up(self) end
    self.steps:stop(self.time_s)
    for _, watch in ipairs(self.watches) do watch:finish(self.time_s, self.log) end
    self.act.picture("end", self.t("End of the exercise."))
    self.act.finish(reason)
end

local function reason_to_end(self)
    if self.reason then return self.reason end
    if self.steps:over() then return "all steps have had their turn" end
    if self.over and self.over.test() then return "over" end
    if self.time_s >= self.exercise.time_limit_s then return "time limit of the exercise" end
    return nil
end

-- The staff hears a request, does what the exercise says and answers. One that the exercise does not have, as in a
-- recording that another one judges, is not for this staff.
local function hear(self, asked, time_s)
    for _, id in ipairs(asked) do
        for _, request in ipairs(self.exercise.requests) do
            if request.id == id then
                table.insert(self.asked, { id = id, title = request.title, step = self.steps:current(),
                    time_s = time_s, settings = words.as_object(request.settings) })
                self.eye:hear(id)
                for _, name in ipairs(words.keys(request.settings)) do self.act.set(name, request.settings[name]) end
                if request.answer then self.act.say(request.answer) end
            end
        end
    end
end

-- Whoever operates was helped: each kind once, with how often and how long.
local function note_aids(self, aids, time_s)
    for _, aid in ipairs(aids) do
        local known
        for _, one in ipairs(self.aids) do known = one.id == aid.name and one or known end
        if not known then
            known = { id = aid.name, first_s = time_s, times = 0, seconds = 0 }
            table.insert(self.aids, known)
        end
        known.times, known.seconds = known.times + 1, known.seconds + aid.value
        if aid.text ~= "" then
            known.told = known.told or {}
            table.insert(known.told, { text = aid.text, time_s = time_s })
        end
    end
end

-- What an instructor pinned to the clock.
local function pin(self, notes, time_s)
    for _, note in ipairs(notes) do table.insert(self.notes, { time_s = time_s, text = note.text }) end
end

--- Takes one observation: time_s, a row of numbers in the order of the schema, and of the step that led to it the ids
--- of the requests, the aids and the notes, lists of { name, value, text }; or nil. Returns the commands, a list of
--- { kind, name, value, text }. Raises "file:line: message (in step ...)" when the curriculum errs.
function Run:observe(time_s, row, asked, aids, notes)
    self.commands = {}
    if self.finished then return self.commands end
    self.time_s = time_s
    self.eye:look(time_s, row, time_s - self.steps:since())
    if asked then hear(self, asked, time_s) end
    if aids then note_aids(self, aids, time_s) end
    if notes then pin(self, notes, time_s) end
    for _, watch in ipairs(self.watches) do watch:tick(time_s, self.steps:current(), self.log) end
    for _, watch in ipairs(self.warnings) do watch:tick(time_s, self.warned, self.t) end
    if self.vitals then self.vitals:tick(time_s) end
    if self.sheet then self.sheet:tick(time_s) end
    if self.whole then self.whole:tick(time_s) end
    self.steps:tick(time_s)
    local reason = reason_to_end(self)
    if reason then finish(self, reason) end
    return self.commands
end

-- A list for the report; nil: there is nothing in it.
local function listed(list) return #list > 0 and table.move(list, 1, #list, 1, {}) or nil end

--- What the run of a changed exercise goes on from: steps, events and scores so far.
function Run:left()
    local index_of, watches = {}, {}
    for i, record in ipairs(self.events) do index_of[record] = i end
    for i, watch in ipairs(self.watches) do watches[i] = watch:left(index_of) end
    return { time_s = self.time_s, steps = self.steps:left(), events = self.events, watches = watches,
        asked = self.asked, aids = self.aids, notes = self.notes, warned = listed(self.warned) or {},
        came = self.warned.came,
        score = self.sheet and self.sheet:carried(self.time_s).measures }
end

--- Goes on where the run of the exercise before it was changed had come to. Steps, events and measures of the same name
--- keep what is known of them; the others begin now.
function Run:take_up(left)
    self.time_s, self.events = left.time_s, left.events
    self.log.events = self.events
    for _, record in ipairs(self.events) do words.as_object(record.evidence) end
    for _, record in ipairs(left.asked) do
        words.as_object(record.settings)
        table.insert(self.asked, record)
        self.eye:hear(record.id, record.time_s)
    end
    local known = {}
    for _, watch in ipairs(left.watches) do known[watch.id] = watch end
    for _, watch in ipairs(self.watches) do
        if known[watch.declared.id] then watch:take_up(known[watch.declared.id], self.events) end
    end
    for _, note in ipairs(left.notes) do table.insert(self.notes, note) end
    for _, one in ipairs(left.came) do table.insert(self.warned.came, one) end
    for _, record in ipairs(left.warned) do
        words.as_object(record.evidence)
        table.insert(self.warned, record)
    end
    self.steps:take_up(left.steps, left.time_s)
    if self.sheet and left.score then self.sheet:take_up(left.score) end
end

-- What the monitor shows of an error event: what the trainee is told.
local function shown_event(record)
    return { title = record.title, advice = record.advice, time_s = record.time_s, outcome = record.outcome,
        severity = record.severity }
end

-- Steps in their order, with where the turn is.
local function shown_steps(self)
    local shown = {}
    for i, record in ipairs(self.steps.records) do
        local declared = self.exercise.steps[i]
        local state = record.completed and "done" or record.skipped and "left out" or record.end_s and "undone"
            or i == self.steps.at and "now" or "to come"
        shown[i] = { title = record.title, state = state, hint = state == "now" and declared.hint or nil }
    end
    return shown
end

-- The score as it would be if the attempt ended now.
local function shown_score(self)
    if not self.sheet then return nil end
    local score = self.sheet:score(self.events, false, self:how())
    local items = {}
    for i, item in ipairs(score.items) do
        items[i] = { id = item.id, name = item.name, score = item.score }
    end
    return { total = score.total, max = score.max, scaled = score.scaled, items = items }
end

--- What the theatre's monitor shows, as of the last observation. The patient's constants begin with the first time
--- that this is asked. score: with the points so far, which takes longer.
function Run:theatre(score)
    self.vitals = self.vitals or vitals.new(self.exercise.vitals, self.eye)
    local shown = {}
    for i, record in ipairs(self.events) do shown[i] = shown_event(record) end
    return { steps = shown_steps(self), events = shown, warnings = self:raised_warnings(),
        vitals = self.vitals:now(), notes = self.notes, score = score and shown_score(self) or nil }
end

--- Warnings that show now: list of { title, advice }.
function Run:raised_warnings()
    local raised = {}
    for _, watch in ipairs(self.warnings) do
        local record = watch:raised()
        if record then table.insert(raised, { title = record.title, advice = record.advice }) end
    end
    return raised
end

local slowed_from = 0.05  -- share of an attempt's time

--- What of the way in which it was made tells measures apart that can be judged: see scoring.lua.
function Run:how()
    local slowed_s = 0
    for _, aid in ipairs(self.aids) do
        if aid.id == "slowed" then slowed_s = slowed_s + aid.seconds end
    end
    return { input = self.exercise.input, slowed = slowed_s > slowed_from * self.time_s }
end

--- The part of report.json that the exercise knows, as far as it has come..
function Run:result()
    local exercise = self.exercise
    local result = { completed = self.finished == true and self.steps:all_completed(), reason = self.reason,
        steps = self.steps.records, events = self.events, requests = self.asked,
        aids = #self.aids > 0 and self.aids or nil, warnings = listed(self.warned), foreseen = listed(self.warned.came),
        notes = #self.notes > 0 and self.notes or nil, mode = exercise.mode, hints = exercise.mode == "teaching",
        level = exercise.level, language = exercise.language or "en",
        orientation = orientation.of(exercise.patient, exercise.handedness), title = exercise.title,
        summary = exercise.summary, objectives = exercise.objectives, goals = words.as_object(exercise.goals),
        settings = words.as_object(exercise.settings), measures = words.as_object({}), advice = {} }
    if self.sheet then
        result.osacss = self.sheet:score(self.events, result.completed, self:how())
        result.measures = self.sheet:measures()
        result.advice = scoring.advice(result.osacss, self.events)
    end
    if self.whole then result.operation = self.whole:result(result, self.time_s, self:how()) end
    return result
end

return Run
