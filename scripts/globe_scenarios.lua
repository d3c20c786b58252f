-- SPDX-License-Identifier: GPL-3.0-or-later
-- Scenario tests of an eye that rolls under a shaft, for every exercise that has the phaco probe, the globe and the
-- error "Eye rolled" (globe_events.lua): the shaft is carried sideways, with the tip where it is.

local over_lens = { 0, 0, 2.6 }

local function come_in(t)
    t.phaco:enter({ speed = 10 })
    t.phaco:pedal(1)
    t.phaco:move_to(over_lens, { speed = 12 })
end

-- So far to the right of the wound that the shaft goes through [mm], or until a condition holds.
local function carry(t, off, stop)
    t.phaco:move_to(over_lens, { seconds = 1, shaft = { off, -4.9, 0.3 }, stop = stop })
    t:wait(0.6)
end

--- scenario: the word of the language of scenarios; patient: whose eye the hands are to meet. Returns a list for
--- `scenarios`.
return function(scenario, patient)
    return {
        patient = patient,
        scenario "eye rolled, shaft back to the wound" {
            function(t)
                come_in(t)
                carry(t, 5)
                t:expect_event("Eye rolled", { within = 1 })
                t:expect("globe.corneal_deflection_mm > 0.3 and globe.excursion_mm > 2")
                t.phaco:move_to(over_lens, { seconds = 1, shaft = "wound" })
                t:expect_event("Eye rolled", { recovered = true, within = 2 })
                t:expect("globe.enlargement_mm > 0.1")
            end },

        scenario "eye rolled, and held so" {
            function(t)
                come_in(t)
                carry(t, 5)
                t:expect_event("Eye rolled", { within = 1 })
                t:expect_event("Eye rolled", { recovered = false, within = 5 })
            end },

        scenario "the tip goes from side to side about the wound, and the shaft a little beside it" {
            silent_twin_of = "Eye rolled",
            near = "globe.rotation_deg > 5",
            function(t)
                come_in(t)
                t.phaco:move_to({ 2, 0, 2.6 }, { speed = 6 })
                t.phaco:move_to({ -2, 0, 2.6 }, { speed = 6 })
                t:expect("globe.rotation_deg < 1")
                carry(t, -5, "globe.rotation_deg > 5")
            end },
    }
end
