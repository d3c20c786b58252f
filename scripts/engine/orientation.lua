-- SPDX-License-Identifier: GPL-3.0-or-later
-- Which way round the eye lies under the microscope. Degrees of a site are those of a protractor laid on the eye as one
-- faces the patient: 0 at three o'clock, 90 above, anticlockwise. So the temple is at 180 in a right eye, at 0 in a
-- left one. The surgeon sits at the main incision; the scene is the surgeon's: the incision is always nearest (-y).

local orientation = {}

local sectors = { "nasal", "upper nasal", "above", "upper temporal", "temporal", "lower temporal", "below",
    "lower nasal" }
local hands = { "to the right", "away, to the right", "away", "away, to the left", "to the left",
    "near, to the left", "near", "near, to the right" }

local function eighth(degrees) return math.floor(degrees % 360 / 45 + 0.5) % 8 + 1 end

--- The name of a site, from its degrees and the side of the eye.
function orientation.site(side, degrees)
    return sectors[eighth(side == "left" and 180 - degrees or degrees)]
end

--- Where a site lies as the surgeon looks, who sits at the incision.
function orientation.seen(degrees, incision) return hands[eighth(degrees - incision + 270)] end

--- patient: of an exercise; hand: "right" or "left".
function orientation.of(patient, hand)
    local side = patient.side or "right"
    local temple = side == "left" and 0 or 180
    local incision = patient.incision_deg or temple
    return { eye = side, incision_deg = incision, incision = orientation.site(side, incision), handedness = hand,
        above = orientation.seen(90, incision), nose = orientation.seen(temple + 180, incision) }
end

return orientation
