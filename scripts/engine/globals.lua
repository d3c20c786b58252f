-- SPDX-License-Identifier: GPL-3.0-or-later
-- The names that a file finds without having declared them. One that nobody has set is a mistake, most often of
-- spelling, and is told as such wherever it is read: not as "attempt to call a nil value".

local words = require "engine.words"

local globals = {}

local function refuse(own, name)
    local known = words.keys(_G)
    table.move(words.keys(own), 1, 64, #known + 1, known)
    local near = words.near(tostring(name), known)
    error(("there is no word '%s'%s"):format(tostring(name), #near > 0 and (" (did you mean %s?)"):format(
        table.concat(near, " or ")) or ""), 3)
end

--- A table of globals that holds `own` and the standard words.
function globals.of(own)
    return setmetatable(own, { __index = function(_, name)
        local found = rawget(_G, name)
        if found == nil then refuse(own, name) end
        return found
    end })
end

--- The same of files that are required: they see the standard words only.
function globals.refuse_unknown()
    setmetatable(_G, { __index = function(_, name) refuse({}, name) end })
end

return globals
