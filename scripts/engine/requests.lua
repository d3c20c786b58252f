-- SPDX-License-Identifier: GPL-3.0-or-later
-- What whoever operates may ask of the staff, or declare: the bottle down, zonules that are weak, a colleague called.
-- A request comes from outside, as movements do; the exercise hears it one step later and lets it take effect from the
-- step after that on.

local settings_check = require "engine.settings_check"
local words = require "engine.words"

local requests = {}

requests.rules = {
    title = { kind = "line" },                    -- how it is said; the name if missing
    meaning = { kind = "line" },                  -- for whoever may say it
    settings = { kind = "table", default = {} },  -- of the machine, that are changed (only such as may change while it
                                                  -- runs); none: it is only declared
    answer = { kind = "text" },                   -- what the staff says
}

--- Checks what a request sets. flatten: as of exercise.lua.
function requests.finish(request, flatten)
    request.settings = flatten(request.settings, "", {})
    settings_check.live(request.settings, request.line, ("request '%s': settings: "):format(request.name))
end

--- The id of a declared request, by its title, its name or its id; else nil and what is wrong. declared: list of { id,
--- title, name }.
function requests.find(declared, name)
    local known = {}
    for i, request in ipairs(declared) do
        if request.title == name or request.name == name or request.id == name then return request.id end
        known[i] = request.name
    end
    return nil, ("the exercise has no request '%s'%s"):format(tostring(name), #known == 0 and " (it has none)"
        or words.hint(tostring(name), known))
end

--- What the host is told of them.
function requests.listing(declared)
    local list = {}
    for i, request in ipairs(declared) do
        list[i] = { id = request.id, title = request.title, name = request.name }
    end
    return list
end

--- One that has been made, as a command.
function requests.command(id) return { kind = "request", name = id, value = 0, text = "" } end

return requests
