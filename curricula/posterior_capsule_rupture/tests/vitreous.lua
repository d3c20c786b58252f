-- SPDX-License-Identifier: GPL-3.0-or-later
-- Vitreous in the chamber: cut away, left, pulled at, and next to none. It came as the tip sucked at the hyaloid:
-- here, or in the start "vitreous".

local hole = { 0.4, 0.8, -1.5 }

local quick = 60  -- where nothing depends on it [mm/s]

local function inject(t, name, place, seconds)
    t[name]:enter { through = "side_port", speed = quick }
    t[name]:move_to(place, { speed = quick })
    t[name]:jaw(1)
    t:wait(seconds)
    t[name]:jaw(0)
    t[name]:withdraw { speed = quick }
end

local function cover(t, seconds) inject(t, "cannula", hole, seconds or 3) end
local function make_white(t, seconds) inject(t, "triamcinolone", { 0, 0.8, 1 }, seconds or 0.8) end

-- Cuts before the hole, then along the strand to the wound.
local function cut(t)
    t.cutter:enter { speed = quick }
    t.cutter:pedal(1)
    t.cutter:move_to({ 0.6, 0.8, -2 }, { speed = 20 })
    t.cutter:pedal(3)
    t:wait_until("vitreous.front_mm3 < 0.3", 8)
    t.cutter:move_to({ 0.3, -4.4, 2.3 }, { speed = 5, stop = "vitreous.wound_mm3 < 0.1" })
    t:wait_until("vitreous.wound_mm3 < 0.1", 4)
    t.cutter:pedal(1)
end

-- The tip over the hole, sucking at the hyaloid until a condition holds.
local function suck(t, condition)
    t.phaco:enter { speed = quick }
    t.phaco:pedal(1)
    t.phaco:move_to({ 0.6, 0.8, -2 }, { speed = 8 })
    t:wait(0.5)
    t:set { ["machine.flow_ml_min"] = 50, ["machine.vacuum_mmhg"] = 500 }
    t.phaco:pedal(2)
    t:wait_until(condition, 4)
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7 },

    scenario "vitreous made white, cut away, and looked for again" {
        start = "vitreous",
        function(t)
            t:wait(0.1)
            t:expect_event("Vitreous")
            make_white(t, 0.5)
            t:expect("vitreous.marked_share > 0.8")
            cover(t)
            cut(t)
            cover(t, 1)
            t.cutter:withdraw { speed = quick }
            make_white(t, 1.2)
            t:expect_event("Vitreous", { recovered = true, within = 2 })
            t:expect_no_event("Vitreous pulled")
        end },

    scenario "vitreous cut away, but nobody looks for what is left" {
        recover_within_s = 3,
        start = "vitreous",
        function(t)
            t:wait(0.1)
            t:expect_event("Vitreous")
            cover(t)
            cut(t)
            cover(t)
            t.cutter:withdraw { speed = quick }
            t:expect_event("Vitreous", { recovered = false, within = 4 })
        end },

    scenario "vitreous sucked in without cutting, pedal up at once" {
        start = "vitreous",
        function(t)
            t.phaco:enter()
            t.phaco:pedal(1)
            t.phaco:move_to({ 0.6, 0.8, -1.5 }, { speed = 8 })
            t.phaco:pedal(2)
            t:wait_until("vitreous.traction_mN > 0.5", 3)
            t:wait(0.15)
            t.phaco:pedal(1)
            t:expect_event("Vitreous pulled", { recovered = true, within = 2 })
        end },

    scenario "vitreous sucked in without cutting, and drawn up with the tip" {
        start = "vitreous",
        function(t)
            t.phaco:enter()
            t.phaco:pedal(1)
            t.phaco:move_to({ 0.6, 0.8, -1.5 }, { speed = 8 })
            t.phaco:pedal(2)
            t:wait_until("vitreous.traction_mN > 0.5", 3)
            t.phaco:move_by({ 0, 0, 0.8 }, { speed = 0.5 })
            t:expect("vitreous.peak_traction_mN > 1")
            t:expect_event("Vitreous pulled", { recovered = false, within = 3 })
        end },

    scenario "the cutter sucks before it cuts: it pulls" {
        start = "vitreous",
        function(t)
            t:set { ["cutter.cut_first"] = 0, ["cutter.flow_ml_min"] = 30, ["cutter.vacuum_mmhg"] = 500 }
            t.cutter:enter()
            t.cutter:pedal(1)
            t.cutter:move_to({ 0.6, 0.8, -2 }, { speed = 8 })
            t.cutter:pedal(2)
            t:wait(1)
            t:expect("vitreous.uncut_s > 0.5 and vitreous.cut_mm3 <= 0 and vitreous.front_mm3 > 6")
        end },

    scenario "the cutter cuts before it sucks: it does not" {
        start = "vitreous",
        function(t)
            t.cutter:enter()
            t.cutter:pedal(1)
            t.cutter:move_to({ 0.6, 0.8, -2 }, { speed = 8 })
            t.cutter:pedal(3)
            t:wait(1)
            t:expect("vitreous.cut_mm3 > 1 and vitreous.uncut_s <= 0")
            t:expect_no_event("Vitreous pulled")
        end },

    scenario "vitreous begins to pull at the tip, and the pedal is let go before it does" {
        start = "vitreous",
        silent_twin_of = "Vitreous pulled",
        near = "vitreous.traction_mN > 0.35",
        function(t)
            t.phaco:enter()
            t.phaco:pedal(1)
            t.phaco:move_to({ 0.6, 0.8, -1.5 }, { speed = 8 })
            t.phaco:pedal(2)
            t:wait_until("vitreous.traction_mN > 0.3", 3)
            t.phaco:pedal(1)
            t:wait(0.5)
            t:expect("not vitreous.held")
        end },

    scenario "the hyaloid breaks under the tip, and the pedal is let go at once: next to none comes" {
        silent_twin_of = "Vitreous",
        near = "vitreous.front_mm3 > 0.5",
        function(t)
            suck(t, "vitreous.hyaloid_broken")
            t.phaco:pedal(1)
            t:wait(0.3)
            t.phaco:move_to({ 0.6, 0.8, 0.5 }, { speed = 8 })
            cover(t, 4.5)
            t.phaco:withdraw { speed = quick }
            t:wait(1)
            t:expect("vitreous.hyaloid_broken and vitreous.front_mm3 < 1 and vitreous.wound_mm3 < 0.5")
        end },

    scenario "the tip sucks at the hyaloid until it breaks, and vitreous is left where it came" {
        recover_within_s = 3,
        function(t)
            suck(t, "vitreous.hyaloid_broken")
            t:expect_event("Capsule torn, hyaloid intact")
            t:wait_until("vitreous.front_mm3 > 2", 3)
            t:expect_event("Vitreous", { within = 1 })
            t.phaco:pedal(1)
            t.phaco:withdraw { speed = quick }
            t:wait(1)
            t:expect("vitreous.wound_mm3 > 0.2")
            t:expect_event("Vitreous", { recovered = false, within = 4 })
        end },
}
