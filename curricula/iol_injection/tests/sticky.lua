-- SPDX-License-Identifier: GPL-3.0-or-later
-- A lens whose surfaces stick to each other: its haptics stay folded on the optic.

local implant_hand = require "implant_hand"

local function tacky(kpa) return implant_hand.thin_with { ["implant.tackiness_kpa"] = kpa } end

return scenarios {
    scenario "haptics stuck to the optic, and left so" {
        recover_within_s = 3,
        set = tacky(50),
        function(t)
            implant_hand.inject(t, { 0, -1.2, 2.2 })
            t.cannula:enter({ speed = 20 })  -- the attempt is over where nothing is in the eye for long
            t:expect_event("Haptic stuck to the optic", { within = 25 })
            t:expect_event("Haptic stuck to the optic", { recovered = false, within = 4 })
        end },

    scenario "haptic folded on the optic, lifted off with forceps and put into the bag" {
        start = "trailing_out",
        function(t)
            t.lens_forceps:enter({ speed = 20 })
            t:expect_event("Haptic stuck to the optic", { within = 25 })
            t.lens_forceps:withdraw({ speed = 20 })
            implant_hand.tuck_in(t, { 1.75, -3.7, 0 }, { 0.3, -2.8, 0.9 })
            t:expect_event("Haptic stuck to the optic", { recovered = true, within = 30 })
        end },

    scenario "haptics that come off the optic by themselves" {
        set = tacky(0),
        start = "upside_down",
        silent_twin_of = "Haptic stuck to the optic",
        function(t)
            t.cannula:enter({ speed = 20 })
            t:wait(22)
        end },
}
