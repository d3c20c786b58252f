-- SPDX-License-Identifier: GPL-3.0-or-later
-- The posterior capsule, torn by ultrasound at the bottom of a hole that is too deep.

local over_lens = { 0, 0, 3.8 }
local coarse = { patient = { tetrahedra = 1000 } }  -- the way down to the capsule needs no finer mesh

-- Down a hole in the middle, and the last of it with ultrasound and without, until the tip is about to touch the
-- capsule; pedal at 1.
local function drill(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to(over_lens, { speed = 20 })
    t.phaco:move_to({ 0, 0, -5 }, { speed = 4, motion = "even", stop = "phaco.tip_posterior_mm < 0.6" })
    t.phaco:pedal(3)
    t.phaco:move_to({ 0, 0, -5 }, { speed = 1.2, motion = "even", stop = "phaco.tip_posterior_mm < 0.3" })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, -5 }, { speed = 1, motion = "even", stop = "phaco.tip_posterior_mm < 0.05" })
end

local function tear(t)
    drill(t)
    t.phaco:pedal(3)
    t.phaco:move_by({ 0, 0, -1.2 }, { speed = 1, motion = "even", stop = "capsule.open" })
    t:expect_event("Capsule torn")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "capsule torn; irrigation only, chamber kept, then out" {
        start = "hole",
        set = coarse,
        function(t)
            tear(t)
            t.phaco:pedal(1)
            t:wait(1.5)
            t:expect("chamber.depth_share > 0.9")
            t.phaco:move_to(over_lens, { speed = 8 })
            t.phaco:withdraw()
            t:expect_event("Capsule torn", { recovered = true, within = 1 })
        end },

    scenario "capsule torn, and the tip drawn out without irrigation" {
        start = "hole",
        set = coarse,
        function(t)
            tear(t)
            t.phaco:pedal(0)
            t.phaco:move_to(over_lens, { speed = 8 })
            t.phaco:withdraw()
            t:expect_event("Capsule torn", { recovered = false, within = 1 })
        end },

    scenario "the capsule pressed without ultrasound" {
        start = "hole",
        set = coarse,
        silent_twin_of = "Capsule torn",
        near = "capsule.strain_share > 0.6",
        function(t)
            drill(t)
            t.phaco:move_by({ 0, 0, -1.5 }, { speed = 1, motion = "even", stop = "capsule.strain_share > 0.6" })
            t:wait(1)
            t.phaco:move_to(over_lens, { speed = 6 })
        end },
}
