-- SPDX-License-Identifier: GPL-3.0-or-later
-- What the function of a step may call: act.say, .wait, .wait_until, .picture, .set. A wrong value ends the exercise
-- with the line on which it was given: left alone, it would only be a warning in a log that nobody reads.

local condition = require "engine.condition"
local fields = require "engine.fields"
local settings_check = require "engine.settings_check"
local words = require "engine.words"

local act = {}

local Act = {}

-- "file:line" of the call; of the step, where it cannot be told.
local function here(self)
    local file, line = words.outside()
    return file and file .. ":" .. line or self.step_where
end

local function text(self, value, name) fields.check_value({ kind = "text" }, value, here(self), name) end

-- seconds: none are as good as none at all; without an end only where `endless`.
local function seconds(self, value, name, endless)
    local number = math.type(value) and value == value
    if not number or value < 0 or (value == math.huge and not endless) then
        words.fail(here(self), ("%s must be a number of seconds, 0 or more, not %s"):format(name, fields.shown(value)))
    end
end

function Act:say(value)
    text(self, value, "act.say")
    self.out.say(value)
end

function Act:picture(name, caption)
    text(self, name, "act.picture: name")
    if caption ~= nil then text(self, caption, "act.picture: caption") end
    self.out.picture(name, caption)
end

function Act:set(name, value)
    text(self, name, "act.set: setting")
    if type(value) == "boolean" then value = value and 1 or 0 end
    fields.check_value({ kind = "number" }, value, here(self), "act.set: " .. name)
    local complaint = settings_check.live_complaint(name, value)
    if complaint then words.fail(here(self), "act.set: " .. complaint) end
    self.out.set(name, value)
end

-- Waiting hands back a test, which is true when to go on.
function Act:wait(value)
    seconds(self, value, "act.wait")
    local until_s = self.eye.time_s + value
    coroutine.yield(function() return self.eye.time_s >= until_s - 1e-9 end)
end

-- True when the condition came true, false when timeout_s passed first.
function Act:wait_until(given, timeout_s)
    if timeout_s ~= nil then seconds(self, timeout_s, "act.wait_until: the longest time", true) end
    local wanted = condition.bind(condition.read(given, here(self), "wait_until"), self.eye, self.what)
    local until_s = self.eye.time_s + (timeout_s or math.huge)
    local met = false
    coroutine.yield(function()
        met = wanted.test()
        return met or self.eye.time_s >= until_s - 1e-9
    end)
    return met
end

--- out: say, picture, set of the run; what: "in step 'a'"; where: of the step. Returns the table that scripts get.
function act.words(out, eye, what, where)
    local self = { out = out, eye = eye, what = what, step_where = where }
    local env = {}
    for _, name in ipairs(words.keys(Act)) do
        env[name] = function(...)
            local result = Act[name](self, ...)  -- no tail call: the line of who calls stays known
            return result
        end
    end
    return setmetatable(env, { __index = function(_, name)
        words.fail(here(self), ("act has no '%s'%s"):format(tostring(name), words.hint(tostring(name),
            words.keys(Act))))
    end })
end

return act
