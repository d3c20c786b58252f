-- SPDX-License-Identifier: GPL-3.0-or-later
-- Names and where they stand: near names for "did you mean", file:line of what a curriculum says.

local words = {}

-- Number of single-letter changes (a swap of neighbours counts one) between two words.
local function distance(a, b)
    local last
    local before, row = nil, {}
    for j = 0, #b do row[j] = j end
    for i = 1, #a do
        last, before, row = before, row, {}
        row[0] = i
        for j = 1, #b do
            local cost = a:byte(i) == b:byte(j) and 0 or 1
            row[j] = math.min(before[j] + 1, row[j - 1] + 1, before[j - 1] + cost)
            if i > 1 and j > 1 and a:byte(i) == b:byte(j - 1) and a:byte(i - 1) == b:byte(j) then
                row[j] = math.min(row[j], last[j - 2] + 1)
            end
        end
    end
    return row[#b]
end

--- Up to three of `known` (a list) that are spelt nearly like `word`, nearest first.
function words.near(word, known)
    local found = {}
    for _, candidate in ipairs(known) do
        local d = distance(word:lower(), candidate:lower())
        local inside = #word >= 4 and candidate:find(word, 1, true) ~= nil
        if inside then d = math.min(d, 2) end
        if d <= math.max(2, #candidate // 3) then found[#found + 1] = { name = candidate, d = d } end
    end
    table.sort(found, function(x, y)
        if x.d ~= y.d then return x.d < y.d end
        return x.name < y.name
    end)
    local names = {}
    for i = 1, math.min(3, #found) do names[i] = found[i].name end
    return names
end

--- Of a choice that is none of `known`: the near ones, and then all there are, when they are few enough to read.
function words.choice_hint(word, known)
    local near = words.near(word, known)
    if #known > 24 then return words.hint(word, known) end
    local all = "one of: " .. table.concat(known, ", ")
    return #near > 0 and (" (did you mean %s? %s)"):format(table.concat(near, " or "), all) or (" (%s)"):format(all)
end

--- " (did you mean a or b?)", or " (one of: ...)" when nothing is near and the list is short, or "".
function words.hint(word, known)
    local near = words.near(word, known)
    if #near > 0 then return " (did you mean " .. table.concat(near, " or ") .. "?)" end
    if #known > 0 and #known <= 16 then return " (one of: " .. table.concat(known, ", ") .. ")" end
    return ""
end

--- What a scene may be made of: names of instruments and tissues.
words.parts = {}

--- The keys of a table that are strings, in a fixed order.
function words.keys(t)
    local keys = {}
    for key in pairs(t) do
        if type(key) == "string" then keys[#keys + 1] = key end
    end
    table.sort(keys)
    return keys
end

--- Whether a list holds a value.
function words.has(list, value)
    for _, one in ipairs(list) do
        if one == value then return true end
    end
    return false
end

--- Joins a list as a person would: "a, b and c".
function words.list(items)
    if #items < 2 then return items[1] or "" end
    return table.concat(items, ", ", 1, #items - 1) .. " and " .. items[#items]
end

-- What is being read: its name in messages and its lines, so that a field can be found again.
local reading = { name = "?", lines = {} }

--- Says which file the following declarations come from. text: its source.
function words.begin_file(name, text)
    reading = { name = name, lines = {} }
    for line in (text .. "\n"):gmatch("(.-)\r?\n") do reading.lines[#reading.lines + 1] = line end
end

function words.file() return reading.name end

--- Line of the file being read from which the running declaration was made, or nil. (`error` at a level of the call
--- stack is how a script without the debug library learns a line.)
function words.line_here()
    for level = 2, 24 do
        local _, message = pcall(error, "", level)
        local file, line = tostring(message):match("^(.*):(%d+):")
        if file == reading.name then return tonumber(line) end
    end
    return nil
end

--- File and line of the innermost script that is not one of scripts/, such as "my_exercise/curriculum.lua", 3: where it
--- calls, or requires a file that ends with `return f { ... }`.
function words.outside()
    for level = 2, 24 do
        local _, message = pcall(error, "", level)
        local file, line = tostring(message):match("^(.*):(%d+):")
        if file and not file:find("^scripts/") then return file, tonumber(line) end
    end
    return nil
end

--- Calls f, which blames mistakes without a better place on a line of another file than the one being read.
function words.at(file, line, f, ...)
    local kept = reading
    if file then reading = { name = file, lines = {}, line = line } end
    local ok, result = pcall(f, ...)
    reading = kept
    if not ok then error(result, 0) end
    return result
end

local object_mark = { __json = "object" }

--- Marks a table as one with names, so that an empty one is written as {} and not as [] in a report.
function words.as_object(t) return setmetatable(t, object_mark) end

-- Line on which `exercise {` stands: what a mistake without a better place is blamed on.
local function line_of_exercise()
    if reading.line then return reading.line end
    for i, line in ipairs(reading.lines) do
        if line:gsub("%-%-.*$", ""):find("%f[%w_]exercise%s*[({]") then return i end
    end
    return 1
end

--- "file:line" of `field = ...` at or after line `from`; without a field, or when it cannot be found, of `from` or of
--- the whole exercise.
function words.where(field, from)
    local plain = field and field:gsub("%p", "%%%0")
    for i = from or 1, plain and #reading.lines or 0 do
        local line = reading.lines[i]:gsub("%-%-.*$", "")
        local bare = line:find("%f[%w_]" .. plain .. "%f[^%w_]%s*=[^=]")
        local quoted = line:find('%["' .. plain .. '"%]%s*=')
        if bare or quoted then return reading.name .. ":" .. i end
    end
    return reading.name .. ":" .. (from or line_of_exercise())
end

--- Line on which `field = ...` stands at or after line `from`, or `from`.
function words.line_of(field, from) return tonumber(words.where(field, from):match(":(%d+)$")) end

local function escaped(character) return ("\\%d"):format(character:byte()) end

--- A text without what a terminal would take for a command: one line, control characters as \27.
function words.plain(text)
    return (text:gsub("[%c\127]", escaped):gsub("\194([\128-\159])", escaped))
end

--- What of a text nobody can read, in words, or nil. lines: whether it may have several, and tabs.
function words.unreadable(text, lines)
    if not utf8.len(text) then return "is no UTF-8: save the file in that form" end
    local rest = lines and text:gsub("[\n\t]", "") or text
    local odd = rest:match("%c") or rest:match("\194([\128-\159])")
    return odd and ("holds the control character %s"):format(escaped(odd)) or nil
end

--- Raises "where: message" without another position before it.
function words.fail(where, message) error(words.plain(where .. ": " .. message), 0) end

-- Mistakes that do not keep the rest of what is read from being read, until they are told together; nil: the first one
-- is raised.
local mistakes

-- Between two mistakes that are told together: bindings/lua/lua_state.cpp, between_mistakes.
local between = "\30"

--- From here on mistakes are noted, until tell_mistakes.
function words.collect_mistakes() mistakes = {} end

local function note(text)
    if not words.has(mistakes, text) then mistakes[#mistakes + 1] = text end
end

--- Notes a mistake, while they are collected; else raises it as `fail` does.
function words.mistake(where, message)
    if not mistakes then words.fail(where, message) end
    note(words.plain(where .. ": " .. message))
end

--- Calls f; while mistakes are collected, one that it raises is noted, and the result is nil.
function words.try(f, ...)
    if not mistakes then return f(...) end
    local ok, result = pcall(f, ...)
    if ok then return result end
    if type(result) ~= "string" then error(result, 0) end
    local follows = #mistakes > 0 and result:find("^scripts/")  -- the engine met what a mistake left out
    if not follows then note(words.plain((result:gsub("[\n" .. between .. "]", " ")))) end
    return nil
end

--- How many mistakes are noted.
function words.mistaken() return mistakes and #mistakes or 0 end

--- Runs a file and gives what it returned to `accept`, whose answer is returned; all mistakes are told together.
function words.read(file, accept)
    local value, answer
    words.collect_mistakes()
    local ran = words.try(function()
        value = file()
        return true
    end)
    if ran then answer = words.try(accept, value) end
    words.tell_mistakes()
    return answer
end

local function file_and_line(text)
    local file, line = text:match("^([^:\n]+):(%d+): ")
    return file or "", tonumber(line) or 0
end

--- What was noted, by file and line; no more is collected.
function words.take_mistakes()
    local noted = mistakes or {}
    mistakes = nil
    local place = {}
    for i, text in ipairs(noted) do
        local file, line = file_and_line(text)
        place[text] = { file = file, line = line, i = i }
    end
    table.sort(noted, function(a, b)
        local x, y = place[a], place[b]
        if x.file ~= y.file then return x.file < y.file end
        if x.line ~= y.line then return x.line < y.line end
        return x.i < y.i
    end)
    return noted
end

--- Raises what was noted; nothing, when nothing was.
function words.tell_mistakes()
    local noted = words.take_mistakes()
    if #noted > 0 then error(table.concat(noted, between), 0) end
end

return words
