-- SPDX-License-Identifier: GPL-3.0-or-later
-- Warnings while there is still time: rules on measures and on how fast they change (theatre/warnings.lua).
--
--   watching -- a sign shows for hold_s --> raised -- it has ceased for quiet_s --> watching again
--
-- They are told to whoever looks at the theatre's monitor, and to a trainee who asked for them, and judge nothing. Each
-- is kept with the time at which what it warned of came, if it came within counts_s.

local condition = require "engine.condition"
local expression = require "engine.expression"
local words = require "engine.words"

local warnings = {}

local hold_s = 0.05   -- so long must the sign show
local quiet_s = 10    -- so long must it have ceased
local apart_s = 2     -- a sign that comes back later than this shows anew, though it is the same warning
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

-- One sign of a rule; nil where the scene has not the measures that it names.
local function bind_sign(sign, rule, eye, names)
    local bound = { declared = sign, past = {}, first = 1, last = 0, when = test_of(sign.when, rule, eye, names) }
    if not bound.when then return nil end
    local heading = sign.rises or sign.falls
    if heading then
        bound.value, bound.limit = quantity(heading, rule, eye, names), quantity(sign.to, rule, eye, names)
        if not (bound.value and bound.limit) then return nil end
    end
    return bound
end

--- Starts to watch by a rule; nil where the scene has not the measures that it names.
function warnings.watch(rule, eye)
    local self = setmetatable({ rule = rule, eye = eye, names = {}, signs = {} }, Watch)
    self.outcome = test_of(rule.of, rule, eye, {})
    for _, sign in ipairs(rule.signs) do table.insert(self.signs, bind_sign(sign, rule, eye, self.names)) end
    return self.outcome and #self.signs > 0 and self or nil
end

-- The change per second of a sign's quantity over the last over_s; nil until it is known for so long, or while it is
-- not defined.
local function rate(sign, time_s, value)
    if value == nil then
        sign.past, sign.first, sign.last = {}, 1, 0
        return nil
    end
    local over_s = sign.declared.over_s
    sign.last = sign.last + 1
    sign.past[sign.last] = { time_s = time_s, value = value }
    while sign.first < sign.last and sign.past[sign.first + 1].time_s <= time_s - over_s + 1e-9 do
        sign.past[sign.first] = nil
        sign.first = sign.first + 1
    end
    local before = sign.past[sign.first]
    local span = time_s - before.time_s
    return span >= over_s - 1e-9 and (value - before.value) / span or nil
end

-- Whether it is at its limit, or on its way there in time.
local function heads_there(sign, time_s)
    if not sign.value then return true end
    local value, limit = sign.value(), sign.limit()
    local speed = rate(sign, time_s, value)
    if value == nil or limit == nil then return false end
    local ahead = value + (speed or 0) * sign.declared.within_s
    if sign.declared.rises then return math.max(value, ahead) >= limit end
    return math.min(value, ahead) <= limit
end

-- All signs are looked at, for each remembers how its quantity changes.
local function any_shows(self, time_s)
    local shows = false
    for _, sign in ipairs(self.signs) do
        local headed = heads_there(sign, time_s)
        shows = headed and sign.when.test() or shows
    end
    return shows
end

-- What was warned of has come: all that warned of it in time were right.
local function note_outcome(self, time_s, log)
    local now = self.outcome.test()
    if now and not self.there then
        local came = { id = self.rule.id, time_s = time_s }
        for _, record in ipairs(log) do
            local showed_s = record.again_s or record.time_s
            if record.id == self.rule.id and not record.came_s and time_s - showed_s <= counts_s then
                record.came_s = time_s
                came.warned_s = came.warned_s or time_s - showed_s
            end
        end
        table.insert(log.came, came)
    end
    self.there = now
end

local function evidence_of(self)
    local evidence = words.as_object({})
    for _, name in ipairs(self.names) do evidence[name] = self.eye:value(name) end
    return evidence
end

--- One step. log: list of the warnings so far, which grows, and as its field `came` what came of what is warned of,
--- with how long before it was warned, if it was. translated: what makes a text one of the run's language.
function Watch:tick(time_s, log, translated)
    self.time_s = time_s
    local shows = any_shows(self, time_s)
    note_outcome(self, time_s, log)
    if self.there or not shows then
        self.since = nil
        if self.record and time_s - self.seen_s >= quiet_s then self.record = nil end
        return
    end
    if self.record and time_s - self.seen_s >= apart_s then self.record.again_s = time_s end
    self.since, self.seen_s = self.since or time_s, time_s
    if self.record or time_s - self.since < hold_s - 1e-9 then return end
    self.record = { id = self.rule.id, title = translated(self.rule.title), advice = translated(self.rule.advice),
        time_s = time_s, evidence = evidence_of(self) }
    table.insert(log, self.record)
end

--- The warning, if a sign of it shows now or did a moment ago; else nil.
function Watch:raised() return self.record and self.time_s - self.seen_s < apart_s and self.record or nil end

return warnings
