-- SPDX-License-Identifier: GPL-3.0-or-later
-- A hole in the posterior capsule, with the hyaloid behind it whole.

local quick = 30  -- where nothing depends on it [mm/s]
local weak = { capsule = { hole_mm = 0, strength = 0.3 } }

-- The tip over the hole with irrigation, as it was when the edge showed.
local function found(t)
    t.phaco:enter { speed = quick }
    t.phaco:pedal(1)
    t.phaco:move_to({ 0.6, 0.8, 0.5 }, { speed = 8 })
    t:wait(0.5)
    t:expect_event("Capsule torn, hyaloid intact")
end

-- Viscoelastic over the hole through the side port, until the chamber is full of it.
local function cover(t)
    t.cannula:enter { through = "side_port", speed = quick }
    t.cannula:move_to({ 0.4, 0.8, -1 }, { speed = 15 })
    t.cannula:jaw(1)
    t:wait_until("tamponade.fill > 0.5", 8)
    t.cannula:jaw(0)
end

-- The tip through the chamber and down at a capsule that is whole, with irrigation, until a condition holds.
local function press(t, stop)
    t.phaco:enter { speed = quick }
    t.phaco:pedal(1)
    t.phaco:move_to({ 0.6, 0.8, 0.5 }, { speed = 20 })
    t.phaco:move_to({ 0.6, 0.8, -6 }, { speed = 4, stop = stop })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7 },

    scenario "a hole, covered before the tip leaves" {
        start = "some_viscoelastic",
        function(t)
            found(t)
            t:expect("tamponade.cover < 0.05")
            cover(t)
            t:expect("tamponade.cover > 0.95 and chamber.depth_share > 0.9")
            t:request("Bottle down")
            t:wait(1)
            t:expect("requested.bottle_down and chamber.pressure_mmhg < 40")
            t.phaco:withdraw { speed = quick }
            t.cannula:withdraw { speed = quick }
            t:expect_event("Capsule torn, hyaloid intact", { recovered = true, within = 2 })
            t:expect("capsule.hole_growth <= 0.1")
            t:expect_no_event("Vitreous")
        end },

    scenario "a hole, and the tip comes out at once" {
        recover_within_s = 3,
        function(t)
            found(t)
            t.phaco:withdraw { speed = quick }
            t:wait(0.5)
            t:expect("capsule.hole_growth > 1")
            t:expect_event("Capsule torn, hyaloid intact", { recovered = false, within = 4 })
        end },

    scenario "a hole, and aspiration goes on" {
        recover_within_s = 3,
        function(t)
            found(t)
            t.phaco:pedal(2)
            t:wait(1)
            t:expect("capsule.hole_growth > 0.1")
            t:expect_event("Capsule torn, hyaloid intact", { recovered = false, within = 4 })
        end },

    scenario "bottle asked down by 15 cm at once: the hole bears that, too" {
        function(t)
            found(t)
            t:request("Bottle down")
            t:wait(2)
            t:expect("requested.bottle_down and chamber.pressure_mmhg < 40")
            t:expect("capsule.hole_growth <= 0.1 and not vitreous.hyaloid_broken")
        end },

    scenario "bottle down step by step: the hole stays as it is" {
        function(t)
            found(t)
            for height = 60, 40, -5 do
                t:set { ["machine.bottle_cm"] = height }
                t:wait(0.5)
            end
            t:expect("capsule.hole_growth <= 0.1 and not vitreous.hyaloid_broken")
        end },

    scenario "the tip presses a weak capsule, and is drawn back before it tears" {
        set = weak,
        silent_twin_of = "Capsule torn, hyaloid intact",
        near = "capsule.strain_share > 0.7",
        function(t)
            press(t, "capsule.strain_share > 0.7")
            t.phaco:move_to({ 0.6, 0.8, 0.5 }, { speed = 6 })
            t.phaco:withdraw { speed = quick }
            t:wait(0.5)
            t:expect("not capsule.open")
        end },

    scenario "the tip pushes through a weak capsule; covered, then out" {
        start = "some_viscoelastic",
        set = weak,
        function(t)
            press(t, "capsule.open")
            t:wait(0.1)
            t:expect_event("Capsule torn, hyaloid intact")
            t.phaco:move_to({ 0.6, 0.8, 0.5 }, { speed = 6 })
            cover(t)
            t.phaco:withdraw { speed = quick }
            t:expect_event("Capsule torn, hyaloid intact", { recovered = true, within = 2 })
        end },

    scenario "the tip pushes through a weak capsule, and comes out at once" {
        recover_within_s = 3,
        set = weak,
        function(t)
            press(t, "capsule.open")
            t:wait(0.1)
            t:expect_event("Capsule torn, hyaloid intact")
            t.phaco:move_to({ 0.6, 0.8, 0.5 }, { speed = 6 })
            t.phaco:withdraw { speed = quick }
            t:expect_event("Capsule torn, hyaloid intact", { recovered = false, within = 4 })
        end },
}
