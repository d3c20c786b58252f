-- SPDX-License-Identifier: GPL-3.0-or-later
-- A basic skill: the forceps go in closed, take bead after bead, carry it to the tray in the middle and let it go.

local touch_events = require "touch_events"

return exercise {
    title = "Forceps: take, carry, let go",
    version = 1,
    summary = "Beads lie in a chamber full of viscoelastic. Go in with closed jaws, open them over a bead, close them "
        .. "on it, carry it to the tray in the middle of the pupil and let it go there, without touching iris or "
        .. "cornea. Come out with closed jaws.",
    objectives = { "Open and close the jaws where it is safe", "Take hold at the first try", "Carry without a jerk" },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "iris", "cornea", "beads" },
    instruments = { "forceps" },

    goals = {
        beads = { 3, from = 1, to = 6, meaning = "how many beads must lie in the tray" },
        wound_mm = { 1.2, from = 0.5, to = 3, meaning = "how near to the wound the jaws must be closed" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 30, path_mm = 55, entries = 1 },

    steps = {
        step "take" {
            title = "Take a bead",
            hint = "Closed through the wound. Open over a bead, go down until it lies between the jaws, close.",
            done = "beads.held",
            time_limit_s = 60,
        },
        step "carry" {
            title = "All beads to the tray",
            hint = "Lift, carry, open over the tray; then the next one.",
            done = "beads.placed >= goal.beads and not beads.held",
            time_limit_s = 180,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Jaws closed, out the way you came.",
            done = "not forceps.present",
            time_limit_s = 30,
        },
    },

    errors = {
        error_event "Bead dropped" {
            when = "beads.dropped",
            recovered = "beads.held",
            deadline_s = 6,
            near_miss_s = 0,
            severity = "minor",
            cue = "The bead sinks beside the tray.",
            advice = "Open the jaws, go back to the bead, take it again in its middle, and move without a jerk.",
            items = { "G4" },
            evidence = { "beads.drops", "beads.grasps" },
        },
        error_event "Jaws open in the wound" {
            when = "beads.jaw > 0.25 and beads.wound_mm < goal.wound_mm",
            hold_s = 0.05,
            recovered = "beads.jaw < 0.25 or beads.wound_mm > goal.wound_mm",
            deadline_s = 1,
            near_miss_s = 0,
            severity = "minor",
            cue = "The lips of the wound are pressed apart, viscoelastic comes out.",
            advice = "Close the jaws before you are in the wound, on the way in and on the way out.",
            items = { "G3", "G4" },
        },
        error_event "Iris touched" (touch_events.iris { items = { "G5", "G4" } }),
        error_event "Cornea touched" (touch_events.cornea("forceps", { items = { "G3", "G4" } })),
    },

    time_limit_s = 240,
    scoring = osacss { "G3", "G4", "G5", "G6" },
}
