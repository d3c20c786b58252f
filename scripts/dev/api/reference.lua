-- SPDX-License-Identifier: GPL-3.0-or-later
-- Renders docs/api.md from the stubs: rhexis lua scripts/dev/api/reference.lua > docs/api.md

local stubs = require "stubs"

local reference = {}

-- Modules by their full name; classes, which scripts never name, by what they are.
local function title(class)
    local object = class.name:match("^rhexis%.(%u%w*)$")
    return object and object .. " objects" or class.name
end

local function anchor(text)
    return (text:lower():gsub("%.", ""):gsub(" ", "-"))
end

local function add(lines, ...)
    for _, line in ipairs { ... } do
        lines[#lines + 1] = line
    end
end

local function cell(text)
    return (text:gsub("|", "\\|"))
end

local function add_fields(lines, fields)
    if #fields == 0 then
        return
    end
    add(lines, "", "| field | type | meaning |", "|---|---|---|")
    for _, field in ipairs(fields) do
        add(lines, ("| `%s` | `%s` | %s |"):format(field.name, cell(field.type), cell(field.text)))
    end
end

local function signature(class, fn)
    local names = {}
    for _, param in ipairs(fn.params) do
        names[#names + 1] = param.optional and "[" .. param.name .. "]" or param.name
    end
    local owner = fn.method and class.name:match("[^.]+$"):lower() .. ":" or class.name .. "."
    return owner .. fn.name .. "(" .. table.concat(names, ", ") .. ")"
end

local function add_params(lines, fn, by_name)
    for _, param in ipairs(fn.params) do
        local options = by_name[param.type]
        local has_fields = options and #options.fields > 0 and #options.functions == 0
        if not has_fields then
            local text = param.text ~= "" and ": " .. param.text or ""
            add(lines, "", ("- `%s`: `%s`%s"):format(param.name, param.type, text))
        else
            add_fields(lines, options.fields)
            for _, field in ipairs(options.fields) do
                local inner = by_name[field.type]
                if inner and #inner.fields > 0 and #inner.functions == 0 then
                    add(lines, "", "Fields of `" .. field.name .. "`:")
                    add_fields(lines, inner.fields)
                end
            end
        end
    end
end

local function add_returns(lines, fn, by_name)
    for _, result in ipairs(fn.returns) do
        local text = result.text ~= "" and ": " .. result.text or ""
        add(lines, "", ("Returns `%s`%s"):format(result.type, text))
        local class = by_name[(result.type:gsub("%[%]$", ""))]
        if class and #class.fields > 0 and #class.functions == 0 then
            add_fields(lines, class.fields)
        end
    end
end

local function add_function(lines, class, fn, by_name)
    add(lines, "", "### `" .. signature(class, fn) .. "`", "")
    add(lines, table.unpack(fn.text))
    add_params(lines, fn, by_name)
    add_returns(lines, fn, by_name)
    add(lines, "", "```lua")
    add(lines, table.unpack(fn.example or {}))
    add(lines, "```")
end

local function has_page(class)
    return class.name == "rhexis" or #class.functions > 0 or #class.fields == 0
end

function reference.render(folder)
    local classes, by_name, aliases = stubs.read(folder)
    local lines = { "<!-- SPDX-License-Identifier: GPL-3.0-or-later -->",
        "<!-- Made by: rhexis lua scripts/dev/api/reference.lua > docs/api.md -->", "# The Lua API", "" }
    for _, class in ipairs(classes) do
        if has_page(class) then
            add(lines, ("- [%s](#%s)"):format(title(class), anchor(title(class))))
        end
    end
    for _, class in ipairs(classes) do
        if has_page(class) then
            add(lines, "", "## " .. title(class), "")
            add(lines, table.unpack(class.text))
            add_fields(lines, class.fields)
            for _, fn in ipairs(class.functions) do
                add_function(lines, class, fn, by_name)
            end
        end
    end
    add(lines, "", "## Words for values")
    for _, alias in ipairs(aliases) do
        add(lines, "", ("`%s` is `%s`. %s"):format(alias.name, alias.type, table.concat(alias.text, " ")))
    end
    return table.concat(lines, "\n") .. "\n"
end

if arg and arg[0] and arg[0]:find("reference%.lua$") then
    io.write(reference.render(arg[1] or "bindings/lua/meta"))
end

return reference
