-- SPDX-License-Identifier: GPL-3.0-or-later
-- The same words in another language. English is the key: a text without a translation stays English. Two places are
-- looked in: the exercise's own texts (`texts = { fr = {...} }`, or curriculum.fr.lua beside curriculum.lua), then
-- scripts/texts/fr.lua for the words of engine, rubric and report.

local fields = require "engine.fields"
local words = require "engine.words"

local texts = {}

--- Languages that engine and report speak besides English.
texts.shared = { "fr" }

local files = {}  -- language -> table, of files beside the curriculum

local function check_table(given, owner)
    if type(given) ~= "table" then
        words.fail(owner, "a file of texts must end with: return { [\"English\"] = ... }")
    end
    for key, value in pairs(given) do
        if type(key) ~= "string" or type(value) ~= "string" or value == "" then
            words.fail(owner, ("texts must be pairs [\"English\"] = \"translated\", not %s"):format(tostring(key)))
        end
        local complaint = words.unreadable(value, true)
        if complaint then words.fail(owner, ("the text for \"%s\" %s"):format(key, complaint)) end
    end
end

--- What a file of texts returned.
function texts.add_file(language, given, name)
    check_table(given, name)
    files[language] = given
end

--- `texts` of an exercise.
function texts.check(given)
    fields.named(given, words.where("texts"), "texts", "fr = { [\"English\"] = \"Texte\" }")
    for _, language in ipairs(words.keys(given)) do
        if not language:find("^%l%l$") then
            words.fail(words.where(language, words.line_of("texts")),
                ("texts: '%s' is no language of two small letters, such as fr"):format(language))
        end
        check_table(given[language], words.where("texts"))
    end
end

--- The languages in which an exercise can be run, besides English.
function texts.languages(exercise)
    local set = {}
    for _, language in ipairs(texts.shared) do set[language] = true end
    for language in pairs(files) do set[language] = true end
    for language in pairs(exercise.texts) do set[language] = true end
    return words.keys(set)
end

--- The languages that the exercise itself has texts in.
function texts.own_languages(exercise)
    local set = {}
    for language in pairs(files) do set[language] = true end
    for language in pairs(exercise.texts) do set[language] = true end
    return words.keys(set)
end

--- The English texts that the exercise itself translates into a language, sorted.
function texts.own_keys(language, exercise)
    local set = {}
    for _, given in ipairs({ exercise.texts[language] or {}, files[language] or {} }) do
        for text in pairs(given) do set[text] = true end
    end
    return words.keys(set)
end

--- Checks the name of a language and returns it.
function texts.known(name, where, exercise)
    local known = texts.languages(exercise)
    known[#known + 1] = "en"
    for _, language in ipairs(known) do
        if language == name then return name end
    end
    words.fail(where, ("there are no texts in '%s'%s"):format(name, words.hint(name, known)))
end

--- The words of engine, rubric and report in a language; none in English.
function texts.of(language)
    for _, name in ipairs(texts.shared) do
        if name == language then return require("texts." .. name) end
    end
    return {}
end

--- A function that gives a text in a language, or the text itself. exercise: whose own texts come first, or nil.
function texts.translator(language, exercise)
    if not language or language == "en" then return function(text) return text end end
    local own = exercise and exercise.texts[language] or {}
    local file, common = exercise and files[language] or {}, texts.of(language)
    return function(text)
        if text == nil then return nil end
        return own[text] or file[text] or common[text] or text
    end
end

--- Whether a text has a translation.
function texts.has(language, exercise, text)
    local own, file = exercise.texts[language] or {}, files[language] or {}
    return own[text] ~= nil or file[text] ~= nil or texts.of(language)[text] ~= nil
end

--- Calls f(owner, key) for every text of an exercise that someone reads.
function texts.each(exercise, f)
    f(exercise, "title")
    f(exercise, "summary")
    for i in ipairs(exercise.objectives) do f(exercise.objectives, i) end
    for _, step in ipairs(exercise.steps) do
        f(step, "title")
        f(step, "hint")
    end
    for _, event in ipairs(exercise.errors) do
        for _, key in ipairs({ "title", "cue", "advice" }) do f(event, key) end
        for i in ipairs(event.consequences.texts) do f(event.consequences.texts, i) end
    end
    for _, name in ipairs(words.keys(exercise.levels)) do f(exercise.levels[name], "meaning") end
    for _, request in ipairs(exercise.requests) do
        for _, key in ipairs({ "title", "meaning", "answer" }) do f(request, key) end
    end
end

--- Puts all texts of an exercise into its language.
function texts.translate(exercise)
    local translated = texts.translator(exercise.language, exercise)
    texts.each(exercise, function(owner, key) owner[key] = translated(owner[key]) end)
    exercise.translated = translated
end

return texts
