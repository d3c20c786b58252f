-- SPDX-License-Identifier: GPL-3.0-or-later
print(pcall(function(...) return ... end, 1, nil, 3))
print(pcall(error, "x", 0))
print(select("#", pcall(error)))
print(pcall(error, nil))
local t = {}
print(select(2, pcall(error, t)) == t)
print(xpcall(function(a, b) return a + b end, print, 2, 3))
print(xpcall(error, function(m) return m .. "!" end, "oops"))
print(pcall(pcall))
print(pcall(xpcall, error, 3))

local co = coroutine.create(function(a)
    local _, b = pcall(function() return coroutine.yield(a + 1) end)
    local ok, c = xpcall(function()
        local v = coroutine.yield(b)
        error("late " .. v, 0)
    end, function(m) return m .. "?" end)
    return ok, c
end)
print(coroutine.resume(co, 1))
print(coroutine.resume(co, 10))
print(coroutine.resume(co, "z"))
print(coroutine.status(co))
print(coroutine.resume(co))
local squares = coroutine.wrap(function()
    for i = 1, 3 do
        coroutine.yield(i, i * i)
    end
    return "end"
end)
for _ = 1, 4 do
    print(squares())
end
print(pcall(coroutine.resume, 1))
print(coroutine.isyieldable(), coroutine.running() ~= nil)
print(coroutine.close(coroutine.create(print)))

local closed
print(pcall(function()
    local _ <close> = setmetatable({}, { __close = function(_, message) closed = message end })
    error("out", 0)
end), closed)
print(getmetatable(setmetatable({}, { __metatable = "mine" })))
print(pcall(setmetatable, setmetatable({}, { __metatable = 1 }), {}))
print(pcall(setmetatable, {}, 1))
print(pcall(setmetatable, 1, {}))
print(getmetatable(setmetatable(setmetatable({}, {}), nil)))

local u = { 5, 2, 9 }
table.insert(u, 1)
table.insert(u, 1, 7)
print(table.concat(u, ","), table.remove(u, 1), table.remove(u))
print(table.concat(table.move(u, 1, 2, 3), ","), table.unpack({ 1, 2, 3 }, 2))
print(pcall(table.insert, u, 99, 1))
print(pcall(table.concat, { {} }))
print(pcall(table.insert, nil, 1))
print(next({}), type(next), rawlen { 1, 2 }, rawequal(u, u))
