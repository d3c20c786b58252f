-- SPDX-License-Identifier: GPL-3.0-or-later
-- The steps of an exercise, one after the other. A step whose turn has come waits until its condition `enter_when`
-- holds, at most enter_limit_s: then it is left out, undone. It is done when its condition `done` holds, or when its
-- `script` has run to its end; its time limit ends it undone. What follows is the next in the list, or the step that
-- `next` names, or `next_late` after the time limit; what is passed over that way counts for nothing.

local act = require "engine.act"
local condition = require "engine.condition"
local words = require "engine.words"

local steps = {}

local Runner = {}
Runner.__index = Runner

--- Prepares all steps of an exercise. out: functions say, picture, set that scripts of steps may use.
function steps.prepare(declared, eye, out)
    local self = setmetatable({ declared = declared, eye = eye, act = out, at = 0, records = {}, bound = {} }, Runner)
    for i, step in ipairs(declared) do
        local what = "in step '" .. step.title .. "'"
        local function bind(parts) return parts and words.try(condition.bind, parts, eye, what) end
        self.bound[i] = { what = what, done = bind(step.done), enter = bind(step.enter_when),
            picture = bind(step.picture_when) }
        self.records[i] = { id = step.id, title = step.title, completed = false }
    end
    return self
end

local function enter(self, time_s)
    local step, record = self.declared[self.at], self.records[self.at]
    self.waiting = false
    record.start_s = time_s
    self.hint = step.hint
    if step.script then
        local env = act.words(self.act, self.eye, self.bound[self.at].what, step.where)
        self.thread = coroutine.create(function() step.script(self.eye.view, env) end)
        self.go_on = nil
    end
end

local function entered(self)
    local wanted = self.bound[self.at].enter
    return not wanted or wanted.test()
end

-- The turn of step `at` has come.
local function turn_to(self, at, time_s)
    for i = self.at + 1, math.min(at - 1, #self.declared) do self.records[i].skipped = true end
    self.at, self.turn_s, self.turned = at, time_s, true
    if not self.declared[at] then return end
    self.waiting = true
    if entered(self) then enter(self, time_s) end
end

-- In teaching mode, the hint of a step that is not done after hint_after_s.
local function give_hint(self, time_s)
    local step = self.declared[self.at]
    if self.hint and not self.waiting and time_s - self.records[self.at].start_s >= step.hint_after_s - 1e-9 then
        self.act.hint(self.hint)
        self.hinted, self.hint = self.hint, nil
    end
end

-- Runs the script of the step as far as it goes now. True once it has run to its end.
local function run_script(self)
    if coroutine.status(self.thread) == "dead" then return true end
    if self.go_on and not self.go_on() then return false end
    local ok, result = coroutine.resume(self.thread)
    if not ok then
        local message, what = tostring(result), " (" .. self.bound[self.at].what .. ")"
        error(message:find(what, 1, true) and message or message .. what, 0)
    end
    self.go_on = result
    return coroutine.status(self.thread) == "dead"
end

-- At the moment that a step wants to have in the report, once.
local function take_picture(self)
    local bound = self.bound[self.at]
    if not bound.picture or bound.pictured or not bound.picture.test() then return end
    bound.pictured = true
    self.act.during(self.records[self.at])
end

local function is_done(self, step)
    local scripted = true
    if step.script then scripted = run_script(self) end
    local done = self.bound[self.at].done
    if done then return done.test() end
    return scripted
end

local function follower(self, late)
    local step = self.declared[self.at]
    return late and step.next_late_at or step.next_at or self.at + 1
end

local function finish(self, completed, late, time_s)
    local record = self.records[self.at]
    record.completed, record.end_s = completed, time_s
    self.act.step_ended(record)
    turn_to(self, follower(self, late and not completed), time_s)
end

-- A step whose turn has come and that has not begun.
local function wait(self, time_s)
    local step, record = self.declared[self.at], self.records[self.at]
    if entered(self) then
        enter(self, time_s)
    elseif step.enter_limit_s and time_s - self.turn_s >= step.enter_limit_s - 1e-9 then
        record.not_entered, self.waiting = true, false
        turn_to(self, follower(self, true), time_s)
    end
end

--- One step of time: at most one step of the exercise ends, and the next begins.
function Runner:tick(time_s)
    if self.at == 0 then turn_to(self, 1, time_s) end
    local step = self.declared[self.at]
    if not step then return end
    if self.waiting then wait(self, time_s) end
    if self.waiting or not self.declared[self.at] then return end
    if self.declared[self.at] == step then
        take_picture(self)
        local completed = is_done(self, step)
        local late = step.time_limit_s and time_s - self.records[self.at].start_s >= step.time_limit_s
        if completed or late then finish(self, completed, late, time_s) end
    end
    if self.declared[self.at] then give_hint(self, time_s) end
end

--- True once after each time that the turn has come to another step.
function Runner:has_turned()
    local turned = self.turned
    self.turned = false
    return turned == true
end

--- What the steps of a changed exercise go on from: see take_up.
function Runner:left() return { steps = self.records, at = self:turn(), hinted = self.hinted } end

--- Id of the step whose turn it is, begun or not.
function Runner:turn() return self.declared[self.at] and self.declared[self.at].id end

-- The place in the list of the step whose turn it is: by its name, or the first that has not had its turn.
local function place_of(self, id)
    for i, step in ipairs(self.declared) do
        if step.id == id then return i end
    end
    for i, record in ipairs(self.records) do
        if not record.end_s and not record.skipped and not record.not_entered then return i end
    end
    return #self.declared + 1
end

--- Goes on where the steps of the exercise before it was changed had come to: what is known of steps of the same name
--- stays known.
function Runner:take_up(left, time_s)
    local known = {}
    for _, record in ipairs(left.steps) do known[record.id] = record end
    for i, record in ipairs(self.records) do
        local before = known[record.id]
        if before and record.id ~= left.at then
            self.records[i] = before
            before.title = record.title
        end
    end
    local at = place_of(self, left.at)
    self.at = at
    turn_to(self, at, time_s)
    if self.hint and self.hint == left.hinted then self.hint = nil end
end

--- Ends the step that runs, undone.
function Runner:stop(time_s)
    local record = self.records[self.at]
    if record and record.start_s and not record.end_s then record.end_s = time_s end
end

--- Id of the step that runs; "" while one waits for its condition to begin.
function Runner:current()
    return not self.waiting and self.declared[self.at] and self.declared[self.at].id or ""
end

function Runner:since() return self.records[self.at] and self.records[self.at].start_s or 0 end

--- All steps have had their turn.
function Runner:over() return self.at > #self.declared end

--- Record of the first step that was to be done and is not; nil: all are.
function Runner:first_undone()
    for _, record in ipairs(self.records) do
        if not record.completed and not record.skipped then return record end
    end
    return nil
end

--- Where the tip is to be in the step that runs, as the exercise marks it; none while one waits for it.
function Runner:marks()
    local step = self.declared[self.at]
    return step and not self.waiting and step.marks or {}
end

function Runner:all_completed()
    return self:first_undone() == nil
end

return steps
