-- SPDX-License-Identifier: GPL-3.0-or-later
-- Settings that a curriculum names, against those that the kernel has: names, ranges, and whether they may change while
-- a scene runs. The host says what there is before a curriculum is read; without that, nothing is checked here.

local words = require "engine.words"

local check = {}

local table_of = nil  -- name -> { from, to, standard, live, tissue }

--- list: of { name, from, to, standard, live, tissue, unit, meaning }.
function check.know(list)
    table_of = {}
    for _, setting in ipairs(list) do table_of[setting.name] = setting end
end

--- Nothing is known any more: for tests.
function check.forget() table_of = nil end

--- What the kernel says of a setting, or nil.
function check.info(name) return table_of and table_of[name] end

--- Every setting of the kernel, sorted by name.
function check.list()
    local list = {}
    for i, name in ipairs(words.keys(table_of or {})) do list[i] = table_of[name] end
    return list
end

local function plain(name) return name:match("([%w_]+)$") end

-- "file:line" of a setting, written whole or by its last word.
local function where_of(name, line)
    local whole = words.where(name, line)
    if whole ~= words.where(nil, line) then return whole end
    return words.where(plain(name), line)
end

local function unknown(name)
    return ("there is no setting '%s'%s"):format(name, words.hint(name, words.keys(table_of)))
end

local function beyond(name, value)
    local setting = table_of[name]
    return (value < setting.from or value > setting.to) and ("%s = %g is out of range (%g to %g)"):format(name, value,
        setting.from, setting.to) or nil
end

local function fixed(name) return not table_of[name].live and name .. " is fixed before the first step" or nil end

-- The eye is the patient's: a script judges it, and does not make it ill.
local function of_tissue(name)
    return table_of[name].tissue and name .. " is the eye's, not the machine's: only a request of the instructor "
        .. "changes it while the exercise runs" or nil
end

--- What is wrong with a setting that a script changes while the scene runs, or nil.
function check.live_complaint(name, value)
    if not table_of then return nil end
    if not table_of[name] then return unknown(name) end
    return beyond(name, value) or fixed(name) or of_tissue(name)
end

local function refuse(name, line, owner, complaint)
    if complaint then words.mistake(where_of(name, line), owner .. complaint) end
end

--- That there is such a setting.
function check.name(name, line, owner)
    if table_of and not table_of[name] then refuse(name, line, owner, unknown(name)) end
end

--- settings: name -> number. line: from where on to look for them. owner: before the message.
function check.all(settings, line, owner)
    if not table_of then return end
    for _, name in ipairs(words.keys(settings)) do
        check.name(name, line, owner)
        if table_of[name] then refuse(name, line, owner, beyond(name, settings[name])) end
    end
end

--- The same for settings that are changed while the scene runs, at a person's request.
function check.live(settings, line, owner)
    if not table_of then return end
    check.all(settings, line, owner)
    for _, name in ipairs(words.keys(settings)) do
        if table_of[name] then refuse(name, line, owner, fixed(name)) end
    end
end

--- The same for settings that the exercise changes by itself.
function check.scripted(settings, line, owner)
    check.live(settings, line, owner)
    if not table_of then return end
    for _, name in ipairs(words.keys(settings)) do
        if table_of[name] then refuse(name, line, owner, of_tissue(name)) end
    end
end

return check
