-- SPDX-License-Identifier: GPL-3.0-or-later
-- Before the first cut: lashes under the drape, lids open, microscope, pedal, settings and side. In any order; who says
-- that all is ready is taken at their word.

local ready = "requested.ready_to_begin and "

return exercise {
    title = "Draping and set-up",
    version = 1,
    summary = "Lead the edge of the drape along both margins until no lash sticks out, open the lids with the "
        .. "speculum, centre and focus the microscope, test the pedal with the tip in the air, confirm the settings "
        .. "of the machine and the side of the eye, and say that you are ready. The order is yours.",
    objectives = {
        "Keep every lash out of the field",
        "See that microscope, pedal and machine do what they are to do before the eye is open",
        "Confirm the side and the settings aloud",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5, incision_deg = 90 },
    tissues = { "iris", "cornea", "lids" },
    instruments = { "drape", "speculum", "phaco", "microscope" },
    settings = { ["microscope.field_mm"] = 30 },

    requests = {
        request "Settings confirmed" { meaning = "power, vacuum, flow and bottle are read out" },
        request "Side confirmed" { meaning = "this is the eye that was consented to" },
        request "Ready to begin" { meaning = "the checklist is done" },
    },

    goals = {
        covered_percent = { 98, from = 50, to = 100, meaning = "share of the lashes that the drape must cover" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 35, path_mm = 220, entries = 3 },

    steps = {
        step "make ready" {
            title = "Make ready",
            hint = "Drape over all lashes, lids open, microscope on the pupil, pedal 1, 2 and 3 with the tip in the "
                .. "air, settings and side said aloud. Then say that you are ready.",
            hint_after_s = 60,
            done = ready .. "lids.covered_percent >= goal.covered_percent and lids.opening > 0.8 and lids.pedal_tested "
                .. "and microscope.in_focus and microscope.pupil_offset < 0.3 and requested.settings_confirmed and "
                .. "requested.side_confirmed and not drape.present and not speculum.present and not phaco.present",
            time_limit_s = 170,
        },
    },

    errors = {
        error_event "Lashes uncovered" {
            when = ready .. "lids.covered_percent < goal.covered_percent",
            recovered = "lids.covered_percent >= goal.covered_percent",
            deadline_s = 8,
            near_miss_s = 0,
            severity = "critical",
            cue = "Lashes stick out beside the drape.",
            advice = "Not ready yet: lashes carry germs into the wound. Lead the drape over them once more.",
            items = { "T1" },
        },
        error_event "Pedal not tested" {
            when = ready .. "not lids.pedal_tested",
            recovered = "lids.pedal_tested",
            deadline_s = 8,
            near_miss_s = 0,
            severity = "critical",
            cue = "Nobody has seen the infusion run.",
            advice = "Tip in the air, pedal to 1, 2 and 3: infusion runs, the pump draws, ultrasound sounds.",
            items = { "T1" },
            evidence = { "lids.pedal_1_s", "lids.pedal_2_s", "lids.pedal_3_s" },
        },
    },

    time_limit_s = 180,
    scoring = osacss { "T1", "G2", "G6" },
}
