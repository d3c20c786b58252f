-- SPDX-License-Identifier: GPL-3.0-or-later
-- Items, measures and reasons in the language of the page. A report holds them in the language of its run, and as
-- whole sentences; what they are made of stands beside them, so that they can be told again.

local markup = require "report.markup"
local osacss = require "osacss"
local quantity = require "report.quantity"
local report_words = require "report.words"

local t, known, count = report_words.t, report_words.known, report_words.count

local reasons = {}

local full_points = 4.995  -- as in scoring.lua: from here on nothing was lost

local function find(list, id)
    for _, entry in ipairs(list) do
        if entry.id == id then return entry end
    end
    return nil
end

local function own_item(rubric, id) return (rubric or osacss.name) == osacss.name and find(osacss.items, id) or nil end

local function own_measure(rubric, item, measure)
    local own = own_item(rubric, item.id)
    return own and find(own.measures, measure.id)
end

--- How many items the rubric has, as far as that is known.
function reasons.items_of(score)
    return (score.rubric or osacss.name) == osacss.name and #osacss.items or #score.items
end

--- What an item of a rubric is called.
function reasons.item_name(rubric, item)
    local own = own_item(rubric, item.id)
    return own and t(own.name) or known(item.name)
end

local function full_name(rubric, item, measure)
    local own = own_measure(rubric, item, measure)
    return own and t(own.name) or known(measure.name) or measure.id
end

--- What a measure is called; a question whose answer is yes or no without how that was counted.
function reasons.measure_name(rubric, item, measure)
    local name = full_name(rubric, item, measure)
    return quantity.asked(name) or name
end

--- The value of a measure as a reader meets it.
function reasons.measure_value(measure)
    if type(measure.value) == "number" and (measure.unit or "1") == "1" and quantity.asked(measure.name) then
        return t(measure.value >= 0.5 and "yes" or "no")
    end
    return quantity.with_unit(markup.number(measure.value, 2), quantity.unit(measure.unit))
end

--- Sentences that say what would have made an item a four.
function reasons.to_four(rubric, item)
    local list = {}
    for _, error in ipairs(item.to_four.errors) do
        list[#list + 1] = t("Without \"%s\", or with it put right at once.", known(error.title))
    end
    for _, one in ipairs(item.to_four.measures) do
        local function told(value)
            return reasons.measure_value({ value = value, unit = one.unit, name = one.name })
        end
        list[#list + 1] = t("%s: %s instead of %s.", reasons.measure_name(rubric, item, one), told(one.wanted),
            told(one.value))
    end
    return list
end

local outcomes = { near_miss = "a near miss, put right at once", recovered = "put right",
    not_recovered = "not put right in time", open = "not put right yet" }

-- "Iris touched at 5.6 s and 2 times more, put right: at most 4 points."
local function cap_told(by, more)
    local again = more == 1 and t(" and once more") or more > 1 and t(" and %d times more", more) or ""
    return count(by.cap, "%s at %s%s, %s: at most %s point.", "%s at %s%s, %s: at most %s points.", known(by.title),
        markup.time(by.time_s), again, t(outcomes[by.outcome] or outcomes.open), markup.number(by.cap, 1))
end

-- Errors of one kind and outcome are told once.
local function caps_told(capped_by)
    local order, more = {}, {}
    for _, by in ipairs(capped_by) do
        local key = tostring(by.event) .. "/" .. tostring(by.outcome)
        if not more[key] then order[#order + 1] = by end
        more[key] = (more[key] or -1) + 1
    end
    local list = {}
    for i, by in ipairs(order) do list[i] = cap_told(by, more[tostring(by.event) .. "/" .. tostring(by.outcome)]) end
    return list
end

-- "1.25 to 2.75 mm", "1.25 or 2.75 mm" in the language of the page.
local function range_told(text)
    for _, pattern in ipairs { "%s to %s", "%s or %s" } do
        local low, high = text:match("^" .. pattern:gsub("%%s", "(.-)", 1):gsub("%%s", "(.+)") .. "$")
        if low then return t(pattern, low, high) end
    end
    return text
end

-- "(5 points at 0.2 mm, 3 at 0.5 mm, 1 at 1.0 mm)". What is not in English stays as it is.
local function scale_told(scale)
    local parts = {}
    for part in (scale:sub(2, -2) .. ", "):gmatch("(.-), ") do
        local points, rest = part:match("^(%d+) points at (.+)$")
        local first = points ~= nil
        if not first then points, rest = part:match("^(%d+) at (.+)$") end
        if not points then return scale:sub(2, -2) end
        parts[#parts + 1] = t(first and "%d points at %s" or "%d at %s", math.tointeger(tonumber(points)),
            range_told(rest))
    end
    return table.concat(parts, ", ")
end

-- "Length of the tunnel: 1.48 mm (5 points at ...). About as long as it is wide."
local function loss_told(rubric, item, measure)
    local better = measure.better and " " .. known(measure.better) or ""
    local name = full_name(rubric, item, measure)
    local rest = measure.text:sub(1, #measure.name) == measure.name and measure.text:sub(#measure.name + 1) or ""
    local amount, scale = rest:match("^%s*:%s*(.-)%s*(%b())$")
    local asked = amount and quantity.asked(name)
    if asked then return t("%s: %s", asked, reasons.measure_value(measure)) .. "." .. better end
    if not amount then return quantity.rewritten(known(measure.text)) .. "." .. better end
    return quantity.rewritten(t("%s: %s (%s)", name, amount, scale_told(scale))) .. "." .. better
end

-- Sentences that are the same in every report, and those that go on with something of the rubric.
local function as_given(list)
    local result = {}
    for i, line in ipairs(list) do
        local why = line:match("^Not scored: (.+)$")
        result[i] = why and t("Not scored: ") .. known(why) or quantity.rewritten(known(line))
    end
    return result
end

--- Why an item has its points: list of sentences.
function reasons.of(rubric, item)
    local given = item.reasons or {}
    local list = caps_told(item.capped_by or {})
    for _, measure in ipairs(item.measures or {}) do
        if type(measure.text) == "string" and (measure.score or 5) <= full_points then
            list[#list + 1] = loss_told(rubric, item, measure)
        end
    end
    return #list == #given and item.score and list or as_given(given)
end

return reasons
