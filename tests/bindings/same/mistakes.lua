-- SPDX-License-Identifier: GPL-3.0-or-later
local broken = { "(", "(a", "[a", "[", "%", "[%", "%1", "(%1)", "%b", "%bx", "%f", "%f(", "[a-", "(()", "a*)" }
for _, p in ipairs(broken) do
    print(p, select(2, pcall(string.find, "aa", p)))
end
print(select(2, pcall(string.gsub, "a", "a", "%2")))
print(select(2, pcall(string.gsub, "a", "a", "%x")))
print(select(2, pcall(string.gsub, "a", "a", function() return {} end)))
print(select(2, pcall(string.find, nil, "a")))
print(select(2, pcall(string.gsub, "a", "a")))
print(pcall(string.rep, "x", 1e15))
print(string.rep("ab", 3, ","), string.rep("x", 0), string.rep("x", -1), string.rep("ab", 2))
print(("%5.2f|%d|%s|%q|%%|%-5s|%x"):format(1.5, 3, "x", "a\nb", "y", 255))
print(pcall(string.format, "%d", 1.5))
print(pcall(string.format, "%y", 1))
print(pcall(string.format, "%s"))
