-- SPDX-License-Identifier: GPL-3.0-or-later
-- What error an exercise may make: `accuracy = { force = 0.25, volume = 0.1 }`. The kernel lists the quantities and
-- chooses mesh and step from its tables; here the words are checked.

local fields = require "engine.fields"
local words = require "engine.words"

local accuracy = {}

local rules = {}
local quantities = {}

--- list: of { name, unit, from, to, meaning }.
function accuracy.know(list)
    rules, quantities = {}, list
    for _, quantity in ipairs(list) do
        rules[quantity.name] = { kind = "number", from = quantity.from, to = quantity.to }
    end
end

--- Every quantity of the kernel, sorted by name.
function accuracy.list() return quantities end

--- The rule of one quantity, or nil.
function accuracy.rule(name) return rules[name] end

--- given: quantity -> error that may be made. owner: "exercise", for messages. line: from where to look for them.
function accuracy.read(given, owner, line)
    return fields.read(given, rules, owner, words.line_of("accuracy", line))
end

return accuracy
