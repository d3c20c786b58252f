-- SPDX-License-Identifier: GPL-3.0-or-later
-- An eye from which nothing has fallen yet.

local quarter_hand = require "quarter_hand"

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
            quarter_hand.look_into_hole(t, 50)
            t:expect("capsule.open and fragments.sunk_mm <= 0")
        end },
}
