-- SPDX-License-Identifier: GPL-3.0-or-later
-- A nucleus with a deep groove is cracked: two instruments go to the floor of the groove, side by side, and part its
-- walls until nothing bridges it any more. It begins in the state `begin` of starts.lua.

-- How far from the posterior capsule a tip may be to count as in the lower third, or the lower half, of the groove.
local lower_third = "groove.floor_posterior_mm + 0.33 * groove_1.depth_mm"
local lower_half = "groove.floor_posterior_mm + 0.5 * groove_1.depth_mm"
local higher_tip = "max(phaco.tip_posterior_mm, spatula.tip_posterior_mm)"

local both_press = "phaco.force_mN > 2 and spatula.force_mN > 2"
local both_free = "not phaco.in_contact and not spatula.in_contact"
local both_out = "phaco.tip_depth_mm < 0 and spatula.tip_depth_mm < 0 and " .. both_free
local bridged = "100 * crack.bridge_share > goal.bridge_percent"

return exercise {
    title = "Cracking the nucleus",
    version = 1,
    summary = "A groove runs through the firm nucleus, four fifths of its thickness deep. Bring both instruments to "
        .. "its floor, part its walls, and go on near each of its ends until the nucleus is in two halves.",
    objectives = {
        "Place both tips in the lower third of the groove before parting",
        "Part the walls by equal and opposite movements, so that the nucleus splits and is not pushed",
        "Look whether the split is complete, and go back where it is not",
    },

    -- Cracks need a firm nucleus. 1500 tetrahedra: what the limit of half a second of CPU per second leaves.
    patient = { age = 68, cataract = "NO4", pupil_mm = 7.5, tetrahedra = 1500 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber" },
    instruments = { "phaco", "spatula" },
    settings = {
        ["machine.bottle_cm"] = 75,
        ["machine.flow_ml_min"] = 25,
        ["machine.vacuum_mmhg"] = 80,
    },

    goals = {
        bridge_percent = { 10, from = 0, to = 50, meaning = "how much of the nucleus may bridge the groove, of the "
            .. "area that it has there" },
    },
    reference = { time_s = 65, path_mm = 220 },

    steps = {
        step "approach" {
            title = "Enter the eye with both instruments",
            hint = "Irrigation on (pedal 1). Phaco tip through the main incision, spatula through the side port, both "
                .. "over the groove.",
            done = "phaco.tip_depth_mm > -1.5 and spatula.tip_depth_mm > -1.5",
            time_limit_s = 60,
        },
        step "engage" {
            title = "Both tips into the lower third of the groove",
            hint = "Side by side, down to the floor of the groove, near one of its ends. The higher the tips, the less "
                .. "they open the floor.",
            done = ("%s < %s"):format(higher_tip, lower_third),
            time_limit_s = 60,
        },
        step "part" {
            title = "Part the walls until the nucleus splits",
            hint = "Move the tips apart, evenly and slowly, and watch the floor: the split runs ahead of the tips. "
                .. "Close, lift, and part again near the other end.",
            done = "100 * crack.bridge_share <= goal.bridge_percent",
            time_limit_s = 150,
        },
        step "check" {
            title = "Look whether the split is complete",
            hint = "Both tips over the lens, pedal 1, two seconds: does the red reflex shine through from end to end?",
            done = both_out .. " and phaco.pedal < 1.5 and step.time_s > 1.5 and not (" .. bridged .. ")",
            time_limit_s = 60,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Pedal 1, tips over the lens, and out through the wounds.",
            done = "not phaco.present and not spatula.present",
        },
    },

    errors = {
        error_event "Incomplete split" {
            when = { ("%s and %s < %s"):format(both_press, higher_tip, lower_half),
                both_out .. " and " .. bridged },
            hold_s = 3,
            recovered = "100 * crack.bridge_share <= goal.bridge_percent",
            deadline_s = 60,
            near_miss_s = 0,
            quiet_s = 5,
            severity = "critical",
            cue = "The halves hang together: the bright line in the floor of the groove stops before its ends.",
            advice = "The split is not complete: go back with both tips into the lower third, next to where the halves "
                .. "still hang together, and part again.",
            items = { "T11" },
            evidence = { "crack.bridge_share", "crack.faces", "groove_1.depth_share" },
        },
        error_event "Tips too shallow" {
            when = ("%s and %s > %s"):format(both_press, higher_tip, lower_half),
            hold_s = 0.3,
            recovered = ("(%s and not (%s)) or %s < %s"):format("phaco.force_mN < 1", "spatula.force_mN > 1",
                higher_tip, lower_third),
            deadline_s = 2,
            near_miss_s = 0,
            quiet_s = 2,
            severity = "minor",
            cue = "The walls lean outwards above, the floor stays shut.",
            advice = "The tips are too high: close them, go down to the lower third of the groove, then part.",
            items = { "T11" },
            evidence = { "phaco.tip_posterior_mm", "spatula.tip_posterior_mm", "groove.floor_posterior_mm" },
        },
        error_event "Pushing the nucleus" {
            when = "lens.displacement_mm > 0.5 and (phaco.in_contact or spatula.in_contact)",
            recovered = "lens.displacement_mm < 0.25 and " .. both_free,
            recovered_hold_s = 0.5,
            deadline_s = 3,
            near_miss_s = 0,
            severity = "critical",
            cue = "The whole lens moves away from the instruments.",
            advice = "You push the nucleus instead of parting it: let go, let it come back, and part with both tips at "
                .. "the same place, by the same amount.",
            items = { "T10", "T11" },
            evidence = { "phaco.force_mN", "spatula.force_mN", "zonules.strain" },
        },
        error_event "Zonules overstrained" {
            when = "zonules.strain > 0.35",
            recovered = "zonules.strain < 0.22 and " .. both_free,
            recovered_hold_s = 0.5,
            deadline_s = 3,
            near_miss_s = 0,
            severity = "critical",
            cue = "The edge of the bag shows, the reflex becomes uneven.",
            advice = "The zonules carry the load: close the tips and take them off the lens. Part in the middle of the "
                .. "groove's width, not to one side and not down.",
            items = { "T10", "G4" },
            evidence = { "zonules.load_mN", "phaco.force_mN", "spatula.force_mN" },
        },
        error_event "Capsule struck" {
            when = "phaco.tip_posterior_mm < 0.3 or spatula.tip_posterior_mm < 0.3",
            recovered = "not (phaco.tip_posterior_mm < 1 or spatula.tip_posterior_mm < 1)",
            recovered_hold_s = 0.5,
            deadline_s = 2,
            near_miss_s = 0,
            harm = "capsule.strain_share > 0.9",
            severity = "critical",
            cue = "The floor gives way under a tip, folds run from it.",
            advice = "A tip is on the posterior capsule: lift it straight up, at once. Judge the floor by its reflex "
                .. "before you go down.",
            items = { "T11", "G4" },
            evidence = { "phaco.tip_posterior_mm", "spatula.tip_posterior_mm", "capsule.dimple_mm" },
        },
        error_event "Capsule torn" {
            when = "capsule.open",
            recovered = { "phaco.pedal >= 0.5 and phaco.pedal < 1.5 and not spatula.present", "not phaco.present" },
            deadline_s = 20,
            near_miss_s = 0,
            harm = "capsule.hole_mm2 > 7",
            severity = "critical",
            cue = "The chamber deepens suddenly, the pupil widens for a moment, a round clear edge shows.",
            advice = "The posterior capsule is torn: irrigation only, second instrument out, chamber full, then leave. "
                .. "Do not part any more.",
            items = { "T11", "G4" },
            evidence = { "capsule.hole_mm2", "capsule.peak_strain", "chamber.diaphragm_mm" },
        },
        error_event "Iris touched" {
            when = "iris.touch and phaco.tip_depth_mm > -1.5",
            recovered = "iris.gap_mm > 0.1 and phaco.pedal < 1.5",
            recovered_hold_s = 0.5,
            deadline_s = 2,
            near_miss_s = 0,
            severity = "minor",
            cue = "The pupil's edge moves with the instrument.",
            advice = "Iris touched: stop, lift the tip to the middle of the pupil, and look at the shaft.",
            items = { "G5", "G4" },
            evidence = { "iris.gap_mm", "phaco.pedal" },
        },
    },

    -- The attempt is over when both instruments have left the eye after work, whatever was reached.
    over = { ("%s < %s"):format(higher_tip, lower_half), "not phaco.present and not spatula.present" },
    time_limit_s = 240,

    scoring = osacss { "T10", "T11", "G3", "G4", "G5", "G6" },
}
