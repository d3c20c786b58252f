-- SPDX-License-Identifier: GPL-3.0-or-later
-- What `when`, `done`, `recovered` may be: a text ("groove.length_mm >= 4"), a function of the eye, or a list of them
-- that must come true one after the other. All become the same thing here.

local expression = require "engine.expression"
local kinds = require "engine.kinds"
local words = require "engine.words"

local condition = {}

local function check_one(value, where, field)
    if type(value) == "string" then return expression.parse(value, where) end
    if type(value) == "function" then return { call = value, where = where, text = "a function" } end
    words.fail(where, ("'%s' must be a condition: a text such as \"groove.length_mm >= 4\", or a function of the eye")
        :format(field))
end

--- Reads a condition when a curriculum loads. Returns a list of parts, in order.
function condition.read(value, where, field)
    if type(value) ~= "table" then return { check_one(value, where, field) } end
    local parts = {}
    for i, part in ipairs(value) do parts[i] = check_one(part, where, field) end
    if #parts == 0 then words.fail(where, ("'%s' is an empty list of conditions"):format(field)) end
    return parts
end

-- Says in plain words what a function that met nil has met: the measures that it read and that are not defined now.
local function explain(message, eye)
    if not message:find("nil", 1, true) then return message end
    for i = #eye.read, 1, -1 do
        if eye:value(eye.read[i]) == nil then
            return message .. (": %s is not defined at this moment (is the instrument outside the eye?); test it first,"
                .. " or write the condition as a text, where such a comparison is simply false"):format(eye.read[i])
        end
    end
    return message
end

--- Calls a part of a curriculum and returns its result and the names of the measures that it read. A failure is raised
--- as one line that names file:line and what was running.
function condition.call(eye, context, f, ...)
    eye.read = {}
    local ok, result = pcall(f, ...)
    local read = eye.read
    if ok then
        eye.read = nil
        return result, read
    end
    local message = explain(tostring(result), eye)
    eye.read = nil
    if not message:find("^[^:\n]+:%d+: ") then message = context.where .. ": " .. message end
    error(message .. " (" .. context.what .. ")", 0)
end

-- One part as { test = function() -> boolean, names = measures it reads, known only after a test for functions }.
local function bind_part(part, eye, what)
    local context = { where = part.where, what = what }
    if part.call then
        local bound = { names = {} }
        function bound.test()
            local result
            result, bound.names = condition.call(eye, context, part.call, eye.view)
            return result and true or false
        end
        return bound
    end
    local value = expression.bind(part, function(name) return eye:resolve(name) end)
    local complaint = kinds.complaint(part, function(name) return eye:is_yes_no(name) end)
    if complaint then words.fail(part.where, ("%s (%s)"):format(complaint, what)) end
    return { names = part.names, test = function() return condition.call(eye, context, value) and true or false end }
end

--- Binds the parts to an eye. The result's test() is true once all parts have come true in order; reset() starts over.
function condition.bind(parts, eye, what)
    local bound, at = {}, 1
    for i, part in ipairs(parts) do bound[i] = bind_part(part, eye, what) end
    local self = {}
    function self.reset() at = 1 end
    function self.test()
        while bound[at] and bound[at].test() do
            if at == #bound then return true end
            at = at + 1
        end
        return false
    end
    --- Names of the measures that the parts read.
    function self.names()
        local names, seen = {}, {}
        for _, part in ipairs(bound) do
            for _, name in ipairs(part.names) do
                if not seen[name] then names[#names + 1] = name end
                seen[name] = true
            end
        end
        return names
    end
    return self
end

return condition
