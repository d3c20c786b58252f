-- SPDX-License-Identifier: GPL-3.0-or-later
-- Around the rescue: too much viscoelastic, and the edge of the pupil.

local rhexis_hand = require "rhexis_hand"

local full = { ["viscoelastic.fill"] = 1 }
-- A thin agent: what is too much leaves beside the cannula within seconds, not half a minute.
local thin = { ["viscoelastic.fill"] = 1, ["viscoelastic.leak"] = 0.04 }

local function press_until(t, pressure)
    t.cannula:enter({ speed = 20 })
    t.cannula:move_to({ 0, -1.5, 3 }, { speed = 12 })
    t.cannula:jaw(1)
    t:wait_until("viscoelastic.pressure_mmhg > " .. pressure, 20)
    t.cannula:jaw(0)
end

local function to_the_iris(t, stop)
    t.forceps:enter({ speed = 20 })
    t.forceps:move_to(rhexis_hand.place(1.5, -30, 1.2), { speed = 12 })
    t.forceps:move_to({ 3.9, 1, 1.5 }, { speed = 4, stop = stop })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "pressed too long, and let out along the cannula" {
        set = thin,
        function(t)
            press_until(t, 62)
            t:expect_event("Overfilled", { recovered = true, within = 6 })
        end },

    scenario "pressed too long, and the wound closed over it" {
        recover_within_s = 3,
        set = full,
        function(t)
            press_until(t, 62)
            t.cannula:withdraw({ speed = 20 })
            t:expect_event("Overfilled", { recovered = false, within = 4 })
        end },

    scenario "iris touched, put right" {
        function(t)
            to_the_iris(t, "iris.gap_mm < -0.05")
            t:expect_event("Iris touched")
            t.forceps:move_to(rhexis_hand.place(1.5, -30, 1.2), { speed = 6 })
            t:expect_event("Iris touched", { recovered = true, within = 1 })
        end },

    scenario "iris touched, and stayed there" {
        function(t)
            to_the_iris(t, "iris.gap_mm < -0.05")
            t:expect_event("Iris touched", { recovered = false, within = 3 })
        end },

    scenario "pressed a little too long" {
        set = full,
        silent_twin_of = "Overfilled",
        near = "viscoelastic.pressure_mmhg > 55",
        function(t)
            press_until(t, 55)
            t.cannula:withdraw({ speed = 20 })
            t:wait(1)
        end },

    scenario "close to the iris, no hand on the capsule" {
        silent_twin_of = "Iris touched",
        near = "iris.gap_mm < 0.2",
        function(t)
            to_the_iris(t, "iris.gap_mm < 0.2")
            t:wait(1)
        end },
}
