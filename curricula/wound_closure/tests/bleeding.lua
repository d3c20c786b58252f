-- SPDX-License-Identifier: GPL-3.0-or-later
-- Bleeding behind the choroid, set off by the instructor.

local setting = "suprachoroidal.pressure_mmhg"

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 6 },

    scenario "bleeding with an instrument in the eye: out at once, the wound shuts, the eye hardens" {
        function(t)
            t.cannula:enter()
            t.cannula:move_to({ 0, -2.6, 2.9 }, { speed = 6 })
            t:set { [setting] = 40 }
            t:wait(1)
            t:expect("chamber.depth_share < 0.98")
            t:expect_event("Suprachoroidal bleeding")
            t.cannula:withdraw { speed = 20 }
            t:expect_event("Suprachoroidal bleeding", { recovered = true, within = 5 })
        end },

    scenario "bleeding, and the instrument stays in the wound" {
        recover_within_s = 3,
        function(t)
            t.cannula:enter()
            t.cannula:move_to({ 0, -2.6, 2.9 }, { speed = 6 })
            t:set { [setting] = 40 }
            t:wait(5)
            t:expect("chamber.depth_share < 0.8 and suprachoroidal.blood_mm3 > 40")
            t:expect_event("Suprachoroidal bleeding", { recovered = false, within = 4 })
        end },

    scenario "no more than a little pressure from behind, in a closed eye" {
        silent_twin_of = "Suprachoroidal bleeding",
        near = "suprachoroidal.blood_mm3 > 2",
        function(t)
            t:set { [setting] = 0.7 }
            t:wait(7)
            t:expect("chamber.pressure_mmhg < 16")
        end },
}
