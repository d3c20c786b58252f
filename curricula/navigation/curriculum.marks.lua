-- SPDX-License-Identifier: GPL-3.0-or-later
-- Where the tip is to be, as who operates in the window sees it.

local targets = require "targets"

-- From the left against the clock, and back to where it began.
local function way_round(ring)
    local way = {}
    for i = 0, 24 do
        local turn = math.pi * (1 + i / 12)
        way[#way + 1] = { ring.radius * math.cos(turn), ring.radius * math.sin(turn), ring.height }
    end
    return way
end

local marks = { circle = way_round(targets.circle) }
for _, target in ipairs(targets) do marks["hold " .. target.name] = { target.place } end
return marks
