-- SPDX-License-Identifier: GPL-3.0-or-later
-- Reads the LuaCATS stubs in bindings/lua/meta, the one description of the API, into plain tables:
--   { { name = "rhexis.Mesh", text = {...}, fields = { {name, optional, type, text} },
--       functions = { {name, method, text, example, params, returns, line, file} } }, ... }
-- in the order of the files. `text` is a list of lines.

local stubs = {}

local files = { "rhexis", "mesh", "scene", "membrane", "tool", "render", "eye" }

local function read_lines(path)
    local lines = {}
    for line in io.lines(path) do
        lines[#lines + 1] = line
    end
    return lines
end

local function new_block()
    return { text = {}, example = nil, params = {}, returns = {}, fields = {} }
end

-- "name? type # text": the type may hold spaces, so the text begins at " # ".
local function split_field(rest)
    local name, optional, after = rest:match("^([%w_]+)(%??)%s+(.*)$")
    local kind, text = after:match("^(.-)%s+#%s+(.*)$")
    return { name = name, optional = optional == "?", type = kind or after, text = text or "" }
end

local function split_return(rest)
    local kind, text = rest:match("^(.-)%s+#%s+(.*)$")
    return { type = kind or rest, text = text or "" }
end

local function add_text(block, line)
    if line:find("^```lua") then
        block.example, block.in_example = {}, true
    elseif line:find("^```") then
        block.in_example = false
    elseif block.in_example then
        block.example[#block.example + 1] = line
    else
        block.text[#block.text + 1] = line
    end
end

local function add_comment(reader, content)
    local tag, rest = content:match("^@(%w+)%s*(.*)$")
    local block = reader.block
    if not tag then
        add_text(block, content)
    elseif tag == "class" then
        local class = { name = rest:match("^[%w_.]+"), text = block.text, fields = {}, functions = {} }
        reader.classes[#reader.classes + 1] = class
        reader.by_name[class.name] = class
        reader.class = class
        reader.block = new_block()
    elseif tag == "field" then
        reader.class.fields[#reader.class.fields + 1] = split_field(rest)
    elseif tag == "param" then
        block.params[#block.params + 1] = split_field(rest)
    elseif tag == "return" then
        block.returns[#block.returns + 1] = split_return(rest)
    elseif tag == "alias" then
        local name, kind = rest:match("^(%S+)%s+(.*)$")
        reader.aliases[#reader.aliases + 1] = { name = name, type = kind, text = block.text }
        reader.block = new_block()
    end
end

local function add_function(reader, line, number, path)
    local owner, separator, name = line:match("^function ([%w_]+)([.:])([%w_]+)%(")
    if not owner then
        return false
    end
    local class = reader.locals[owner]
    local block = reader.block
    class.functions[#class.functions + 1] = {
        name = name, method = separator == ":", text = block.text, example = block.example, params = block.params,
        returns = block.returns, line = number, file = path,
    }
    reader.block = new_block()
    return true
end

local function read_file(reader, path)
    reader.locals, reader.block = {}, new_block()
    for number, line in ipairs(read_lines(path)) do
        local comment = line:match("^%-%-%-(.*)$")
        local declared = line:match("^local ([%w_]+) = {}$")
        if comment and comment ~= "@meta" then
            add_comment(reader, comment)
        elseif declared then
            reader.locals[declared] = reader.class
        elseif not add_function(reader, line, number, path) and line == "" then
            reader.block = new_block()
        end
    end
end

-- Classes in order, the same by name, and aliases.
function stubs.read(folder)
    local reader = { classes = {}, by_name = {}, aliases = {} }
    for _, file in ipairs(files) do
        read_file(reader, folder .. "/" .. file .. ".lua")
    end
    return reader.classes, reader.by_name, reader.aliases
end

return stubs
