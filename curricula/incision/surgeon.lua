-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does: side port, main incision, and a look whether it is dry. Fluid at the lip: hydrate, then
-- sew. It sees the picture only: no measure, no event, no score. [mm]

local wounding = require "surgeons.wounding"

local within_cornea = 1.1  -- of the tunnel before it turns level
local longest_look = 1.5   -- [s]

local function leaks(seen) return seen.landmarks.wound_fluid or seen.landmarks.wound_gape end

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.incision_site ~= nil end, 10)
    wounding.cut_side_port(me)
    wounding.cut_tunnel(me, within_cornea)
    me.wait(longest_look)
    if me.notices(leaks) then wounding.hydrate(me) end
    me.wait(longest_look)
    if me.notices(leaks) then wounding.stitch(me, 0) end
end
