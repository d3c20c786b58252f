-- SPDX-License-Identifier: GPL-3.0-or-later
-- Too deep: ultrasound or aspiration close to the posterior capsule.

local front_of_lens = { 0, 0, 3 }
local coarse = { patient = { tetrahedra = 1500 } }  -- drilling is costly, and needs no finer mesh to come too deep

-- A hole straight down the middle from close to the lens, until the tip is `rest` mm from the posterior capsule.
local function drill(t, rest)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 2.3 }, { speed = 20 })
    t.phaco:pedal(3)
    t.phaco:move_to({ 0, 0, -4 }, { speed = 1, motion = "even", stop = "phaco.tip_posterior_mm < " .. rest })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "too deep, put right by letting go and lifting the tip" {
        set = coarse,
        function(t)
            drill(t, 0.29)
            t:expect_event("Groove too deep")
            t.phaco:pedal(1)
            t.phaco:move_to(front_of_lens, { speed = 8 })
            t:expect_event("Groove too deep", { recovered = true })
        end },

    scenario "too deep, and stays there" {
        set = coarse,
        function(t)
            drill(t, 0.29)
            t.phaco:pedal(2)
            t:expect_event("Groove too deep", { recovered = false, within = 3 })
            t:expect("phaco.tip_posterior_mm < 0.6")
        end },

    scenario "deep, but stops in time" {
        set = coarse,
        silent_twin_of = "Groove too deep",
        near = "phaco.tip_posterior_mm < 0.45 and phaco.ultrasound",
        function(t)
            drill(t, 0.44)
            t.phaco:pedal(1)
            t:wait(1)
            t:expect("phaco.tip_posterior_mm < 0.6")
            t.phaco:move_to(front_of_lens, { speed = 8 })
        end },
}
