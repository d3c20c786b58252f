-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon cracks a nucleus along one groove. All groups follow this plan; what they make of it depends on
-- their hands, eyes and attention (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event,
-- no score.

local cracking = require "surgeons.cracking"
local sculpting = require "surgeons.sculpting"
local spatula = require "surgeons.spatula"

local stop_s = 110

return function(me)
    local eye = sculpting.look_around(me)
    sculpting.enter(me, eye, sculpting.plan_groove(eye))
    spatula.bring(me, eye)
    for _ = 1, 12 do  -- irrigation has pushed the lens back
        me.wait(0.1)
        sculpting.look_at_height(me, eye)
    end
    cracking.crack(me, eye, "groove_1", "bridge", cracking.along_one_groove, stop_s)
    spatula.take_away(me, eye)
    sculpting.leave(me, eye)
end
