-- SPDX-License-Identifier: GPL-3.0-or-later
-- A nucleus with a deep groove is cracked: two instruments go to the floor of the groove, side by side, and part its
-- walls until nothing bridges it any more. It begins in the state `begin` of starts.lua.

local crack_events = require "crack_events"

local lower_third, lower_half = crack_events.lower_third, crack_events.lower_half
local higher_tip, both_out = crack_events.higher_tip, crack_events.both_out
local bridge = "crack.bridge_share"
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

    -- Cracks need a firm nucleus.
    patient = { age = 68, cataract = "NO4", pupil_mm = 7.5 },
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
    reference = { time_s = 65, path_mm = 433, movements = 50, entries = 2, jerk_mm_s3 = 490 },

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
        error_event "Incomplete split" (crack_events.incomplete(bridge, { items = { "T11" } })),
        error_event "Tips too shallow" (crack_events.shallow({ items = { "T11" } })),
        error_event "Pushing the nucleus" (crack_events.pushing({ items = { "T10", "T11" } })),
        error_event "Zonules overstrained" (crack_events.zonules({ items = { "T10", "G4" } })),
        error_event "Capsule struck" (crack_events.struck({ items = { "T11", "G4" } })),
        error_event "Capsule torn" (crack_events.torn({ items = { "T11", "G4" } })),
        error_event "Iris touched" (crack_events.iris({ items = { "G5", "G4" } })),
    },

    -- The attempt is over when both instruments have left the eye after work, whatever was reached.
    over = { ("%s < %s"):format(higher_tip, lower_half), "not phaco.present and not spatula.present" },
    time_limit_s = 240,

    scoring = osacss { "T10", "T11", "G3", "G4", "G5", "G6" },
}
