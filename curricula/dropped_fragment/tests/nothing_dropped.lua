-- SPDX-License-Identifier: GPL-3.0-or-later
-- An eye from which nothing has fallen yet, and a quarter that nearly does.

-- The far left quarter on the tip.
local function hold(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 20 })
    t.phaco:move_to({ 0, 0, 0.2 }, { speed = 8 })
    t.phaco:pedal(2)
    t.phaco:move_to({ -0.85, 0.85, 0.2 }, { speed = 2 })
    t.phaco:pedal(2.1)
    t.phaco:move_to({ -1.4, 1.4, -0.4 }, { speed = 1.5, motion = "even" })
    t.phaco:pedal(1.75)
    t.phaco:move_to({ -1.9, 1.9, -0.7 }, { speed = 1, motion = "even" })
    t:wait(0.8)
    t:expect("phaco.hold_mN > 10")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "a piece led through the hole while the bottle is down, held, and drawn up with the bottle" {
        start = "untouched",
        silent_twin_of = "Dropped piece",
        near = "fragments.sunk_mm > 0.1",
        function(t)
            hold(t)
            t:set { ["machine.bottle_cm"] = 0 }
            t.phaco:move_to({ 0, 0, 0 }, { speed = 4 })
            t.phaco:move_to({ 0, 0, -4.5 }, { speed = 2, motion = "even", stop = "fragments.sunk_mm > 0.1" })
            t.phaco:move_to({ 0, 0, 1 }, { speed = 2.5 })
            t:set { ["machine.bottle_cm"] = 95 }
            t:wait(0.5)
            t:expect("capsule.open and fragments.sunk_mm <= 0")
        end },
}
