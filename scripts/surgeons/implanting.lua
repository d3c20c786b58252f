-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon puts an implant into the bag: words that plans share. They see the picture only: no measure, no
-- event, no score. Where a haptic cannot be seen it lies behind the iris: in the bag, or before it in the angle; what
-- tells is how deep it went when it was seen last. [mm]

local filling = require "surgeons.filling"
local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local implanting = {}

local free_speed = 10         -- where nothing is near [mm/s]
local careful_speed = 2.5     -- where something is
local back_speed = 5          -- of the injector, beside the optic that comes out of it: as fast as that does
local push_speed = 0.18       -- of the plunger, strokes per second: some 5 mm/s
local short_of = 0.2          -- the mouth stays so far short of the middle of the opening,
local under_rim = 0.8         -- and so far under its plane: what comes out higher unfolds before the capsule
local half_out = 1.0          -- short of the middle of the opening, where the optic's middle is when one draws back
local near_edge = 1.7         -- back so far on this side of the middle: the mouth stays in the opening,
local still_under = 1.0       -- and under the rim, until the trailing haptic has come out under it too
local push_longest = 12       -- until the optic is half out [s]
local let_unfold = 0.6        -- from then on, before one leaves: a nozzle that stays keeps it off the middle, one that
                              -- leaves at once draws the trailing haptic out of the bag again [s]
local full, shallow = 0.97, 0.9
local heed = 0.3              -- how much a new look counts against those before

--- What is known of the eye after looking for a while: wound, port, pupil, rim and rim_radius.
function implanting.look_around(me)
    me.wait_until(function(seen)
        return seen and seen.landmarks.incision and seen.landmarks.pupil and seen.landmarks.bag_rim
    end, 5)
    local marks = me.see().landmarks
    local eye = { wound = marks.incision.position, pupil = marks.pupil.position, rim = marks.bag_rim.position,
        rim_radius = marks.bag_rim.size, port = marks.side_port and marks.side_port.position }
    for _ = 1, 8 do
        me.wait(0.25)
        marks = me.see().landmarks
        for name, of in pairs { wound = "incision", pupil = "pupil", rim = "bag_rim", port = "side_port" } do
            if marks[of] and eye[name] then
                eye[name] = vector.mix(eye[name], marks[of].position, heed)
            end
        end
    end
    return eye
end

local function withdraw(me, eye)
    me.jaw(0)
    me.go(eye.wound, free_speed)
    me.go(instruments.outside(eye.wound), free_speed)
    me.put_down()
end

--- Whether the chamber looks as if the viscoelastic had left it.
function implanting.is_shallow(seen)
    return filling.is_below(seen, shallow)
end

--- Viscoelastic until the chamber looks full, or as full as this person finds full.
function implanting.fill(me, eye)
    me.take_up(instruments.outside(eye.wound), "cannula")
    me.wait(0.5)
    me.go(eye.wound, free_speed)
    me.go(vector.add(eye.rim, { 0, -1.5, 1.5 }), free_speed)
    filling.press(me, full)
    withdraw(me, eye)
end

--- The injector's mouth through the opening, under the rim; the plunger home. Half out, the optic is left where it is
--- and the mouth drawn back to the near edge, still under the rim: a haptic that comes out over it stays before the
--- capsule.
function implanting.inject(me, eye)
    me.take_up(instruments.outside(eye.wound), "injector")
    me.wait(0.5)
    me.go(eye.wound, free_speed)
    me.go(vector.add(eye.rim, { 0, -short_of, -under_rim }), careful_speed)
    me.jaw(1, push_speed * me.about(1))
    me.wait_until(function(seen)
        local optic = seen.landmarks.optic
        return optic and optic.position[2] > eye.rim[2] - half_out
    end, push_longest)
    me.go(vector.add(eye.rim, { 0, -near_edge, -still_under }), back_speed)
    me.wait(let_unfold)
    withdraw(me, eye)
end

return implanting
