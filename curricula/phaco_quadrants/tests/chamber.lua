-- SPDX-License-Identifier: GPL-3.0-or-later
-- Surge when an occlusion breaks, and a chamber that empties.

local quarter_hand = require "quarter_hand"

local coarse = { patient = { tetrahedra = 1000 } }
-- Old tubing, much vacuum, a low bottle.
local risky = { patient = { tetrahedra = 1000 },
    machine = { tubing_mm3_mmhg = 0.8, vacuum_mmhg = 600, bottle_cm = 40 } }
local careful = { patient = { tetrahedra = 1000 },
    machine = { tubing_mm3_mmhg = 0.8, vacuum_mmhg = 350, bottle_cm = 90 } }

local function come_in(t) quarter_hand.come_in(t, 20, 20) end

local function occlude(t)
    come_in(t)
    quarter_hand.press_on_piece(t)
    t:wait_until("phaco.occlusion > 0.9 and panel.vacuum_mmhg > 180", 6)
end

-- The same, and torn away.
local function break_occlusion(t)
    occlude(t)
    t:wait(3)
    t.phaco:move_to({ 1.2, -0.6, 3 }, { speed = 30 })
end

local function empty(t)
    come_in(t)
    t:set { ["machine.bottle_cm"] = 0, ["machine.flow_ml_min"] = 50 }
    t.phaco:pedal(2)
    t:wait_until("chamber.depth_share < 0.4", 10)
    t:expect_event("Chamber collapse")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "surge, pedal up at once" {
        set = risky,
        function(t)
            occlude(t)  -- so much vacuum draws in what shuts the tip, until it is free
            t:wait_until("chamber.depth_lost_share > 0.3", 6)
            t.phaco:pedal(1)
            t:expect_event("Surge", { recovered = true, within = 3 })
        end },

    scenario "surge, and the pedal stays down" {
        set = risky,
        function(t)
            break_occlusion(t)
            t:expect_event("Surge", { recovered = false, within = 4 })
        end },

    scenario "less vacuum and a higher bottle: no surge" {
        set = careful,
        silent_twin_of = "Surge",
        near = "chamber.depth_lost_share > 0.2",
        function(t)
            break_occlusion(t)
            t:wait(1)
            t:expect("chamber.surges == 0")
        end },

    scenario "chamber empty, bottle up" {
        set = coarse,
        function(t)
            empty(t)
            t:set { ["machine.bottle_cm"] = 95 }
            t.phaco:pedal(1)
            t:expect_event("Chamber collapse", { recovered = true, within = 4 })
        end },

    scenario "chamber empty, and aspiration goes on" {
        set = coarse,
        function(t)
            empty(t)
            t:expect_event("Chamber collapse", { recovered = false, within = 5 })
        end },

    scenario "bottle too low for the flow, seen while the chamber is shallow" {
        set = coarse,
        silent_twin_of = "Chamber collapse",
        near = "chamber.depth_share < 0.55",
        function(t)
            come_in(t)
            t:set { ["machine.flow_ml_min"] = 45 }
            t.phaco:pedal(2)
            for height = 85, 49, -3 do
                t:set { ["machine.bottle_cm"] = height }
                t:wait(0.35)
            end
            t:wait(1)
            t:set { ["machine.bottle_cm"] = 95 }
            t.phaco:pedal(1)
            t:wait(1)
            t:expect("chamber.depth_share > 0.9 and chamber.least_depth_share > 0.4")
            t:expect_no_event("Surge")
        end },
}
