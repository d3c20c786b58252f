-- SPDX-License-Identifier: GPL-3.0-or-later
-- The edge of the iris in the tip.

local coarse = { patient = { tetrahedra = 1000, pupil_mm = 6 } }

-- To the right edge of the pupil, in the plane of the iris, aspirating.
local function catch(t)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
    t:wait(1.5)
    t.phaco:pedal(2)
    t.phaco:move_to({ 2.2, 0.3, 1.3 }, { speed = 4 })
    t.phaco:move_to({ 4, 0.3, 1.1 }, { speed = 2, motion = "even", stop = "iris.captured" })
    t:expect_event("Iris in the tip")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "iris in the tip, let go" {
        set = coarse,
        function(t)
            catch(t)
            t.phaco:pedal(1)
            t:expect_event("Iris in the tip", { recovered = true, within = 1.5 })
            t:expect_near("iris.torn_mm", 0, 0)
        end },

    scenario "iris in the tip, and kept there" {
        set = coarse,
        function(t)
            catch(t)
            t:expect_event("Iris in the tip", { recovered = false, within = 3 })
        end },

    scenario "the same way with irrigation only" {
        set = coarse,
        silent_twin_of = "Iris in the tip",
        near = "iris.touch",
        function(t)
            t.phaco:enter()
            t.phaco:pedal(1)
            t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
            t:wait(1.5)
            t.phaco:move_to({ 2.2, 0.3, 1.3 }, { speed = 4 })
            t.phaco:move_to({ 4, 0.3, 1.1 }, { speed = 2, motion = "even", stop = "iris.touch" })
            t:wait(1)
            t:expect("iris.touch")
        end },
}
