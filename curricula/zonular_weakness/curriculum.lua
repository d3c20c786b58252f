-- SPDX-License-Identifier: GPL-3.0-or-later
-- A lens on weak zonules, of which an arc is lost: hold the bag, then sculpt without tearing more.

local zonule_events = require "zonule_events"

return exercise {
    title = "Weak zonules",
    version = 1,
    summary = "Zonules are weak all round, and over two and a half clock hours they are lost: the lens lies aside. Lay "
        .. "viscoelastic over the gap, hold the bag there with hooks or put in a ring, lower bottle and flow, and then "
        .. "sculpt a groove without pushing, so that no more of them tear.",
    objectives = {
        "See by the edge of the bag and by how the lens moves where it lacks its hold",
        "Support the bag before any force is put on the lens",
        "Sculpt with a low bottle and little force",
    },

    patient = { age = 74, cataract = "NO3", pupil_mm = 8 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber", "vitreous", "zonules" },
    instruments = { "phaco", "cannula", "capsule_hook", "ring", "cutter", "triamcinolone" },
    settings = {
        ["zonules.strength"] = 0.4,
        ["zonules.toughness"] = 0.3,
        ["zonules.tension"] = 0.4,
        ["zonules.lost_from_deg"] = 30,
        ["zonules.lost_deg"] = 75,
        ["machine.bottle_cm"] = 45,
        ["machine.flow_ml_min"] = 20,
        ["machine.vacuum_mmhg"] = 60,
    },

    goals = {
        open_deg = { 45, from = 15, to = 120, meaning = "the widest arc that may be without hold" },
        length_mm = { 3.5, from = 1, to = 7, meaning = "how long the groove must be" },
        depth_percent = { 45, from = 10, to = 90, meaning = "how deep, of the lens's thickness" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 75, path_mm = 270, movements = 45, entries = 3, jerk_mm_s3 = 495, cde = 320 },

    steps = {
        step "cover" {
            title = "Viscoelastic over the gap",
            hint = "Look where the lens lies aside. Cannula towards the gap, and press until it is covered.",
            done = "tamponade.gap_cover > 0.9",
            time_limit_s = 60,
        },
        step "support" {
            title = "Hold the bag",
            hint = "Hooks round the edge of the opening over the gap, or a ring into the bag: a ring does for up to "
                .. "four clock hours.",
            done = "zonules.unsupported_deg <= goal.open_deg and not capsule_hook.present and not ring.present",
            time_limit_s = 90,
        },
        step "sculpt" {
            title = "Sculpt a groove",
            hint = "Low bottle, slow strokes, enough ultrasound: the tip cuts, it does not push.",
            done = "groove.length_mm >= goal.length_mm and 100 * groove.depth_share >= goal.depth_percent "
                .. "and phaco.tip_depth_mm < 0",
            time_limit_s = 180,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Pedal 1, tip over the lens, and out.",
            done = "not phaco.present",
        },
    },

    errors = {
        error_event "Zonular dialysis" (zonule_events.dialysis { items = { "T10", "T11", "G4" } }),
        error_event "Bag not supported" (zonule_events.unsupported { items = { "T9", "T10" } }),
        error_event "Vitreous through the gap" (zonule_events.vitreous { items = { "T11", "G4" } }),
    },

    over = { "phaco.tip_depth_mm > -0.5", "not phaco.present", "instruments.out_s > 12" },
    time_limit_s = 360,

    scoring = osacss { "T8", "T9", "T10", "T11", "G3", "G4", "G5", "G6" },
}
