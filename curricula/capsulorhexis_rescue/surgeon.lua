-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon brings a tear back that runs out. All groups follow this plan; what they make of it depends on
-- their hands, eyes and attention (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event,
-- no score. Who does not react to what goes wrong (surgeon.recovery=0) does not fill the chamber, and pulls as usual.

local capsulorhexis = require "surgeons.capsulorhexis"
local centring = require "surgeons.centring"
local sculpting = require "surgeons.sculpting"

local wanted_radius = 2.7
local inwards = 10  -- farther than usual: what has run out once will do so again [degrees]

return function(me)
    centring.centre(me)
    local eye = sculpting.look_around(me)
    local radius = capsulorhexis.plan_radius(me, wanted_radius)
    local heeds = me.notices(capsulorhexis.is_shallow)
    if heeds then capsulorhexis.fill(me, eye) end
    centring.keep(me)
    capsulorhexis.tear_round(me, eye, { radius = radius, inwards = heeds and inwards or 0 }, 200)
    capsulorhexis.take_away(me, eye)
end
