-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an exact hand does with the phaco tip among the quarters of a nucleus, for scenarios that share it.

local quarter_hand = {}

--- In through the wound with irrigation on, over the lens, and until the chamber has filled. entering, over: speeds
--- [mm/s]; entering nil: as a hand usually does.
function quarter_hand.come_in(t, entering, over)
    t.phaco:enter(entering and { speed = entering })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = over })
    t:wait(1.5)
end

--- From the trench into the far right quarter with a touch of ultrasound, and pressed on with aspiration until it shuts
--- the tip.
function quarter_hand.press_on_piece(t)
    t.phaco:move_to({ 0.8, 0.8, 0.2 }, { speed = 4 })
    t.phaco:pedal(2.1)
    t.phaco:move_to({ 1.4, 1.4, -0.1 }, { speed = 1.5, motion = "even" })
    t.phaco:pedal(2)
    t.phaco:move_to({ 2.3, 2.3, -0.6 }, { speed = 1, motion = "even", stop = "phaco.occlusion > 0.9" })
end

--- The tip, aspirating, down to a hole in the posterior capsule and up again, while the bottle is low and then as high
--- as `bottle_cm` again; it touches nothing.
function quarter_hand.look_into_hole(t, bottle_cm)
    t.phaco:pedal(1.5)
    t:set { ["machine.bottle_cm"] = 20 }
    t.phaco:move_to({ 0, 0, -0.6 }, { speed = 1 })
    t:wait(0.5)
    t:set { ["machine.bottle_cm"] = bottle_cm }
    t.phaco:move_to({ 0, 0, 1 }, { speed = 4 })
    t:wait(0.5)
end

return quarter_hand
