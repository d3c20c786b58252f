-- SPDX-License-Identifier: GPL-3.0-or-later
-- What the tests of scripts share: cases, expectations, and a made-up stream of observations.

local Run = require "engine.run"
local language = require "exercise"
local osacss = require "osacss"
local words = require "engine.words"

local support = {}

function support.case(name, run) table.insert(harness.cases, { name = name, run = run }) end

function support.equal(found, expected, what)
    if found ~= expected then
        error(("%s: found %s, expected %s"):format(what or "value", tostring(found), tostring(expected)), 2)
    end
end

function support.near(found, expected, tolerance, what)
    if type(found) ~= "number" or found ~= found or math.abs(found - expected) > tolerance then
        error(("%s: found %s, expected %s within %s"):format(what or "value", tostring(found), tostring(expected),
            tostring(tolerance)), 2)
    end
end

--- f must fail with a message that holds each of the texts.
function support.fails(f, ...)
    local ok, message = pcall(f)
    if ok then error("did not fail", 2) end
    for _, text in ipairs({ ... }) do
        if not tostring(message):find(text, 1, true) then
            error(("the message \"%s\" lacks \"%s\""):format(tostring(message), text), 2)
        end
    end
    return message
end

--- Runs the text of a curriculum as the host does.
function support.load(text, name)
    name = name or "demo/curriculum.lua"
    words.begin_file(name, text)
    local globals = setmetatable({ exercise = language.exercise, step = language.step,
        error_event = language.error_event, request = language.request, osacss = osacss }, { __index = _G })
    return harness.compile(text, name, globals)()
end

support.schema = {
    { name = "tip.depth_mm", unit = "mm", meaning = "" },
    { name = "tip.speed_mm_s", unit = "mm/s", meaning = "" },
    { name = "tip.touch", unit = "bool", meaning = "" },
    { name = "tool.present", unit = "bool", meaning = "" },
}

local nan = 0 / 0

--- Feeds an exercise with a made-up attempt: at(t) gives a table of measures by name; what it leaves out is undefined.
--- Returns the run and all commands. asked: ids of requests by the number of the observation that follows them.
function support.attempt(exercise, seconds, at, schema, asked)
    schema = schema or support.schema
    local run = Run.new(exercise, schema)
    local commands = {}
    for i = 0, math.floor(seconds / 0.01 + 0.5) do
        local t = i * 0.01
        local values, row = at(t), {}
        for k, entry in ipairs(schema) do
            local value = values[entry.name]
            if type(value) == "boolean" then value = value and 1 or 0 end
            row[k] = value or nan
        end
        for _, command in ipairs(run:observe(t, row, asked and asked[i])) do
            command.time_s = t
            commands[#commands + 1] = command
        end
    end
    return run, commands
end

--- A small exercise with the given fields in place of the usual ones, all as text.
function support.demo(given)
    given = given or {}
    return support.load(([[
return exercise {
    title = "Demo",
    tissues = { "lens" },
    instruments = { "phaco" },
    steps = { %s },
    errors = { %s },
    %s
}]]):format(given.steps or 'step "only" { done = "tip.depth_mm > 1" }', given.errors or "", given.rest or ""))
end

local empty_elements = { meta = true, br = true, img = true, rect = true, circle = true, line = true, path = true,
    input = true }

--- Every element of a page that opens is closed in order.
function support.check_balance(html)
    local open = {}
    html = html:gsub("<style>.-</style>", ""):gsub("<script>.-</script>", "")
    for slash, name, rest in html:gmatch("<(/?)([%a%d]+)([^>]*)>") do
        if slash == "/" then
            local last = table.remove(open)
            if last ~= name then error(("</%s> closes <%s>"):format(name, tostring(last)), 2) end
        elseif rest:sub(-1) ~= "/" and not (empty_elements[name] and name ~= "line" and name ~= "rect"
                and name ~= "circle") then
            open[#open + 1] = name
        end
    end
    if #open > 0 then error("not closed: " .. table.concat(open, ", "), 2) end
end

--- The page has this text.
function support.holds(html, text)
    if not html:find(text, 1, true) then error("the page lacks \"" .. text .. "\"", 2) end
end

return support
