-- SPDX-License-Identifier: GPL-3.0-or-later
local sculpting = require "surgeons.sculpting"
return function(me)
    local eye = sculpting.look_around(me)
    local groove = sculpting.plan_groove(eye)
    sculpting.enter(me, eye, groove)
    local x, y, front = eye.pupil[1], eye.pupil[2], eye.front[3]
    me.pedal(1)
    me.go({ x, y - 1.5, front + 0.5 }, 6)
    me.pedal(3)
    me.go({ x, y + 1.5, front - 1.0 }, 2)
    me.pedal(2)
    me.go({ x, y + 1.8, front - 1.2 }, 1)
    me.wait(1.2)
    me.go({ x, y - 2, front + 1.2 }, 8)
    me.wait(me.about(0.3))
    me.pedal(1)
    me.wait(1.5)
    me.request("Bottle up")
    sculpting.leave(me, eye)
end
