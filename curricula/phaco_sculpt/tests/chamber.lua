-- SPDX-License-Identifier: GPL-3.0-or-later
-- The infusion is shut: the chamber empties, and ultrasound that goes on without flow burns the wound.

local coarse = { patient = { tetrahedra = 1000 } }  -- the fluid does not see the mesh
local no_infusion = { ["machine.infusion"] = 0 }
local infusion = { ["machine.infusion"] = 1 }

-- To the front of the lens with irrigation, pump and infusion as the exercise sets them.
local function come_in(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -1, 3 }, { speed = 20 })
    t:wait(1)  -- the chamber deepens
end

local function empty(t)
    come_in(t)
    t:set(no_infusion)
    t.phaco:pedal(2)
    t:wait_until("chamber.depth_share < 0.4", 3)
    t:expect_event("Chamber collapse")
end

-- Ultrasound just over the lens while the infusion is shut.
local function run_dry(t)
    come_in(t)
    t:set(no_infusion)
    t.phaco:pedal(3)
    t:expect_event("Infusion off", { within = 1 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "chamber empty; pedal to irrigation, infusion opened" {
        set = coarse,
        function(t)
            empty(t)
            t.phaco:pedal(1)
            t:set(infusion)
            t:expect_event("Chamber collapse", { recovered = true, within = 2 })
        end },

    scenario "chamber empty, and aspiration goes on" {
        set = coarse,
        function(t)
            empty(t)
            t:expect_event("Chamber collapse", { recovered = false, within = 5 })
        end },

    scenario "infusion shut for a moment" {
        set = coarse,
        silent_twin_of = "Chamber collapse",
        near = "chamber.depth_share < 0.55",
        function(t)
            come_in(t)
            t:set(no_infusion)
            t.phaco:pedal(2)
            t:wait_until("chamber.depth_share < 0.53", 3)
            t.phaco:pedal(1)
            t:set(infusion)
            t:wait(1)
            t:expect("chamber.depth_share > 0.9 and chamber.least_depth_share > 0.4")
        end },

    scenario "no infusion; ultrasound off at once, infusion opened" {
        set = coarse,
        function(t)
            run_dry(t)
            t.phaco:pedal(1)
            t:set(infusion)
            t.phaco:move_by({ 0, 0, 0.6 }, { speed = 4 })
            t:expect_event("Infusion off", { recovered = true, within = 2 })
        end },

    scenario "no infusion, and ultrasound goes on" {
        set = coarse,
        function(t)
            run_dry(t)
            t:expect_event("Infusion off", { recovered = false, within = 4 })
        end },

    scenario "no infusion, seen before ultrasound" {
        set = coarse,
        silent_twin_of = "Infusion off",
        near = "chamber.infusion_ml_min < 5 and phaco.aspirating and not phaco.ultrasound",
        function(t)
            come_in(t)
            t:set(no_infusion)
            t.phaco:pedal(2)
            t:wait(0.5)
            t:expect("chamber.infusion_ml_min < 5")
            t.phaco:pedal(1)
            t:set(infusion)
            t:wait_until("chamber.depth_share > 1", 2)
            t.phaco:pedal(3)
            t:wait(1)
            t:expect("chamber.infusion_ml_min > 15 and phaco.ultrasound")
        end },

    scenario "wound burnt for want of flow; ultrasound off, infusion opened" {
        set = coarse,
        function(t)
            run_dry(t)
            t:expect_event("Wound burn", { within = 5 })
            t.phaco:pedal(1)
            t:set(infusion)
            t.phaco:move_by({ 0, 0, 0.6 }, { speed = 4 })
            t:expect_event("Wound burn", { recovered = true, within = 2.5 })
            t:expect("wound.temperature_c < 45")
        end },

    scenario "wound burnt, and ultrasound goes on" {
        set = coarse,
        function(t)
            run_dry(t)
            t:expect_event("Wound burn", { within = 5 })
            t:expect_event("Wound burn", { recovered = false, within = 4 })
            t:expect("wound.burn_share > 0.9")
        end },

    scenario "ultrasound without flow, let go before it burns" {
        set = coarse,
        silent_twin_of = "Wound burn",
        near = "wound.temperature_c > 52",
        function(t)
            run_dry(t)
            t:wait_until("wound.temperature_c > 52", 4)
            t.phaco:pedal(1)
            t:set(infusion)
            t:wait(1)
            t:expect("wound.burn_share == 0 and wound.temperature_c < 45")
        end },

    scenario "long ultrasound with flow" {
        set = coarse,
        function(t)
            come_in(t)
            t.phaco:pedal(3)
            t:wait(8)
            t:expect("wound.temperature_c < 40 and phaco.ultrasound_s > 7")
            t:expect_no_event("Wound burn")
        end },
}
