-- SPDX-License-Identifier: GPL-3.0-or-later
-- What bindings/lua/surgeon_script.cpp calls: chooses a person and a plan, and hands samples of instruments back.

local groups = require "surgeons.groups"
local operator = require "surgeons.operator"
local words = require "engine.words"

local surgeon = {}

local function known_names()
    local names = { "none" }
    for _, name in ipairs(groups.names) do names[#names + 1] = name end
    for _, name in ipairs(words.keys(groups.aliases)) do names[#names + 1] = name end
    return names
end

--- name: of a group, or an alias; plan: module of the curriculum's folder. Returns a complaint, or nil.
function surgeon.choose(name, plan)
    local group = groups.aliases[name] or name
    if not groups.meaning[group] then
        return ("there is no surgeon '%s'%s"):format(name, words.hint(name, known_names()))
    end
    surgeon.group = group
    surgeon.plan = require(plan)
    if type(surgeon.plan) ~= "function" then
        return ("the plan %s.lua must return a function(me)"):format(plan)
    end
    surgeon.seed = math.random(math.mininteger, math.maxinteger)
    return nil
end

--- instruments: names, in the scene's order; dt: step [s].
function surgeon.start(instruments, dt)
    local person = operator.start(surgeon.plan, surgeon.group, surgeon.seed, dt)
    -- The plans so far use one instrument, the first.
    function surgeon.operate(percept)
        local samples = { person:operate(percept) }
        samples[1].instrument = 0
        for i = 2, #instruments do
            samples[i] = { instrument = i - 1, present = false, position = { 0, 0, 0 },
                orientation = { 1, 0, 0, 0 }, jaw = 0, pedal = 0 }
        end
        return samples
    end
end

return surgeon
