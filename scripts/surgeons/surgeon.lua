-- SPDX-License-Identifier: GPL-3.0-or-later
-- What bindings/lua/surgeon_script.cpp calls: chooses a person and a plan, and hands samples of instruments back.

local globals = require "engine.globals"
local groups = require "surgeons.groups"
local operator = require "surgeons.operator"
local random = require "surgeons.random"
local words = require "engine.words"

local surgeon = {}

globals.refuse_unknown()

local function known_names()
    local names = { "none", "random" }
    for _, name in ipairs(groups.names) do names[#names + 1] = name end
    for _, name in ipairs(words.keys(groups.aliases)) do names[#names + 1] = name end
    return names
end

-- What --set surgeon.* may change.
local habits = {
    recovery = "1: what is seen to go wrong is reacted to; 0: it is not",
}

-- The habits that were asked for, as texts by name; or nil and a complaint.
local function read_habits(given)
    for _, key in ipairs(words.keys(given)) do
        local shown = ("--set surgeon.%s=%s: "):format(key, given[key])
        if not habits[key] then
            return nil, ("%snothing is called 'surgeon.%s'%s"):format(shown, key, words.hint(key, words.keys(habits)))
        end
        if given[key] ~= "0" and given[key] ~= "1" then
            return nil, ("%ssurgeon.%s must be 0 or 1 (%s)"):format(shown, key, habits[key])
        end
    end
    return { recovers = given.recovery ~= "0" }
end

-- The plan beside the curriculum, or a complaint that there is none.
local function plan_of(name)
    local found, result = pcall(require, name)
    if found then return result, nil end
    if not tostring(result):find("no module '" .. name .. "'", 1, true) then error(result, 0) end
    return nil, ("the exercise has no %s.lua, the plan of a virtual surgeon: write one (docs/surgeon.md), or run it "
        .. "with --surgeon none or random"):format(name)
end

--- name: of a group, or an alias; plan: module of the curriculum's folder; given: habits, texts by name. Returns a
--- complaint, or nil.
function surgeon.choose(name, plan, given)
    local anything = name == "random"
    local group = anything and "a" or groups.aliases[name] or name
    if not groups.meaning[group] then
        return ("there is no surgeon '%s'%s"):format(name, words.hint(name, known_names()))
    end
    local complaint
    surgeon.habits, complaint = read_habits(given)
    if complaint then return complaint end
    surgeon.group = group
    surgeon.seed = math.random(math.mininteger, math.maxinteger)
    if anything then
        surgeon.plan = random(surgeon.seed)
    else
        surgeon.plan, complaint = plan_of(plan)
        if complaint then return complaint end
    end
    if type(surgeon.plan) ~= "function" then
        return ("the plan %s.lua must return a function(me)"):format(plan)
    end
    return nil
end

--- instruments: names, in the scene's order; dt: step [s]; requests: what may be asked of the staff, list of { id,
--- title, name }.
function surgeon.start(instruments, dt, requests)
    local person = operator.start(surgeon.plan, surgeon.group, surgeon.seed, dt, instruments, surgeon.habits, requests)
    function surgeon.operate(percept)
        local samples, asked = person:operate(percept)
        for i, sample in ipairs(samples) do sample.instrument = i - 1 end
        return samples, asked
    end
end

return surgeon
