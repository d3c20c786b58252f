-- SPDX-License-Identifier: GPL-3.0-or-later
-- A lens whose surfaces stick to each other: one haptic or both stay folded on the optic, which tilts. Those that raise
-- the error begin when it has lasted its 20 s already.

local implant_hand = require "implant_hand"

-- The hook comes to an arm from its inner side, draws it outwards over the front of the optic and off its edge, and
-- comes back over the opening.
local function draw_off(t, from, to, height)
    t.hook:move_to({ from[1], from[2], 1.0 }, { speed = 8 })
    t.hook:move_to({ from[1], from[2], height }, { speed = 4 })
    t.hook:move_to({ to[1], to[2], height }, { speed = 3 })
    t.hook:move_to({ 0.5 * to[1], 0.5 * to[2], 1.0 }, { speed = 6 })
end

local stuck = "implant.haptics_on_optic > 0 and implant.tilt_deg > 5"

return scenarios {
    patient = { age = 68, pupil_mm = 8 },

    scenario "haptics stuck to the optic, and left so" {
        recover_within_s = 3,
        hold_within_s = 0.1,
        set = implant_hand.sticky(10),
        start = "stuck",
        function(t)
            t.cannula:enter({ speed = 20 })  -- the attempt is over where nothing is in the eye for long
            t:expect_event("Haptic stuck to the optic", { within = 1 })
            t:expect_event("Haptic stuck to the optic", { recovered = false, within = 4 })
        end },

    scenario "haptics stuck to the optic, drawn off it with the hook" {
        hold_within_s = 0.1,
        set = implant_hand.sticky(10),
        start = "stuck",
        function(t)
            t:wait(0.2)
            t:expect_event("Haptic stuck to the optic")
            t:expect(stuck)
            t.hook:enter({ speed = 20 })
            draw_off(t, { -0.1, -1.3 }, { 2.2, -2.2 }, -1.3)
            draw_off(t, { 0, 1.4 }, { -1.9, 1.9 }, -1.1)
            t.hook:withdraw({ speed = 20 })
            t:expect_event("Haptic stuck to the optic", { recovered = true })
            t:expect("implant.haptics_in_bag >= 2 and implant.tilt_deg < 5 and bag.rim_peak_stretch < 1.1")
        end },

    scenario "haptic before the rim and on the optic, lifted off with forceps and put into the bag" {
        hold_within_s = 0.1,
        start = "trailing_out",
        function(t)
            t:wait(0.2)
            t:expect_event("Haptic stuck to the optic")
            implant_hand.tuck_in(t, { 1.6, -2.9, 0.6 }, { 0, -2.7, 1.0 })
            t:expect_event("Haptic stuck to the optic", { recovered = true, within = 8 })
        end },

    scenario "a haptic that sticks to the optic, which comes to lie flat all the same" {
        hold_within_s = 4,
        set = implant_hand.sticky(50),
        start = "settles",
        silent_twin_of = "Haptic stuck to the optic",
        near = stuck,
        function(t)
            t.cannula:enter({ speed = 20 })
            t:wait(5)
            t:expect("implant.haptics_on_optic >= 1 and implant.tilt_deg < 5")
        end },
}
