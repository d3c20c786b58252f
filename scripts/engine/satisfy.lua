-- SPDX-License-Identifier: GPL-3.0-or-later
-- Whether a condition written as text can ever hold, found from its form alone: "x < 1 and x > 2" cannot, whatever x
-- is. Goals count as the numbers that they are; measures may be anything, but one and the same at a time. What cannot
-- be decided is taken to be possible.

local interval = require "engine.interval"

local satisfy = {}

local most_cases = 64  -- ways in which a condition could hold that are looked at

local flip = { ["<"] = ">", [">"] = "<", ["<="] = ">=", [">="] = "<=", ["=="] = "==", ["~="] = "~=" }
local opposite = { ["<"] = ">=", [">"] = "<=", ["<="] = ">", [">="] = "<", ["=="] = "~=", ["~="] = "==" }

-- Stands for the value of a part that never has one, such as 1 / 0.
local undefined = {}

-- The value of a part that holds no measure; undefined; or nil. known: name -> number that does not change.
local function constant(node, known)
    if node.op == "constant" then return node.value end
    if node.op == "name" then return known(node.name) end
    if not interval.fold[node.op] then return nil end
    local values, whole = {}, true
    for i, inner in ipairs(node) do
        local value = constant(inner, known)
        if value == undefined or (i == 2 and node.op == "/" and value == 0) then return undefined end
        whole = whole and type(value) == "number"
        values[i] = value or 0
    end
    if not whole then return nil end
    local value = interval.folded(node.op, values)
    return math.abs(value) < math.huge and value or undefined  -- not a number is neither
end

--- Text of a part, the same for the same part.
local function text_of(node)
    if node.op == "constant" then return tostring(node.value) end
    if node.op == "name" then return node.name end
    local parts = {}
    for i, inner in ipairs(node) do parts[i] = text_of(inner) end
    return node.op .. "(" .. table.concat(parts, ",") .. ")"
end

-- A comparison as { key, node, sign, number }: of a part with a number, or of the difference of two parts with 0.
local function atom_of(node, sign, known)
    local left, right = constant(node[1], known), constant(node[2], known)
    if type(right) == "number" then return { key = text_of(node[1]), node = node[1], sign = sign, number = right } end
    if type(left) == "number" then
        return { key = text_of(node[2]), node = node[2], sign = flip[sign], number = left }
    end
    local a, b = node[1], node[2]
    if text_of(a) > text_of(b) then a, b, sign = b, a, flip[sign] end
    return { key = text_of(a) .. " - " .. text_of(b), node = { op = "-", a, b }, sign = sign, number = 0 }
end

-- Whether a part has a value at any time: clocks and what does not change, without a division or a root.
local function always_defined(node, known)
    if node.op == "name" then
        return node.name == "time_s" or node.name == "step.time_s" or known(node.name) ~= nil
    end
    if node.op == "/" or node.op == "sqrt" then return false end
    for _, inner in ipairs(node) do
        if not always_defined(inner, known) then return false end
    end
    return true
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

local function certain(holds) return holds and { {} } or {} end

local function comparison_cases(node, negated, known)
    local left, right = constant(node[1], known), constant(node[2], known)
    if left == undefined or right == undefined then return certain(negated) end
    if left ~= nil and right ~= nil then
        return certain(type(left) ~= type(right) or compare[node.op](left, right) ~= negated)
    end
    if type(left) == "boolean" or type(right) == "boolean" then return certain(true) end
    local sure = always_defined(node, known)
    if text_of(node[1]) == text_of(node[2]) then
        return certain(compare[node.op](0, 0) ~= negated or (negated and not sure))
    end
    local atom = atom_of(node, negated and opposite[node.op] or node.op, known)
    atom.maybe_undefined = negated and not sure
    return { { atom } }
end

-- What is true or false, alone. Whoever touches has touched: the count of touches and their time are no longer 0.
local function plain_case(node, negated)
    local case = { { key = text_of(node), node = node, sign = negated and "no" or "yes", maybe_undefined = negated } }
    if not negated and node.op == "name" and node.name:find("touch$") then
        for ending, sign in pairs({ es = ">=", _s = ">" }) do
            local name = node.name .. ending
            table.insert(case, { key = name, node = { op = "name", name = name }, sign = sign,
                number = sign == ">" and 0 or 1 })
        end
    end
    return { case }
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
    if value == undefined then return certain(negated) end
    if value ~= nil then return certain((value and true or false) ~= negated) end
    return plain_case(node, negated)
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

-- Narrows what a sum, a distance and the like can be by what their measures can be.
local function bring_in(range, known, bounds)
    local found = interval.of(range.node, known, bounds)
    if found.low > range.low then range.low, range.open_low = found.low, found.open_low end
    if found.high < range.high then range.high, range.open_high = found.high, found.open_high end
end

-- What each part can be where all atoms hold: key -> { low, high, open_low, open_high }; nil: they cannot all hold.
-- bounds(name): { low, high } of a measure, or nil.
local function ranges_of(atoms, known, bounds)
    local ranges, keys = {}, {}
    for _, atom in ipairs(atoms) do
        if not ranges[atom.key] then
            ranges[atom.key] = { low = -math.huge, high = math.huge, node = atom.node }
            bring_in(ranges[atom.key], known, bounds)
            keys[#keys + 1] = atom.key
        end
        narrow(ranges[atom.key], atom)
    end
    local function narrowed(name) return ranges[name] or bounds(name) end
    for _, key in ipairs(keys) do
        bring_in(ranges[key], known, narrowed)
        if empty(ranges[key]) then return nil end
    end
    return ranges
end

--- Whether a parsed condition can hold. known(name): its number where it never changes; bounds(name): { low, high }.
function satisfy.can_hold(parsed, known, bounds)
    local cases = cases_of(parsed.tree, false, known)
    if not cases then return true end
    for _, atoms in ipairs(cases) do
        if ranges_of(atoms, known, bounds) then return true end
    end
    return false
end

--- Whether it holds at any time, whatever the measures are.
function satisfy.always_holds(parsed, known, bounds)
    return not satisfy.can_hold({ tree = { op = "not", parsed.tree } }, known, bounds)
end

-- The lowest that each measure can be that grows, in any of the ways in which a condition can hold.
local function least_of(cases, known, bounds, grows)
    local least
    for _, atoms in ipairs(cases) do
        local ranges, here = ranges_of(atoms, known, bounds), {}
        for key, range in pairs(ranges or {}) do
            local before = not least and range or least[key]
            if range.defined and before and grows(key) then
                here[key] = (range.low < before.low or (range.low == before.low and not range.open_low)) and range
                    or before
            end
        end
        if ranges then least = here end
    end
    return least or {}
end

--- The bounds from then on that a condition has held: what never falls is never again lower than it was. grows(name):
--- whether a measure never falls.
function satisfy.after(parsed, known, bounds, grows)
    local cases = cases_of(parsed.tree, false, known)
    local least = cases and least_of(cases, known, bounds, grows) or {}
    return function(name)
        local bound, low = bounds(name), least[name]
        if not low then return bound end
        return { low = low.low, open_low = low.open_low, high = bound and bound.high or math.huge }
    end
end

--- Whether a parsed condition holds nothing that changes.
function satisfy.never_changes(parsed, known)
    for _, name in ipairs(parsed.names) do
        if known(name) == nil then return false end
    end
    return true
end

return satisfy
