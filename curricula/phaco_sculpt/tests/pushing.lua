-- SPDX-License-Identifier: GPL-3.0-or-later
-- Pushing the nucleus: a tip that is deep in a hard one goes on without ultrasound.

local hole = { 0, -0.8, -0.2 }
local over_hole = { 0, -0.8, 3.8 }
local hard = { patient = { tetrahedra = 1000, cataract = "NO5" } }  -- it moves as a whole, in any mesh

-- Deep into the lens with ultrasound, then away from the surgeon without, until it is shifted by `shift` mm.
local function push(t, shift)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to(over_hole, { speed = 8 })
    t:wait(0.6)  -- the chamber deepens
    t.phaco:pedal(3)
    t.phaco:move_to(hole, { speed = 1.2, motion = "even" })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 1, -0.2 }, { speed = 2, motion = "even", stop = "lens.displacement_mm > " .. shift })
end

local function draw_back(t)
    t.phaco:move_to(hole, { speed = 5 })
    t.phaco:move_to(over_hole, { speed = 8 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "nucleus pushed, put right by drawing back and lifting the tip off the lens" {
        set = hard,
        function(t)
            push(t, 0.52)
            t:expect_event("Pushing the nucleus")
            draw_back(t)
            t:expect_event("Pushing the nucleus", { recovered = true, within = 1 })
        end },

    scenario "nucleus pushed, and held there" {
        set = hard,
        function(t)
            push(t, 0.52)
            t:expect_event("Pushing the nucleus", { recovered = false, within = 4 })
        end },

    scenario "nucleus pushed a little, and the tip lifted" {
        set = hard,
        silent_twin_of = "Pushing the nucleus",
        near = "lens.displacement_mm > 0.38 and phaco.in_contact",
        function(t)
            push(t, 0.38)
            t:wait(1)
            t:expect("lens.peak_displacement_mm > 0.38")
            draw_back(t)
        end },
}
