-- SPDX-License-Identifier: GPL-3.0-or-later
-- A folded implant pushed out of its injector into the capsular bag, turned in and centred.

local implant_events = require "implant_events"
local rhexis_events = require "rhexis_events"

-- A sequence in the report: a picture each time that a measure of the implant, 0 to 1, passes one of these.
local function pictures_as(measure, shares, caption)
    return function(eye, act)
        for _, share in ipairs(shares) do
            if eye.implant[measure] <= share then
                act.wait_until(("implant.%s > %g"):format(measure, share))
                act.picture(("%s_%d"):format(measure, 100 * share), caption:format(100 * share))
            end
        end
    end
end

local in_place = "implant.haptics_in_bag >= 2 and not implant.upside_down"

return exercise {
    title = "Injecting the implant",
    version = 1,
    summary = "The bag is empty and filled with viscoelastic, the implant lies folded in its injector. Bring the tip "
        .. "before the opening, push the leading haptic into the bag, let the optic unfold, turn the trailing haptic "
        .. "in with the hook, and leave the implant in the middle.",
    objectives = {
        "Keep chamber and bag filled while the implant comes out",
        "Lead the first haptic under the far rim before the optic leaves the nozzle",
        "Put back a haptic that came out before the rim, hand over hand",
        "See an implant that lies upside down or with a haptic outside before you leave",
    },

    patient = { age = 68, pupil_mm = 8 },
    tissues = { "implant", "bag", "viscoelastic", "iris", "cornea" },
    instruments = { "injector", "hook", "cannula", "lens_forceps" },
    settings = {
        ["viscoelastic.fill"] = 1,
        ["cartridge.tucked"] = 0,
    },

    accuracy = { time = 0.02 },  -- nothing here is faster than the plunger

    goals = {
        fill_percent = { 90, from = 50, to = 100, meaning = "how full the chamber must be before the implant comes" },
        decentration_mm = { 0.3, from = 0.1, to = 1, meaning = "how far off the bag's axis the optic may be left" },
        tilt_deg = { 3, from = 1, to = 15, meaning = "how much it may be tilted" },
    },
    reference = { time_s = 75, path_mm = 90, entries = 2, jerk_mm_s3 = 400 },

    steps = {
        step "fill" {
            title = "See that chamber and bag are filled",
            hint = "Where the chamber is shallow, fill it with the cannula.",
            done = "100 * viscoelastic.fill >= goal.fill_percent",
            time_limit_s = 60,
        },
        step "place" {
            title = "Bring the tip before the opening",
            hint = "Injector through the main incision, its mouth through the opening, under the rim.",
            done = "injector.present and injector.tip_y_mm > -3 and abs(injector.tip_x_mm) < 1.5",
            time_limit_s = 60,
        },
        step "inject" {
            title = "Push the leading haptic into the bag",
            hint = "Slowly: the leading haptic comes first. Point it down, under the far rim.",
            done = "implant.haptic_leading_in_bag or implant.released",
            script = pictures_as("delivered", { 0.05, 0.3, 0.6, 0.9 }, "%.0f %% of the implant are out of the nozzle."),
            time_limit_s = 60,
        },
        step "release" {
            title = "Release the optic",
            hint = "Push on evenly. When the optic is half out, draw the mouth back to the near edge, still under the "
                .. "rim.",
            done = "implant.released and implant.unfolded > 0.9",
            script = pictures_as("unfolded", { 0.6, 0.7, 0.8 }, "Unfolded to %.0f %%."),
            time_limit_s = 60,
        },
        step "dial" {
            title = "Turn the trailing haptic in",
            hint = "If a haptic lies before the rim: lens forceps. Draw its arm in by its middle, then by its elbow "
                .. "until all of it is within the rim; press it down, and lead it back behind the rim.",
            done = in_place,
            time_limit_s = 120,
        },
        step "centre" {
            title = "Centre the implant",
            hint = "Push the optic to the middle, let go, and look whether it stays there.",
            done = in_place .. " and implant.unfolded > 0.995 and implant.decentration_mm <= goal.decentration_mm "
                .. "and implant.tilt_deg <= goal.tilt_deg",
            time_limit_s = 60,
        },
        step "withdraw" {
            title = "Leave the eye",
            hint = "Off the implant, straight up, and out through the wound.",
            done = "not injector.present and not hook.present and not cannula.present and not lens_forceps.present",
        },
    },

    errors = {
        error_event "Injected without viscoelastic" (implant_events.unfilled { items = { "T13" } }),
        error_event "Implant jammed" (implant_events.jammed { items = { "T13" } }),
        error_event "Upside down" (implant_events.upside_down { items = { "T13" } }),
        error_event "Haptic not in the bag" (implant_events.haptic_out { items = { "T13", "G5" } }),
        error_event "Haptic stuck to the optic" (implant_events.haptic_stuck { items = { "T13" } }),
        error_event "Rim overstretched" (implant_events.rim_stretched { items = { "T13" } }),
        error_event "Rim split" (implant_events.rim_split { items = { "T13", "G4" } }),
        error_event "Posterior capsule struck" (implant_events.capsule_struck { items = { "T13", "G4" } }),
        error_event "Cornea touched" (implant_events.cornea_touched { items = { "T13", "G3", "G4" } }),
        -- A cartridge of 3 mm rests on the iris by the wound on its way under the rim: a touch, but no error.
        error_event "Iris touched" (rhexis_events.iris_touched { items = { "G5", "G4" },
            when = "iris.gap_mm < -1 or (iris.touch and not injector.present)",
            recovered = "iris.gap_mm > 0.1 or (injector.present and iris.gap_mm > -0.8)" }),
    },

    -- The attempt is over when no instrument has come back for longer than it takes to change them.
    over = { "implant.released", "instruments.out_s > 25" },
    time_limit_s = 300,

    scoring = osacss { "T13", "G3", "G4", "G5", "G6" },
}
