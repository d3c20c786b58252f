-- SPDX-License-Identifier: GPL-3.0-or-later
-- An operation is made of exercises, one after the other, on one eye. See curricula/full_operation/curriculum.lua.
--
--   return operation {
--       title   = "Opening the capsule and implanting",
--       patient = { age = 68, pupil_mm = 7.5 },
--       parts   = {
--           part "capsulorhexis" {},
--           part "iol_injection" {
--               opening     = "capsulorhexis",                                 -- the bag has the opening torn there
--               begins_with = { ["viscoelastic.fill"] = "viscoelastic.fill" }, -- setting = what earlier parts left
--           },
--       },
--       scoring = osacss.all,
--   }
--
-- Each part is simulated as its exercise says, no more. What one part leaves for the next is named: the opening, the
-- whole state (continues), or single facts. The score reaches over all parts.

local accuracy = require "engine.accuracy"
local expression = require "engine.expression"
local fields = require "engine.fields"
local language = require "exercise"
local settings_check = require "engine.settings_check"
local texts = require "engine.texts"
local words = require "engine.words"

local operation = {}

local part_rules = {
    exercise = { kind = "text" },          -- folder in curricula/, or beside this one; the part's name if missing
    title = { kind = "line" },             -- that of the exercise if missing
    start = { kind = "text" },             -- of its starts.lua, when nothing is handed over
    continues = { kind = "yes_no", default = false },  -- begins in the state that the part before it left: same eye,
                                           -- tissues, instruments and fixed settings; the machine's are its own
    opening = { kind = "text" },           -- the part in which the opening of the bag was torn
    begins_with = { kind = "table", default = {} },    -- setting = text over the measures that earlier parts left
    patient = { kind = "table", default = {} },        -- besides the operation's
    tissues = { kind = "texts" },          -- in place of the exercise's
    instruments = { kind = "texts" },
    settings = { kind = "table", default = {} },
    goals = { kind = "table", default = {} },
    time_limit_s = { kind = "number", from = 1, to = 7200 },
    accuracy = { kind = "table", default = {} },       -- besides the exercise's
    step_s = { kind = "number", from = 0.001, to = 0.02 },  -- by hand; the exercise's if missing
}

local operation_rules = {
    title = { kind = "line", required = true },
    version = { kind = "number", default = 1, from = 0 },
    summary = { kind = "text" },
    objectives = { kind = "texts", default = {} },
    patient = { kind = "table", default = {} },
    settings = { kind = "table", default = {} },       -- of every part
    parts = { kind = "table", required = true },
    scoring = { kind = "table" },
    reference = { kind = "table", default = {} },
    mode = { kind = "text", default = "teaching", choices = { "teaching", "exam" } },
}

--- part "name" { ... }
operation.part = language.declaration("part", part_rules, function(part)
    part.exercise = part.exercise or part.id
    part.begins = {}
    part.accuracy_where = words.where("accuracy", part.line)
    part.accuracy = accuracy.read(part.accuracy, ("part '%s': accuracy"):format(part.name), part.line)
    fields.named(part.begins_with, words.where("begins_with", part.line), ("part '%s': begins_with"):format(part.name),
        "[\"viscoelastic.fill\"] = \"viscoelastic.fill\"")
    for _, setting in ipairs(words.keys(part.begins_with)) do
        local text = part.begins_with[setting]
        local where = words.where(setting, part.line)
        if type(text) ~= "string" then
            words.fail(where, ("part '%s': begins_with %s must be a text over measures of earlier parts"):format(
                part.name, setting))
        end
        settings_check.name(setting, part.line, ("part '%s': begins_with: "):format(part.name))
        part.begins[setting] = expression.parse(text, where)
    end
    if part.continues and part.step_s then
        words.fail(words.where("step_s", part.line),
            ("part '%s' continues the one before it, whose step_s is its own as well"):format(part.name))
    end
end)

local function check_opening(part, before)
    if not part.opening then return end
    for _, earlier in ipairs(before) do
        if earlier == part.opening then return end
    end
    words.fail(words.where("opening", part.line), ("part '%s': there is no part '%s' before it%s"):format(part.name,
        part.opening, words.hint(part.opening, before)))
end

--- operation { ... }: checks what can be checked without its exercises.
function operation.operation(given)
    local result = fields.read(given, operation_rules, "operation")
    result.kind = "operation"
    result.patient = language.read_patient(result.patient)
    result.settings = language.flatten(result.settings, "", {})
    result.reference = language.read_reference(result.reference)
    language.check_list(result.parts, "part", "parts")
    if #result.parts == 0 then words.fail(words.where("parts"), "an operation needs at least one part") end
    if result.scoring and not result.scoring.rubric then
        words.fail(words.where("scoring"), "scoring must be a rubric, like osacss { \"T5\", \"G4\" }")
    end
    local before = {}
    for i, part in ipairs(result.parts) do
        if part.continues and i == 1 then
            words.fail(part.where, ("part '%s' is the first: it has nothing to continue"):format(part.name))
        end
        part.patient = language.read_patient(part.patient)
        part.settings = language.flatten(part.settings, "", {})
        check_opening(part, before)
        before[i] = part.id
    end
    return result
end

-- Its own texts that files beside it, such as curriculum.fr.lua, lack.
local function untranslated(wanted)
    local lines, own = {}, { texts = {} }
    for _, name in ipairs(texts.own_languages(own)) do
        local function look(text)
            if text and not texts.has(name, own, text) then
                lines[#lines + 1] = ("no text in %s: \"%s\""):format(name, text)
            end
        end
        look(wanted.title)
        look(wanted.summary)
        for _, objective in ipairs(wanted.objectives) do look(objective) end
    end
    return lines
end

--- What the program needs to know of an operation before its parts are loaded. t: gives a text in its language.
function operation.listing(wanted, t)
    local parts = {}
    for i, part in ipairs(wanted.parts) do
        parts[i] = { id = part.id, title = part.name, exercise = part.exercise, start = part.start, where = part.where,
            continues = part.continues, opening = part.opening }
    end
    local objectives = {}
    for i, objective in ipairs(wanted.objectives) do objectives[i] = t(objective) end
    return { title = t(wanted.title), version = wanted.version, summary = t(wanted.summary), objectives = objectives,
        parts = parts, untranslated = untranslated(wanted) }
end

local function overlay(under, over)
    for _, key in ipairs(words.keys(over)) do under[key] = over[key] end
end

local function set_goals(exercise, part)
    for _, name in ipairs(words.keys(part.goals)) do
        local rule = exercise.goal_rules[name]
        local where = words.where(name, part.line)
        if not rule then
            words.fail(where, ("part '%s': the exercise has no goal '%s'%s"):format(part.name, name,
                words.hint(name, words.keys(exercise.goal_rules))))
        end
        exercise.goals[name] = fields.check_value(rule, part.goals[name], where, "goal " .. name)
    end
end

-- measured: names of the measures of earlier parts.
local function check_begins(part, measured)
    for _, setting in ipairs(words.keys(part.begins)) do
        for _, name in ipairs(part.begins[setting].names) do
            if not words.has(measured, name) then
                words.fail(part.begins[setting].where, ("part '%s': begins_with %s: no part before it measures '%s'%s")
                    :format(part.name, setting, name, words.hint(name, measured)))
            end
        end
    end
end

-- What an earlier part left may be more than the next model knows, as a wound cut at the limbus itself.
local function within_range(setting, value)
    local info = settings_check.info(setting)
    return info and math.max(info.from, math.min(info.to, value)) or value
end

-- A fact that no earlier part left is unknown: the setting keeps its own value.
local function begin_with(exercise, part, facts)
    for _, setting in ipairs(words.keys(part.begins)) do
        local value = expression.bind(part.begins[setting], function(name)
            return function() return facts[name] end
        end)()
        if type(value) == "boolean" then value = value and 1 or 0 end
        if value ~= nil then exercise.settings[setting] = within_range(setting, value) end
    end
end

-- The scene in which the part before it ended. live: names of the settings that may change while a scene runs.
local function continue_scene(exercise, scene, live)
    exercise.patient, exercise.tissues, exercise.instruments = scene.patient, scene.tissues, scene.instruments
    exercise.step_s, exercise.advance, exercise.chosen = scene.step_s, scene.advance, scene.chosen
    local settings = scene.settings
    for _, name in ipairs(live) do settings[name] = exercise.settings[name] end
    exercise.settings = settings
end

--- Makes an exercise a part: the operation's patient, settings and mode, the part's own, and what earlier parts left.
--- before: as Run:result().carried; an empty table for the first; of a check { measured = names of the measures of
--- earlier parts, scene }. live: see above.
function operation.join(wanted, index, exercise, before, live)
    local part = wanted.parts[index]
    overlay(exercise.patient, wanted.patient)
    overlay(exercise.patient, part.patient)
    overlay(exercise.settings, wanted.settings)
    overlay(exercise.settings, part.settings)
    if before.measured then check_begins(part, before.measured) end
    begin_with(exercise, part, before.facts or {})
    set_goals(exercise, part)
    exercise.tissues = part.tissues or exercise.tissues
    exercise.instruments = part.instruments or exercise.instruments
    exercise.step_s = part.step_s or exercise.step_s
    exercise.step_by_hand = exercise.step_by_hand or part.step_s ~= nil
    if next(part.accuracy) then exercise.accuracy_where = part.accuracy_where end
    overlay(exercise.accuracy, part.accuracy)
    if part.continues and before.scene then continue_scene(exercise, before.scene, live) end
    exercise.time_limit_s = part.time_limit_s or exercise.time_limit_s
    exercise.mode = wanted.mode
    exercise.whole = { part = part, parts = wanted.parts, scoring = wanted.scoring, reference = wanted.reference,
        before = before }
end

return operation
