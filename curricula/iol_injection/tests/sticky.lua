-- SPDX-License-Identifier: GPL-3.0-or-later
-- A lens whose surfaces stick to each other: its haptics stay folded on the optic. All begin when the lens has had time
-- to unfold, so that the error need not last its 20 s again.

local implant_hand = require "implant_hand"

return scenarios {
    scenario "haptics stuck to the optic, and left so" {
        recover_within_s = 3,
        hold_within_s = 4,
        set = implant_hand.tacky(50),
        start = "stuck",
        function(t)
            t.cannula:enter({ speed = 20 })  -- the attempt is over where nothing is in the eye for long
            t:expect_event("Haptic stuck to the optic", { within = 5 })
            t:expect_event("Haptic stuck to the optic", { recovered = false, within = 4 })
        end },

    scenario "haptic folded on the optic, lifted off with forceps and put into the bag" {
        hold_within_s = 0.1,
        start = "trailing_out",
        function(t)
            t:wait(0.2)
            t:expect_event("Haptic stuck to the optic")
            implant_hand.tuck_in(t, { 1.6, -2.9, 0.6 }, { 0, -2.7, 1.0 })
            t:expect_event("Haptic stuck to the optic", { recovered = true, within = 8 })
        end },

    scenario "haptics that come off the optic by themselves" {
        hold_within_s = 4,
        set = implant_hand.tacky(0),
        start = "came_off",
        silent_twin_of = "Haptic stuck to the optic",
        function(t)
            t.cannula:enter({ speed = 20 })
            t:wait(6)
        end },
}
