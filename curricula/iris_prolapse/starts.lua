-- SPDX-License-Identifier: GPL-3.0-or-later
-- The tip left under the full pressure of the bottle, and the iris came after it.

return starts {
    begin = { function(t)
        t.phaco:enter()
        t.phaco:pedal(1)
        t.phaco:move_to({ 0, 0, 2.6 }, { speed = 8 })
        t:wait(1)
        t.phaco:withdraw({ speed = 8 })
        t:wait(1.5)
    end },
    before = { function(t) t:wait(0.1) end },  -- the wound is cut, nothing has gone through it
}
