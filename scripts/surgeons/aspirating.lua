-- SPDX-License-Identifier: GPL-3.0-or-later
-- What the movements of a virtual surgeon with the irrigation-aspiration tip have in common. It sees the picture only.

local instruments = require "surgeons.instruments"

local aspirating = {}

--- Folds of the posterior capsule that run to the tip, for me.go to stop at.
function aspirating.folds(seen) return seen.landmarks.capsule_folds and "folds" or nil end

--- The mouth up and suction off, until the capsule has slipped from it.
function aspirating.let_go(me)
    me.turn(0)
    me.pedal(1)
    me.wait_until(function(seen) return not seen.landmarks.capsule_folds end, 2)
end

--- Waits until done(seen), at most `longest` [s]. When the capsule comes meanwhile, lets go of it and returns false.
function aspirating.wait_until(me, done, longest)
    me.wait_until(function(seen) return done(seen) or (me.notices(aspirating.folds) and true) end, longest)
    if not me.notices(aspirating.folds) then return true end
    aspirating.let_go(me)
    return false
end

--- Takes the tip up and brings it to the wound, irrigation on. Returns where that is.
function aspirating.come_to_wound(me, speed)
    local wound = me.see().landmarks.incision.position
    me.take_up(instruments.outside(wound))
    me.wait(0.5)
    me.pedal(1)
    me.go(wound, speed)
    return wound
end

--- Out through the wound, irrigation on until the tip is out.
function aspirating.come_out(me, wound, speed)
    me.go(wound, speed)
    me.go(instruments.outside(wound), speed)
    me.put_down()
    me.pedal(0)
end

return aspirating
