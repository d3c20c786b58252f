-- SPDX-License-Identifier: GPL-3.0-or-later
-- An eye from which nothing has fallen yet.

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "a tip that aspirates over the hole while the bottle is down, and leaves the pieces alone" {
        start = "untouched",
        silent_twin_of = "Dropped piece",
        near = "capsule.open and phaco.aspirating and phaco.tip_posterior_mm < 2.5 and fragments.count == 4",
        function(t)
            t.phaco:enter({ speed = 20 })
            t.phaco:pedal(1)
            t.phaco:move_to({ 0, 0, 3 }, { speed = 20 })
            t.phaco:move_to({ 0, 0, 0.2 }, { speed = 8 })
            t.phaco:pedal(1.5)
            t:set { ["machine.bottle_cm"] = 20 }
            t.phaco:move_to({ 0, 0, -0.6 }, { speed = 1 })
            t:wait(0.5)
            t:set { ["machine.bottle_cm"] = 50 }
            t.phaco:move_to({ 0, 0, 1 }, { speed = 4 })
            t:wait(0.5)
            t:expect("capsule.open and fragments.sunk_mm <= 0")
        end },
}
