-- SPDX-License-Identifier: GPL-3.0-or-later
-- Weak zonules carry what the tip presses on the lens.

local over_lens = { 0, 0, 3.8 }
local weak = { patient = { tetrahedra = 1000 }, ["zonules.strength"] = 0.2 }  -- the load counts, not the mesh

local function come_in(t)
    t.phaco:enter()
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -0.8, 3 }, { speed = 8 })
    t:wait(0.6)  -- the chamber deepens
end

-- Straight down into the lens with ultrasound, faster than it clears a way for the sleeve.
local function bear_down(t, strain)
    come_in(t)
    t.phaco:pedal(3)
    t.phaco:move_to({ 0, -0.8, -1.2 }, { speed = 1.2, motion = "even", stop = "zonules.strain > " .. strain })
    t.phaco:pedal(1)
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "zonules overstrained, put right by taking the tip off the lens" {
        set = weak,
        function(t)
            bear_down(t, 0.31)
            t:expect_event("Zonules overstrained")
            t.phaco:move_to(over_lens, { speed = 6 })
            t:expect_event("Zonules overstrained", { recovered = true, within = 1 })
        end },

    scenario "zonules overstrained, and the tip stays in the lens" {
        set = weak,
        function(t)
            bear_down(t, 0.31)
            t:expect_event("Zonules overstrained", { recovered = false, within = 4 })
        end },

    scenario "the tip bears down less" {
        set = weak,
        silent_twin_of = "Zonules overstrained",
        near = "zonules.strain > 0.27 and phaco.in_contact",
        function(t)
            bear_down(t, 0.27)
            t:wait(2)
            t:expect("zonules.peak_strain > 0.27 and phaco.in_contact")
            t.phaco:move_to(over_lens, { speed = 6 })
        end },

    scenario "the chamber empties and stretches them" {
        set = { patient = { tetrahedra = 1000 } },
        silent_twin_of = { "Zonules overstrained", "Pushing the nucleus" },
        near = "zonules.strain > 0.30",
        function(t)
            come_in(t)
            t:set { ["machine.infusion"] = 0 }
            t.phaco:pedal(2)
            t:wait_until("zonules.strain > 0.31", 3)
            t.phaco:pedal(1)
            t:set { ["machine.infusion"] = 1 }
            t:wait(1)
            t:expect("zonules.strain < 0.2")
        end },
}
