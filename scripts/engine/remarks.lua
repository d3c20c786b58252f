-- SPDX-License-Identifier: GPL-3.0-or-later
-- What rhexis check remarks on an exercise that is well formed, but may not do what its author meant: items that
-- nothing tells of, errors that count for nothing, what holds from the first moment on, translations of texts that are
-- not there. These are no mistakes: an exercise may be meant so.

local osacss = require "osacss"
local texts = require "engine.texts"
local words = require "engine.words"

local remarks = {}

-- Of OSACSS, which knows measures of all exercises, only what leaves a whole item without any; of a rubric of one's own
-- each measure.
local function unscored(exercise, sheet, say)
    for _, untold in ipairs(sheet and sheet:untold() or {}) do
        local first = untold.measures[1]
        if untold.none and exercise.scoring.rubric == osacss then
            say("scoring: item %s (%s) cannot be scored here: nothing that this exercise simulates tells of it",
                untold.item.id, untold.item.name)
        elseif first and exercise.scoring.rubric ~= osacss then
            for _, one in ipairs(untold.measures) do
                say("scoring: measure %s of item %s counts for nothing here: %s", one.measure.id, untold.item.id,
                    one.complaint or "it is not watched")
            end
        end
    end
end

local function items_that_count_for_nothing(exercise, say)
    local scoring = exercise.scoring
    for _, event in ipairs(exercise.errors) do
        for _, item in ipairs(scoring and event.items or {}) do
            if not words.has(scoring.items, item) then
                say("error_event '%s': item %s is not among those of `scoring`, so nothing is limited there",
                    event.name, item)
            end
        end
    end
end

-- After a moment in which nobody did anything.
local function from_the_first_moment(exercise, run, say)
    for _, event in ipairs(run.events) do
        if event.time_s <= 2 * exercise.step_s then
            say("error_event '%s' happens at the first moment, before anybody can do anything", event.title)
        end
    end
    for i, step in ipairs(exercise.steps) do
        local record = run.steps.records[i]
        if record and record.completed and not step.script then
            say("step '%s' is done at the first moment, before anybody has done anything", step.name)
        end
    end
end

local function translations_of_nothing(exercise, say)
    local there, list = {}, {}
    texts.each(exercise, function(owner, key)
        local text = owner[key]
        if text and not there[text] then
            there[text] = true
            list[#list + 1] = text
        end
    end)
    for _, language in ipairs(texts.own_languages(exercise)) do
        for _, text in ipairs(texts.own_keys(language, exercise)) do
            local near = not there[text] and not exercise.whole and words.near(text, list)[1]
            if near and near ~= text then
                say("texts in %s: nothing here says \"%s\" (did you mean \"%s\"?)", language, text, near)
            end
        end
    end
end

--- exercise: as loaded; run: of it, after a moment. Returns a list of lines.
function remarks.of(exercise, run)
    local lines = {}
    local function say(text, ...) lines[#lines + 1] = "note: " .. text:format(...) end
    if not exercise.whole then
        unscored(exercise, run.sheet, say)
        items_that_count_for_nothing(exercise, say)
    end
    from_the_first_moment(exercise, run, say)
    translations_of_nothing(exercise, say)
    return lines
end

return remarks
