-- SPDX-License-Identifier: GPL-3.0-or-later
math.randomseed(7)
local function one(list) return list[math.random(#list)] end

local singles = { "a", "b", "c", ".", "%a", "%d", "%S", "[ab]", "[^a]", "[a-c]", "[%d_]", "%.", "1", "[^%s%d]" }
local repeats = { "", "", "", "*", "+", "-", "?" }
local letters = { "a", "b", "c", "1", " ", "_", ".", "(", ")" }

local function random_pattern(depth)
    local p = ""
    for _ = 1, math.random(4) do
        local kind = math.random(12)
        if kind == 1 and depth < 3 then
            p = p .. "(" .. random_pattern(depth + 1) .. ")"
        elseif kind == 2 then
            p = p .. "()"
        elseif kind == 3 then
            p = p .. "%b" .. one { "ab", "()", "aa" }
        elseif kind == 4 then
            p = p .. "%f[" .. one { "%a", "ab", "^c" } .. "]"
        else
            p = p .. one(singles) .. one(repeats)
        end
    end
    return p
end

for k = 1, 4000 do
    local p = one { "", "", "^" } .. random_pattern(1) .. one { "", "", "$" }
    local s = ""
    for _ = 1, math.random(0, 12) do
        s = s .. one(letters)
    end
    print(k, p, s, string.find(s, p))
    print(k, string.gsub(s, p, "[%0]"))
    local found = {}
    for a, b in string.gmatch(s, p) do
        found[#found + 1] = tostring(a) .. "/" .. tostring(b)
    end
    print(k, table.concat(found, " "))
end
