-- SPDX-License-Identifier: GPL-3.0-or-later
-- What is about to go wrong, told by measures and how fast they change: see engine/warnings.lua. A rule is watched
-- wherever the scene has the measures that it names; each of its signs is enough. docs/station.md, "Warnings", has how
-- often they were right.
--
--   of       what is warned of
--   when     of a sign: what must hold
--   rises    a quantity that is at the limit `to`, or is heading upwards to it (or `falls`, downwards) and, as it
--            changes now, is there within within_s; none: `when` alone is the sign
--   over_s   its rate is that over so long

return {
    {
        id = "tear_runs_out",
        title = "The tear is about to run out",
        advice = "Stop pulling: fill the chamber, take the flap close to the tear, and pull to the middle.",
        of = "rhexis.run_out",
        signs = {
            { when = "rhexis.opened and not rhexis.closed and rhexis.tip_heading_deg > 15 "
                .. "and rhexis.tip_radius_mm > 2.5", rises = "rhexis.tip_radius_mm", to = "3.2 + viscoelastic.fill",
                over_s = 0.4, within_s = 2 },
        },
    },
    {
        id = "capsule_near",
        title = "The posterior capsule is near",
        advice = "Draw the tip up, pedal to 1, and look where the capsule is.",
        of = "capsule.open",
        signs = {
            { when = "phaco.pedal >= 2", rises = "capsule.strain_share", to = 1, over_s = 0.1, within_s = 1.5 },
            { when = "phaco.pedal > 2.05 and phaco.tip_posterior_mm < 1.6", falls = "phaco.tip_posterior_mm", to = 0.3,
                over_s = 0.1, within_s = 1.5 },
        },
    },
    {
        id = "surge_coming",
        title = "A surge is coming",
        advice = "Pedal to 1 before the piece clears, or raise the bottle.",
        of = "chamber.depth_lost_share > 0.3",
        signs = {
            { when = "phaco.present and phaco.occlusion > 0.9 and phaco.pedal >= 2",
                rises = "panel.stored_mm3 / max(1, chamber.pressure_mmhg)", to = 4.2, over_s = 0.3, within_s = 0.5 },
        },
    },
}
