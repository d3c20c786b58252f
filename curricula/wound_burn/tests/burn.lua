-- SPDX-License-Identifier: GPL-3.0-or-later
-- Ultrasound with a blocked tip and a tight wound: let go in time, too late, and not at all.

local clear = { ["machine.flow_ml_min"] = 25 }

local function come_in(t)
    t.phaco:enter({ speed = 10 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 2.6 }, { speed = 12 })
    t:wait(1)
end

local function run_dry(t)
    come_in(t)
    t.phaco:pedal(3)
    t:expect_event("Infusion off", { within = 2 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "no flow, seen and cleared" {
        function(t)
            run_dry(t)
            t.phaco:pedal(1)
            t:set(clear)
            t.phaco:pedal(2)
            t:expect_event("Infusion off", { recovered = true, within = 3 })
            t:expect_no_event("Wound burn")
        end },

    scenario "no flow, and ultrasound goes on" {
        function(t)
            run_dry(t)
            t:expect_event("Infusion off", { recovered = false, within = 5 })
        end },

    scenario "the flow is tried before ultrasound, and the tip cleared" {
        silent_twin_of = "Infusion off",
        near = "chamber.infusion_ml_min < 5 and phaco.aspirating and not phaco.ultrasound",
        function(t)
            come_in(t)
            t.phaco:pedal(2)
            t:wait(0.5)
            t:expect("chamber.infusion_ml_min < 5 and panel.flow_ml_min < 1")
            t.phaco:pedal(1)
            t:set(clear)
            t.phaco:pedal(2)
            t:wait(0.5)
            t.phaco:pedal(3)
            t:wait(2)
            t:expect("chamber.infusion_ml_min > 15 and phaco.ultrasound")
        end },

    scenario "wound burnt; ultrasound off, tip cleared" {
        function(t)
            run_dry(t)
            t:expect_event("Wound burn", { within = 6 })
            t.phaco:pedal(1)
            t:set(clear)
            t.phaco:pedal(2)
            t:expect_event("Wound burn", { recovered = true, within = 3 })
            t:expect("wound.burn_share > 0 and wound.burn_share < 0.5")
        end },

    scenario "wound burnt, and ultrasound goes on" {
        function(t)
            run_dry(t)
            t:expect_event("Wound burn", { within = 6 })
            t:expect_event("Wound burn", { recovered = false, within = 3.5 })
            t:expect("wound.temperature_c > 60 and wound.burn_share > 0.5")
        end },

    scenario "ultrasound without flow, let go before it burns" {
        silent_twin_of = "Wound burn",
        near = "wound.temperature_c > 52",
        function(t)
            run_dry(t)
            t:wait_until("wound.temperature_c > 52.5", 3)
            t.phaco:pedal(1)
            t:wait(2)
            t:expect("wound.burn_share == 0 and wound.temperature_c > 40")
        end },
}
