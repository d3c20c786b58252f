-- SPDX-License-Identifier: GPL-3.0-or-later
-- The edge of the pupil, 3.75 mm from its middle and 1.48 mm over the middle of the lens.

local full = { ["viscoelastic.fill"] = 1 }

local function come_in(t)
    t.forceps:enter({ speed = 20 })
    t.forceps:move_to({ 1.5, 1, 2.6 }, { speed = 12 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "iris touched, put right" {
        set = full,
        function(t)
            come_in(t)
            t.forceps:move_to({ 3.9, 1, 1.5 }, { speed = 4, stop = "iris.gap_mm < -0.05" })
            t:expect_event("Iris touched")
            t.forceps:move_to({ 1.5, 1, 2.6 }, { speed = 6 })
            t:expect_event("Iris touched", { recovered = true, within = 1 })
        end },

    scenario "iris touched, and stayed there" {
        set = full,
        function(t)
            come_in(t)
            t.forceps:move_to({ 3.9, 1, 1.5 }, { speed = 4, stop = "iris.gap_mm < -0.05" })
            t:expect_event("Iris touched", { recovered = false, within = 3 })
        end },

    scenario "close to the edge of the pupil" {
        set = full,
        silent_twin_of = "Iris touched",
        near = "iris.gap_mm < 0.2",
        function(t)
            come_in(t)
            t.forceps:move_to({ 3.9, 1, 1.5 }, { speed = 4, stop = "iris.gap_mm < 0.2" })
            t:wait(1)
        end },
}
