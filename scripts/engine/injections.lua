-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an instructor may let happen (theatre/injections.lua): what of it this scene knows.

local standard = require "theatre.injections"

local injections = {}

--- List of { id, title, settings = { { name, to, over_s } }, head, microscope } that this scene knows.
function injections.listing(eye, exercise)
    local list, t = {}, exercise.translated or function(text) return text end
    for _, one in ipairs(standard) do
        if not one.needs or eye.info[one.needs] then
            local settings = {}
            for i, setting in ipairs(one.settings or {}) do
                settings[i] = { name = setting[1], to = setting.to, over_s = setting.over_s }
            end
            list[#list + 1] = { id = one.id, title = t(one.title), settings = settings, head = one.head or {},
                microscope = one.microscope or {} }
        end
    end
    return list
end

return injections
