-- SPDX-License-Identifier: GPL-3.0-or-later
-- Too deep: ultrasound or aspiration close to the posterior capsule.

local over_lens = { 0, 0, 3.8 }
local coarse = { patient = { tetrahedra = 1000 } }  -- a hole comes too deep in any mesh

-- A hole straight down the middle, until the tip is `rest` mm from the posterior capsule.
local function drill(t, rest)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to(over_lens, { speed = 8 })
    t.phaco:pedal(3)
    t.phaco:move_to({ 0, 0, 1.4 }, { speed = 8 })
    t.phaco:move_to({ 0, 0, -4 }, { speed = 1.2, motion = "even", stop = "phaco.tip_posterior_mm < " .. rest })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "too deep, put right by letting go and lifting the tip well over the lens" {
        set = coarse,
        function(t)
            drill(t, 0.29)
            t:expect_event("Groove too deep")
            t.phaco:pedal(1)
            t.phaco:move_to(over_lens, { speed = 10 })
            t:expect_event("Groove too deep", { recovered = true, within = 1 })
        end },

    scenario "too deep, and only the pedal is let go" {
        set = coarse,
        function(t)
            drill(t, 0.29)
            t.phaco:pedal(1)
            t:expect_event("Groove too deep", { recovered = false, within = 3 })
        end },

    scenario "deep, but stops in time" {
        set = coarse,
        silent_twin_of = "Groove too deep",
        near = "phaco.tip_posterior_mm < 0.45 and phaco.ultrasound",
        function(t)
            drill(t, 0.44)
            t.phaco:pedal(1)
            t:wait(1)
            t:expect("phaco.tip_posterior_mm < 0.65")
            t.phaco:move_to(over_lens, { speed = 10 })
        end },
}
