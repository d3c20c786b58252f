-- SPDX-License-Identifier: GPL-3.0-or-later
-- Coordinates that a scenario writes: of a place, or of a shift from one.

local fields = require "engine.fields"
local words = require "engine.words"

local coordinates = {}

--- Gives a function that checks { x, y, z } and copies it. farthest: from 0, each of them [mm].
function coordinates.within(farthest)
    return function(value, where, what)
        if type(value) ~= "table" or #value ~= 3 then
            words.fail(where, ("%s must be given { x, y, z } in mm"):format(what))
        end
        local place = {}
        for i, axis in ipairs({ "x", "y", "z" }) do
            local rule = { kind = "number", from = -farthest, to = farthest }
            fields.check_value(rule, value[i], where, what .. ": " .. axis)
            place[i] = value[i] + 0.0
        end
        return place
    end
end

return coordinates
