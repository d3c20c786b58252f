-- SPDX-License-Identifier: GPL-3.0-or-later
-- For what is written outside pages, as in the trainee's window: what instruments and settings are called, and the
-- shared translations.

local instruments = require "report.instruments"
local names = require "report.names"
local texts = require "engine.texts"
local words = require "report.words"

--- language: "en", "fr". list: names of instruments.
return function(language, list)
    words.use(language)
    local spoken = { texts = {}, instruments = {}, settings = {} }
    for english, text in pairs(texts.of(language)) do spoken.texts[english] = text end
    for _, name in ipairs(list) do spoken.instruments[name] = instruments.name(name) end
    for name, meaning in pairs(names.own) do spoken.settings[name] = words.known(meaning) end
    return spoken
end
