-- SPDX-License-Identifier: GPL-3.0-or-later
-- The way into the eye: a side port, and a main incision that closes by itself.

local wound_events = require "wound_events"

return exercise {
    title = "Incision and side port",
    version = 1,
    summary = "Nothing is cut yet. Cut the side port for the other hand, then the main incision: in two planes, about "
        .. "as long as it is wide, so that the pressure of the eye shuts it. What is wrong now goes wrong for the "
        .. "whole operation.",
    objectives = {
        "Cut a side port 60 to 100 degrees from the main incision",
        "Cut a tunnel of 2 mm in two planes, as wide as the blade",
        "Know a bad tunnel, and close or leave it",
    },

    patient = { age = 68, cataract = "NO3", pupil_mm = 7 },
    tissues = { "iris", "cornea", "chamber", "wounds" },
    instruments = { "keratome", "side_port_blade", "cannula", "hydration_cannula", "needle_holder" },
    settings = { ["wounds.uncut"] = 2 },

    goals = {
        tunnel_mm = { 1.25, from = 0.8, to = 2.5, meaning = "how long the tunnel of the main incision must be" },
    },
    -- proposal: what group d comes near to
    reference = { time_s = 25, path_mm = 40, movements = 10, entries = 2, jerk_mm_s3 = 300 },

    steps = {
        step "side port" {
            title = "Side port",
            hint = "Small blade, to the side of the hand that it is for. Straight through the cornea, level with "
                .. "the iris.",
            picture_when = "side_port_blade.present and wounds.side_cut",
            done = "wounds.side_cut and wounds.side_width_mm > 0.8 and not side_port_blade.present",
            time_limit_s = 60,
        },
        step "main incision" {
            title = "Main incision",
            hint = "Keratome at the limbus: first within the cornea along its slope, then level, until the shoulders "
                .. "of the blade are through. Straight back, without moving sideways.",
            picture_when = "keratome.present and wounds.main_cut",
            done = "wounds.main_cut and wounds.main_width_mm > 2.2 and wounds.main_tunnel_mm > goal.tunnel_mm "
                .. "and not keratome.present",
            time_limit_s = 90,
        },
        step "dry" {
            title = "Is it tight?",
            hint = "Everything out. Is there fluid at the lip? Then hydrate or suture it.",
            done = "instruments.out_s > 1 and wounds.leak_at_20_ul_s < 0.05",
            time_limit_s = 120,
        },
    },

    errors = {
        error_event "Tunnel too short" (wound_events.short { items = { "T2", "T14", "G1" } }),
        error_event "Tunnel too long" (wound_events.long { items = { "T2", "T14", "G1" } }),
        error_event "Posterior entry" (wound_events.posterior { items = { "T2", "G5" } }),
        error_event "Descemet's membrane peeled" (wound_events.descemet { items = { "T2", "T7", "G3" } }),
    },

    time_limit_s = 300,

    scoring = osacss { "T2", "G3", "G5", "G6" },
}
