-- SPDX-License-Identifier: GPL-3.0-or-later
-- The iris touched by the phaco tip.

local narrow = { patient = { pupil_mm = 6.5 } }

-- To the right edge of the pupil, at the height of the iris.
local function approach(t, stop)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 2.6 })
    t:wait(0.5)
    t.phaco:move_to({ 1.5, 0.5, 1.6 }, { speed = 5 })
    t.phaco:move_to({ 4, 0.5, 1.2 }, { speed = 2, motion = "even", stop = stop })
end

return scenarios {
    patient = { age = 68, cataract = "NO4", pupil_mm = 7.5 },

    scenario "iris touched, put right" {
        set = narrow,
        function(t)
            approach(t, "iris.gap_mm < -0.05")
            t:expect_event("Iris touched")
            t.phaco:move_to({ 0, 0, 2.6 }, { speed = 8 })
            t:expect_event("Iris touched", { recovered = true, within = 2 })
        end },

    scenario "iris touched, and stays there" {
        set = narrow,
        function(t)
            approach(t, "iris.gap_mm < -0.05")
            t:expect_event("Iris touched", { recovered = false, within = 3 })
        end },

    scenario "close to the iris" {
        set = narrow,
        silent_twin_of = "Iris touched",
        near = "iris.gap_mm < 0.15 and phaco.tip_depth_mm > -1.5",
        function(t)
            approach(t, "iris.gap_mm < 0.15")
            t:wait(2)
            t:expect("iris.gap_mm < 0.3")
            t.phaco:move_to({ 0, 0, 2.6 }, { speed = 8 })
        end },
}
