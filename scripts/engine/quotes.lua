-- SPDX-License-Identifier: GPL-3.0-or-later
-- Quotation marks that a word processor puts in place of straight ones. Lua says of them "unexpected symbol near
-- '<\226>'", which nobody understands.

local words = require "engine.words"

local quotes = {}

local curly = { "“", "”", "„", "‟", "‘", "’", "‚", "«", "»" }

-- Where the text or comment ends that begins at `at`, or nil where none begins.
local function end_of_quoted(text, at)
    local comment, level = text:match("^(%-?%-?)%[(=*)%[", at)
    if level and (comment == "" or comment == "--") then
        local _, last = text:find("]" .. level .. "]", at, true)
        return last or #text
    end
    if text:find("^%-%-", at) then return (text:find("\n", at, true) or #text + 1) - 1 end
    local mark = text:match("^[\"']", at)
    if not mark then return nil end
    local last = at + 1
    while last <= #text and text:sub(last, last) ~= mark and text:sub(last, last) ~= "\n" do
        last = last + (text:sub(last, last) == "\\" and 2 or 1)
    end
    return last
end

-- The first such mark outside of texts and comments, and where it stands.
local function first_outside(text)
    local at = 1
    while at do
        at = text:find("[\"'%-%[\194\226]", at)
        if not at then return nil end
        local last = end_of_quoted(text, at)
        for _, mark in ipairs(last and {} or curly) do
            if text:sub(at, at + #mark - 1) == mark then return mark, at end
        end
        at = (last or at) + 1
    end
end

--- Refuses a script that holds one where Lua reads no text. name: of its file in messages.
function quotes.refuse_curly(name, text)
    if not text:find("[\194\226]") then return end
    local mark, at = first_outside(text)
    if not mark then return end
    local _, before = text:sub(1, at):gsub("\n", "")
    words.fail(name .. ":" .. before + 1, ("%s is a quotation mark of a word processor: write straight ones, \" and \"")
        :format(mark))
end

return quotes
