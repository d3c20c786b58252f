-- SPDX-License-Identifier: GPL-3.0-or-later
-- The iris, touched by a tip that is at the lens. Irrigation has pushed both back.

local coarse = { patient = { tetrahedra = 1000 } }  -- the lens is only in the way
local middle = { 1.5, 0.5, 1.9 }
local beyond_pupil = { 4.2, 0.5, 0.9 }

local function come_to_lens(t)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3.8 }, { speed = 8 })
    t:wait(1)  -- the chamber deepens
    t.phaco:move_to(middle, { speed = 6 })
end

-- Sideways until the tip touches the pupil's edge.
local function touch(t)
    come_to_lens(t)
    t.phaco:move_to(beyond_pupil, { speed = 4, stop = "iris.gap_mm < -0.05" })
    t:expect_event("Iris touched")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "iris touched, put right over the middle of the pupil" {
        set = coarse,
        function(t)
            touch(t)
            t.phaco:move_to({ 0, 0, 3.8 }, { speed = 8 })
            t:expect_event("Iris touched", { recovered = true, within = 1 })
            t:expect_near("iris.touches", 1, 0)
        end },

    scenario "iris touched, and the tip stays" {
        set = coarse,
        function(t)
            touch(t)
            t:expect_event("Iris touched", { recovered = false, within = 3 })
        end },

    scenario "turns back before the iris" {
        set = coarse,
        silent_twin_of = "Iris touched",
        near = "iris.gap_mm < 0.15 and phaco.tip_depth_mm > -1",
        function(t)
            come_to_lens(t)
            t.phaco:move_to(beyond_pupil, { speed = 4, stop = "iris.gap_mm < 0.15" })
            t:expect("iris.gap_mm < 0.15 and iris.gap_mm > 0 and phaco.tip_depth_mm > -1")
            t.phaco:move_to(middle, { speed = 6 })
        end },
}
