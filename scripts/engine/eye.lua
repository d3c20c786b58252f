-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a curriculum sees of the eye. The measure "phaco.tip_depth_mm" is eye.phaco.tip_depth_mm in a function and
-- phaco.tip_depth_mm in a text. Values stand in one row that the host overwrites each step; not-a-number shows as nil.
-- That the staff has been asked for something is eye.requested("Bottle down"), and requested.bottle_down in a text.

local requests = require "engine.requests"
local words = require "engine.words"

local Eye = {}
Eye.__index = Eye

--- schema: list of { name, unit, meaning }; goals: named numbers of the exercise; declared: its requests, or nil.
function Eye.new(schema, goals, declared)
    local self = setmetatable({ row = {}, time_s = 0, step_time_s = 0, goals = goals, names = {}, groups = {},
        info = {}, requests = declared or {}, requested = {}, used = {} }, Eye)  -- `read`: names read since it was
        -- set, if it is; `used`: set of those that texts name, and that functions have read
    for i, entry in ipairs(schema) do
        local group, field = entry.name:match("^([^.]+)%.(.+)$")
        self.names[i] = entry.name
        self.info[entry.name] = { index = i, unit = entry.unit, meaning = entry.meaning, bool = entry.unit == "bool" }
        self.groups[group] = self.groups[group] or { fields = {}, names = {} }
        self.groups[group].fields[field] = entry.name
        table.insert(self.groups[group].names, field)
    end
    self.view = self:make_view()
    return self
end

--- Takes the next row: time_s and one number per schema entry.
function Eye:look(time_s, row, step_time_s)
    self.time_s, self.row, self.step_time_s = time_s, row, step_time_s
end

--- Whether what a name stands for is true or false.
function Eye:is_yes_no(name)
    return name:find("^requested%.") ~= nil or (self.info[name] ~= nil and self.info[name].bool)
end

--- A request was made, now or at that time.
function Eye:hear(id, time_s) self.requested[id] = time_s or self.time_s end

--- Whether it was made so far; while `asked_since` is set, only since then.
function Eye:has_been_asked(id)
    local time_s = self.requested[id]
    return time_s ~= nil and time_s >= (self.asked_since or time_s)
end

--- Value of a measure by its full name; nil when it is not defined now.
function Eye:value(name)
    local info = self.info[name]
    local value = info and self.row[info.index]
    if value == nil or value ~= value then return nil end
    if info.bool then return value ~= 0 end
    return value
end

--- For texts: a function that gives the value now, or nil and the known names.
function Eye:resolve(name)
    if name == "time_s" then return function() return self.time_s end end
    if name == "step.time_s" then return function() return self.step_time_s end end
    local request = name:match("^requested%.(.+)$")
    if request then
        local known = {}
        for i, declared in ipairs(self.requests) do
            if declared.id == request then return function() return self:has_been_asked(request) end end
            known[i] = "requested." .. declared.id
        end
        return nil, known
    end
    local goal = name:match("^goal%.(.+)$")
    if goal then
        local value = self.goals[goal]
        if value ~= nil then return function() return value end end
        local known = {}
        for _, key in ipairs(words.keys(self.goals)) do known[#known + 1] = "goal." .. key end
        return nil, known
    end
    local info = self.info[name]
    if not info then return nil, self.names end
    self.used[name] = true
    local index = info.index
    if info.bool then
        return function()
            local value = self.row[index]
            if value == value then return value ~= 0 end
        end
    end
    return function()
        local value = self.row[index]
        if value == value then return value end
    end
end

-- A group of measures as a table that reads the row, notes what was read, and knows no other names.
local function group_view(self, group, content)
    return setmetatable({}, {
        __index = function(_, field)
            local name = content.fields[field]
            if not name then
                error(("unknown measure '%s.%s'%s"):format(group, tostring(field),
                    words.hint(tostring(field), content.names)), 2)
            end
            self.used[name] = true
            if self.read then table.insert(self.read, name) end
            return self:value(name)
        end,
        __newindex = function() error("measures can only be read", 2) end,
        __metatable = false,
    })
end

local function goal_view(self)
    return setmetatable({}, {
        __index = function(_, field)
            local value = self.goals[field]
            if value == nil then
                error(("unknown goal '%s'%s"):format(tostring(field),
                    words.hint(tostring(field), words.keys(self.goals))), 2)
            end
            return value
        end,
        __newindex = function() error("goals can only be read", 2) end,
        __metatable = false,
    })
end

-- requested("Bottle down") and requested.bottle_down: whether that has been asked for, or declared, so far.
local function request_view(self)
    local function asked(_, name)
        local id, complaint = requests.find(self.requests, name)
        if not id then error(complaint, 2) end
        return self:has_been_asked(id)
    end
    return setmetatable({}, {
        __index = asked,
        __call = asked,
        __newindex = function() error("requests can only be looked at", 2) end,
        __metatable = false,
    })
end

--- The table that functions of a curriculum receive as `eye`.
function Eye:make_view()
    local groups, names = {}, {}
    for _, group in ipairs(words.keys(self.groups)) do
        groups[group] = group_view(self, group, self.groups[group])
        names[#names + 1] = group
    end
    groups.goal = goal_view(self)
    groups.requested = request_view(self)
    local times = { time_s = function() return self.time_s end, step_time_s = function() return self.step_time_s end }
    return setmetatable({}, {
        __index = function(_, name)
            if groups[name] then return groups[name] end
            if times[name] then return times[name]() end
            error(("unknown group of measures '%s'%s"):format(tostring(name), words.hint(tostring(name), names)), 2)
        end,
        __newindex = function() error("the eye can only be looked at", 2) end,
        __metatable = false,
    })
end

return Eye
