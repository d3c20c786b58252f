-- SPDX-License-Identifier: GPL-3.0-or-later
-- A quarter of the nucleus has gone through a hole in the posterior capsule. It is not chased.

local phaco_events = require "phaco_events"

return exercise {
    title = "A piece has gone into the vitreous",
    version = 1,
    summary = "The posterior capsule is open, and a quarter of the nucleus lies behind it, dim and small. Whatever "
        .. "goes after it pulls on the vitreous. Keep tip and vacuum away from the depth, lay viscoelastic over the "
        .. "hole so that nothing else follows, and come out: the piece is taken out from behind, later.",
    objectives = {
        "Know a piece that has sunk, and let it lie",
        "Keep the other pieces and the vitreous where they are with viscoelastic",
        "Leave a chamber that stays up",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },
    tissues = { "lens", "bag", "capsule", "iris", "cornea", "chamber", "vitreous" },
    instruments = { "phaco", "cannula", "cutter", "triamcinolone" },
    settings = {
        ["nucleus.segments"] = 4,
        ["nucleus.trench_mm"] = 1.5,
        ["capsule.hole_mm"] = 4,
        ["machine.bottle_cm"] = 50,
        ["machine.flow_ml_min"] = 25,
        ["machine.vacuum_mmhg"] = 300,
    },

    goals = {
        fill_percent = { 40, from = 20, to = 90, meaning = "how full of viscoelastic the chamber must be" },
    },
    reference = { time_s = 30, path_mm = 121, movements = 8, entries = 2, jerk_mm_s3 = 490 },

    requests = {
        request "Retina surgeon called" {
            meaning = "the patient is referred: the piece is taken out from behind",
            answer = "They take the patient today.",
        },
    },

    steps = {
        step "hold" {
            title = "Keep the chamber up",
            hint = "Tip in with irrigation on (pedal 1), in the plane of the iris. No aspiration, not towards the "
                .. "piece.",
            done = "phaco.present and phaco.irrigating and phaco.tip_posterior_mm > 1 and chamber.depth_share > 0.95",
            time_limit_s = 60,
        },
        step "cover" {
            title = "Viscoelastic over the hole",
            hint = "Cannula through the side port, before the hole, until it is covered and the chamber is full.",
            done = "tamponade.cover > 0.95 and 100 * tamponade.fill > goal.fill_percent",
            time_limit_s = 90,
        },
        step "withdraw" {
            title = "Come out",
            hint = "The tip leaves a chamber that stays up.",
            done = "not phaco.present and not cannula.present",
            time_limit_s = 60,
        },
        step "refer" {
            title = "Refer the patient",
            hint = "Say that the retina surgeon is to be called; the rest is done from behind.",
            done = "requested.retina_surgeon_called",
            time_limit_s = 30,
        },
    },

    errors = {
        error_event "Dropped piece" (phaco_events.dropped_piece {
            when = "fragments.sunk_mm > 2 and phaco.present",
            recovered = {
                "phaco.pedal < 1.5 and phaco.tip_posterior_mm > 1 and tamponade.cover > 0.95",
                "not phaco.present",
            },
            deadline_s = 40,
            harm = "phaco.aspirating and phaco.tip_posterior_mm < 0.5",
            items = { "T11", "G4" },
        }),
        error_event "Piece chased" {
            when = "phaco.aspirating and phaco.tip_posterior_mm < 0.5 and fragments.sunk_mm > 1",
            hold_s = 0.1,
            recovered = "phaco.pedal < 1.5 and phaco.tip_posterior_mm > 1",
            deadline_s = 3,
            near_miss_s = 0,
            harm = "vitreous.peak_traction_mN > 1",
            severity = "critical",
            cue = "The tip goes down through the hole after a piece that gets dimmer.",
            advice = "Stop: pedal to 1, tip up to the plane of the iris. Through the vitreous nobody reaches it "
                .. "without pulling on the retina.",
            items = { "T11", "G4" },
            evidence = { "phaco.tip_posterior_mm", "fragments.sunk_mm", "vitreous.traction_mN" },
        },
    },

    time_limit_s = 240,

    scoring = osacss { "T8", "T11", "G3", "G4", "G5", "G6" },
}
