-- SPDX-License-Identifier: GPL-3.0-or-later
-- The posterior capsule in the tip, and torn.

local coarse = { patient = { tetrahedra = 1000 } }  -- the way down to the capsule needs no finer mesh

-- Down a hole in the middle, between the quarters, and the last of it with ultrasound and without, until the tip is
-- 0.05 mm from the capsule; pedal at 1.
local function drill(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 20 })
    t.phaco:move_to({ 0, 0, -5 }, { speed = 4, motion = "even", stop = "phaco.tip_posterior_mm < 0.6" })
    t.phaco:pedal(3)
    t.phaco:move_to({ 0, 0, -5 }, { speed = 1.2, motion = "even", stop = "phaco.tip_posterior_mm < 0.3" })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, -5 }, { speed = 1, motion = "even", stop = "phaco.tip_posterior_mm < 0.05" })
end

local function capture(t)
    t:set { ["machine.vacuum_mmhg"] = 120 }
    drill(t)
    t.phaco:pedal(2)
    t:wait_until("capsule.captured", 5)
    t:expect_event("Capsule in the tip")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "capsule in the tip, let go in time" {
        start = "hole",
        set = coarse,
        function(t)
            capture(t)
            t.phaco:pedal(1)
            t:expect_event("Capsule in the tip", { recovered = true, within = 2 })
            t:expect_no_event("Capsule torn")
        end },

    scenario "capsule in the tip, and held there" {
        start = "hole",
        set = coarse,
        function(t)
            capture(t)
            t:expect_event("Capsule in the tip", { recovered = false, within = 3 })
            t.phaco:pedal(1)
        end },

    scenario "close to the capsule, with hardly any vacuum" {
        start = "hole",
        set = coarse,
        silent_twin_of = "Capsule in the tip",
        near = "phaco.tip_posterior_mm < 0.06 and phaco.suction_mmhg > 4",
        function(t)
            t:set { ["machine.vacuum_mmhg"] = 5, ["machine.flow_ml_min"] = 5 }
            drill(t)
            t.phaco:pedal(2)
            t:wait(2)
            t.phaco:pedal(1)
            t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
        end },

    scenario "the capsule pressed without ultrasound" {
        start = "hole",
        set = coarse,
        silent_twin_of = "Capsule torn",
        near = "capsule.strain_share > 0.6",
        function(t)
            drill(t)
            t.phaco:move_by({ 0, 0, -1.5 }, { speed = 1, motion = "even", stop = "capsule.strain_share > 0.6" })
            t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
            t:wait(0.5)
        end },

    scenario "capsule torn by ultrasound; irrigation only, chamber kept, then out" {
        start = "hole",
        set = coarse,
        function(t)
            drill(t)
            t.phaco:pedal(3)
            t.phaco:move_by({ 0, 0, -1.2 }, { speed = 1, motion = "even", stop = "capsule.open" })
            t:expect_event("Capsule torn")
            t.phaco:pedal(1)
            t:wait(1.5)
            t:expect("chamber.depth_share > 0.9")
            t.phaco:move_to({ 0, 0, 3 }, { speed = 8 })
            t.phaco:withdraw()
            t:expect_event("Capsule torn", { recovered = true, within = 2 })
        end },

    scenario "capsule torn, and vacuum goes on" {
        recover_within_s = 3,
        start = "hole",
        set = coarse,
        function(t)
            drill(t)
            t.phaco:pedal(3)
            t.phaco:move_by({ 0, 0, -1.2 }, { speed = 1, motion = "even", stop = "capsule.open" })
            t:expect_event("Capsule torn")
            t.phaco:pedal(2)
            t:expect_event("Capsule torn", { recovered = false, within = 4 })
        end },
}
