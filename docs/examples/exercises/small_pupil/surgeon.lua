-- SPDX-License-Identifier: GPL-3.0-or-later
local capsulorhexis = require "surgeons.capsulorhexis"
local sculpting = require "surgeons.sculpting"

return function(me)
    local eye = sculpting.look_around(me)
    local radius = capsulorhexis.plan_radius(me, 2.25)
    if capsulorhexis.is_shallow(me.see()) then capsulorhexis.fill(me, eye) end
    if capsulorhexis.begin_flap(me, eye, radius) then
        capsulorhexis.take_away(me, eye)
        capsulorhexis.tear_round(me, eye, { radius = radius, inwards = 0 }, 150)
    end
    capsulorhexis.take_away(me, eye)
end
