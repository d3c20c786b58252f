-- SPDX-License-Identifier: GPL-3.0-or-later
-- A piece behind the posterior capsule: left alone, chased, and nearly chased.

local quick = 30  -- where nothing depends on it [mm/s]

local function come_in(t)
    t.phaco:enter { speed = quick }
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 2 }, { speed = 8 })
    t:wait(0.3)
end

local function cover(t)
    t.cannula:enter { through = "side_port", speed = quick }
    t.cannula:move_to({ -0.4, 0, -1.2 }, { speed = 15 })
    t.cannula:jaw(1)
    t:wait_until("tamponade.cover > 0.96 and tamponade.fill > 0.42", 12)
    t.cannula:jaw(0)
end

local function chase(t)
    come_in(t)
    t:expect("fragments.sunk_mm > 2")
    t.phaco:pedal(2)
    t.phaco:move_to({ 0, 0, -3.2 }, { speed = 4, stop = "phaco.tip_posterior_mm < 0.3" })
    t:wait(0.2)
    t:expect_event("Piece chased")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "piece left alone, hole covered, then out" {
        start = "some_viscoelastic",
        function(t)
            come_in(t)
            t:expect_event("Dropped piece")
            t:expect("tamponade.cover < 0.05")
            cover(t)
            t.phaco:withdraw { speed = quick }
            t.cannula:withdraw { speed = quick }
            t:expect_event("Dropped piece", { recovered = true, within = 2 })
            t:request("Retina surgeon called")
            t:wait(0.1)
            t:expect("requested.retina_surgeon_called")
            t:expect_no_event("Piece chased")
        end },

    scenario "piece left alone, but the tip comes out of an uncovered hole" {
        recover_within_s = 3,
        function(t)
            come_in(t)
            t:expect_event("Dropped piece")
            t.phaco:withdraw()
            t:expect_event("Dropped piece", { recovered = false, within = 4 })
        end },

    scenario "piece chased, and given up" {
        function(t)
            chase(t)
            t.phaco:pedal(1)
            t.phaco:move_to({ 0, 0, 2 }, { speed = 6 })
            t:expect_event("Piece chased", { recovered = true, within = 2 })
        end },

    scenario "piece chased, and on" {
        function(t)
            chase(t)
            t:expect_event("Piece chased", { recovered = false, within = 4 })
        end },

    scenario "the tip begins to go after it, and turns back before the hole" {
        silent_twin_of = "Piece chased",
        near = "phaco.tip_posterior_mm < 0.75 and phaco.aspirating and fragments.sunk_mm > 1",
        function(t)
            come_in(t)
            t.phaco:pedal(2)
            t.phaco:move_to({ 0, 0, -3.2 }, { speed = 4, stop = "phaco.tip_posterior_mm < 0.7" })
            t:wait(0.2)
            t.phaco:pedal(1)
            t.phaco:move_to({ 0, 0, 2 }, { speed = 6 })
            t:expect("phaco.tip_posterior_mm > 1")
        end },
}
