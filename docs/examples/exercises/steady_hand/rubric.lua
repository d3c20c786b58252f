-- SPDX-License-Identifier: GPL-3.0-or-later
-- Three items for a steady hand; thresholds are proposals.
local scoring = require "scoring"
return scoring.rubric {
    name = "Steady hand",
    source = "own thresholds, to be tuned",
    caps = {
        critical = { not_recovered = 1, open = 1, recovered = 3, near_miss = 4 },
        minor = { not_recovered = 3, open = 3, recovered = 4, near_miss = 5 },
    },
    items = {
        { id = "S1", name = "Holding still", measures = {
            { id = "S1.time", name = "Time within the ring", unit = "%", digits = 0,
              of = "abs(probe.tip_x_mm) < 0.4 and abs(probe.tip_y_mm) < 0.4", take = "share",
              during = "probe.present and probe.speed_mm_s < 0.8", five = 95, three = 70, one = 30, source = "own",
              better = "Rest the hand." },
            { id = "S1.tremor", name = "Trembling", unit = "um", digits = 0, of = "probe.tremor_um", take = "mean",
              five = 60, three = 120, one = 250, source = "own", better = "Rest the hand." },
        } },
        { id = "S2", name = "Following", measures = {
            { id = "S2.off", name = "Distance from the line", unit = "mm", digits = 2, of = "abs(probe.tip_y_mm)",
              take = "mean", during = "probe.present and abs(probe.tip_x_mm) > 0.5",
              five = 0.2, three = 0.6, one = 1.5, source = "own", better = "Slower." },
        } },
        { id = "S3", name = "Care for the iris", measures = {
            { id = "S3.touches", name = "Touches of the iris", unit = "1", digits = 0, of = "iris.touch",
              take = "count", quiet_s = 1, five = 0, three = 1, one = 3, source = "own",
              better = "Watch the edge of the pupil." },
        } },
    },
}
