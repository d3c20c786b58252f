-- SPDX-License-Identifier: GPL-3.0-or-later
-- Zonules tear by force: a tip that is deep in a hard lens goes on without ultrasound.

local hand = require "zonule_hand"

local set = { patient = { tetrahedra = 1000, cataract = "NO5" },
    zonules = { lost_deg = 0, strength = 1, toughness = 0.15 } }

local hole = { 0, -0.8, 0.2 }
local over_hole = { 0, -0.8, 3.8 }

-- Into the lens with ultrasound, then away from the surgeon without, until a condition holds.
local function push(t, stop)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to(over_hole, { speed = 15 })
    t.phaco:pedal(3)
    t.phaco:move_to(hole, { speed = 1.4, motion = "even" })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 2, 0.2 }, { speed = 2, motion = "even", stop = stop })
    print(("%.2f torn %.1f offset %.3f tilt %.2f at %.0f gap %.0f p %.1f"):format(t:time_s(), t:value("zonules.torn_deg"), t:value("bag.offset_mm"), t:value("bag.tilt_deg"), t:value("zonules.gap_at_deg"), t:value("zonules.gap_deg"), t:value("chamber.pressure_mmhg")))
end

local function draw_back(t)
    t.phaco:move_to(hole, { speed = 8 })
    t.phaco:move_to(over_hole, { speed = 12 })
    print(("%.2f torn %.1f offset %.3f tilt %.2f at %.0f gap %.0f"):format(t:time_s(), t:value("zonules.torn_deg"), t:value("bag.offset_mm"), t:value("bag.tilt_deg"), t:value("zonules.gap_at_deg"), t:value("zonules.gap_deg")))
end

return scenarios {
    scenario "pushed on until they tear; bottle down, viscoelastic over the gap, a hook" {
        set = set,
        function(t)
            push(t, "zonules.gap_deg >= 30")
            t:expect_event("Zonular dialysis")
            draw_back(t)
            t:expect("bag.tilt_deg > 0.5 and bag.offset_mm > 0.05")
            t:set { ["machine.bottle_cm"] = 35 }
            t.phaco:withdraw({ speed = 20 })
            hand.cover(t)
            hand.set_hook(t)
            t:expect_event("Zonular dialysis", { recovered = true, within = 2 })
        end },

    scenario "pushed on until they tear, and left so" {
        set = set,
        function(t)
            push(t, "zonules.gap_deg >= 30")
            draw_back(t)
            t:expect_event("Zonular dialysis", { recovered = false, within = 13 })
        end },

    scenario "pushed until the first tear, and drawn back" {
        set = set,
        silent_twin_of = "Zonular dialysis",
        function(t)
            push(t, "zonules.torn_deg >= 7")
            draw_back(t)
            t:wait(0.5)
            t:expect("zonules.torn_deg > 0 and zonules.torn_deg < 30")
        end },
}
