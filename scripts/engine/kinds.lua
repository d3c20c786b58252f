-- SPDX-License-Identifier: GPL-3.0-or-later
-- Whether the parts of a condition fit each other: what is true or false is not compared with a number nor reckoned
-- with, and a number does not stand alone, since it would hold whatever it is.

local kinds = {}

local joins = { ["and"] = true, ["or"] = true, ["not"] = true }
local orders = { ["<"] = true, ["<="] = true, [">"] = true, [">="] = true }
local equals = { ["=="] = true, ["~="] = true }

local function called(node) return node.name or node.text or "a part of it" end

local function number_alone(node)
    local name = called(node)
    return ("%s is a number, which holds whatever it is: compare it, as in \"%s > 1\""):format(name, name)
end

-- "phaco.present == 0" was meant as "not phaco.present".
local function instead(op, yes_no, number)
    local name = called(yes_no)
    local zero = number.op == "constant" and number.value == 0
    local one = number.op == "constant" and number.value == 1
    if zero and op == "==" or one and op == "~=" then return "write \"not " .. name .. "\"" end
    if one and op == "==" or zero and op == "~=" then return "write \"" .. name .. "\"" end
    return "write it alone, or after `not`"
end

local function compared(node, found)
    if orders[node.op] then
        local odd = found[1] == "yes_no" and node[1] or found[2] == "yes_no" and node[2]
        return odd and ("what is true or false has no size: %s cannot be compared by %s"):format(called(odd), node.op)
    end
    if found[1] == found[2] then return nil end
    local yes_no, number = node[1], node[2]
    if found[2] == "yes_no" then yes_no, number = number, yes_no end
    if yes_no.op == "constant" then
        return ("%s is a number, and never true or false: compare it with a number"):format(called(number))
    end
    return ("%s is true or false, and no number: %s"):format(called(yes_no), instead(node.op, yes_no, number))
end

local function misused(node, found)
    if orders[node.op] or equals[node.op] then return compared(node, found) end
    for i, kind in ipairs(found) do
        if joins[node.op] and kind == "number" then return number_alone(node[i]) end
        if not joins[node.op] and kind == "yes_no" then
            return ("%s is true or false: nothing can be reckoned with it"):format(called(node[i]))
        end
    end
    return nil
end

-- "yes_no" or "number"; or nil and what is wrong.
local function kind_of(node, is_yes_no)
    if node.op == "constant" then return type(node.value) == "boolean" and "yes_no" or "number" end
    if node.op == "name" then return is_yes_no(node.name) and "yes_no" or "number" end
    local found = {}
    for i, inner in ipairs(node) do
        local kind, complaint = kind_of(inner, is_yes_no)
        if complaint then return nil, complaint end
        found[i] = kind
    end
    local complaint = misused(node, found)
    if complaint then return nil, complaint end
    return (joins[node.op] or orders[node.op] or equals[node.op]) and "yes_no" or "number"
end

--- What is wrong with a parsed text as a condition, or nil. is_yes_no(name): whether a measure is true or false.
function kinds.complaint(parsed, is_yes_no)
    local kind, complaint = kind_of(parsed.tree, is_yes_no)
    if complaint then return complaint end
    return kind == "number" and number_alone(parsed.tree) or nil
end

return kinds
