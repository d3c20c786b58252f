-- SPDX-License-Identifier: GPL-3.0-or-later
-- The hook in the eye while the implant is still in its injector: at the iris, at the back of the bag, at the cornea.

local function come_in(t)
    t.hook:enter({ through = "side_port", speed = 20 })
    t.hook:move_to({ -1, 0, 2.6 }, { speed = 12 })
end

local function to_iris(t, stop) return t.hook:move_to({ 4.2, 0, 1.3 }, { speed = 4, stop = stop }) end

local function to_back(t, stop)
    t.hook:move_to({ 0, 0, 2.0 }, { speed = 8 })
    return t.hook:move_to({ 0, 0, -4 }, { speed = 2, motion = "even", stop = stop })
end

local function to_cornea(t, stop)
    t.hook:move_to({ 0, 0, 3 }, { speed = 8 })
    return t.hook:move_to({ 0, 0, 6 }, { speed = 3, motion = "even", stop = stop })
end

return scenarios {
    patient = { age = 68, pupil_mm = 8 },

    scenario "iris touched, put right" {
        function(t)
            come_in(t)
            to_iris(t, "iris.gap_mm < -0.05")
            t:expect_event("Iris touched")
            t.hook:move_to({ 0, 0, 2.8 }, { speed = 8 })
            t:expect_event("Iris touched", { recovered = true, within = 1 })
        end },

    scenario "iris touched, and stayed there" {
        function(t)
            come_in(t)
            to_iris(t, "iris.gap_mm < -0.05")
            t:expect_event("Iris touched", { recovered = false, within = 3 })
        end },

    scenario "close to the iris" {
        silent_twin_of = "Iris touched",
        near = "iris.gap_mm < 0.2",
        function(t)
            come_in(t)
            to_iris(t, "iris.gap_mm < 0.2")
            t:wait(1)
        end },

    scenario "posterior capsule struck, and lifted" {
        function(t)
            come_in(t)
            to_back(t, "bag.posterior_force_mN > 5.5")
            t:expect_event("Posterior capsule struck")
            t.hook:move_by({ 0, 0, 2.5 }, { speed = 8 })
            t:expect_event("Posterior capsule struck", { recovered = true, within = 2 })
        end },

    scenario "posterior capsule struck, and stayed there" {
        function(t)
            come_in(t)
            to_back(t, "bag.posterior_force_mN > 7")
            t:expect_event("Posterior capsule struck", { recovered = false, within = 3 })
        end },

    scenario "posterior capsule pressed on, but not hard" {
        silent_twin_of = "Posterior capsule struck",
        near = "bag.posterior_force_mN > 3.5",
        function(t)
            come_in(t)
            to_back(t, "bag.posterior_force_mN > 3.5")
            t:expect("bag.posterior_touches >= 1")
        end },

    scenario "cornea touched by the hook, put right" {
        function(t)
            come_in(t)
            to_cornea(t, "hook.endothelium_mm < 0.05")
            t:expect_event("Cornea touched")
            t.hook:move_to({ 0, 0, 2.8 }, { speed = 8 })
            t:expect_event("Cornea touched", { recovered = true, within = 1 })
        end },

    scenario "cornea touched by the hook, and stayed there" {
        function(t)
            come_in(t)
            to_cornea(t, "hook.endothelium_mm < 0.05")
            t:expect_event("Cornea touched", { recovered = false, within = 5 })
        end },

    scenario "hook close to the cornea" {
        silent_twin_of = "Cornea touched",
        near = "hook.endothelium_mm < 0.3 and hook.tip_x_mm > -2.5",
        function(t)
            come_in(t)
            to_cornea(t, "hook.endothelium_mm < 0.3")
            t:wait(0.5)
        end },
}
