-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon brings a tear back that runs out. All groups follow this plan; what they make of it depends on
-- their hands, eyes and attention (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event,
-- no score. Who does not react to what goes wrong (surgeon.recovery=0) does not fill the chamber.

local capsulorhexis = require "surgeons.capsulorhexis"
local centring = require "surgeons.centring"
local sculpting = require "surgeons.sculpting"

local wanted_radius = 2.62

return function(me)
    centring.centre(me)
    local eye = sculpting.look_around(me)
    local radius = capsulorhexis.plan_radius(me, wanted_radius)
    if me.notices(capsulorhexis.is_shallow) then capsulorhexis.fill(me, eye) end
    centring.keep(me)
    capsulorhexis.tear_round(me, eye, radius, 200)
    capsulorhexis.take_away(me, eye)
end
