-- SPDX-License-Identifier: GPL-3.0-or-later
-- Ultrasound without flow burns the wound.

local coarse = { patient = { tetrahedra = 1000 } }

local function come_in(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, 0, 3 }, { speed = 20 })
    t:wait(1)
end

-- Ultrasound over the lens while the infusion is shut.
local function burn(t)
    come_in(t)
    t:set { ["machine.infusion"] = 0 }
    t.phaco:pedal(3)
    t:expect_event("Wound burn", { within = 8 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "wound burnt for want of flow; ultrasound off, infusion opened" {
        set = coarse,
        function(t)
            burn(t)
            t.phaco:pedal(1)
            t:set { ["machine.infusion"] = 1 }
            t:expect_event("Wound burn", { recovered = true, within = 2 })
            t:expect("wound.temperature_c < 45")
        end },

    scenario "wound burnt, and ultrasound goes on" {
        set = coarse,
        function(t)
            burn(t)
            t:expect_event("Wound burn", { recovered = false, within = 5 })
            t:expect("wound.temperature_c > 60")
        end },

    scenario "ultrasound without flow, let go before it burns" {
        set = coarse,
        silent_twin_of = "Wound burn",
        near = "wound.temperature_c > 52",
        function(t)
            come_in(t)
            t:set { ["machine.infusion"] = 0 }
            t.phaco:pedal(3)
            t:wait_until("wound.temperature_c > 52", 4)
            t.phaco:pedal(1)
            t:set { ["machine.infusion"] = 1 }
            t:wait(1)
            t:expect("wound.burn_share == 0 and wound.temperature_c < 45")
        end },

    scenario "long ultrasound with flow" {
        set = coarse,
        function(t)
            come_in(t)
            t.phaco:pedal(3)
            t:wait(8)
            t:expect("wound.temperature_c < 45 and phaco.ultrasound_s > 4")
            t:expect_no_event("Wound burn")
        end },
}
