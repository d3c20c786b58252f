-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does at a tip that may be blocked: tries the flow in pedal position 2, looks at the panel, and
-- comes out if nothing flows. Who does not look finds out by the white wound. It sees the picture and the machine's
-- panel only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"

local try_s = 1.2          -- with the pedal at 2
local flows = 8            -- on the panel, and more [ml/min]
local strokes = 3
local stroke_speed = 2.5
local layer = 0.45
local press_speed = 1.0

local function blocked(seen) return seen.flow_ml_min < flows end

local function white(seen) return seen.landmarks.wound_white and "burn" or nil end

local function to_lens(me, eye, groove)
    sculpting.enter(me, eye, groove)
    me.wait(1.0)
    me.go({ groove.x, groove.near, sculpting.surface(eye, groove.near) + 0.4 }, sculpting.free_speed)
end

-- Strokes along a groove; stopped by a wound that turns white. The reason, or nil.
local function sculpt(me, eye, groove)
    for number = 1, strokes do
        local depth = me.about(layer) * number
        local function over(y) return { groove.x, y, sculpting.surface(eye, y) + 0.5 } end
        me.go(over(groove.near), sculpting.free_speed)
        me.pedal(3)
        local near = { groove.x, groove.near, sculpting.surface(eye, groove.near) - depth }
        local far = { groove.x, groove.far, sculpting.surface(eye, groove.far) - depth }
        local reason = me.go(near, press_speed, white) or me.go(far, me.about(stroke_speed), white)
        me.pedal(1)
        if reason then return reason end
        me.go(over(me.tip()[2]), sculpting.free_speed)
    end
end

return function(me)
    local eye = sculpting.look_around(me)
    local groove = sculpting.plan_groove(eye)
    groove.far = groove.deepest
    for _ = 1, 3 do
        to_lens(me, eye, groove)
        me.pedal(2)
        me.wait(me.about(try_s))
        local reason = me.notices(blocked)
        if not reason then reason = sculpt(me, eye, groove) end
        sculpting.leave(me, eye)
        me.wait(1.0)
        if not reason then return end
    end
end
