-- SPDX-License-Identifier: GPL-3.0-or-later
local instruments = require "surgeons.instruments"

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.pupil and seen.landmarks.incision end, 5)
    local wound, pupil = me.see().landmarks.incision.position, me.see().landmarks.pupil.position
    local function over(right) return { pupil[1] + right, pupil[2], pupil[3] + 1.1 } end
    me.take_up(instruments.outside(wound))
    me.go(wound, 6)
    me.go(over(0), 6)
    me.wait(4)
    me.go(over(2.3), 4)
    me.go(over(-2.3), 4)
    me.go(over(0), 4)
    me.go(wound, 6)
    me.go(instruments.outside(wound), 6)
    me.put_down()
end
