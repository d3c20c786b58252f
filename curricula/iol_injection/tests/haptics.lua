-- SPDX-License-Identifier: GPL-3.0-or-later
-- Haptics before the capsule, or in the bag, when the hook leaves.

local implant_hand = require "implant_hand"

local function hook_comes_and_goes(t)
    t.hook:enter({ speed = 20 })
    t:wait(0.2)
    t.cannula:enter({ speed = 20 })  -- the attempt is over where nothing is in the eye for long
    t.hook:withdraw({ speed = 20 })
end

return scenarios {
    patient = { age = 68, pupil_mm = 8 },

    scenario "trailing haptic before the rim, put back into the bag" {
        start = "trailing_out",
        hold_within_s = 0.1,
        function(t)
            t.lens_forceps:enter({ speed = 50 })
            t.lens_forceps:withdraw({ speed = 50 })
            t:wait(0.2)
            t:expect_event("Haptic not in the bag")
            implant_hand.tuck_in(t, { 1.6, -2.9, 0.6 }, { 0, -2.7, 1.0 })
            t:expect_event("Haptic not in the bag", { recovered = true, within = 8 })
            t:expect("implant.tilt_deg < 3 and bag.rim_peak_stretch < 1.2")
        end },

    scenario "implant left before the capsule" {
        recover_within_s = 3,
        set = implant_hand.thin,
        start = "before_capsule",
        function(t)
            hook_comes_and_goes(t)
            t:wait(1.2)
            t:expect_event("Haptic not in the bag")
            t:expect_event("Haptic not in the bag", { recovered = false, within = 4 })
        end },

    -- Its silent twin is in upside_down.lua: a haptic before the rim that is in the bag again when the forceps leave.
    scenario "both haptics in the bag when the hook leaves" {
        set = implant_hand.thin,
        start = "upside_down",
        function(t)
            hook_comes_and_goes(t)
            t:wait(1.5)
            t:expect("implant.haptics_in_bag >= 2")
            t:expect_no_event("Haptic not in the bag")
        end },
}
