-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of the eye under the shafts in its wounds, and of the iris that comes into one of them.

local with = require "with_fields"

local globe_events = {}

--- The shaft leads the eye instead of turning about its wound.
function globe_events.eye_rolled(own)
    return with({
        when = "globe.rotation_deg > 7",
        hold_s = 0.3,
        recovered = "globe.rotation_deg < 3",
        deadline_s = 4,
        near_miss_s = 0,
        harm = "globe.enlargement_mm > 0.3",
        severity = "minor",
        cue = "The eye turns away under the microscope, the cornea folds at the wound.",
        advice = "You carry the eye with the instrument: bring the shaft back to the middle of the wound, and turn it "
            .. "about the wound from there.",
        evidence = { "globe.rotation_deg", "globe.excursion_mm", "globe.corneal_deflection_mm",
            "globe.enlargement_mm" },
    }, own)
end

--- Iris in the main wound. Put right: back by itself, once nothing presses it out and the lip is stroked; a push
--- through the wound is none.
function globe_events.iris_prolapse(own)
    return with({
        when = "iris.prolapse_mm > 0.3",
        recovered = "iris.prolapse_mm < 0.2 and iris.prolapse_damage < 0.1 and chamber.pressure_mmhg < 20",
        recovered_hold_s = 1,
        deadline_s = 30,
        near_miss_s = 0,
        harm = "iris.prolapse_damage > 0.05",
        severity = "critical",
        cue = "Iris lies in the wound, and the pupil peaks towards it.",
        advice = "Do not push it back. Lower the pressure: press on the lip of the side port until fluid comes. Then "
            .. "stroke over the outer lip of the wound: the iris slips back when nothing presses it out.",
        evidence = { "iris.prolapse_mm", "iris.prolapse_damage", "iris.pushed_back_mm", "chamber.pressure_mmhg" },
    }, own)
end

return globe_events
