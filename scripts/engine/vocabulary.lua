-- SPDX-License-Identifier: GPL-3.0-or-later
-- What rhexis words says: every name that an exercise may use, with its unit and meaning. Measures are those of the
-- exercise's own tissues and instruments.

local accuracy = require "engine.accuracy"
local osacss = require "osacss"
local settings_check = require "engine.settings_check"
local words = require "engine.words"

local vocabulary = {}

local function line(name, unit, meaning)
    return { name = name, text = ("%-34s %-10s %s"):format(name, unit, meaning) }
end

local function measures(exercise, eye)
    local lines = {}
    for i, name in ipairs(eye.names) do
        local info = eye.info[name]
        lines[i] = line(name, info.bool and "yes/no" or info.unit == "1" and "number" or info.unit, info.meaning)
    end
    lines[#lines + 1] = line("time_s", "s", "Time since the exercise began.")
    lines[#lines + 1] = line("step.time_s", "s", "Time since the step that runs began.")
    for _, name in ipairs(words.keys(exercise.goals)) do
        lines[#lines + 1] = line("goal." .. name, "goal", exercise.goal_rules[name].meaning
            or ("%g unless a level or --set says otherwise."):format(exercise.goals[name]))
    end
    for _, request in ipairs(exercise.requests) do
        lines[#lines + 1] = line("requested." .. request.id, "yes/no", ("\"%s\" has been asked for."):format(
            request.title))
    end
    return lines
end

local function settings()
    local lines = {}
    for i, info in ipairs(settings_check.list()) do
        local unit = info.unit == "1" and "number" or info.unit
        lines[i] = line(info.name, unit, ("%s [%g to %g, %g if nothing is said; %s]"):format(info.meaning, info.from,
            info.to, info.standard, info.tissue and "the eye's: changed by an instructor's request only" or info.live
            and "may change while it runs" or "fixed before the first step"))
    end
    return lines
end

local function quantities()
    local lines = {}
    for i, quantity in ipairs(accuracy.list()) do
        local unit = quantity.unit == "1" and "share" or quantity.unit
        lines[i] = line(quantity.name, unit, ("%s [%g to %g%s]"):format(quantity.meaning, quantity.from, quantity.to,
            quantity.kept ~= "" and "; if nothing is said: " .. quantity.kept or ""))
    end
    return lines
end

local function items(exercise, sheet)
    local untold, lines = {}, {}
    for _, one in ipairs(sheet and sheet:untold() or {}) do untold[one.item.id] = one.none end
    local rubric = exercise.scoring and exercise.scoring.rubric or osacss
    for i, item in ipairs(rubric.items) do
        local note = ""
        if exercise.scoring and words.has(exercise.scoring.items, item.id) then
            note = untold[item.id] and "listed, but cannot be scored here" or "scored here"
        end
        lines[i] = line(item.id, "item", item.name .. (note ~= "" and " (" .. note .. ")" or ""))
    end
    return lines
end

--- exercise: as loaded; run: of it. Returns a list of { title, lines = list of { name, text } }.
function vocabulary.of(exercise, run)
    return {
        { title = "Measures, for conditions and rubrics", lines = measures(exercise, run.eye) },
        { title = "Settings of patient, machine and simulation", lines = settings() },
        { title = "Errors that may be made, for accuracy = { }", lines = quantities() },
        { title = "Items of the rubric", lines = items(exercise, run.sheet) },
    }
end

return vocabulary
