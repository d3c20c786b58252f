-- SPDX-License-Identifier: GPL-3.0-or-later
-- The mouth of the tip and the posterior capsule.

local function low(t, turned)
    t.ia_tip:enter()
    t.ia_tip:pedal(1)
    t.ia_tip:move_to({ 0, -0.5, -0.5 }, { speed = 10 })
    t.ia_tip:turn(turned)
    t.ia_tip:move_to({ 0, -1.0, -1.5 }, { speed = 8 })
    t.ia_tip:move_to({ 0, -1.4, -3.05 }, { speed = 3 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 8.5 },

    scenario "drawn in, and let go at once" {
        set = { cortex = { left = 0 } },
        function(t)
            low(t, 180)
            t.ia_tip:pedal(2)
            t:wait_until("capsule.captured", 3)
            t:expect_event("Posterior capsule drawn in")
            t.ia_tip:pedal(0)
            t:expect_event("Posterior capsule drawn in", { recovered = true, within = 1 })
            t:expect("not capsule.open")
        end },

    scenario "drawn in, and pulled away" {
        set = { cortex = { left = 0 }, ia = { vacuum_mmhg = 600 } },
        function(t)
            low(t, 180)
            t.ia_tip:pedal(2)
            t:wait_until("capsule.captured", 3)
            t:wait(0.5)
            t.ia_tip:move_by({ 0, 0, 2 }, { speed = 3 })
            t:expect("capsule.open")
            t:expect_event("Posterior capsule drawn in", { recovered = false, within = 3 })
        end },

    scenario "as low, with the mouth turned to the capsule and hardly any vacuum" {
        set = { cortex = { left = 0 } },
        silent_twin_of = "Posterior capsule drawn in",
        near = "ia_tip.tip_posterior_mm < 0.05 and ia_tip.suction_mmhg > 15",
        function(t)
            t:set { ["ia.vacuum_mmhg"] = 15 }
            low(t, 180)
            t.ia_tip:pedal(2)
            t:wait(2)
            t:expect("not capsule.open")
        end },

    scenario "as low, with the mouth up" {
        set = { cortex = { left = 0 } },
        silent_twin_of = "Posterior capsule drawn in",
        near = "ia_tip.tip_posterior_mm < 0 and ia_tip.suction_mmhg > 20",
        function(t)
            low(t, 0)
            t.ia_tip:pedal(2)
            t:wait(2)
            t:expect("not capsule.open and not ia_tip.port_down")
        end },
}
