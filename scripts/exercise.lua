-- SPDX-License-Identifier: GPL-3.0-or-later
-- The words that a curriculum is written in. See curricula/groove/curriculum.lua for one that uses most of them.
--
--   return exercise {
--       title       = "Sculpting a groove",
--       patient     = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
--       tissues     = { "lens", "bag", "iris" },                -- nothing else is simulated
--       instruments = { "phaco" },
--       accuracy    = { volume = 0.1 },                         -- error that it can bear: mesh and step follow
--       goals       = { length_mm = 4 },                        -- numbers that conditions may use as goal.length_mm
--       steps  = { step "sculpt" { done = "groove.length_mm >= goal.length_mm" } },
--       errors = { error_event "too deep" {
--           when      = "phaco.tip_posterior_mm < 0.3 and phaco.aspirating",
--           recovered = "phaco.tip_posterior_mm > 1.0",
--           advice    = "Stop, draw the tip up, and go on elsewhere.",
--           items     = { "T9", "G4" } } },
--       scoring = osacss { "T8", "T9", "G4" },
--   }
--
-- A condition (`when`, `done`, `recovered`, `harm`, `over`) is a text as above, a function of the eye
-- (function(eye) return eye.groove.length_mm > 4 end), or a list of either that must come true in that order.

local accuracy = require "engine.accuracy"
local fields = require "engine.fields"
local requests = require "engine.requests"
local settings_check = require "engine.settings_check"
local texts = require "engine.texts"
local vitals = require "engine.vitals"
local words = require "engine.words"

local language = {}

local step_rules = {
    title = { kind = "line" },             -- what the trainee reads; the name of the step if missing
    hint = { kind = "text" },              -- said when the step begins, in teaching mode
    hint_after_s = { kind = "number", default = 0, from = 0, to = 7200 },  -- or only if it is not done by then
    marks = { kind = "places" },           -- where the tip is to be, as a person sees it in teaching mode [mm]: one
                                           -- place, or a way through several
    enter_when = { kind = "condition" },   -- the step begins once this holds
    enter_limit_s = { kind = "number", from = 0.1, to = 7200 },  -- it is left out when it has not begun by then
    done = { kind = "condition" },         -- the step is complete
    picture_when = { kind = "condition" }, -- a picture for the report is taken when this holds for the first time
    script = { kind = "call" },            -- function(eye, act): act.say, .wait, .wait_until, .picture, .set
    time_limit_s = { kind = "number", from = 0.1, to = 7200 },  -- then the next step begins, this one undone
    next = { kind = "text" },              -- name of the later step that follows; the next in the list if missing
    next_late = { kind = "text" },         -- the one that follows when the time limit has ended this one
}

local event_rules = {
    title = { kind = "line" },
    when = { kind = "condition", required = true },  -- the error happens
    given = { kind = "condition" },        -- what of it the eye may have from the start, if that is less than `when`:
                                           -- while it has, the error is the task and not the operator's
    hold_s = { kind = "number", default = 0, from = 0, to = 60 },  -- only if it lasts this long
    recovered = { kind = "condition" },    -- it is put right
    recovered_hold_s = { kind = "number", default = 0, from = 0, to = 60 },  -- only if that lasts this long
    deadline_s = { kind = "number", default = 10, from = 0, to = 7200 },  -- time to put it right
    harm = { kind = "condition" },         -- tissue was changed: no longer a near miss
    near_miss_s = { kind = "number", default = 0.5, from = 0, to = 60 },  -- put right as fast as this: a near miss
    quiet_s = { kind = "number", default = 1, from = 0, to = 60 },  -- calm needed before it can happen again
    severity = { kind = "text", default = "critical", choices = { "critical", "minor" } },
    cue = { kind = "text" },               -- what the surgeon sees of it
    advice = { kind = "text", required = true },  -- what to do
    consequences = { kind = "table", default = {} },  -- what the educator lets follow: texts that are said, settings
                                           -- of the machine that are changed (only such as may change while it runs)
    items = { kind = "texts" },            -- items of the rubric that it caps
    evidence = { kind = "texts" },         -- measures to note besides those of `when`
    steps = { kind = "texts" },            -- only during these steps
    ends_exercise = { kind = "yes_no", default = false },
}

local patient_rules = {
    age = { kind = "number", from = 20, to = 95 },
    nuclear_grade = { kind = "number", from = 1, to = 6 },
    cortical_opacity = { kind = "number", from = 0, to = 1 },
    cataract = { kind = "text" },
    pupil_mm = { kind = "number", from = 3, to = 9 },
    side = { kind = "text", choices = { "right", "left" } },  -- which eye
    incision_deg = { kind = "number", from = 0, to = 360 },   -- site of the main incision: see engine/orientation.lua
    tetrahedra = { kind = "number", from = 500, to = 24000, whole = true },  -- by hand, in place of `accuracy`
}

local exercise_rules = {
    title = { kind = "line", required = true },
    version = { kind = "number", default = 1, from = 0 },
    summary = { kind = "text" },
    objectives = { kind = "texts", default = {} },
    patient = { kind = "table", default = {} },
    tissues = { kind = "texts", required = true, choices = { "lens", "bag", "capsule", "anterior_capsule",
        "iris", "cornea", "chamber", "viscoelastic", "implant", "vitreous", "globe", "wounds", "zonules",
        "hydrodissection", "cortex", "retained_viscoelastic", "lids", "beads" } },
    instruments = { kind = "texts", required = true, choices = { "cannula", "capsule_hook", "cutter", "cystotome",
        "drape", "forceps", "hook", "hydration_cannula", "ia_tip", "injector", "keratome", "lens_forceps",
        "needle_holder", "phaco", "probe", "ring", "saline_cannula", "side_port_blade", "spatula", "speculum", "sponge",
        "triamcinolone", "microscope" } },
    settings = { kind = "table", default = {} },
    goals = { kind = "table", default = {} },
    steps = { kind = "table", required = true },
    errors = { kind = "table", default = {} },
    requests = { kind = "table", default = {} },   -- what may be asked of the staff: see engine/requests.lua
    scoring = { kind = "table" },
    reference = { kind = "table", default = {} },  -- what a good performance needs, for measures relative to it
    vitals = { kind = "table" },           -- of the patient, as the theatre's monitor shows them: theatre/vitals.lua
    over = { kind = "condition" },         -- ends the exercise, whatever step it is in
    time_limit_s = { kind = "number", default = 300, from = 1, to = 7200 },
    recover_within_s = { kind = "number", from = 0.1, to = 7200 },  -- no error has longer, whatever its own deadline
    hold_within_s = { kind = "number", from = 0, to = 60 },  -- no error has to last longer, whatever its own hold_s
    mode = { kind = "text", default = "teaching", choices = { "teaching", "exam" } },
    levels = { kind = "table", default = {} },     -- easy = { patient, settings, goals, ... }: see level_rules
    handedness = { kind = "text", default = "right", choices = { "right", "left" } },  -- hand of the main instrument
    input = { kind = "text", default = "hands", choices = { "hands", "mouse", "gamepad", "vrpn" } },  -- done with
    texts = { kind = "table", default = {} },      -- fr = { ["English text"] = "French text" }
    surgeon = { kind = "text", default = "surgeon" },  -- the plan that virtual surgeons follow: a file beside this one
    accuracy = { kind = "table", default = {} },   -- error that may be made, by quantity: force = 0.25
    step_s = { kind = "number", default = 0.01, from = 0.001, to = 0.02 },  -- by hand, in place of `accuracy`
    advance = { kind = "text", default = "automatic", choices = { "automatic", "explicit", "implicit" } },
}

for _, field in ipairs({ "tissues", "instruments" }) do
    for _, name in ipairs(exercise_rules[field].choices) do words.parts[#words.parts + 1] = name end
end

-- A level of difficulty: what it changes of the exercise.
local level_rules = {
    meaning = { kind = "line" },           -- in a few words
    patient = { kind = "table", default = {} },
    settings = { kind = "table", default = {} },
    goals = { kind = "table", default = {} },
    time_limit_s = { kind = "number", from = 1, to = 7200 },
    mode = { kind = "text", choices = { "teaching", "exam" } },
}

local function id_of(name) return (name:lower():gsub("[^%w]+", "_"):gsub("^_+", ""):gsub("_+$", "")) end

-- step "name" { ... } and error_event "name" { ... } share this shape.
function language.declaration(kind, rules, finish)
    return function(name)
        if type(name) ~= "string" or id_of(name) == "" then
            words.fail(words.where(nil, words.line_here()), ("%s must be followed by a name in quotes"):format(kind))
        end
        fields.check_value({ kind = "line" }, name, words.where(nil, words.line_here()), kind .. ": its name")
        return function(given)
            local line, before = words.line_here(), words.mistaken()
            local result = words.try(fields.read, given, rules, ("%s '%s'"):format(kind, name), line) or {}
            result.id, result.title = id_of(name), result.title or name
            result.kind, result.name, result.line, result.where = kind, name, line, words.where(nil, line)
            if finish and words.mistaken() == before then words.try(finish, result) end
            return result
        end
    end
end

language.step = language.declaration("step", step_rules, function(step)
    if not step.done and not step.script then
        words.fail(step.where, ("step '%s' lacks 'done' (or 'script'): when is it complete?"):format(step.name))
    end
end)

-- { "text", ["phaco.power_limit"] = 0.3 } becomes { texts, settings }.
local function read_consequences(event)
    local said, settings = {}, {}
    for key, value in pairs(event.consequences) do
        if type(key) == "string" then
            settings[key] = value
        elseif type(value) == "string" then
            said[#said + 1] = fields.check_value({ kind = "text" }, value, words.where("consequences", event.line),
                ("error_event '%s': consequences"):format(event.name))
        else
            words.fail(words.where("consequences", event.line), ("error_event '%s': consequences hold texts and "
                .. "settings, like { \"The nurse turns the power down.\", [\"phaco.power_limit\"] = 0.3 }"):format(
                event.name))
        end
    end
    settings = language.flatten(settings, "", {}, event.line)
    settings_check.scripted(settings, event.line, ("error_event '%s': consequences: "):format(event.name))
    event.consequences = { texts = said, settings = settings }
end

language.error_event = language.declaration("error_event", event_rules, function(event) read_consequences(event) end)

language.request = language.declaration("request", requests.rules, function(request)
    requests.finish(request, language.flatten)
end)

function language.check_list(list, kind, field)
    local seen = {}
    for i, entry in ipairs(list) do
        if type(entry) ~= "table" or entry.kind ~= kind then
            words.fail(words.where(field), ("%s: entry %d is no %s \"name\" { ... }"):format(field, i, kind))
        end
        if seen[entry.id] then
            words.mistake(entry.where, ("%s '%s' is there twice"):format(kind, entry.name))
        end
        seen[entry.id] = true
    end
    return seen
end

-- { phaco = { power_limit = 0.6 } } and { ["phaco.power_limit"] = 0.6 } both become { "phaco.power_limit" = 0.6 }.
--- line: where to look for them from, or nil.
function language.flatten(settings, prefix, out, line)
    fields.named(settings, words.where(prefix ~= "" and prefix:match("([^.]*)%.$") or "settings", line), "settings",
        "phaco = { power_limit = 0.6 }")
    for _, key in ipairs(words.keys(settings)) do
        local value = settings[key]
        if type(value) == "table" then
            if prefix ~= "" then
                words.fail(words.where(key, line), ("settings: %s%s is a table within a table: write phaco = "
                    .. "{ power_limit = 0.6 }"):format(prefix, key))
            end
            language.flatten(value, prefix .. key .. ".", out, line)
        elseif type(value) == "boolean" then
            out[prefix .. key] = value and 1 or 0
        else
            out[prefix .. key] = words.try(fields.check_value, { kind = "number" }, value, words.where(key, line),
                prefix .. key)
        end
    end
    return out
end

local goal_rules = { from = { kind = "number" }, to = { kind = "number" }, meaning = { kind = "line" } }

-- What a goal may be: { number, from = , to = , meaning = } without its number.
local function goal_rule(given, name, line)
    local rest = {}
    for key, value in pairs(given) do
        if key ~= 1 then rest[key] = value end
    end
    local rule = fields.read(rest, goal_rules, "goal " .. name, line)
    if rule.from and rule.to and rule.from > rule.to then
        words.mistake(words.where("from", line),
            ("goal %s: from = %g is above to = %g"):format(name, rule.from, rule.to))
    end
    rule.kind = "number"
    return rule
end

-- A goal is a number, or a table as above.
local function read_goals(goals)
    local values, rules = {}, {}
    fields.named(goals, words.where("goals"), "goals", "length_mm = 4")
    for _, name in ipairs(words.keys(goals)) do
        local given = goals[name]
        local line = words.line_of(name, words.line_of("goals"))
        rules[name] = goal_rule(type(given) == "table" and given or {}, name, line)
        local value = type(given) == "table" and given[1] or given
        words.try(fields.check_value, rules[name], value, words.where(nil, line), "goal " .. name)
        values[name] = tonumber(value) or 0  -- where a mistake is told, conditions still know the goal
    end
    return values, rules
end

local function grade_of(cataract, where)
    local grade = tonumber(tostring(cataract):match("^N[OC](%d%.?%d*)$"))
    if not grade then
        words.fail(where, ("patient: cataract = \"%s\" is not a grade such as \"NO3\" (NO1 to NO6)"):format(cataract))
    end
    return fields.check_value(patient_rules.nuclear_grade, grade, where, "patient: cataract (grade)")
end

function language.read_patient(given)
    local patient = fields.read(given, patient_rules, "patient")
    if patient.cataract then
        patient.nuclear_grade = words.try(grade_of, patient.cataract, words.where("cataract"))
        patient.cataract = nil
    end
    return patient
end

--- What a good performance needs: a positive number by name.
function language.read_reference(given)
    fields.named(given, words.where("reference"), "reference", "path_mm = 80")
    for _, name in ipairs(words.keys(given)) do
        words.try(fields.check_value, { kind = "number", from = 1e-9 }, given[name],
            words.where(name, words.line_of("reference")), "reference: " .. name)
    end
    return given
end

local function check_steps_of_events(result, known)
    for _, event in ipairs(result.errors) do
        for _, name in ipairs(event.steps or {}) do
            if not known[id_of(name)] then
                words.mistake(words.where("steps", event.line), ("error_event '%s': there is no step '%s'%s"):format(
                    event.name, name, words.hint(id_of(name), words.keys(known))))
            end
            event.in_steps = event.in_steps or {}
            event.in_steps[id_of(name)] = true
        end
    end
end

local function check_items(result)
    if not result.scoring then return end
    if not result.scoring.rubric then
        words.fail(words.where("scoring"), "scoring must be a rubric, like osacss { \"T9\", \"G4\" }")
    end
    local known = words.keys(result.scoring.rubric.by_id)
    for _, event in ipairs(result.errors) do
        for _, item in ipairs(event.items or {}) do
            if not result.scoring.rubric.by_id[item] then
                words.mistake(words.where("items", event.line), ("error_event '%s': unknown item '%s'%s"):format(
                    event.name, item, words.hint(item, known)))
            end
        end
    end
end

--- Marks of a file beside the exercise, by the names of steps: { file, places = { ["name"] = { { x, y, z } } } }.
function language.mark(exercise, given)
    if type(given.places) ~= "table" then
        words.fail(given.file, "a file of marks must end with: return { [\"step\"] = { { x, y, z } } }")
    end
    local at, names = {}, {}
    for i, step in ipairs(exercise.steps) do at[step.id], names[i] = step, step.name end
    fields.named(given.places, given.file, "marks", "[\"step\"] = { { x, y, z } }")
    for _, name in ipairs(words.keys(given.places)) do
        local step = at[id_of(name)]
        if not step then
            words.fail(given.file, ("there is no step '%s'%s"):format(name, words.hint(name, names)))
        end
        step.marks = fields.check_value(step_rules.marks, given.places[name], given.file, "marks of " .. name)
    end
end

-- Steps that `next` names must come later: an exercise goes on, never round.
local function link_steps(result)
    local at = {}
    for i, step in ipairs(result.steps) do at[step.id] = i end
    for i, step in ipairs(result.steps) do
        for _, field in ipairs({ "next", "next_late" }) do
            local name = step[field]
            local where = name and words.where(field, step.line)
            local target = name and at[id_of(name)]
            if name and not target then
                words.mistake(where, ("step '%s': %s: there is no step '%s'%s"):format(step.name, field, name,
                    words.hint(id_of(name), words.keys(at))))
            elseif name and target <= i then
                words.mistake(where, ("step '%s': %s: step '%s' does not come later"):format(step.name, field, name))
            end
            step[field .. "_at"] = target
        end
    end
end

local function check_goals(result, given, where_line, owner)
    for _, name in ipairs(words.keys(given)) do
        local where = words.where(name, where_line)
        local rule = result.goal_rules[name]
        if not rule then
            words.mistake(where, ("%s: the exercise has no goal '%s'%s"):format(owner, name,
                words.hint(name, words.keys(result.goal_rules))))
        else
            words.try(fields.check_value, rule, given[name], where, owner .. ": goal " .. name)
        end
    end
end

local function read_levels(result)
    local levels = {}
    fields.named(result.levels, words.where("levels"), "levels", "easy = { patient = { age = 60 } }")
    for _, name in ipairs(words.keys(result.levels)) do
        local owner = ("level '%s'"):format(name)
        local line = words.line_of(name, words.line_of("levels"))
        local level = fields.read(result.levels[name], level_rules, owner, line)
        level.patient = language.read_patient(level.patient or {})
        level.settings = language.flatten(level.settings or {}, "", {})
        settings_check.all(level.settings, line, owner .. ": ")
        check_goals(result, level.goals or {}, line, owner)
        levels[name] = level
    end
    result.levels = levels
end

-- What stands in tables of its own; a field that had a mistake is empty, and what hangs on it is not asked for.
local function read_parts(result)
    for field, rule in pairs(exercise_rules) do
        if result[field] == nil and rule.kind == "table" and rule.default then result[field] = {} end
    end
    result.patient = language.read_patient(result.patient)
    result.settings = language.flatten(result.settings, "", {})
    settings_check.all(result.settings, words.line_of("settings"), "settings: ")
    result.goals, result.goal_rules = read_goals(result.goals)
    result.reference = language.read_reference(result.reference)
    result.accuracy_where = words.where("accuracy")
    result.accuracy = accuracy.read(result.accuracy, "accuracy")
    if result.vitals then result.vitals = words.try(vitals.read, result.vitals) end
    words.try(texts.check, result.texts)
end

-- What names something else of the exercise.
local function check_names(result)
    if result.steps then
        local known = language.check_list(result.steps, "step", "steps")
        if #result.steps == 0 then words.mistake(words.where("steps"), "an exercise needs at least one step") end
        link_steps(result)
        language.check_list(result.errors, "error_event", "errors")
        check_steps_of_events(result, known)
    end
    language.check_list(result.requests, "request", "requests")
    check_items(result)
    read_levels(result)
end

--- exercise { ... }: checks everything that can be checked before there is an eye.
function language.exercise(given)
    local result = fields.read(given, exercise_rules, "exercise")
    result.kind = "exercise"
    result.step_by_hand = given.step_s ~= nil
    words.try(read_parts, result)
    words.try(check_names, result)
    return result
end

local function overlay(under, over)
    for _, key in ipairs(words.keys(over)) do under[key] = over[key] end
end

--- Makes the exercise what one of its levels says.
function language.set_level(exercise, name)
    local level = exercise.levels[name]
    if not level then
        local known = words.keys(exercise.levels)
        words.fail("--level " .. name, ("the exercise has no level '%s'%s"):format(name,
            #known == 0 and " (it has none)" or words.hint(name, known)))
    end
    overlay(exercise.patient, level.patient)
    overlay(exercise.settings, level.settings)
    overlay(exercise.goals, level.goals)
    exercise.time_limit_s = level.time_limit_s or exercise.time_limit_s
    exercise.mode = level.mode or exercise.mode
    exercise.level = name
end

-- Fields of the exercise that --set may change, besides patient.*, goal.* and the settings of the machine.
local changeable = { "mode", "step_s", "advance", "time_limit_s", "recover_within_s", "hold_within_s",
    "handedness", "input" }

--- Every name that --set knows. settings: names of the machine's settings, from the kernel.
function language.changeable(exercise, settings)
    local names = {}
    for _, name in ipairs(changeable) do names[#names + 1] = name end
    names[#names + 1], names[#names + 2] = "language", "level"
    for _, name in ipairs(words.keys(patient_rules)) do names[#names + 1] = "patient." .. name end
    for _, quantity in ipairs(accuracy.list()) do names[#names + 1] = "accuracy." .. quantity.name end
    for _, name in ipairs(words.keys(exercise.goal_rules)) do names[#names + 1] = "goal." .. name end
    for _, name in ipairs(settings) do names[#names + 1] = name end
    return names
end

local function set_accuracy(exercise, name, text, full)
    exercise.accuracy[name] = fields.from_text(accuracy.rule(name), text, full)
    exercise.accuracy_where = "--set " .. full .. "=" .. text
end

local function set_patient(exercise, name, text, full)
    local value = fields.from_text(patient_rules[name], text, full)
    if name == "cataract" then
        exercise.patient.nuclear_grade = grade_of(value, "--set " .. full .. "=" .. text)
    else
        exercise.patient[name] = value
    end
end

--- Applies --set name=text. settings: the names of the machine's settings; their ranges are the kernel's to check.
function language.set(exercise, name, text, settings)
    local patient, goal = name:match("^patient%.(.+)$"), name:match("^goal%.(.+)$")
    local quantity = name:match("^accuracy%.(.+)$")
    if name == "level" then return language.set_level(exercise, text) end
    if name == "language" then
        exercise.language = texts.known(text, "--language " .. text, exercise)
        return
    end
    for _, known in ipairs(changeable) do
        if known == name then
            exercise[name] = fields.from_text(exercise_rules[name], text, name)
            exercise.step_by_hand = exercise.step_by_hand or name == "step_s"
            return
        end
    end
    for _, known in ipairs(settings) do
        if known == name then
            exercise.settings[name] = fields.from_text({ kind = "number" }, text, name)
            return
        end
    end
    if patient and patient_rules[patient] then
        set_patient(exercise, patient, text, name)
    elseif quantity and accuracy.rule(quantity) then
        set_accuracy(exercise, quantity, text, name)
    elseif goal and exercise.goal_rules[goal] then
        exercise.goals[goal] = fields.from_text(exercise.goal_rules[goal], text, name)
    else
        words.fail("--set " .. name .. "=" .. text, ("nothing is called '%s'%s"):format(name,
            words.hint(name, language.changeable(exercise, settings))))
    end
end

return language
