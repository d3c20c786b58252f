-- SPDX-License-Identifier: GPL-3.0-or-later
-- Error events of instruments that touch iris or cornea, for the exercises that share them.

local with = require "with_fields"

local touch_events = {}

--- Put right: off the iris within a second.
function touch_events.iris(own)
    return with({
        when = "iris.touch",
        recovered = "iris.gap_mm > 0.1",
        deadline_s = 1,
        near_miss_s = 0,
        severity = "minor",
        cue = "The pupil's edge moves with the instrument.",
        advice = "Iris touched: stop, draw the instrument back to the middle of the pupil, and look at the shaft.",
    }, own)
end

--- The tip of an instrument, by its name, at the back of the cornea inside the wound. Put right: well below it.
function touch_events.cornea(instrument, own)
    return with({
        when = ("%s.endothelium_mm < 0.1 and %s.tip_y_mm > -2.5"):format(instrument, instrument),
        recovered = instrument .. ".endothelium_mm > 0.5",
        deadline_s = 1,
        near_miss_s = 0,
        severity = "minor",
        cue = "Folds in the cornea around the tip.",
        advice = "Lower the tip at once: endothelium does not grow again.",
    }, own)
end

return touch_events
