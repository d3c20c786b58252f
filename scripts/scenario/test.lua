-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a scenario is given as `t`: time, instruments, settings and expectations. It moves instruments and looks; it
-- cannot write anything into the eye.

local Eye = require "engine.eye"
local Hand = require "scenario.hand"
local Microscope = require "scenario.microscope"
local Near = require "scenario.near"
local condition = require "engine.condition"
local fields = require "engine.fields"
local microscope = require "surgeons.microscope"
local requests = require "engine.requests"
local scoring = require "scoring"
local words = require "engine.words"

local Test = {}
Test.__index = Test

local seconds_rule = { kind = "number", from = 0, to = 7200 }

--- What a scenario may ask of it, besides its instruments.
Test.public = { "wait", "wait_until", "together", "set", "request", "expect", "expect_near", "expect_event",
    "expect_no_event", "value", "time_s" }

-- The table that a scenario is given for an object: its words and parts, and nothing behind them. what: for messages.
local function front(object, names, parts, what)
    local found, known = {}, {}
    for _, name in ipairs(names) do
        local method = object[name]
        found[name] = function(_, ...) return method(object, ...) end
        known[#known + 1] = name
    end
    for name, part in pairs(parts) do
        found[name] = part
        known[#known + 1] = name
    end
    table.sort(known)
    return setmetatable({}, {
        __index = function(_, key)
            if found[key] then return found[key] end
            error(("%s has no '%s'%s"):format(what, tostring(key), words.hint(tostring(key), known)), 2)
        end,
        __newindex = function() error(what .. " cannot be changed", 2) end,
        __metatable = false,
    })
end

--- setup: schema, goals, events and requests (declared), settings, instruments (names), landmarks, step_s; scenario: as
--- declared.
function Test.new(setup, scenario)
    local self = setmetatable({ scenario = scenario, step_s = setup.step_s, declared = setup.events,
        settings = setup.settings, eye = Eye.new(setup.schema, setup.goals, setup.requests), events = {},
        failures = {}, covered = {}, commands = {}, hands = {}, at = words.where(nil, scenario.line) }, Test)
    local instruments = {}
    for i, name in ipairs(setup.instruments) do
        local foot = name == microscope.name
        self.hands[i] = foot and Microscope.new(i - 1, self) or Hand.new(name, i - 1, setup.landmarks, self)
        instruments[name] = front(self.hands[i], foot and Microscope.public or Hand.public, {}, name)
    end
    self.t = front(self, Test.public, instruments, "t")
    return self
end

--- file:line of the scenario's line that runs.
function Test:where()
    self.at = words.where(nil, words.line_here() or self.scenario.line)
    return self.at
end

--- Hands the time on until the test is true: at once, if it is true now.
function Test:pause(where, test)
    while not test() do
        self.at = where
        coroutine.yield()
    end
end

function Test:pause_one_step(where)
    self.at = where
    coroutine.yield()
end

local function fail(self, where, message)
    local failures = self.failures
    failures[#failures + 1] = { where = where, message = message, time_s = self.eye.time_s }
end

-- Time: simulated, since the start ---------------------------------------------------------------------------------

function Test:time_s() return self.eye.time_s end

function Test:wait(seconds)
    local where = self:where()
    fields.check_value(seconds_rule, seconds, where, "wait: seconds")
    local until_s = self.eye.time_s + seconds
    self:pause(where, function() return self.eye.time_s >= until_s - 1e-9 end)
end

-- What the measures of a condition are now.
local function shown(eye, bound)
    local parts = {}
    for _, name in ipairs(bound.names()) do
        local value
        local get = eye:resolve(name)
        if get then value = get() end
        if math.type(value) == "float" then value = ("%.4g"):format(value) end
        parts[#parts + 1] = ("%s = %s"):format(name, value == nil and "undefined" or tostring(value))
    end
    return #parts > 0 and table.concat(parts, ", ") or "no measure"
end

local function text_of(value)
    if type(value) == "string" then return '"' .. value .. '"' end
    return type(value) == "table" and "all of a list in turn" or "a function to be true"
end

local function bind(self, value, where, what)
    return condition.bind(condition.read(value, where, what), self.eye, "in " .. what)
end

--- Waits until a condition holds; it fails when `longest` seconds pass first.
function Test:wait_until(value, longest)
    local where = self:where()
    fields.check_value(seconds_rule, longest, where, "wait_until: seconds")
    local wanted = bind(self, value, where, "wait_until")
    local until_s, met = self.eye.time_s + longest, false
    self:pause(where, function()
        met = wanted.test()
        return met or self.eye.time_s >= until_s - 1e-9
    end)
    if not met then
        fail(self, where, ("expected %s within %g s, seen after it: %s"):format(text_of(value), longest,
            shown(self.eye, wanted)))
    end
    return met
end

--- Runs several functions side by side, for instruments that move at once; goes on when all have ended.
function Test:together(...)
    local where = self:where()
    local threads = { ... }
    if #threads == 0 then words.fail(where, "together must be given functions") end
    for i, f in ipairs(threads) do
        if type(f) ~= "function" then words.fail(where, "together must be given functions") end
        threads[i] = coroutine.create(f)
    end
    while true do
        local alive = false
        for _, thread in ipairs(threads) do
            if coroutine.status(thread) ~= "dead" then
                local ok, message = coroutine.resume(thread)
                if not ok then error(message, 0) end
                alive = alive or coroutine.status(thread) ~= "dead"
            end
        end
        if not alive then return end
        coroutine.yield()
    end
end

-- Settings ---------------------------------------------------------------------------------------------------------

--- Sets machine settings from the next step on: t:set { ["phaco.power_limit"] = 0.4 }.
function Test:set(values)
    local where = self:where()
    fields.check_value({ kind = "table" }, values, where, "set")
    for _, name in ipairs(words.keys(values)) do
        local setting = self.settings[name]
        if not setting then
            words.fail(where, ("there is no setting '%s'%s"):format(name, words.hint(name, words.keys(self.settings))))
        end
        if not setting.live then
            words.fail(where, ("%s can only be set before the first step, by set = { ... } of the scenario"):format(
                name))
        end
        local value = values[name]
        fields.check_value({ kind = "number", from = setting.minimum, to = setting.maximum }, value, where, name)
        table.insert(self.commands, { kind = "set", name = name, value = value, text = "" })
    end
end

--- Asks the staff for something, or declares it, by its name in the exercise.
function Test:request(name)
    local where = self:where()
    local id, complaint = requests.find(self.eye.requests, name)
    if not id then words.fail(where, complaint) end
    table.insert(self.commands, requests.command(id))
end

-- Expectations -----------------------------------------------------------------------------------------------------

--- A condition holds now.
function Test:expect(value)
    local where = self:where()
    local wanted = bind(self, value, where, "expect")
    if wanted.test() then return true end
    fail(self, where, ("expected %s, seen: %s"):format(text_of(value), shown(self.eye, wanted)))
    return false
end

--- A measure (or a sum of some) is now within a tolerance of a value.
function Test:expect_near(measure, value, tolerance)
    local where = self:where()
    fields.check_value({ kind = "text" }, measure, where, "expect_near: measure")
    fields.check_value({ kind = "number" }, value, where, "expect_near: value")
    fields.check_value({ kind = "number", from = 0 }, tolerance, where, "expect_near: tolerance")
    local close = bind(self, ("abs((%s) - (%.17g)) <= %.17g"):format(measure, value, tolerance), where, "expect_near")
    if close.test() then return true end
    fail(self, where, ("expected %s within %g of %g, seen: %s"):format(measure, tolerance, value,
        shown(self.eye, close)))
    return false
end

--- The value of a measure now; nil when it is not defined.
function Test:value(measure)
    local where = self:where()
    local get, known = self.eye:resolve(measure)
    if not get then
        words.fail(where, ("unknown measure '%s'%s"):format(tostring(measure), words.hint(tostring(measure), known)))
    end
    return get()
end

-- The id of a declared error event, by its title or its id.
local function event_id(self, name, where)
    local known = {}
    for i, event in ipairs(self.declared) do
        if event.title == name or event.id == name then return event.id end
        known[i] = event.title
    end
    words.fail(where, ("the exercise has no error event '%s'%s"):format(tostring(name),
        words.hint(tostring(name), known)))
end

local outcomes = { open = "still open", recovered = "recovered", near_miss = "recovered at once",
    not_recovered = "not recovered" }

local function list_of_events(self)
    local parts = {}
    for i, event in ipairs(self.events) do
        local after = event.recovery_s and (" after %.2f s"):format(event.recovery_s) or ""
        parts[i] = ("\"%s\" at %.2f s, %s%s"):format(event.title, event.time_s, outcomes[event.outcome], after)
    end
    return #parts > 0 and table.concat(parts, "; ") or "no error event"
end

local function fits(event, recovered)
    if recovered == nil then return true end
    if recovered then return event.outcome == "recovered" or event.outcome == "near_miss" end
    return event.outcome == "not_recovered"
end

local function find_event(self, id, recovered)
    for _, event in ipairs(self.events) do
        if event.id == id and fits(event, recovered) then return event end
    end
    return nil
end

local function cover(self, id, outcome)
    self.covered[id] = self.covered[id] or {}
    self.covered[id].raised = true
    self.covered[id][outcome] = true
end

-- What an event that is still open needs to be put right, and how things are.
function Test:still_lacking(id)
    local open = false
    for _, event in ipairs(self.events) do open = open or (event.id == id and event.outcome == "open") end
    for _, event in ipairs(self.declared) do
        if open and event.id == id and event.recovered then
            local wanted = bind(self, event.recovered, "?", "recovered")
            return ("; it is put right by \"%s\", now: %s"):format(event.recovered, shown(self.eye, wanted))
        end
    end
    return ""
end

local event_rules = { recovered = { kind = "yes_no" }, within = { kind = "number", default = 0, from = 0, to = 7200 } }

--- An error event has happened. recovered = true: and was put right; false: and its deadline passed; within: seconds to
--- wait for that.
function Test:expect_event(name, given)
    local where = self:where()
    local id = event_id(self, name, where)
    local options = fields.read(given or {}, event_rules, "expect_event", words.line_here())
    local until_s, found = self.eye.time_s + options.within, nil
    self:pause(where, function()
        found = find_event(self, id, options.recovered)
        return found ~= nil or self.eye.time_s >= until_s - 1e-9
    end)
    if found then
        cover(self, id, found.outcome == "near_miss" and "recovered" or found.outcome)
        return true
    end
    local how = options.recovered == nil and "" or options.recovered and " recovered" or " not recovered"
    local limit = options.within > 0 and (" within %g s"):format(options.within) or ""
    local still = options.recovered and self:still_lacking(id) or ""
    fail(self, where, ("expected error event \"%s\"%s%s, seen: %s%s"):format(name, how, limit, list_of_events(self),
        still))
    return false
end

--- An error event has not happened so far; without a name: none has.
function Test:expect_no_event(name)
    local where = self:where()
    local id = name ~= nil and event_id(self, name, where)
    for _, event in ipairs(self.events) do
        if not id or event.id == id then
            fail(self, where, ("expected no error event%s, seen: %s"):format(id and " \"" .. name .. "\"" or "",
                list_of_events(self)))
            return false
        end
    end
    return true
end

-- The run ----------------------------------------------------------------------------------------------------------

local function check_twin(self)
    local where = words.where("silent_twin_of", self.scenario.line)
    if self.near and not self.near.came then fail(self, self.near.where, self.near:lacking()) end
    for _, name in ipairs(self.scenario.silent_twin_of) do
        local id = event_id(self, name, where)
        if find_event(self, id) then
            fail(self, where, ("expected to the end no error event \"%s\", seen: %s"):format(name,
                list_of_events(self)))
        else
            self.covered[id] = self.covered[id] or {}
            self.covered[id].silent = true
        end
    end
end

local function go_on(self)
    local ok, message = coroutine.resume(self.thread)
    if not ok then error(message, 0) end
    if coroutine.status(self.thread) == "dead" then
        check_twin(self)
        return true
    end
    return false
end

function Test:begin()
    for _, name in ipairs(self.scenario.silent_twin_of) do  -- before any time is spent
        event_id(self, name, words.where("silent_twin_of", self.scenario.line))
    end
    local near = self.scenario.near
    if near then self.near = Near.new(near, self.eye, words.where("near", self.scenario.line)) end
    self.thread = coroutine.create(function() self.scenario.play(self.t) end)
end

--- One step: what is observed now and the events so far; gives samples, commands and whether it is over.
function Test:step(time_s, row, events)
    self.eye:look(time_s, row, 0)
    if self.near then self.near:look() end
    for _, command in ipairs(self.commands) do
        if command.kind == "request" then self.eye:hear(command.name) end
    end
    self.events = events
    self.commands = {}
    if go_on(self) then return { done = true } end
    if time_s >= self.scenario.time_limit_s then
        fail(self, self.at, ("expected an end within %g s of simulated time, seen: it still runs here"):format(
            self.scenario.time_limit_s))
        return { done = true }
    end
    local samples = {}
    for i, hand in ipairs(self.hands) do samples[i] = hand:sample(self.step_s) end
    return { samples = samples, commands = self.commands, done = false }
end

--- What the exercise makes of it at the end (as report.json has it): no item that an error concerns has more points
--- than the rubric leaves it after such an error.
function Test:judged(result)
    for _, event in ipairs(result.osacss and result.events or {}) do
        local cap = scoring.cap_of(result.osacss.caps, event)
        local concerned = {}
        for _, id in ipairs(event.items) do concerned[id] = cap end
        for _, item in ipairs(result.osacss.items) do
            if concerned[item.id] and item.score and item.score > concerned[item.id] then
                fail(self, self.at, ("expected at most %g points in %s after error event \"%s\", %s, seen: %g")
                    :format(cap, item.id, event.title, outcomes[event.outcome], item.score))
            end
        end
    end
end

--- The kernel did not take what was asked for in the last step.
function Test:refused(why) fail(self, self.at, why) end

return Test
