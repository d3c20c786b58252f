-- SPDX-License-Identifier: GPL-3.0-or-later
-- A cross in the nucleus: a groove, a quarter turn, a second groove across the first. It prepares cracking into
-- quarters.

local phaco_events = require "phaco_events"

-- Where a tip must be, for long enough to look, after something went wrong: pedal let go, tip out of the lens and
-- higher over it than any tip comes between strokes, still in the eye.
local tip_clear = "phaco.pedal < 1.5 and phaco.tip_depth_mm < -1.7 and phaco.tip_y_mm > -2.5"
local spatula_clear = "spatula.tip_depth_mm < -1.7 and spatula.tip_x_mm > -2.5"
local either_clear = ("not phaco.in_contact and not spatula.in_contact and ((%s) or (%s))"):format(tip_clear,
    spatula_clear)
local look_s = 0.5

-- An instrument touches the lens in a chamber that is there: what an empty chamber does to lens and zonules is an error
-- of its own.
local handled = "(phaco.in_contact or spatula.in_contact) and chamber.depth_share > 0.5"

return exercise {
    title = "Sculpting a cross",
    version = 1,
    summary = "The capsule is open and the nucleus turns freely. Sculpt a groove, turn the nucleus by a quarter with "
        .. "the second instrument, and sculpt another groove across the first: each at least 4 mm long and so deep "
        .. "that the red reflex glows in it, without touching posterior capsule or iris and without pushing the lens.",
    objectives = {
        "Judge depth by the red reflex",
        "Turn the nucleus by its groove, with little load on the zonules",
        "Work with two instruments through two wounds",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    accuracy = { force = 0.2, time = 0.02 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber" },
    instruments = { "phaco", "spatula" },
    settings = {
        ["machine.bottle_cm"] = 75,
        ["machine.flow_ml_min"] = 22,
        ["machine.vacuum_mmhg"] = 80,
    },

    goals = {
        length_mm = { 4.0, from = 1, to = 7, meaning = "how long each groove must be" },
        depth_percent = { 60, from = 10, to = 90, meaning = "how deep, of the lens's thickness" },
        angle_deg = { 90, from = 30, to = 90, meaning = "between the two grooves" },
        tolerance_deg = { 10, from = 1, to = 30, meaning = "how far from that angle they may be" },
    },
    -- cde [% s]: the median of whole operations without a rupture [Bustamante2016]
    reference = { time_s = 135, path_mm = 830, movements = 84, entries = 2, jerk_mm_s3 = 480, cde = 1400 },

    steps = {
        step "approach" {
            title = "Enter the eye and come to the lens",
            hint = "Go in through the main incision with irrigation on (pedal 1), and bring the tip to the front of "
                .. "the lens, on your own side of its centre.",
            done = "phaco.tip_depth_mm > -0.5",
            time_limit_s = 60,
        },
        step "first groove" {
            title = "Sculpt the first groove",
            hint = "Stroke away from yourself with ultrasound (pedal 3), come back without it. Take a thin layer each "
                .. "time. Stop when the groove glows red.",
            done = "groove_1.length_mm >= goal.length_mm and 100 * groove_1.depth_share >= goal.depth_percent "
                .. "and phaco.tip_depth_mm < 0",
            time_limit_s = 150,
        },
        step "rotate" {
            title = "Turn the nucleus by a quarter",
            hint = "Back to pedal 1. Bring the spatula in through the side port, put its end into the groove near the "
                .. "far end, and push the wall sideways along an arc: the lens must turn, not shift.",
            done = "abs(abs(lens.rotation_deg) - goal.angle_deg) < goal.tolerance_deg",
            time_limit_s = 90,
        },
        step "second groove" {
            title = "Sculpt the second groove",
            hint = "The same again. In the middle, where the first groove is, nothing is left to sculpt: keep the tip "
                .. "from dropping in.",
            done = "grooves.count >= 2 and groove_2.length_mm >= goal.length_mm "
                .. "and 100 * min(groove_1.depth_share, groove_2.depth_share) >= goal.depth_percent "
                .. "and abs(grooves.angle_deg - goal.angle_deg) <= goal.tolerance_deg and phaco.tip_depth_mm < 0",
            time_limit_s = 150,
        },
        step "depth check" {
            title = "Look at the depth",
            hint = "Pedal 1, tip over the lens, and look for two seconds: both grooves glow evenly from end to end, or "
                .. "you go back to the one that does not.",
            done = "phaco.tip_depth_mm < 0 and phaco.pedal < 1.5 and step.time_s >= 1.5 "
                .. "and 100 * min(groove_1.depth_share, groove_2.depth_share) >= goal.depth_percent",
            time_limit_s = 60,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Pedal 1, tips over the lens, and out through the wounds.",
            done = "not phaco.present and not spatula.present",
        },
    },

    errors = {
        error_event "Groove too deep" {
            when = "phaco.tip_posterior_mm < 0.3 and (phaco.aspirating or phaco.ultrasound)",
            recovered = tip_clear,
            recovered_hold_s = look_s,
            deadline_s = 2,
            harm = "phaco.tip_posterior_mm < 0.1",
            near_miss_s = 0,
            severity = "critical",
            cue = "The reflex in the groove is bright, and the plate at its floor feels soft.",
            advice = "Too deep: let go to pedal 1 and lift the tip straight out of the groove, well over the lens. "
                .. "Look before you go on, and go on elsewhere.",
            items = { "T9", "G4" },
            evidence = { "grooves.count", "groove_1.depth_share", "phaco.power", "reflex.tip" },
        },
        error_event "Groove too shallow" {
            when = "spatula.in_contact and grooves.count == 1 and 100 * groove_1.depth_share < goal.depth_percent",
            recovered = "100 * min(groove_1.depth_share, groove_2.depth_share) >= goal.depth_percent",
            deadline_s = 150,
            near_miss_s = 0,
            severity = "critical",
            cue = "The groove is dull where it ought to glow: the reflex hardly shines through its floor.",
            advice = "You come to turn the nucleus before the groove is deep enough: take the spatula away and deepen "
                .. "it, in thin layers, until the reflex glows.",
            items = { "T9" },
            evidence = { "groove_1.depth_mm", "reflex.tip" },
        },
        error_event "Groove askew" {
            -- A shorter or shallower one has no clear direction yet, nor has one that is wider at one end until both
            -- strokes of a layer are made.
            when = "groove_2.length_mm >= 3 and 200 * groove_2.depth_share >= goal.depth_percent "
                .. "and abs(grooves.angle_deg - goal.angle_deg) > goal.tolerance_deg",
            hold_s = 8,
            -- leaving the eye is no answer to it: the tip comes back to work
            recovered = { tip_clear,
                "abs(grooves.angle_deg - goal.angle_deg) <= goal.tolerance_deg and phaco.tip_depth_mm > 0" },
            deadline_s = 60,
            near_miss_s = 0,
            severity = "critical",
            cue = "The second groove does not cross the first at a right angle: one quarter becomes wide, the next "
                .. "narrow.",
            advice = "The grooves are not across each other: lift the tip, turn the nucleus until the first groove "
                .. "lies across, and sculpt there.",
            items = { "T9", "T10" },
            evidence = { "lens.rotation_deg", "groove_1.direction_deg", "groove_2.direction_deg" },
        },
        error_event "Pushing the nucleus" {
            when = "lens.displacement_mm > 0.5 and " .. handled,
            recovered = "lens.displacement_mm < 0.25 and " .. either_clear,
            recovered_hold_s = look_s,
            deadline_s = 3,
            near_miss_s = 0,
            severity = "critical",
            cue = "The whole lens moves away from the instrument.",
            advice = "You push more than you cut or turn: stop, lift the tip out of the lens and let it come back; "
                .. "then more slowly, or with more power.",
            items = { "T9", "T10" },
            evidence = { "phaco.force_mN", "spatula.force_mN", "phaco.speed_mm_s", "phaco.power", "zonules.strain" },
        },
        error_event "Zonules overstrained" {
            -- The fluid alone stretches them by 16 % with irrigation from 75 cm.
            when = "zonules.strain > 0.30 and " .. handled,
            recovered = "zonules.strain < 0.22 and " .. either_clear,
            recovered_hold_s = look_s,
            deadline_s = 3,
            near_miss_s = 0,
            severity = "critical",
            cue = "The edge of the pupil shows the rim of the bag, the reflex becomes uneven.",
            advice = "The zonules carry the load: take the instruments off the lens. Push along the groove's wall at "
                .. "a right angle to it, and not down.",
            items = { "T10", "G4" },
            evidence = { "zonules.load_mN", "zonules.torque_mNmm", "lens.tool_torque_mNmm", "bag.turn_deg",
                "bag.slip_deg" },
        },
        error_event "Spatula on the capsule" {
            when = "spatula.capsule_gap_mm < -0.2 or spatula.tip_posterior_mm < 0.3",
            recovered = spatula_clear,
            recovered_hold_s = look_s,
            deadline_s = 3,
            near_miss_s = 0,
            quiet_s = 3,
            harm = "spatula.tip_posterior_mm < 0.1",
            severity = "critical",
            cue = "The edge of the capsulorhexis dents, or folds run from the instrument.",
            advice = "The spatula presses on the capsule: stop, and lift it straight up. Work inside the opening "
                .. "of the capsule.",
            items = { "T10", "G4" },
            evidence = { "spatula.capsule_gap_mm", "spatula.tip_posterior_mm" },
        },
        error_event "Iris touched" {
            when = "iris.touch and phaco.tip_depth_mm > -1.0",
            recovered = "iris.gap_mm > 0.1 and " .. tip_clear,
            recovered_hold_s = look_s,
            deadline_s = 2,
            near_miss_s = 0,
            severity = "minor",
            cue = "The pupil's edge moves with the instrument.",
            advice = "Iris touched: stop, lift the tip over the lens to the middle of the pupil, and look at the "
                .. "shaft.",
            items = { "G5", "G4" },
            evidence = { "iris.gap_mm", "phaco.pedal" },
        },
        error_event "Chamber collapse" (phaco_events.chamber_collapse { items = { "T8", "G3", "G4" } }),
        -- A stroke that ends is no answer to it: the tip must come out, for long enough to see that it flows.
        error_event "Infusion off" (phaco_events.infusion_off {
            recovered = ("%s and %s"):format(phaco_events.flows_again, tip_clear),
            recovered_hold_s = look_s,
            items = { "T7", "T8" },
        }),
        error_event "Wound burn" (phaco_events.wound_burn {
            recovered = "wound.temperature_c < 45 and " .. tip_clear,
            recovered_hold_s = look_s,
            items = { "T8", "T14", "G1" },
        }),
        error_event "Capsule torn" (phaco_events.capsule_torn("not spatula.present", { items = { "T9", "G4" } })),
    },

    -- The attempt is over when both instruments have left the eye after work, whatever was reached.
    over = { "phaco.tip_depth_mm > -0.5", "not phaco.present and not spatula.present" },
    time_limit_s = 300,

    scoring = osacss { "T7", "T8", "T9", "T10", "G3", "G4", "G5", "G6" },
}
