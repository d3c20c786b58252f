-- SPDX-License-Identifier: GPL-3.0-or-later
-- Warnings while there is still time: rules on measures and on how fast they change (theatre/warnings.lua).
--
--   watching -- the sign shows for hold_s --> raised -- it has ceased for quiet_s --> watching again
--
-- They are told to whoever looks at the theatre's monitor, and to a trainee who asked for them, and judge nothing. Each
-- is kept with the time at which what it warned of came, if it came within counts_s.

local condition = require "engine.condition"
local expression = require "engine.expression"
local words = require "engine.words"

local warnings = {}

local hold_s = 0.05   -- so long must the sign show
local quiet_s = 2.0   -- so long must it have ceased
local counts_s = 10   -- later, what was warned of has come by something else

local Watch = {}
Watch.__index = Watch

local function where_of(rule) return "warning '" .. rule.id .. "'" end

-- The quantity of a text as a function, or nil where the scene has not what it names.
local function quantity(value, rule, eye, names)
    if type(value) == "number" then return function() return value end end
    local part = expression.parse(value, where_of(rule))
    for _, name in ipairs(part.names) do
        if not eye:resolve(name) then return nil end
        if eye.info[name] then names[#names + 1] = name end
    end
    return expression.bind(part, function(name) return eye:resolve(name) end)
end

-- A condition of a text likewise.
local function test_of(text, rule, eye, names)
    local parts = condition.read(text, where_of(rule), "when")
    for _, part in ipairs(parts) do
        for _, name in ipairs(part.names or {}) do
            if not eye:resolve(name) then return nil end
            if eye.info[name] then names[#names + 1] = name end
        end
    end
    return condition.bind(parts, eye, where_of(rule))
end

--- Starts to watch by a rule; nil where the scene has not the measures that it names.
function warnings.watch(rule, eye)
    local self = setmetatable({ rule = rule, eye = eye, past = {}, first = 1, last = 0, names = {} }, Watch)
    self.when = test_of(rule.when, rule, eye, self.names)
    self.outcome = test_of(rule.of, rule, eye, {})
    if not (self.when and self.outcome) then return nil end
    local heading = rule.rises or rule.falls
    if heading then
        self.value, self.limit = quantity(heading, rule, eye, self.names), quantity(rule.to, rule, eye, self.names)
        if not (self.value and self.limit) then return nil end
    end
    return self
end

-- Its change per second over the last over_s; nil until it is known for so long, or while it is not defined.
local function rate(self, time_s, value)
    if value == nil then
        self.past, self.first, self.last = {}, 1, 0
        return nil
    end
    self.last = self.last + 1
    self.past[self.last] = { time_s = time_s, value = value }
    while self.first < self.last and self.past[self.first + 1].time_s <= time_s - self.rule.over_s + 1e-9 do
        self.past[self.first] = nil
        self.first = self.first + 1
    end
    local before = self.past[self.first]
    local span = time_s - before.time_s
    return span >= self.rule.over_s - 1e-9 and (value - before.value) / span or nil
end

-- Whether it is at its limit, or on its way there in time.
local function heads_there(self, time_s)
    if not self.value then return true end
    local value, limit = self.value(), self.limit()
    local speed = rate(self, time_s, value)
    if value == nil or limit == nil then return false end
    local ahead = value + (speed or 0) * self.rule.within_s
    if self.rule.rises then return value >= limit or ahead >= limit end
    return value <= limit or ahead <= limit
end

-- What was warned of has come: all that warned of it in time were right.
local function note_outcome(self, time_s, log)
    local now = self.outcome.test()
    if now and not self.there then
        for _, record in ipairs(log) do
            if record.id == self.rule.id and not record.came_s and time_s - record.time_s <= counts_s then
                record.came_s = time_s
            end
        end
    end
    self.there = now
end

local function evidence_of(self)
    local evidence = words.as_object({})
    for _, name in ipairs(self.names) do evidence[name] = self.eye:value(name) end
    return evidence
end

--- One step. log: list of the warnings so far, which grows. translated: what makes a text one of the run's language.
function Watch:tick(time_s, log, translated)
    local headed = heads_there(self, time_s)
    note_outcome(self, time_s, log)
    if not (headed and not self.there and self.when.test()) then
        self.since = nil
        if self.record and time_s - self.seen_s >= quiet_s then self.record = nil end
        return
    end
    self.since, self.seen_s = self.since or time_s, time_s
    if self.record or time_s - self.since < hold_s - 1e-9 then return end
    self.record = { id = self.rule.id, title = translated(self.rule.title), advice = translated(self.rule.advice),
        time_s = time_s, evidence = evidence_of(self) }
    table.insert(log, self.record)
end

--- Whether the sign shows now, or did a moment ago.
function Watch:raised() return self.record ~= nil end

return warnings
