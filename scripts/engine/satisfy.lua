-- SPDX-License-Identifier: GPL-3.0-or-later
-- Whether a condition written as text can ever hold, found from its form alone: "x < 1 and x > 2" cannot, whatever x
-- is. Goals count as the numbers that they are; measures may be anything, but one and the same at a time. What cannot
-- be decided is taken to be possible.

local satisfy = {}

local most_cases = 64  -- ways in which a condition could hold that are looked at

local flip = { ["<"] = ">", [">"] = "<", ["<="] = ">=", [">="] = "<=", ["=="] = "==", ["~="] = "~=" }
local opposite = { ["<"] = ">=", [">"] = "<=", ["<="] = ">", [">="] = "<", ["=="] = "~=", ["~="] = "==" }

local fold = {
    ["+"] = function(a, b) return a + b end,
    ["-"] = function(a, b) return a - b end,
    ["*"] = function(a, b) return a * b end,
    ["/"] = function(a, b) return a / b end,
    min = math.min,
    max = math.max,
    abs = function(a) return math.abs(a) end,
}

-- The value of a part that holds no measure, or nil. known: name -> number that does not change.
local function constant(node, known)
    if node.op == "constant" then return node.value end
    if node.op == "name" then return known(node.name) end
    if not fold[node.op] then return nil end
    local value = constant(node[1], known)
    for i = 2, #node do
        local right = constant(node[i], known)
        if type(value) ~= "number" or type(right) ~= "number" then return nil end
        value = fold[node.op](value, right)
    end
    if type(value) ~= "number" then return nil end
    return #node == 1 and fold[node.op](value) or value
end

--- Text of a part, the same for the same part.
local function text_of(node)
    if node.op == "constant" then return tostring(node.value) end
    if node.op == "name" then return node.name end
    local parts = {}
    for i, inner in ipairs(node) do parts[i] = text_of(inner) end
    return node.op .. "(" .. table.concat(parts, ",") .. ")"
end

-- A comparison as { key, sign, number }: of a part with a number, or of the difference of two parts with 0.
local function atom_of(node, sign, known)
    local left, right = constant(node[1], known), constant(node[2], known)
    if left ~= nil and right ~= nil then return nil end
    if type(right) == "number" then return { key = text_of(node[1]), sign = sign, number = right } end
    if type(left) == "number" then return { key = text_of(node[2]), sign = flip[sign], number = left } end
    local a, b = text_of(node[1]), text_of(node[2])
    if a <= b then return { key = a .. " - " .. b, sign = sign, number = 0 } end
    return { key = b .. " - " .. a, sign = flip[sign], number = 0 }
end

local compare = {
    ["<"] = function(a, b) return a < b end,
    ["<="] = function(a, b) return a <= b end,
    [">"] = function(a, b) return a > b end,
    [">="] = function(a, b) return a >= b end,
    ["=="] = function(a, b) return a == b end,
    ["~="] = function(a, b) return a ~= b end,
}

local cases_of

local function comparison_cases(node, negated, known)
    local left, right = constant(node[1], known), constant(node[2], known)
    if left ~= nil and right ~= nil then
        if type(left) ~= type(right) then return { {} } end
        return compare[node.op](left, right) ~= negated and { {} } or {}
    end
    if type(left) == "boolean" or type(right) == "boolean" then return { {} } end
    local atom = atom_of(node, negated and opposite[node.op] or node.op, known)
    atom.maybe_undefined = negated
    return { { atom } }
end

local function both(left, right)
    local all = {}
    for _, a in ipairs(left) do
        for _, b in ipairs(right) do
            if #all >= most_cases then return nil end
            local joined = table.move(a, 1, #a, 1, {})
            all[#all + 1] = table.move(b, 1, #b, #joined + 1, joined)
        end
    end
    return all
end

local function either(left, right)
    if #left + #right > most_cases then return nil end
    return table.move(right, 1, #right, #left + 1, left)
end

-- The ways in which a condition could hold, each a list of atoms; nil: too many.
function cases_of(node, negated, known)
    if node.op == "not" then return cases_of(node[1], not negated, known) end
    if node.op == "and" or node.op == "or" then
        local left, right = cases_of(node[1], negated, known), cases_of(node[2], negated, known)
        if not left or not right then return nil end
        return ((node.op == "and") ~= negated and both or either)(left, right)
    end
    if compare[node.op] then return comparison_cases(node, negated, known) end
    local value = constant(node, known)
    if value ~= nil then return (value and true or false) ~= negated and { {} } or {} end
    return { { { key = text_of(node), sign = negated and "no" or "yes", maybe_undefined = negated } } }
end

local function narrow(range, atom)
    local sign, number = atom.sign, atom.number
    if sign == "yes" or sign == "no" then
        range.impossible = range.impossible or (range.yes ~= nil and range.yes ~= (sign == "yes"))
        range.yes = sign == "yes"
    elseif sign == "~=" then
        range.without = number
    else
        if sign ~= "<" and sign ~= "<=" and (number > range.low or (number == range.low and sign == ">")) then
            range.low, range.open_low = number, sign == ">"
        end
        if sign ~= ">" and sign ~= ">=" and (number < range.high or (number == range.high and sign == "<")) then
            range.high, range.open_high = number, sign == "<"
        end
    end
    range.defined = range.defined or not atom.maybe_undefined
end

local function empty(range)
    if not range.defined then return false end  -- a measure that is not defined makes `not (x < 1)` hold
    if range.impossible or range.low > range.high then return true end
    return range.low == range.high and (range.open_low or range.open_high or range.without == range.low)
end

-- bounds: key -> { low, high } of measures that have such.
local function possible(atoms, bounds)
    local ranges, keys = {}, {}
    for _, atom in ipairs(atoms) do
        if not ranges[atom.key] then
            local bound = bounds[atom.key] or {}
            ranges[atom.key] = { low = bound.low or -math.huge, high = bound.high or math.huge }
            keys[#keys + 1] = atom.key
        end
        narrow(ranges[atom.key], atom)
    end
    for _, key in ipairs(keys) do
        if empty(ranges[key]) then return false end
    end
    return true
end

--- Whether a parsed condition can hold. known(name): its number where it never changes; bounds: see above.
function satisfy.can_hold(parsed, known, bounds)
    local cases = cases_of(parsed.tree, false, known)
    if not cases then return true end
    for _, atoms in ipairs(cases) do
        if possible(atoms, bounds) then return true end
    end
    return false
end

--- Whether a parsed condition holds nothing that changes.
function satisfy.never_changes(parsed, known)
    for _, name in ipairs(parsed.names) do
        if known(name) == nil then return false end
    end
    return true
end

return satisfy
