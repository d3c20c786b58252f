-- SPDX-License-Identifier: GPL-3.0-or-later
-- What the exercises that open the anterior capsule share: the eye, what takes part, the plan, and steps. An exercise
-- may put another value in place of any field of a step. The errors are in rhexis_events.lua.

local with = require "with_fields"

local rhexis_exercise = {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "anterior_capsule", "viscoelastic", "iris", "cornea" },
    instruments = { "cystotome", "forceps", "cannula", "microscope" },

    accuracy = { time = 0.02 },  -- who tears looks at the flap, not at a hundredth of a second

    goals = {
        radius_mm = { 2.62, from = 2, to = 3.2, meaning = "of the circle that is planned" },
        fill_percent = { 90, from = 50, to = 100,
            meaning = "how full the chamber must be before the capsule is opened or pulled at" },
    },
}

function rhexis_exercise.fill(own)
    return with({
        title = "Fill the chamber",
        done = "100 * viscoelastic.fill >= goal.fill_percent",
        time_limit_s = 60,
    }, own)
end

--- The flap led round.
function rhexis_exercise.close(own)
    return with({
        done = "rhexis.closed",
        time_limit_s = 180,
    }, own)
end

function rhexis_exercise.withdraw(own)
    return with({
        title = "Leave the eye",
        hint = "Take the flap out with the forceps.",
        done = "not forceps.present and not cystotome.present and not cannula.present",
    }, own)
end

return rhexis_exercise
