-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon judges and fills the chamber: words that plans share. They see the picture only: no measure, no
-- event, no score.

local filling = {}

local press = 0.7     -- how hard on the syringe, of all
local longest = 30    -- [s]
local settles = 0.5   -- before the cannula leaves [s]

-- Share of the chamber that looks full of viscoelastic; nothing where that is not seen.
local function filled(seen)
    return seen.landmarks.viscoelastic and seen.landmarks.viscoelastic.size
end

--- Whether less than a share of the chamber looks full.
function filling.is_below(seen, share) return filled(seen) and filled(seen) < share end

--- With the cannula where it is to be: presses until the chamber looks full, or as full as this person finds full.
function filling.press(me, full)
    local enough = math.min(full, me.about(full))
    me.jaw(press)
    me.wait_until(function(seen) return filled(seen) and filled(seen) >= enough end, longest)
    me.jaw(0)
    me.wait(settles)
end

return filling
