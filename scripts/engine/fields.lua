-- SPDX-License-Identifier: GPL-3.0-or-later
-- Checks what a curriculum wrote against what may be written, and names the place of a mistake.

local condition = require "engine.condition"
local words = require "engine.words"

local fields = {}

local function is_number(value) return math.type(value) ~= nil and value == value and math.abs(value) < math.huge end

local function list_of_text(value)
    if type(value) ~= "table" then return false end
    local count = 0
    for _ in pairs(value) do count = count + 1 end
    for i = 1, count do
        if type(value[i]) ~= "string" then return false end
    end
    return true
end

local function list_of_places(value)
    if type(value) ~= "table" or #value == 0 then return false end
    for _, place in ipairs(value) do
        if type(place) ~= "table" or #place ~= 3 then return false end
        for _, of in ipairs(place) do
            if not is_number(of) or math.abs(of) > 100 then return false end
        end
    end
    return true
end

-- What a field may hold: a test, and how the message calls it.
local kinds = {
    text = { function(v) return type(v) == "string" and v ~= "" end, "a text in quotes" },
    line = { function(v) return type(v) == "string" and v ~= "" end, "a text in quotes" },  -- without line breaks
    number = { is_number, "a number" },
    yes_no = { function(v) return type(v) == "boolean" end, "true or false" },
    texts = { list_of_text, "a list of texts, like { \"lens\", \"bag\" }" },
    places = { list_of_places, "a list of places { x, y, z } in mm, like { { 2, 0, 3 } }" },
    table = { function(v) return type(v) == "table" end, "a table { ... }" },
    any = { function() return true end, "anything" },
    call = { function(v) return type(v) == "function" end, "a function" },
}

--- A value in a message.
function fields.shown(value)
    if type(value) == "string" then return '"' .. value .. '"' end
    if type(value) == "table" then return "a table" end
    if type(value) == "function" then return "a function" end
    if value ~= value then return "nan" end
    return tostring(value)
end

local shown = fields.shown

-- Texts go to terminals and into pages: nothing may be in them that commands a terminal.
local function check_readable(rule, value, where, name)
    for _, text in ipairs(type(value) == "table" and value or { value }) do
        local complaint = words.unreadable(text, rule.kind ~= "line")
        if complaint then words.fail(where, ("%s %s"):format(name, complaint)) end
    end
end

local function check_range(rule, value, where, name)
    if rule.whole and math.tointeger(value) == nil then
        words.fail(where, ("%s = %s must be a whole number"):format(name, shown(value)))
    end
    if value < (rule.from or -math.huge) or value > (rule.to or math.huge) then
        words.fail(where, ("%s = %s is out of range (%s to %s)"):format(name, shown(value), rule.from or "any",
            rule.to or "any"))
    end
end

local function check_choice(rule, value, where, name)
    for _, allowed in ipairs(rule.choices) do
        if allowed == value then return end
    end
    words.mistake(where, ("%s = %s is not allowed%s"):format(name, shown(value),
        words.choice_hint(value, rule.choices)))
end

--- Checks one value by a rule: { kind, from, to, whole, choices }. Raises with `where` and `name`.
function fields.check_value(rule, value, where, name)
    if rule.kind == "condition" then return condition.read(value, where, name) end
    local kind = kinds[rule.kind]
    if not kind[1](value) then
        words.fail(where, ("%s must be %s, not %s"):format(name, kind[2], shown(value)))
    end
    if rule.kind == "text" or rule.kind == "line" or rule.kind == "texts" then
        check_readable(rule, value, where, name)
    end
    if rule.from or rule.to or rule.whole then check_range(rule, value, where, name) end
    if rule.choices then
        for _, one in ipairs(type(value) == "table" and value or { value }) do check_choice(rule, one, where, name) end
    end
    return value
end

--- That a table has names only, which can be read: levels = { "easy" } names nothing. example: how it is written.
function fields.named(given, where, owner, example)
    for key, value in pairs(given) do
        if type(key) ~= "string" then
            words.mistake(where, ("%s: %s has no name: write %s"):format(owner, shown(value), example))
        else
            local complaint = words.unreadable(key)
            if complaint then words.mistake(where, ("%s: the name '%s' %s"):format(owner, key, complaint)) end
        end
    end
end

--- Reads a table of named fields. rules: name -> rule, with `default` or `required`. Returns a new table of checked
--- values; conditions come back as read by condition.read. owner: "step 'sculpt'", for messages. line: where the
--- declaration begins, or nil. While mistakes are collected, fields with a mistake are left out of the result.
function fields.read(given, rules, owner, line)
    if type(given) ~= "table" then
        words.fail(words.where(nil, line), owner .. " must be followed by a table { ... }")
    end
    local known = words.keys(rules)
    for key in pairs(given) do
        if type(key) ~= "string" then
            words.mistake(words.where(nil, line), owner .. " holds an entry without a name: " .. shown(given[key]))
        elseif not rules[key] then
            words.mistake(words.where(key, line), ("%s has no field '%s'%s"):format(owner, key, words.hint(key, known)))
        end
    end
    local result = {}
    for _, name in ipairs(known) do
        local rule = rules[name]
        local value = given[name]
        if value == nil then value = rule.default end
        if value == nil and rule.required then
            words.mistake(words.where(nil, line), ("%s lacks '%s'"):format(owner, name))
        end
        if value ~= nil then
            result[name] = words.try(fields.check_value, rule, value, words.where(name, line), owner .. ": " .. name)
        end
    end
    return result
end

--- A value given as text on the command line, as the number, yes/no or text that a rule wants.
function fields.from_text(rule, text, name)
    local value = text
    if rule.kind == "number" then
        value = tonumber(text)
        if value == nil or value ~= value then
            words.fail("--set " .. name .. "=" .. text, ("%s must be a number"):format(name))
        end
    elseif rule.kind == "yes_no" then
        if text == "true" then value = true elseif text == "false" then value = false end
    end
    return fields.check_value(rule, value, "--set " .. name .. "=" .. text, name)
end

return fields
