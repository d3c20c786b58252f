-- SPDX-License-Identifier: GPL-3.0-or-later
-- Zonules tear by force: a tip that is deep in a hard lens goes on without ultrasound.

local hand = require "zonule_hand"

local set = { patient = { tetrahedra = 1000, cataract = "NO5" },
    zonules = { lost_deg = 0, strength = 1, toughness = 0.2, tension = 0.2 } }

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
end

-- First the way it came, so that the zonules that are left are relieved, then up.
local function draw_back(t)
    t.phaco:move_by({ 0, -1.0, 0.3 }, { speed = 25 })
    t.phaco:move_by({ 0, 0, 3.0 }, { speed = 12 })
end

return scenarios {
    patient = { age = 74, cataract = "NO3", pupil_mm = 8 },

    scenario "pushed on until they tear; bottle down, viscoelastic over the gap, a hook" {
        set = set,
        function(t)
            push(t, "zonules.gap_deg >= 45")
            t:expect_event("Zonular dialysis")
            draw_back(t)
            t:expect("bag.tilt_deg > 0.5 and bag.offset_mm > 0.05")
            t:set { ["machine.bottle_cm"] = 35 }
            t.phaco:withdraw({ speed = 20 })
            hand.cover(t)
            t:expect("zonules.unsupported_deg > 40")
            hand.set_hook(t)
            t:expect_event("Zonular dialysis", { recovered = true, within = 2 })
        end },

    scenario "pushed on until they tear, and left so" {
        recover_within_s = 3,
        set = set,
        function(t)
            push(t, "zonules.gap_deg >= 45")
            draw_back(t)
            t:expect_event("Zonular dialysis", { recovered = false, within = 4 })
        end },

    scenario "pushed until some tear, and drawn back" {
        set = set,
        silent_twin_of = "Zonular dialysis",
        near = "zonules.torn_deg > 15",
        function(t)
            push(t, "zonules.torn_deg > 0")
            draw_back(t)
            t:wait(0.5)
            t:expect("zonules.torn_deg < 45")
        end },
}
