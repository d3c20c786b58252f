-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon opens the capsule. All groups follow this plan; what they make of it depends on their hands,
-- eyes and attention (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event, no score.

local capsulorhexis = require "surgeons.capsulorhexis"
local centring = require "surgeons.centring"
local sculpting = require "surgeons.sculpting"

local wanted_radius = 2.54  -- for an opening 5.25 mm wide as it stands: corners are cut, the rim springs outwards

return function(me)
    centring.centre(me)
    local eye = sculpting.look_around(me)
    local radius = capsulorhexis.plan_radius(me, wanted_radius)
    capsulorhexis.fill(me, eye)
    centring.keep(me)
    for _ = 1, 3 do
        if capsulorhexis.begin_flap(me, eye, radius) then break end
        capsulorhexis.take_away(me, eye)
    end
    capsulorhexis.take_away(me, eye)
    centring.keep(me)
    capsulorhexis.tear_round(me, eye, { radius = radius, inwards = 0 }, 150)
    capsulorhexis.take_away(me, eye)
end
