-- SPDX-License-Identifier: GPL-3.0-or-later
-- The report's own words in the language of the page: t "In short". English where there is no other.

local markup = require "report.markup"
local texts = require "engine.texts"

local report_words = { missing = {} }

local translated, language = {}, "en"

--- Chooses the language; a report is of one at a time.
function report_words.use(name)
    language = name or "en"
    translated = texts.translator(language)
    report_words.missing = {}
    markup.use(language)
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

--- Of two texts the one for `n` things, with the values. French counts none as one thing.
function report_words.count(n, one, many, ...)
    local single = n == 1 or language == "fr" and n < 2
    return report_words.t(single and one or many, ...)
end

--- A text in the quotation marks of the language.
function report_words.quoted(text)
    return language == "fr" and "«\u{A0}" .. text .. "\u{A0}»" or "“" .. text .. "”"
end

function report_words.language() return language end

return report_words
