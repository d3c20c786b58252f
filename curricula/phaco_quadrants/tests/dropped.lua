-- SPDX-License-Identifier: GPL-3.0-or-later
-- A piece that goes through a hole in the posterior capsule.

local quarter_hand = require "quarter_hand"

local coarse = { patient = { tetrahedra = 1000 } }

-- The capsule is torn: to the middle of the lens with irrigation.
local function come_in(t)
    t.phaco:enter({ speed = 20 })
    t:expect_event("Capsule torn")
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 20 })
    t.phaco:move_to({ 0, 0, 0.2 }, { speed = 8 })
end

-- The tip at the far left quarter.
local function reach(t)
    t.phaco:pedal(2)
    t.phaco:move_to({ -0.85, 0.85, 0.2 }, { speed = 2 })
    t.phaco:pedal(2.1)
    t.phaco:move_to({ -1.4, 1.4, -0.1 }, { speed = 1.5, motion = "even" })
    t.phaco:pedal(1.75)
    t.phaco:move_to({ -1.9, 1.9, -0.4 }, { speed = 1, motion = "even" })
    t:wait(0.8)
end

-- It is pushed through the hole while nothing keeps the chamber up.
local function drop(t)
    come_in(t)
    reach(t)
    t:set { ["machine.bottle_cm"] = 0 }
    t.phaco:move_to({ 0, 0, 0 }, { speed = 2 })
    t.phaco:move_to({ 0, 0, -5 }, { speed = 1, motion = "even", stop = "fragments.sunk_mm > 2" })
    t:wait(0.1)
    t:expect_event("Dropped piece")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "piece dropped, not chased" {
        start = "torn",
        set = coarse,
        function(t)
            drop(t)
            t:set { ["machine.bottle_cm"] = 95 }
            t.phaco:pedal(1)
            t.phaco:move_to({ 0, 0, 2.5 }, { speed = 6 })
            t:expect_event("Dropped piece", { recovered = true, within = 3 })
        end },

    scenario "piece dropped, and chased" {
        recover_within_s = 2.5,
        start = "torn",
        set = coarse,
        function(t)
            drop(t)
            t.phaco:pedal(2)
            t:expect_event("Dropped piece", { recovered = false, within = 6 })
        end },

    scenario "a tip that aspirates over the hole while the bottle is down, and leaves the pieces alone" {
        start = "torn",
        set = coarse,
        silent_twin_of = "Dropped piece",
        near = "capsule.hole_mm2 > 0 and phaco.aspirating and phaco.tip_posterior_mm < 2.5",
        function(t)
            come_in(t)
            quarter_hand.look_into_hole(t, 95)
            t:expect("fragments.sunk_mm <= 0")
        end },
}
