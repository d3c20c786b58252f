-- SPDX-License-Identifier: GPL-3.0-or-later
-- The spatula presses the far edge of the capsule's opening in.

local coarse = { patient = { tetrahedra = 1000 } }  -- the capsule does not see the mesh
local over_lens = { 0, 0, 3.8 }

-- Phaco tip over the lens with irrigation, the spatula's end over the edge of the opening, far from the surgeon.
local function come_in(t)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -1, 3.2 }, { speed = 8 })
    t.spatula:enter()
    t.spatula:move_to({ 0, 0, 2.6 }, { speed = 8 })
    t.spatula:move_to({ 0, 3, 2.2 }, { speed = 6 })
end

-- Down, until the end of the spatula is `deep` mm through the place of the capsule at rest.
local function press(t, deep)
    t.spatula:move_to({ 0, 3, 0.2 }, { speed = 2, motion = "even", stop = "spatula.capsule_gap_mm < " .. -deep })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "spatula on the edge of the capsule, put right by lifting it straight up" {
        set = coarse,
        function(t)
            come_in(t)
            press(t, 0.25)
            t:expect_event("Spatula on the capsule")
            t.spatula:move_to({ 0, 3, 3.6 }, { speed = 6 })
            t:expect_event("Spatula on the capsule", { recovered = true, within = 1 })
        end },

    scenario "spatula on the edge of the capsule, and drawn along it" {
        set = coarse,
        function(t)
            come_in(t)
            press(t, 0.25)
            t.spatula:move_by({ 1, -0.2, 0 }, { speed = 1, motion = "even" })
            t:expect_event("Spatula on the capsule", { recovered = false, within = 3 })
        end },

    scenario "spatula touches the edge of the capsule and is lifted" {
        set = coarse,
        silent_twin_of = "Spatula on the capsule",
        near = "spatula.capsule_gap_mm < -0.15",
        function(t)
            come_in(t)
            press(t, 0.15)
            t:expect("spatula.capsule_gap_mm < -0.15")
            t:wait(1)
            t.spatula:move_to(over_lens, { speed = 6 })
        end },
}
