-- SPDX-License-Identifier: GPL-3.0-or-later
-- The steps of an exercise, one after the other. A step is done when its condition `done` holds, or when its `script`
-- has run to its end; its time limit ends it undone, and the exercise goes on with the next.

local condition = require "engine.condition"

local steps = {}

local Runner = {}
Runner.__index = Runner

--- Prepares all steps of an exercise. act: functions say, picture, set that scripts of steps may use.
function steps.prepare(declared, eye, act)
    local self = setmetatable({ declared = declared, eye = eye, act = act, at = 0, records = {}, bound = {} }, Runner)
    for i, step in ipairs(declared) do
        local what = "in step '" .. step.title .. "'"
        self.bound[i] = { what = what, done = step.done and condition.bind(step.done, eye, what) }
        self.records[i] = { id = step.id, title = step.title, completed = false }
    end
    return self
end

-- What the function of a step may call. Waiting hands back a test, which is true when to go on.
local function script_words(self, what, where)
    local env = { say = self.act.say, picture = self.act.picture, set = self.act.set }
    function env.wait(seconds)
        local until_s = self.eye.time_s + seconds
        coroutine.yield(function() return self.eye.time_s >= until_s - 1e-9 end)
    end
    --- True when the condition came true, false when timeout_s passed first.
    function env.wait_until(text_or_function, timeout_s)
        local parts = condition.read(text_or_function, where, "wait_until")
        local wanted = condition.bind(parts, self.eye, what)
        local until_s = self.eye.time_s + (timeout_s or math.huge)
        local met = false
        coroutine.yield(function()
            met = wanted.test()
            return met or self.eye.time_s >= until_s - 1e-9
        end)
        return met
    end
    return env
end

local function begin(self, time_s)
    self.at = self.at + 1
    local step, record = self.declared[self.at], self.records[self.at]
    if not step then return end
    record.start_s = time_s
    if step.hint then self.act.hint(step.hint) end
    if step.script then
        local env = script_words(self, self.bound[self.at].what, step.where)
        self.thread = coroutine.create(function() step.script(self.eye.view, env) end)
        self.go_on = nil
    end
end

-- Runs the script of the step as far as it goes now. True once it has run to its end.
local function run_script(self)
    if coroutine.status(self.thread) == "dead" then return true end
    if self.go_on and not self.go_on() then return false end
    local ok, result = coroutine.resume(self.thread)
    if not ok then error(tostring(result) .. " (" .. self.bound[self.at].what .. ")", 0) end
    self.go_on = result
    return coroutine.status(self.thread) == "dead"
end

local function is_done(self, step)
    local scripted = true
    if step.script then scripted = run_script(self) end
    local done = self.bound[self.at].done
    if done then return done.test() end
    return scripted
end

local function finish(self, completed, time_s)
    local record = self.records[self.at]
    record.completed, record.end_s = completed, time_s
    self.act.step_ended(record)
end

--- One step of time: at most one step of the exercise ends, and the next begins.
function Runner:tick(time_s)
    if self.at == 0 then begin(self, time_s) end
    local step = self.declared[self.at]
    if not step then return end
    local completed = is_done(self, step)
    local late = step.time_limit_s and time_s - self.records[self.at].start_s >= step.time_limit_s
    if completed or late then
        finish(self, completed, time_s)
        begin(self, time_s)
    end
end

--- Ends the step that runs, undone.
function Runner:stop(time_s)
    local record = self.records[self.at]
    if record and record.start_s and not record.end_s then record.end_s = time_s end
end

function Runner:current() return self.declared[self.at] and self.declared[self.at].id or "" end

function Runner:since() return self.records[self.at] and self.records[self.at].start_s or 0 end

--- All steps have had their turn.
function Runner:over() return self.at > #self.declared end

function Runner:all_completed()
    for _, record in ipairs(self.records) do
        if not record.completed then return false end
    end
    return true
end

return steps
