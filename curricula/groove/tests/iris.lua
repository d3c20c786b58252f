-- SPDX-License-Identifier: GPL-3.0-or-later
-- The iris, touched by the tip from the middle of the pupil.

local middle = { 1.5, 1, 2.6 }

local function go_to_middle(t)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
    t.phaco:move_to(middle, { speed = 6 })
end

-- Sideways until the tip touches the pupil's edge.
local function touch(t)
    go_to_middle(t)
    t.phaco:move_to({ 3.7, 1, 1.7 }, { speed = 4, stop = "iris.gap_mm < -0.05" })
    t:expect_event("Iris touched")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "iris touched, put right" {
        function(t)
            touch(t)
            t.phaco:move_to(middle, { speed = 6 })
            t:expect_event("Iris touched", { recovered = true })
            t:expect_near("iris.touches", 1, 0)
        end },

    scenario "iris touched, and the tip stays" {
        function(t)
            touch(t)
            t:expect_event("Iris touched", { recovered = false, within = 2 })
        end },

    scenario "turns back before the iris" {
        silent_twin_of = "Iris touched",
        near = "iris.gap_mm < 0.15",
        function(t)
            go_to_middle(t)
            t.phaco:move_to({ 3.7, 1, 1.7 }, { speed = 4, stop = "iris.gap_mm < 0.15" })
            t:expect("iris.gap_mm < 0.15 and iris.gap_mm > 0")
            t.phaco:move_to(middle, { speed = 6 })
        end },
}
