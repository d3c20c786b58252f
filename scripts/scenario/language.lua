-- SPDX-License-Identifier: GPL-3.0-or-later
-- The words that scenario tests are written in. See curricula/groove/tests for some that use most of them.
--
--   return scenarios {                                    -- of the exercise in whose folder this file lies
--       patient = { age = 68, pupil_mm = 7.5 },           -- whose eye these hands know; else that of the exercise
--       scenario "iris touched, put right" {
--           set = { ["patient.pupil_mm"] = 6 },           -- as --set of rhexis run
--           start = "after_groove",                       -- a state that the exercise prepares, in its starts.lua
--           function(t)
--               local tip = t.phaco
--               tip:enter()
--               tip:move_to({ 2.5, 1, 2.6 }, { speed = 5 })
--               t:expect_event("Iris touched")
--           end } }

local fields = require "engine.fields"
local words = require "engine.words"

local language = {}

local scenario_rules = {
    seed = { kind = "number", default = 1, from = 0, to = 2 ^ 53, whole = true },
    set = { kind = "table", default = {} },
    start = { kind = "text" },             -- a state of the exercise's starts.lua, or a state file (.rhxs)
    silent_twin_of = { kind = "texts", default = {} },  -- error events that it nearly raises, and must not
    near = { kind = "condition" },         -- of a silent twin: what must hold at some time, so that it came near
    recover_within_s = { kind = "number", from = 0.1, to = 7200 },  -- as --set recover_within_s
    hold_within_s = { kind = "number", from = 0, to = 60 },         -- as --set hold_within_s
    time_limit_s = { kind = "number", default = 300, from = 0.1, to = 7200 },  -- simulated time it may take
}

local start_rules = {
    surgeon = { kind = "text" },           -- d, unless a function(t) leads the instruments; then its end is kept
    seed = scenario_rules.seed,
    set = scenario_rules.set,
    opening = { kind = "text" },           -- where the bag's opening was torn: a state (.rhxs), a recording (.rhx), the
                                           -- folder of a run, or "EXERCISE:START"
    when = { kind = "text" },              -- the moment that is kept: a condition, as in the exercise
    limit_s = { kind = "number", default = 300, from = 0.1, to = 7200 },
}

local function text_of(value, where, name)
    if type(value) == "boolean" then return tostring(value) end
    if type(value) == "string" then return value end
    fields.check_value({ kind = "number" }, value, where, "set: " .. name)
    return math.type(value) == "integer" and tostring(value) or ("%.17g"):format(value)
end

-- { patient = { age = 70 } } and { ["patient.age"] = 70 } both become { ["patient.age"] = "70" }.
local function flatten(set, where, prefix, out)
    for key in pairs(set) do
        if type(key) ~= "string" then words.fail(where, "set holds an entry without a name") end
    end
    for _, key in ipairs(words.keys(set)) do
        if type(set[key]) == "table" then
            flatten(set[key], where, prefix .. key .. ".", out)
        else
            out[prefix .. key] = text_of(set[key], where, prefix .. key)
        end
    end
    return words.as_object(out)
end

-- The fields of a declaration without its function, and the function.
local function split(given, owner, line)
    if type(given) ~= "table" then
        words.fail(words.where(nil, line), owner .. " must be followed by a table { ... }")
    end
    local named = {}
    for key, value in pairs(given) do
        if key ~= 1 then named[key] = value end
    end
    if type(given[1]) ~= "function" then
        words.fail(words.where(nil, line), owner .. " lacks what happens in it: function(t) ... end")
    end
    return named, given[1]
end

-- One name in quotes will do where a list is allowed.
local function as_list(value) return type(value) == "string" and { value } or value end

local function read_scenario(given, owner, line)
    local named, play = split(given, owner, line)
    named.silent_twin_of = as_list(named.silent_twin_of)
    local result = fields.read(named, scenario_rules, owner, line)
    if result.near and #(result.silent_twin_of or {}) == 0 then
        words.mistake(words.where("near", line), owner .. " has near, but names no error event in silent_twin_of")
    end
    result.play = play
    result.set = flatten(result.set or {}, words.where("set", line), "", {})
    for _, field in ipairs { "recover_within_s", "hold_within_s" } do
        if result[field] then result.set[field] = tostring(result[field]) end
    end
    return result
end

--- scenario "name" { fields, function(t) ... end }
function language.scenario(name)
    if type(name) ~= "string" or name == "" then
        words.fail(words.where(nil, words.line_here()), "scenario must be followed by a name in quotes")
    end
    return function(given)
        local line = words.line_here()
        local result = words.try(read_scenario, given, ("scenario '%s'"):format(name), line) or { set = {} }
        result.kind, result.name, result.line = "scenario", name, line
        return result
    end
end

-- The patient that a file's hands know stands in for the exercise's, unless a scenario chooses another itself: places
-- and depths that were found in one eye are others in another.
local function pin(patient, list)
    for name, value in pairs(flatten({ patient = patient }, words.where("patient"), "", {})) do
        for _, entry in ipairs(list) do
            if not entry.set.level then entry.set[name] = entry.set[name] or value end
        end
    end
end

local function collect(given, exercise)
    if type(given) ~= "table" then words.fail(words.where(), "scenarios must be followed by a table { ... }") end
    local seen, list = {}, {}
    for i, entry in ipairs(given) do
        if type(entry) ~= "table" or entry.kind ~= "scenario" then
            words.fail(words.where(), ("scenarios: entry %d is no scenario \"name\" { ... }"):format(i))
        end
        if seen[entry.name] then
            words.mistake(words.where(nil, entry.line), ("scenario '%s' is there twice"):format(entry.name))
        end
        seen[entry.name], list[i] = true, entry
    end
    for key in pairs(given) do
        if not list[key] and key ~= "patient" then
            words.fail(words.where(), "scenarios: only patient and scenario \"name\" { ... } may stand in it")
        end
    end
    if #list == 0 then words.fail(words.where(), "scenarios: there is none in it") end
    if given.patient ~= nil then
        if type(given.patient) ~= "table" then
            words.fail(words.where("patient"), "scenarios: patient must be a table, as in an exercise")
        end
        pin(given.patient, list)
    end
    return { kind = "scenarios", exercise = exercise, list = list }
end

--- scenarios { ... } for the exercise in whose folder the file lies, scenarios "exercise" { ... } for any.
function language.scenarios(given)
    if type(given) ~= "string" then return collect(given, nil) end
    return function(list) return collect(list, given) end
end

local function read_start(name, recipe, line)
    local owner = "start " .. name
    local where = words.where(name, line)
    local play = type(recipe) == "table" and recipe[1]
    local named = recipe
    if play ~= nil and play ~= false then named, play = split(recipe, owner, line) end
    local before = words.mistaken()
    local read = fields.read(named, start_rules, owner, line)
    if words.mistaken() > before then return read end
    if play and (read.surgeon or read.when) then
        words.fail(where, owner .. " has a function: neither surgeon nor when goes with it")
    end
    if not play and not read.when and not read.opening then
        words.fail(where, owner .. " lacks 'when' (or a function(t) ... end, or opening)")
    end
    if read.surgeon and not read.when then
        words.fail(where, owner .. " names a surgeon, but lacks 'when': the moment that is kept")
    end
    read.surgeon = read.surgeon or (read.when and "d" or "none")
    read.set = flatten(read.set, where, "", {})
    read.where, read.line, read.play = where, tonumber(where:match(":(%d+)$")), play or nil
    return read
end

--- starts { name = { surgeon, seed, when, ... } } or { name = { function(t) ... end } }: the file starts.lua of an
--- exercise. opening = "...": the bag is open as a capsulorhexis left it; with neither moment nor function: that is the
--- start.
function language.starts(given)
    if type(given) ~= "table" then words.fail(words.where(), "starts must be followed by a table { ... }") end
    local line = words.line_here()
    local result = {}
    for name, recipe in pairs(given) do
        if type(name) ~= "string" or not name:find("^[%w_]+$") then
            words.fail(words.where(nil, line), "starts: a name has letters, digits and _ only, not " .. tostring(name))
        end
        result[name] = read_start(name, recipe, line)
    end
    return { kind = "starts", starts = words.as_object(result) }
end

return language
