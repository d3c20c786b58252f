-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a part of a condition can be at all, as { low, high }: |x| is never less than 0, x * 0 is 0.

local interval = {}

interval.fold = {
    ["+"] = function(a, b) return a + b end,
    ["-"] = function(a, b) return a - b end,
    ["*"] = function(a, b) return a * b end,
    ["/"] = function(a, b) return a / b end,
    min = math.min,
    max = math.max,
    abs = math.abs,
    sqrt = math.sqrt,
}

--- The value of a part of which all numbers are known.
function interval.folded(op, values)
    if #values == 1 then return interval.fold[op](values[1]) end
    local value = values[1]
    for i = 2, #values do value = interval.fold[op](value, values[i]) end
    return value
end

local function anything() return { low = -math.huge, high = math.huge } end

-- A bound that is no number, as of infinity less infinity, tells nothing.
local function from_to(low, high)
    return { low = low == low and low or -math.huge, high = high == high and high or math.huge }
end

-- What is finite times 0 is 0, however large it may be.
local function product(a, b)
    if a == 0 or b == 0 then return 0 end
    return a * b
end

local function times(a, b)
    local corners = { product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high) }
    return from_to(math.min(table.unpack(corners)), math.max(table.unpack(corners)))
end

local with_two = {
    ["+"] = function(a, b) return from_to(a.low + b.low, a.high + b.high) end,
    ["-"] = function(a, b) return from_to(a.low - b.high, a.high - b.low) end,
    ["*"] = times,
    ["/"] = function(a, b)
        if b.low <= 0 and b.high >= 0 then return anything() end
        return times(a, from_to(1 / b.high, 1 / b.low))
    end,
    min = function(a, b) return from_to(math.min(a.low, b.low), math.min(a.high, b.high)) end,
    max = function(a, b) return from_to(math.max(a.low, b.low), math.max(a.high, b.high)) end,
}

local with_one = {
    abs = function(a)
        if a.low >= 0 then return a end
        if a.high <= 0 then return from_to(-a.high, -a.low) end
        return from_to(0, math.max(-a.low, a.high))
    end,
    sqrt = function(a) return from_to(math.sqrt(math.max(0, a.low)), math.sqrt(math.max(0, a.high))) end,
}

--- Of a parsed part. known(name): its number where it never changes; bounds(name): { low, high } of a measure, or nil.
function interval.of(node, known, bounds)
    if node.op == "constant" and type(node.value) == "number" then return from_to(node.value, node.value) end
    if node.op == "name" then
        local value = known(node.name)
        if value ~= nil then return from_to(value, value) end
        return bounds(node.name) or anything()
    end
    if not interval.fold[node.op] then return anything() end
    local found = interval.of(node[1], known, bounds)
    if #node == 1 then return with_one[node.op] and with_one[node.op](found) or anything() end
    for i = 2, #node do found = with_two[node.op](found, interval.of(node[i], known, bounds)) end
    return found
end

return interval
