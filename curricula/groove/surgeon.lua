-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon sculpts a groove. All groups follow this plan; what they make of it depends on their hands,
-- eyes and attention (scripts/surgeons/groups.lua). The plan sees the picture only: no measure, no event, no score.

local sculpting = require "surgeons.sculpting"

return function(me)
    local eye = sculpting.look_around(me)
    local groove = sculpting.plan_groove(eye)
    sculpting.enter(me, eye, groove)
    sculpting.sculpt(me, eye, groove, {
        deep_enough = 0.82, surely_deep = 0.65, thin = 0.06, until_s = 180, recover = sculpting.draw_back,
        floor = function(seen) return seen.landmarks.groove_floor end,
    })
    sculpting.leave(me, eye)
end
