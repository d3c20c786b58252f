-- SPDX-License-Identifier: GPL-3.0-or-later
-- What bindings/lua/exercise_host.cpp calls: the whole border between the kernel and the exercise engine.

local Eye = require "engine.eye"
local Run = require "engine.run"
local accuracy = require "engine.accuracy"
local condition = require "engine.condition"
local globals = require "engine.globals"
local injections = require "engine.injections"
local language = require "exercise"
local operation = require "operation"
local osacss = require "osacss"
local quotes = require "engine.quotes"
local remarks = require "engine.remarks"
local requests = require "engine.requests"
local review = require "engine.review"
local scoring = require "scoring"
local settings_check = require "engine.settings_check"
local standing = require "engine.standing"
local texts = require "engine.texts"
local vocabulary = require "engine.vocabulary"
local words = require "engine.words"

local host = {}

local vocabulary_of_files = { exercise = language.exercise, step = language.step, error_event = language.error_event,
    request = language.request, operation = operation.operation, part = operation.part, osacss = osacss,
    rubric = scoring.rubric }

--- The words that a curriculum finds besides the standard ones.
function host.environment()
    local own = {}
    for name, word in pairs(vocabulary_of_files) do own[name] = word end
    globals.refuse_unknown()
    return globals.of(own)
end

--- Before the curriculum runs: its name in messages and its text.
function host.begin_file(name, text)
    words.begin_file(name, text)
    quotes.refuse_curly(name, text)
end

--- Runs a file and gives what it returns to host[receiver], whose answer is returned.
function host.read(receiver, file) return words.read(file, host[receiver]) end

--- Before any curriculum: the settings of the kernel, list of { name, from, to, standard, live, tissue, unit,
--- meaning }.
host.know_settings = settings_check.know

--- Likewise what an error budget may be about, list of { name, unit, from, to, meaning }.
host.know_quantities = accuracy.know

--- A file of texts beside the curriculum, "curriculum.fr.lua": what it returned.
function host.accept_texts(value)
    local name = words.file()
    texts.add_file(name:match("%.(%l%l)%.lua$"), value, name)
end

--- The file "curriculum.marks.lua" beside the curriculum: what it returned.
function host.accept_marks(value) host.marked = { file = words.file(), places = value } end

--- Before an operation runs: the language of its texts.
function host.speak(name) host.spoken = name end

--- After it ran: what it returned. Of an operation, what it is made of; of anything else, nothing.
function host.accept_operation(value)
    if type(value) ~= "table" or value.kind ~= "operation" then return nil end
    host.operation = value
    return operation.listing(value, texts.translator(host.spoken, { texts = {} }))
end

--- After it ran: what it returned.
function host.accept(value)
    if type(value) == "table" and value.kind == "operation" then
        words.fail(words.where(), "this is an operation, made of exercises; rhexis run and rhexis check take it, "
            .. "here an exercise is wanted")
    end
    if type(value) ~= "table" or value.kind ~= "exercise" then
        words.fail(words.where(), "a curriculum must end with: return exercise { ... }")
    end
    host.exercise = value
    if host.marked then language.mark(value, host.marked) end
end

--- After it ran: what it returned. Whether that is a rubric, to judge an exercise by in place of its own.
function host.is_rubric(value) return type(value) == "table" and value.by_id ~= nil and value.caps ~= nil end

-- Items of another rubric that judge what the exercise is scored by: who drapes is not judged on depth in the eye.
local function items_for(rubric, scoring_of)
    local scored, ids = {}, {}
    for _, id in ipairs(scoring_of and scoring_of.items or {}) do scored[id] = true end
    for _, item in ipairs(rubric.items) do
        local wanted = not item.errors_of or not scoring_of
        for _, id in ipairs(item.errors_of or {}) do wanted = wanted or scored[id] end
        if wanted then ids[#ids + 1] = item.id end
    end
    return rubric(ids)
end

--- After the exercise and then a rubric ran: the exercise, and the operation that it is a part of, is judged by the
--- rubric.
function host.judge_by(value)
    if not host.is_rubric(value) then
        words.fail(words.where(), "a rubric must end with: return rubric { ... }")
    end
    host.exercise.scoring = items_for(value, host.exercise.scoring)
    local whole = host.exercise.whole
    if whole then whole.scoring = items_for(value, whole.scoring) end
end

--- Makes the exercise a part of the operation: place = { index, before, live }. Returns nothing.
function host.join(place) operation.join(host.operation, place.index, host.exercise, place.before, place.live) end

--- --set name=text; settings: names that the kernel knows. Returns the complaint, or nil.
function host.set(name, text, settings)
    local ok, complaint = pcall(language.set, host.exercise, name, text, settings)
    if not ok then return complaint end
    host.changed = host.changed or standing.is_another_task(name)
    return nil
end

--- How virtual surgeons did the exercise: an entry of rubrics/cohorts.json, or nil.
function host.take_cohort(cohort) host.cohort = cohort end

local function shorten_times(exercise)
    for _, event in ipairs(exercise.errors) do
        event.deadline_s = math.min(event.deadline_s, exercise.recover_within_s or event.deadline_s)
        event.hold_s = math.min(event.hold_s, exercise.hold_within_s or event.hold_s)
    end
end

--- All is set: what remains to be done before the scene is built.
function host.ready()
    local exercise = host.exercise
    shorten_times(exercise)
    texts.translate(exercise)
    local port = settings_check.info("side_port.angle_deg")
    if exercise.handedness == "left" and port and words.has(exercise.tissues, "wounds") then
        exercise.settings["side_port.angle_deg"] = -(exercise.settings["side_port.angle_deg"] or port.standard)
    end
end

--- The scene that the exercise asks for.
function host.scene()
    local exercise = host.exercise
    return { title = exercise.title, objectives = exercise.objectives, levels = words.keys(exercise.levels),
        version = exercise.version, surgeon = exercise.surgeon,
        patient = words.as_object(exercise.patient), tissues = exercise.tissues, instruments = exercise.instruments,
        settings = words.as_object(exercise.settings), step_s = exercise.step_s, advance = exercise.advance,
        accuracy = words.as_object(exercise.accuracy), accuracy_where = exercise.accuracy_where,
        step_by_hand = exercise.step_by_hand == true, chosen = exercise.chosen,
        time_limit_s = exercise.time_limit_s, goals = words.as_object(exercise.goals) }
end

--- How finely that scene is simulated, as the kernel chose it: { step_s, models }.
function host.choose(chosen) host.exercise.chosen, host.exercise.step_s = chosen, chosen.step_s end

--- The error events that the exercise declares: id, title, whether they can be put right, and by what text.
function host.declared_events()
    local list = {}
    for i, event in ipairs(host.exercise.errors) do
        local part = event.recovered and event.recovered[#event.recovered]
        list[i] = { id = event.id, title = event.title, recovers = event.recovered ~= nil,
            recovered = part and part.tree and part.text or nil }
    end
    return list
end

--- What may be asked of the staff.
function host.declared_requests() return requests.listing(host.exercise.requests) end

--- schema: list of { name, unit, meaning }. The row that observe reads is returned: the host overwrites it.
function host.start(schema)
    words.collect_mistakes()
    host.run = words.try(Run.new, host.exercise, schema)
    words.tell_mistakes()
    host.row = {}
    return host.row
end

--- asked: ids of the requests made in the step that led here, or nil; aids, notes: likewise, list of { name, value,
--- text }, or nil.
function host.observe(time_s, asked, aids, notes)
    return host.run:observe(time_s, host.row, asked, aids, notes)
end

--- Whether the turn has just come to another step: when a changed exercise may be taken up.
function host.at_boundary() return host.run ~= nil and not host.run.finished and host.run.steps:has_turned() end

--- Places that a person is shown now, in teaching mode: list of { x, y, z }.
function host.marks()
    local shown = host.run ~= nil and host.exercise.mode == "teaching"
    return shown and host.run.steps:marks() or {}
end

--- What the theatre's monitor shows now; score: with the points so far.
function host.theatre(score) return host.run and host.run:theatre(score) or nil end

--- What an instructor may let happen in this scene: see theatre/injections.lua.
function host.injections() return injections.listing(host.run.eye, host.exercise) end

--- What of a level may change while the exercise runs, and how many values may not.
function host.level_now(name)
    local level, settings, later = host.exercise.levels[name], words.as_object({}), 0
    if not level then return nil end
    for _, key in ipairs(words.keys(level.settings)) do
        local info = settings_check.info(key)
        if info and info.live then settings[key] = level.settings[key] else later = later + 1 end
    end
    return { settings = settings, later = later + #words.keys(level.patient) + #words.keys(level.goals or {}) }
end

--- Warnings that show now: list of { title, advice }.
function host.warnings() return host.run and host.run:raised_warnings() or {} end

--- Of the exercise as it was, and to the exercise as it is now, after start.
function host.left() return host.run:left() end
function host.take_up(left) host.run:take_up(left) end

function host.finished() return host.run ~= nil and host.run.finished == true end

--- The error events so far.
function host.events()
    local list = {}
    for i, event in ipairs(host.run.events) do
        list[i] = { id = event.id, title = event.title, time_s = event.time_s, outcome = event.outcome,
            recovery_s = event.recovery_s, given = event.given }
    end
    return list
end

--- Watches for a moment besides what the exercise watches: moment = { when, where }.
function host.watch(moment)
    host.moment = condition.bind(condition.read(moment.when, moment.where, "when"), host.run.eye, "in 'when'")
end

--- Whether that moment is now.
function host.reached() return host.moment.test() end

function host.result()
    if not host.run then return words.as_object({}) end
    local result = host.run:result()
    if result.osacss then
        result.osacss.standing = standing.of(result.osacss, result.completed, host.cohort, host.changed)
    end
    if result.operation then result.operation.carried.scene = host.scene() end
    return result
end

--- What rhexis check tells of an exercise that has been started.
function host.review()
    local found = review.of(host.exercise, host.run.eye)
    table.move(remarks.of(host.exercise, host.run), 1, 64, #found.notes + 1, found.notes)
    return found
end

--- Measures that steps, events and scores of the exercise use, as far as it has come: a list.
function host.used_measures() return words.keys(host.run.eye.used) end

--- The scene of an exercise with mistakes, without what is none: the names of a scene can be told all the same.
function host.scene_in_spite()
    local exercise = host.exercise or {}
    local function known(list)
        local names = {}
        for _, name in ipairs(list or {}) do
            if words.has(words.parts, name) then names[#names + 1] = name end
        end
        return names
    end
    return { patient = words.as_object({}), tissues = known(exercise.tissues), settings = words.as_object({}),
        instruments = known(exercise.instruments), step_s = 0.01, advance = "automatic" }
end

--- What is wrong with the conditions of such an exercise, where its scene is as it says: a list.
function host.mistakes_of(schema)
    local exercise = host.exercise
    local scene = host.scene_in_spite()
    if not exercise or not exercise.steps or not exercise.tissues or not exercise.instruments or #schema == 0 then
        return {}
    end
    if #scene.tissues < #exercise.tissues or #scene.instruments < #exercise.instruments then return {} end
    words.collect_mistakes()
    pcall(Run.new, exercise, schema)
    local list = {}
    for _, text in ipairs(words.take_mistakes()) do
        if not text:find("^scripts/") then list[#list + 1] = text end  -- the engine met what a mistake left out
    end
    return list
end

--- The vocabulary of such an exercise. schema: list of { name, unit, meaning }.
function host.vocabulary_of(schema)
    local exercise = host.exercise or {}
    local shown = { goals = {}, goal_rules = {}, requests = {}, scoring = exercise.scoring }
    if exercise.goal_rules then shown.goals, shown.goal_rules = exercise.goals, exercise.goal_rules end
    return vocabulary.of(shown, { eye = Eye.new(schema, shown.goals) })
end

--- Every name that the exercise, which has been started, may use.
function host.vocabulary() return vocabulary.of(host.exercise, host.run) end

return host
