-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of what happens in the bag between its opening and the implant: hydrodissection, cortex, viscoelastic.

local with = require "with_fields"

local bag_events = {}

--- A millilitre given and no wave, or a lens that takes its bag along when it is turned. Put right: saline at another
--- quadrant, until the lens turns freely.
function bag_events.no_wave(own)
    return with({
        when = "hydro.wave_share < 0.3 and (hydro.injected_ml > 1 or bag.turn_deg * bag.turn_deg > 30 "
            .. "and bag.slip_deg * bag.slip_deg < 0.25 * bag.turn_deg * bag.turn_deg)",
        hold_s = 0.2,
        recovered = "hydro.wave_share > 0.6 and bag.slip_deg * bag.slip_deg >= 8100 and zonules.strain < 0.15",
        deadline_s = 20,
        near_miss_s = 0,
        harm = "zonules.peak_strain > 0.3",
        severity = "minor",
        cue = "No dark front crosses the red reflex; the nucleus does not turn, or the whole bag turns with it.",
        advice = "Do not force it to turn. Bring the cannula under the rim at another quadrant, its end close to the "
            .. "capsule, lift it a little and inject steadily until the wave crosses. Then turn by 90 degrees.",
        evidence = { "hydro.wave_share", "hydro.injected_ml", "hydro.freed_share", "zonules.peak_strain" },
    }, own)
end

--- Fluid trapped behind the nucleus. Put right: the nucleus pressed back, so that it comes out past it.
function bag_events.block(own)
    return with({
        when = "hydro.forward_mm > 0.5 and not hydro.burst",
        recovered = "hydro.forward_mm < 0.25 and not hydro.burst",
        recovered_hold_s = 0.2,
        deadline_s = 6,
        near_miss_s = 0,
        harm = "hydro.burst or hydro.strain_share > 0.8",
        severity = "critical",
        cue = "The nucleus bulges forward, the pupil widens, the chamber gets shallow.",
        advice = "Stop injecting. Press gently on the middle of the nucleus until the trapped fluid has come out "
            .. "past it, and let viscoelastic out of the chamber, before you inject again.",
        evidence = { "hydro.trapped_mm3", "hydro.bag_pressure_mmhg", "hydro.strain_share", "hydro.viscoelastic_fill" },
    }, own)
end

--- The posterior capsule has burst. Put right: nothing is turned, viscoelastic under the nucleus holds it up.
function bag_events.hydrorupture(own)
    return with({
        when = "hydro.burst",
        recovered = "hydro.lift_mm3 > 30 and hydro.turned_after_burst_deg < 10 and bag.tilt_deg < 1",
        deadline_s = 15,
        near_miss_s = 0,
        harm = "hydro.burst",
        severity = "critical",
        cue = "The widened pupil suddenly snaps smaller, the chamber deepens, and the nucleus tilts back.",
        advice = "Stop at once, and do not turn the nucleus. Viscoelastic under it until it lies level again; then "
            .. "bring it forward, or go on with low flow and a low bottle.",
        evidence = { "hydro.peak_pressure_mmhg", "capsule.hole_mm2", "hydro.lift_mm3", "bag.tilt_deg" },
    }, own)
end

--- A mouth has drawn in the posterior capsule. Put right: suction off before it tears, without pulling away.
function bag_events.captured(own)
    return with({
        when = "capsule.captured",
        recovered = "not capsule.captured and not capsule.open",
        deadline_s = 2,
        near_miss_s = 0,
        harm = "capsule.open",
        severity = "critical",
        cue = "Folds run like a star to the tip.",
        advice = "Pedal up at once, and do not pull away. Turn the mouth up, so that you see it, before you aspirate "
            .. "again.",
        evidence = { "ia_tip.suction_mmhg", "ia_tip.port_down", "capsule.strain" },
    }, own)
end

--- The tip is out, or the time is over, and cortex is left. Put right: in again, until next to none is.
function bag_events.cortex_left(own)
    return with({
        when = { "cortex.taken_mm3 > 0 and ia_tip.present", "not ia_tip.present and cortex.left_percent > 10" },
        recovered = "cortex.left_percent <= 2",
        deadline_s = 60,
        near_miss_s = 0,
        severity = "minor",
        cue = "White tags hang in the fornix when the tip has left.",
        advice = "Go in again. Hold each tag in the fornix, draw it towards the middle along the capsule, and aspirate "
            .. "it there.",
        evidence = { "cortex.left_percent", "cortex.loose_percent" },
    }, own)
end

--- The tip is out, and viscoelastic is left behind the implant. Put right: aspirated from there.
function bag_events.viscoelastic_left(own)
    return with({
        when = { "ia_tip.present and viscoelastic.left_percent < 90",
            "not ia_tip.present and viscoelastic.behind_percent > 5" },
        recovered = "viscoelastic.behind_percent <= 5 and viscoelastic.left_percent <= 10",
        deadline_s = 60,
        near_miss_s = 0,
        severity = "minor",
        cue = "The implant floats, and moves when it is touched.",
        advice = "Go in again, bring the tip behind the optic, or rock the optic with it, and aspirate until the "
            .. "implant lies still on the capsule. What is left raises the pressure in the days after.",
        evidence = { "viscoelastic.behind_mm3", "viscoelastic.angle_mm3", "viscoelastic.left_percent" },
    }, own)
end

return bag_events
