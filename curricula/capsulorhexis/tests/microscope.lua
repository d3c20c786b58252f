-- SPDX-License-Identifier: GPL-3.0-or-later
-- The microscope: what brings the eye into the middle of the field and into focus, and what leaves it at the edge.

-- The cannula over the lens for a while, as whoever fills the chamber holds it.
local function work(t)
    t.cannula:enter({ speed = 20 })
    t.cannula:move_to({ 0, -1, 3 }, { speed = 10 })
    t:wait(1)
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "the eye is centred and in focus before an instrument goes in" {
        function(t)
            t:expect_near("microscope.pupil_offset", 2 / 7.3, 1e-6)
            t:expect("not microscope.in_focus")
            t.microscope:centre()
            work(t)
            t:expect_near("microscope.pupil_offset", 0, 1e-9)
            t:expect_near("microscope.defocus_mm", 0, 1e-9)
            t:expect("microscope.pupil_in_view and microscope.in_focus")
        end },

    scenario "the eye is left at the edge of the field" {
        set = { ["microscope.x_mm"] = 4, ["microscope.y_mm"] = 0 },
        function(t)
            t.microscope:move_by({ 0, 0, -2 })
            work(t)
            t:expect_near("microscope.pupil_offset", 4 / 7.3, 1e-6)
            t:expect("microscope.in_focus and not microscope.pupil_in_view")
        end },
}
