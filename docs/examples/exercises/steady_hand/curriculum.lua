-- SPDX-License-Identifier: GPL-3.0-or-later
-- A skill without a lens: hold still, then lead the tip along a line. Scored by a rubric of its own.
local own = require "rubric"
return exercise {
    title = "A steady hand",
    objectives = { "Hold the tip still in the middle", "Lead it along a line and back" },
    patient = { pupil_mm = 7 },
    tissues = { "iris", "cornea" },
    instruments = { "probe" },
    goals = { ring_mm = { 0.4, from = 0.1, to = 1 }, reach_mm = { 2, from = 1, to = 3 } },
    steps = {
        step "arrive" {
            hint = "Tip to the middle of the pupil, 2.6 mm up.",
            done = "abs(probe.tip_x_mm) < goal.ring_mm and abs(probe.tip_y_mm) < goal.ring_mm",
            time_limit_s = 20,
        },
        step "hold" {
            hint = "Keep still for three seconds.",
            script = function(_, act)
                act.wait(3)
                act.say("Well held.")
            end,
        },
        step "follow" {
            hint = "Along the line: right, left, back to the middle.",
            done = { "probe.tip_x_mm > goal.reach_mm", "probe.tip_x_mm < -goal.reach_mm",
                "abs(probe.tip_x_mm) < goal.ring_mm" },  -- one after the other
            time_limit_s = 30,
        },
        step "leave" { done = "not probe.present", time_limit_s = 15 },
    },
    errors = {
        error_event "Drifts out of the ring" {
            when = "abs(probe.tip_x_mm) > goal.ring_mm or abs(probe.tip_y_mm) > goal.ring_mm",
            steps = { "hold" },
            hold_s = 0.2,
            recovered = "abs(probe.tip_x_mm) < goal.ring_mm and abs(probe.tip_y_mm) < goal.ring_mm",
            deadline_s = 1,
            severity = "minor",
            advice = "Rest the hand on the forehead, breathe out.",
            items = { "S1" },
        },
        error_event "Iris touched" {
            when = "iris.touch", recovered = "iris.gap_mm > 0.2", deadline_s = 2,
            severity = "minor", advice = "Back to the middle.", items = { "S3" },
        },
    },
    scoring = own { "S1", "S2", "S3" },
    time_limit_s = 90,
}
