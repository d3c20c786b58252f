-- SPDX-License-Identifier: GPL-3.0-or-later
-- A chamber that empties, and the posterior capsule that comes to the tip.

local quarter_hand = require "quarter_hand"

local function come_in(t) quarter_hand.come_in(t, 20, 8) end

local function empty(t)
    come_in(t)
    t:set { ["machine.bottle_cm"] = 0, ["machine.flow_ml_min"] = 50 }
    t.phaco:pedal(2)
    t:wait_until("chamber.depth_share < 0.4", 10)
    t:expect_event("Chamber collapse")
end

-- A hole straight down the middle, between the quarters, until the tip is close to the capsule; pedal at 1.
local function drill(t)
    come_in(t)
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

    scenario "chamber empty, bottle up and pedal 1" {
        function(t)
            empty(t)
            t:set { ["machine.bottle_cm"] = 95 }
            t.phaco:pedal(1)
            t:expect_event("Chamber collapse", { recovered = true, within = 4 })
        end },

    scenario "chamber empty, and aspiration goes on" {
        function(t)
            empty(t)
            t:expect_event("Chamber collapse", { recovered = false, within = 5 })
        end },

    scenario "bottle sinks under much flow, seen while the chamber is shallow" {
        silent_twin_of = "Chamber collapse",
        near = "chamber.depth_share < 0.55",
        function(t)
            come_in(t)
            t:set { ["machine.flow_ml_min"] = 45 }
            t.phaco:pedal(2)
            for height = 65, 49, -2 do
                t:set { ["machine.bottle_cm"] = height }
                t:wait(0.4)
            end
            t:wait(1)
            t:set { ["machine.bottle_cm"] = 95 }
            t.phaco:pedal(1)
            t:wait(1)
            t:expect("chamber.depth_share > 0.9 and chamber.least_depth_share > 0.4")
            t:expect_no_event("Surge")
        end },

    scenario "capsule in the tip, let go in time" {
        function(t)
            capture(t)
            t.phaco:pedal(1)
            t:expect_event("Capsule in the tip", { recovered = true, within = 2 })
        end },

    scenario "capsule in the tip, and held there" {
        function(t)
            capture(t)
            t:expect_event("Capsule in the tip", { recovered = false, within = 3 })
        end },

    scenario "close to the capsule, with hardly any vacuum" {
        silent_twin_of = "Capsule in the tip",
        near = "phaco.tip_posterior_mm < 0.06 and phaco.suction_mmhg > 10",
        function(t)
            t:set { ["machine.vacuum_mmhg"] = 5, ["machine.flow_ml_min"] = 5 }
            drill(t)
            t.phaco:pedal(2)
            t:wait(1)
        end },
}
