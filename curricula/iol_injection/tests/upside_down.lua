-- SPDX-License-Identifier: GPL-3.0-or-later
-- An implant that came out with its front to the back of the eye, because the injector was turned about its shaft.

local implant_hand = require "implant_hand"

-- The optic stands on its edge, its front to the left: its upper edge is pushed to the right, over the top, and down.
local function turn_over(t)
    t.hook:enter({ speed = 20 })
    t.hook:move_to({ -2.6, 0.8, 1.5 }, { speed = 10 })
    t.hook:move_to({ 2.9, 0.8, 1.5 }, { speed = 2, motion = "even" })
    t.hook:move_to({ 2.9, 0.8, -0.5 }, { speed = 2, motion = "even" })
end

return scenarios {
    patient = { age = 68, pupil_mm = 8 },

    scenario "on its side with its front to the back, and turned over with the hook" {
        set = implant_hand.thin,
        start = "on_its_side",
        function(t)
            t:wait(2.2)
            t:expect_event("Upside down")
            turn_over(t)
            t.hook:move_to({ 0, 0.8, 1.8 }, { speed = 4 })
            t:expect_event("Upside down", { recovered = true, within = 6 })
        end },

    -- One haptic comes before the rim on the way over, and is in the bag again when the forceps leave.
    scenario "upside down in the bag, taken by its edge with forceps and turned over" {
        set = implant_hand.thin,
        start = "upside_down",
        silent_twin_of = { "Haptic not in the bag", "Rim overstretched" },
        near = "implant.haptics_in_bag < 2 and bag.rim_stretch > 1.17",
        function(t)
            t:wait(0.2)
            t:expect("implant.tilt_deg < 20")
            implant_hand.turn_over(t, function() t:expect_event("Upside down", { within = 2 }) end)
            t:expect("implant.haptics_in_bag >= 2")
            t:expect_event("Upside down", { recovered = true, within = 2 })
            t:wait(1)
            t:expect("not implant.upside_down and implant.tilt_deg < 45 and bag.rim_peak_stretch < 1.2")
        end },

    scenario "upside down in the bag, and left so" {
        recover_within_s = 3,
        set = implant_hand.thin,
        start = "upside_down",
        function(t)
            t.cannula:enter({ speed = 20 })  -- the attempt is over where nothing is in the eye for long
            t:expect_event("Upside down", { recovered = false, within = 4 })
        end },

    scenario "on its side with its front to the front" {
        set = implant_hand.thin,
        start = "nearly_over",
        silent_twin_of = "Upside down",
        near = "implant.released and implant.tilt_deg > 70",
        function(t)
            t.cannula:enter({ speed = 20 })
            t:wait(4)
            t:expect("implant.released and implant.unfolded > 0.9")
        end },
}
