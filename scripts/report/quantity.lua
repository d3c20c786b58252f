-- SPDX-License-Identifier: GPL-3.0-or-later
-- A measure, setting or goal as a reader meets it: its meaning instead of its name, its value with a unit.

local instruments = require "report.instruments"
local markup = require "report.markup"
local names = require "report.names"
local report_words = require "report.words"

local t, known = report_words.t, report_words.known

local quantity = {}

local kinds = {}  -- what the exercise measured, as series.json tells it: name to { unit, meaning }

--- Takes what series.json tells of the measures.
function quantity.use(measures) kinds = type(measures) == "table" and measures or {} end

-- How a name ends, the longest first, the unit that this tells, and how often it holds what is counted.
local endings = { { "_mm3_mmhg", "mm³/mmHg" }, { "_ml_min", "ml/min" }, { "_percent", "%" }, { "_mm_s3", "mm/s³" },
    { "_mm3_s", "mm³/s" }, { "_share", "%", 100 }, { "_mNmm", "mN mm" }, { "_deg_s", "°/s" }, { "_mm_s", "mm/s" },
    { "_ul_s", "µl/s" }, { "_mmhg", "mmHg" }, { "_mNm", "mN m" }, { "_mm2", "mm²" }, { "_mm3", "mm³" },
    { "_deg", "°" }, { "_khz", "kHz" }, { "_hz", "Hz" }, { "_mm", "mm" }, { "_um", "µm" }, { "_ml", "ml" },
    { "_mg", "mg" }, { "_mJ", "mJ" }, { "_mN", "mN" }, { "_cm", "cm" }, { "_c", "°C" }, { "_n", "N" }, { "_s", "s" } }

-- Units as rubrics and the kernel write them.
local written = { ["1"] = "", bool = "", deg = "°", degrees = "°", ["degrees C"] = "°C", ["ul/s"] = "µl/s",
    um = "µm", x = "×", ["mm^2"] = "mm²", ["mm^3"] = "mm³", ["mm^3/s"] = "mm³/s", ["mm/s^3"] = "mm/s³" }

--- A unit as people write it.
function quantity.unit(unit) return unit and (written[unit] or known(unit)) or "" end

--- A number with its unit.
function quantity.with_unit(number, unit)
    if unit == "" then return number end
    return number .. (unit:sub(1, 2) == "°" and unit ~= "°C" and "" or "\u{A0}") .. unit
end

-- Those that are written otherwise, the longest first: "degrees C" before "degrees".
local by_length = {}
for unit, better in pairs(written) do
    if better ~= "" then by_length[#by_length + 1] = unit end
end
table.sort(by_length, function(a, b) return #a > #b or #a == #b and a < b end)

--- Units within a sentence of a rubric: "1.2 ul/s".
function quantity.rewritten(text)
    for _, unit in ipairs(by_length) do
        local place = "(%d) " .. unit:gsub("%p", "%%%0")
        text = text:gsub(place .. "%f[^%w%^/]", function(digit) return quantity.with_unit(digit, written[unit]) end)
    end
    return text
end

local function unit_of(name)
    for _, ending in ipairs(endings) do
        if name:sub(-#ending[1]) == ending[1] then return ending[2], ending[3] or 1, name:sub(1, -#ending[1] - 1) end
    end
    if names.shares[name] or names.shares[name:match("[^.]+$")] then return "%", 100, name end
    return nil, 1, name
end

-- As exact as someone can make use of.
local function digits_of(value)
    local size = math.abs(value)
    return size >= 100 and 0 or size >= 10 and 1 or size >= 0.1 and 2 or 3
end

local function is_yes_no(name)
    return names.yes_no[name] or names.yes_no[name:match("[^.]+$")] or kinds[name] and kinds[name].unit == "bool"
end

local function value_of(name, value)
    if type(value) == "number" and is_yes_no(name) then value = value >= 0.5 end
    if type(value) == "boolean" then return t(value and "yes" or "no") end
    if type(value) ~= "number" then return markup.number(value) end
    local unit, times = unit_of(name)
    if not unit and kinds[name] then unit = quantity.unit(kinds[name].unit) end
    return quantity.with_unit(markup.number(times * value, digits_of(times * value)), unit or "")
end

-- The words of a name that nobody has given a meaning.
local function words_of(name)
    local _, _, rest = unit_of(name)
    return (rest:gsub("[._]+", " "))
end

local function kernels_meaning(name)
    local meaning = kinds[name] and kinds[name].meaning
    if type(meaning) ~= "string" or meaning == "" then return nil end
    meaning = known(meaning)
    local first, second = meaning:sub(1, 1), meaning:sub(2, 2)
    if second:find("%l") or second == " " then meaning = first:lower() .. meaning:sub(2) end
    return (meaning:gsub("%.$", ""))
end

--- What a measure or setting means.
function quantity.meaning(name)
    if names.own[name] then return t(names.own[name]) end
    local instrument, what = name:match("^([%l_%d]+)%.([%w_]+)$")
    if instrument and names.of_instrument[what] and instruments.known(instrument) then
        return t(names.of_instrument[what], instruments.name(instrument))
    end
    return kernels_meaning(name) or words_of(name)
end

local function told(name, meaning, value)
    return ('<span class="quantity" title="%s">%s <b>%s</b></span>'):format(markup.escape(name),
        markup.escape(meaning), markup.escape(value))
end

--- "force of the tip 0.3 mN" as HTML; the name is to be seen by who points at it.
function quantity.measure(name, value) return told(name, quantity.meaning(name), value_of(name, value)) end

--- The same of a goal, whose meaning is another than that of a measure.
function quantity.goal(name, value)
    local meaning = names.goals[name]
    return told(name, meaning and t(meaning) or words_of(name), value_of(name, value))
end

--- Meaning and value apart, as plain text, for sentences.
function quantity.parts(name, value) return quantity.meaning(name), value_of(name, value) end

--- All of a table as HTML, one after the other. tell: quantity.measure or quantity.goal.
function quantity.all(values, tell)
    local sorted, pieces = {}, {}
    for name in pairs(values or {}) do sorted[#sorted + 1] = name end
    table.sort(sorted)
    for i, name in ipairs(sorted) do pieces[i] = tell(name, values[name]) end
    return table.concat(pieces, " · ")
end

--- What a rubric asks whose answer is yes or no: "Pedal tested (1: yes)" without its end. Nil where it asks for more.
function quantity.asked(name)
    local question, answer = tostring(name):match("^(.-)%s*%(1 ?: ?(%a+)%)$")
    return (answer == "yes" or answer == "oui") and question or nil
end

return quantity
