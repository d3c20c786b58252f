-- SPDX-License-Identifier: GPL-3.0-or-later
-- What is about to go wrong, told by measures and how fast they change: see engine/warnings.lua. A rule is watched
-- wherever the scene has the measures that it names. docs/station.md, "Warnings", has how often they were right.
--
--   when     what must hold besides
--   rises    a quantity that is heading upwards to the limit `to` (or `falls`, downwards) and, as it changes now, is
--            there within within_s; none: `when` alone is the sign
--   over_s   its rate is that over so long
--   of       what is warned of

return {
    {
        id = "tear_runs_out",
        title = "The tear is about to run out",
        advice = "Stop pulling: fill the chamber, take the flap close to the tear, and pull to the middle.",
        when = "rhexis.opened and not rhexis.closed and not rhexis.run_out and rhexis.tip_heading_deg > 10",
        rises = "rhexis.tip_radius_mm",
        to = 4.2,
        over_s = 0.4,
        within_s = 1.5,
        of = "rhexis.run_out",
    },
    {
        id = "capsule_near",
        title = "The posterior capsule is near",
        advice = "Draw the tip up, pedal to 1, and look where the capsule is.",
        when = "phaco.pedal >= 2 and not capsule.open",
        rises = "capsule.strain_share",
        to = 1,
        over_s = 0.1,
        within_s = 1,
        of = "capsule.open",
    },
    {
        id = "surge_coming",
        title = "A surge is coming",
        advice = "Pedal to 1 before the piece clears, or raise the bottle.",
        when = "phaco.present and phaco.occlusion > 0.9 and phaco.pedal >= 2",
        rises = "panel.vacuum_mmhg",
        to = 250,
        over_s = 0.3,
        within_s = 1,
        of = "chamber.depth_lost_share > 0.3",
    },
}
