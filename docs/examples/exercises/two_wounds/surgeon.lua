-- SPDX-License-Identifier: GPL-3.0-or-later
local wounding = require "surgeons.wounding"

return function(me)
    me.wait_until(function(seen) return seen ~= nil end, 2)
    wounding.cut_tunnel(me, 1.2)
    wounding.cut_side_port(me)
    wounding.fill(me, 3)
    for _ = 1, 2 do
        local hard, wet = wounding.test(me)
        if hard > 14 and not wet then return end
        wounding.hydrate(me)
        wounding.fill(me, 3)
    end
    wounding.test(me)
end
