-- SPDX-License-Identifier: GPL-3.0-or-later
local cases = {
    { "hello world", "o w" }, { "hello", "l+" }, { "hello", "(h)(e)(l+)" }, { "hello", "()ll()" },
    { "key = value", "^(%w+)%s*=%s*(%w+)$" }, { "THE (quick) fox", "%((%a+)%)" }, { "f(a(b)c)d", "%b()" },
    { "THE (quick) fox", "%f[%a]%a+%f[%A]" }, { "aaa", "a-" }, { "aaab", "a-b" }, { "", ".*" }, { "", "" },
    { "abc", "$" }, { "abc", "^" }, { "a$c", "a$c" }, { "[[x]]", "%[%[(.-)%]%]" }, { "x]y", "[]]" }, { "x^y", "[%^]" },
    { "a-b", "[a%-]+" }, { "a-b", "[%a-]+" }, { "abcabc", "(abc)%1" }, { "\0a\0", "%z?a" }, { "a5", "(%d+)-(%d+)" },
    { "2024-05-06", "(%d+)-(%d+)-(%d+)" }, { "aXb", "%u" }, { "aXb", "%U+" }, { "\xc3\xa4", "[\xc3]" },
    { "tab\tx", "%c" }, { "a.b", "%." }, { "a+b", "a%+b" }, { "xyz", "[x-z]+" }, { "", "^$" }, { "ab", "^b" },
    { "  trim  ", "^%s*(.-)%s*$" }, { "aaa", "a?a?a?a" }, { "abc", "((a)(b))c" }, { "a\nb", ".-\n" },
}
for _, case in ipairs(cases) do
    local s, p = case[1], case[2]
    print(p, string.find(s, p))
    print(p, string.match(s, p))
    print(p, string.find(s, p, 2))
    print(p, string.find(s, p, -2))
    print(p, string.find(s, p, 1, true))
    print(p, string.find(s, p, 99))
    print(p, string.gsub(s, p, "<%0>"))
    print(p, string.gsub(s, p, function(...) return select("#", ...) end, 2))
    print(p, string.gsub(s, p, { a = "A", b = false }))
    for a, b, c in string.gmatch(s, p) do
        print(p, a, b, c)
    end
end
