-- SPDX-License-Identifier: GPL-3.0-or-later
-- Fluid that cannot come out past the nucleus, and a posterior capsule that bursts under it.

local function under_rim(hand)
    hand:enter()
    hand:path({ { 0, 2.0, 2.7 }, { 0, 3.0, 1.15 } }, { speed = 8 })
end

-- Too fast for the way out, until a condition holds.
local function inject(t, condition)
    under_rim(t.saline_cannula)
    t.saline_cannula:jaw(1)
    t:wait_until(condition, 4)
    t.saline_cannula:jaw(0)
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "the nucleus bulges, and is pressed back" {
        function(t)
            inject(t, "hydro.forward_mm > 0.55")
            t:expect_event("Capsular block")
            t.saline_cannula:path({ { 0, 2.0, 2.9 }, { 0, 0, 2.9 } }, { speed = 8 })
            t.saline_cannula:move_to({ 0, 0, 0.9 }, { speed = 3 })
            t:wait(1)
            t:expect_event("Capsular block", { recovered = true, within = 3 })
            t:expect("not hydro.burst")
        end },

    scenario "the nucleus bulges, and is left so" {
        function(t)
            inject(t, "hydro.forward_mm > 0.55")
            t:expect_event("Capsular block", { recovered = false, within = 7 })
        end },

    scenario "the nucleus begins to bulge, and the hand stops" {
        silent_twin_of = "Capsular block",
        near = "hydro.forward_mm > 0.4",
        function(t)
            inject(t, "hydro.forward_mm > 0.4")
            t:wait(2)
            t:expect("hydro.forward_mm < 0.1")
        end },

    scenario "the capsule bursts, and the nucleus is held up" {
        set = { capsule = { strength = 0.6 } },
        function(t)
            inject(t, "hydro.burst")
            t:expect_event("Hydrorupture")
            t:wait(0.4)
            t:expect("capsule.open and hydro.bag_pressure_mmhg < 5 and hydro.trapped_mm3 < 5")
            t:expect("bag.tilt_deg > 1")
            t.saline_cannula:withdraw { speed = 12 }
            under_rim(t.cannula)
            t.cannula:jaw(0.2)
            t:wait_until("hydro.lift_mm3 > 40", 3)
            t.cannula:jaw(0)
            t:expect_event("Hydrorupture", { recovered = true, within = 2 })
        end },

    scenario "the capsule bursts, and nothing is done" {
        recover_within_s = 3,
        set = { capsule = { strength = 0.6 } },
        function(t)
            inject(t, "hydro.burst")
            t:expect_event("Hydrorupture", { recovered = false, within = 4 })
        end },

    scenario "close to what the capsule bears" {
        silent_twin_of = "Hydrorupture",
        near = "hydro.strain_share > 0.7",
        function(t)
            inject(t, "hydro.strain_share > 0.7")
            t:wait(0.5)
            t:expect("not capsule.open")
        end },
}
