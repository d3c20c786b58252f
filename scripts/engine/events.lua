-- SPDX-License-Identifier: GPL-3.0-or-later
-- The life of an error event:
--
--   watching -- `when` holds for hold_s --> raised -- `recovered` comes true --> over --> watching again
--                                             |                                 ^
--                                             +-- deadline_s passes: lost ------+ (once `when` has ceased)
--
-- An error that is put right within near_miss_s, without `harm`, was a near miss. What the eye has from the start is
-- not the operator's error but the task: such an event is `given`, until what makes it so has ceased for once. Nothing
-- here ends an exercise unless the curriculum says ends_exercise.

local condition = require "engine.condition"
local words = require "engine.words"

local events = {}

local Watch = {}
Watch.__index = Watch

--- Starts to watch for one declared error event. task: what holds at the first observation is given, not made: not so
--- in an operation, whose earlier parts made it.
function events.watch(declared, eye, task)
    local what = "in error event '" .. declared.title .. "'"
    local function bind(parts) return parts and words.try(condition.bind, parts, eye, what) end
    local self = setmetatable({ declared = declared, eye = eye, state = "watching" }, Watch)
    self.when, self.recovered, self.harm = bind(declared.when), bind(declared.recovered), bind(declared.harm)
    self.there = task and bind(declared.given or declared.when) or nil
    for _, name in ipairs(declared.evidence or {}) do
        if not eye.info[name] then
            words.mistake(declared.where, ("evidence: unknown measure '%s'%s"):format(name,
                words.hint(name, eye.names)))
        else
            eye.used[name] = true
        end
    end
    return self
end

-- The measures that tell of the error, with their values now.
local function evidence_of(self)
    local evidence = words.as_object({})
    local function add(name)
        if self.eye.info[name] then evidence[name] = self.eye:value(name) end
    end
    for _, name in ipairs(self.when.names()) do add(name) end
    for _, name in ipairs(self.declared.evidence or {}) do add(name) end
    return evidence
end

local function raise(self, step, log)
    local declared = self.declared
    self.state = "raised"
    self.when.reset()
    if self.recovered then self.recovered.reset() end
    self.right_since = nil
    self.record = { id = declared.id, title = declared.title, step = step, time_s = self.since,
        severity = declared.severity, items = declared.items or {}, advice = declared.advice, cue = declared.cue,
        evidence = evidence_of(self), recovered = false, outcome = "open", harmed = false,
        given = self.there and true or nil,
        consequences = words.as_object({ texts = declared.consequences.texts,
            settings = words.as_object(declared.consequences.settings) }) }
    table.insert(log.events, self.record)
    log.raised(self.record, declared)
end

local function close(self, outcome, time_s, log)
    self.record.outcome = outcome
    self.record.recovered = outcome == "recovered" or outcome == "near_miss"
    if self.record.recovered then self.record.recovery_s = time_s - self.record.time_s end
    log.closed(self.record, self.declared)
    self.state = "over"
    self.calm_since = nil
end

local function watch(self, time_s, step, log)
    if not self.when.test() then
        self.since = nil
        return
    end
    self.since = self.since or time_s
    if time_s - self.since >= self.declared.hold_s - 1e-9 then raise(self, step, log) end
end

-- What was asked for before an error puts nothing right.
local function recovered_now(self)
    self.eye.asked_since = self.record.time_s
    local right = self.recovered.test()
    self.eye.asked_since = nil
    return right
end

-- Whether the error is put right, and has been for as long as is asked.
local function is_right(self, time_s)
    if not (self.recovered and recovered_now(self)) then
        self.right_since = nil
        return false
    end
    self.right_since = self.right_since or time_s
    return time_s - self.right_since >= self.declared.recovered_hold_s - 1e-9
end

local function follow(self, time_s, log)
    local declared, record = self.declared, self.record
    if self.harm and self.harm.test() then record.harmed = true end
    local elapsed = time_s - record.time_s
    if is_right(self, time_s) then
        local near = not record.harmed and elapsed <= declared.near_miss_s + 1e-9
        close(self, near and "near_miss" or "recovered", time_s, log)
    elseif elapsed > declared.deadline_s and not self.right_since then
        close(self, "not_recovered", time_s, log)
    end
end

-- The same trembling tip must not raise an event ten times a second: `when` has to rest for quiet_s.
local function calm(self, time_s)
    if self.when.test() then
        self.calm_since = nil
        return
    end
    self.calm_since = self.calm_since or time_s
    if time_s - self.calm_since < self.declared.quiet_s then return end
    self.state, self.since = "watching", nil
    self.when.reset()
end

--- One step. step: id of the running step. log: { events, raised(record, declared), closed(record, declared) }.
function Watch:tick(time_s, step, log)
    if self.there and not self.there.test() then self.there = nil end
    if self.state == "watching" then
        local wanted = self.declared.in_steps
        if not wanted or wanted[step] then watch(self, time_s, step, log) end
    elseif self.state == "raised" then
        follow(self, time_s, log)
    else
        calm(self, time_s)
    end
end

--- What the watch of a changed exercise goes on from. index_of: of a record in the list of events.
function Watch:left(index_of)
    return { id = self.declared.id, state = self.state, since = self.since, right_since = self.right_since,
        calm_since = self.calm_since, given = self.there ~= nil, record = self.record and index_of[self.record] }
end

--- Goes on where the event of the same name had come to. records: the events so far.
function Watch:take_up(left, records)
    self.state, self.since, self.right_since, self.calm_since = left.state, left.since, left.right_since,
        left.calm_since
    self.record = left.record and records[left.record]
    if not left.given then self.there = nil end
end

--- The exercise is over: what is still open was not put right.
function Watch:finish(time_s, log)
    if self.state == "raised" then close(self, "not_recovered", time_s, log) end
end

return events
