-- SPDX-License-Identifier: GPL-3.0-or-later
-- Whether a silent twin came near what it must not raise: `near` of a scenario must hold at some time in it. What its
-- measures went through is kept, for the message of a twin that stayed away.

local condition = require "engine.condition"

local Near = {}
Near.__index = Near

--- parts: the condition, as condition.read gives it; where: file:line of it.
function Near.new(parts, eye, where)
    return setmetatable({ wanted = condition.bind(parts, eye, "in near"), eye = eye, where = where, came = false,
        seen = {} }, Near)
end

-- Smallest and largest value of each measure that the condition reads; of one that is true or false, as 1 or 0.
local function note(self)
    for _, name in ipairs(self.wanted.names()) do
        local get = self.eye:resolve(name)
        local value = get and get()
        if type(value) == "boolean" then value = value and 1 or 0 end
        if value then
            local range = self.seen[name] or { value, value }
            self.seen[name] = { math.min(range[1], value), math.max(range[2], value) }
        end
    end
end

-- What a measure went through, in words.
local function shown(self, name)
    local range = self.seen[name]
    if not range then return name .. " undefined" end
    if not self.eye:is_yes_no(name) then return ("%s from %.4g to %.4g"):format(name, range[1], range[2]) end
    return name .. (range[1] == 1 and " always" or range[2] == 1 and " at times" or " never")
end

--- Looks at the eye in this step.
function Near:look()
    if self.came then return end
    self.came = self.wanted.test()
    note(self)
end

--- What was seen instead, in words.
function Near:lacking()
    local ranges = {}
    for _, name in ipairs(self.wanted.names()) do
        ranges[#ranges + 1] = shown(self, name)
    end
    return ("expected the silent twin to come near at some time, seen: %s"):format(
        #ranges > 0 and table.concat(ranges, ", ") or "no measure")
end

return Near
