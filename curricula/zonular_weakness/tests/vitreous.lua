-- SPDX-License-Identifier: GPL-3.0-or-later
-- Vitreous through a gap in the zonules: the chamber falls while nothing lies over the gap, and it comes; with
-- viscoelastic over it, it does not.

local hand = require "zonule_hand"

-- Tough zonules, so that the gap stays as wide as it is; a bottle as for any lens, so that the chamber falls far.
local gap = { patient = { tetrahedra = 1000 }, zonules = { lost_from_deg = 45, lost_deg = 60, toughness = 1 },
    machine = { bottle_cm = 65 } }

-- In with irrigation, and out again: the wound gapes, and the chamber falls.
local function in_and_out(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -1, 3.6 }, { speed = 15 })
    t:wait(0.8)
    t.phaco:withdraw({ speed = 20 })
    t:wait(0.5)
end

local function make_white(t)
    t.triamcinolone:enter({ through = "side_port", speed = 25 })
    t.triamcinolone:move_to({ 0, 0, 3.2 }, { speed = 25 })
    t.triamcinolone:jaw(1)
    t:wait(0.8)
    t.triamcinolone:jaw(0)
    t.triamcinolone:withdraw({ speed = 25 })
end

-- Cuts along the strand in the wound, covers the gap, cuts before it, and leaves a chamber whose pressure does not fall
-- any more.
local function cut(t)
    t:set { ["machine.bottle_cm"] = 22 }
    t.cutter:enter({ speed = 20 })
    t.cutter:pedal(3)
    t.cutter:move_to({ 0.3, -4.2, 2.5 }, { speed = 15, stop = "vitreous.wound_mm3 < 0.1" })
    t:wait_until("vitreous.wound_mm3 < 0.1", 3)
    t.cutter:pedal(1)
    t:set { ["machine.bottle_cm"] = 10 }
    t:together(function() hand.cover(t, "side_port") end,
        function() t.cutter:move_to(hand.by_rim(t, -1.2, 0.3), { speed = 20 }) end)
    t.cutter:pedal(3)
    t:wait_until("vitreous.front_mm3 < 0.1", 5)
    t:wait(0.3)
    t.cutter:pedal(1)
    t.cutter:withdraw({ speed = 20 })
end

return scenarios {
    patient = { age = 74, cataract = "NO3", pupil_mm = 8 },

    scenario "the tip leaves with nothing over the gap: vitreous comes; cut, and looked for again" {
        set = gap,
        function(t)
            in_and_out(t)
            t:expect("vitreous.hyaloid_broken and vitreous.front_mm3 > 1")
            t:expect_event("Vitreous through the gap")
            cut(t)
            make_white(t)
            t:expect_event("Vitreous through the gap", { recovered = true, within = 1 })
        end },

    scenario "vitreous comes through the gap, and is left there" {
        recover_within_s = 3,
        set = gap,
        function(t)
            in_and_out(t)
            t:expect_event("Vitreous through the gap", { recovered = false, within = 4 })
        end },

    scenario "viscoelastic over the gap before the tip leaves: it does not come" {
        set = gap,
        function(t)
            hand.cover(t)
            in_and_out(t)
            t:expect("not vitreous.hyaloid_broken and vitreous.front_mm3 <= 0 and chamber.lowest_pressure_mmhg < 20")
            t:expect_no_event("Vitreous through the gap")
        end },

    scenario "the hyaloid breaks in a chamber that falls, and that is filled at once: next to none comes" {
        set = gap,
        silent_twin_of = "Vitreous through the gap",
        near = "vitreous.front_mm3 > 0.6",
        function(t)
            t.phaco:enter({ speed = 20 })
            t.phaco:pedal(1)
            t.phaco:move_to({ 0, -1, 3.6 }, { speed = 15 })
            t:wait(0.8)
            t:set { ["machine.flow_ml_min"] = 40, ["machine.vacuum_mmhg"] = 300 }
            t.phaco:pedal(2)
            t:wait_until("vitreous.hyaloid_broken", 3)
            t.phaco:pedal(1)
            hand.cover(t, "side_port")
            t:wait(0.5)
            t:expect("vitreous.front_mm3 < 1 and tamponade.gap_cover > 0.9")
        end },
}
