-- SPDX-License-Identifier: GPL-3.0-or-later
-- The report's own words in the language of the run: t "In short". English where there is no other.

local texts = require "engine.texts"

local report_words = { missing = {} }

local translated, language = {}, "en"

--- Chooses the language; a report is of one at a time.
function report_words.use(name)
    language = name or "en"
    translated = texts.translator(language)
    report_words.missing = {}
end

report_words.use("en")

--- A text in that language. With values: as string.format.
function report_words.t(text, ...)
    local found = translated(text)
    if language ~= "en" and not texts.has(language, { texts = {} }, text) then
        table.insert(report_words.missing, text)
    end
    return select("#", ...) > 0 and found:format(...) or found
end

--- A text that need not have a translation, such as a rubric's own.
function report_words.known(text) return translated(text) end

function report_words.language() return language end

return report_words
