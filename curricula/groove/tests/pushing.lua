-- SPDX-License-Identifier: GPL-3.0-or-later
-- Pushing the lens: the tip is driven through it faster than it cuts.

local over_lens = { 0, 0, 3 }

local function come_to_lens(t)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -1.5, 2.6 }, { speed = 8 })
end

-- Sinks the tip into the front of the lens without ultrasound and drives it away from the surgeon.
local function push(t)
    come_to_lens(t)
    t.phaco:move_to({ 0, -1.5, 0.3 }, { speed = 2, motion = "even" })
    t.phaco:move_to({ 0, 2.4, 0.1 }, { speed = 2, motion = "even", stop = "lens.displacement_mm > 0.52" })
    t:expect_event("Pushing the lens")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "lens pushed, put right by drawing back" {
        function(t)
            push(t)
            t.phaco:move_to(over_lens, { speed = 8 })
            t:expect_event("Pushing the lens", { recovered = true, within = 3 })
            t:expect_near("lens.removed_mm3", 0, 0)
        end },

    scenario "lens pushed, and held there" {
        function(t)
            push(t)
            t:expect_event("Pushing the lens", { recovered = false, within = 6 })
        end },

    scenario "the lens begins to move, and ultrasound frees the tip" {
        silent_twin_of = "Pushing the lens",
        near = "lens.displacement_mm > 0.36",
        function(t)
            come_to_lens(t)
            t.phaco:move_to({ 0, -1.5, 0.3 }, { speed = 2, motion = "even" })
            t.phaco:move_to({ 0, 2.4, 0.1 }, { speed = 2, motion = "even", stop = "lens.displacement_mm > 0.37" })
            t.phaco:pedal(3)
            t:wait(1)
            t:expect("lens.displacement_mm < 0.3")
            t.phaco:move_to({ 0, 2, 1 }, { speed = 2 })
            t:expect("lens.removed_mm3 > 2")
        end },

    scenario "aspiration alone removes nothing" {
        function(t)
            come_to_lens(t)
            t.phaco:pedal(2)
            t.phaco:move_to({ 0, -1.5, 1.8 }, { speed = 2 })
            t.phaco:move_to({ 0, 2, 1.7 }, { speed = 4 })
            t:expect("phaco.aspirating and lens.removed_mm3 == 0")
        end },
}
