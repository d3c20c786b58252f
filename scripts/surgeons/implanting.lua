-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon puts an implant into the bag: words that plans share. They see the picture only: no measure, no
-- event, no score. Where a haptic cannot be seen it lies behind the iris: in the bag, or before it in the angle; what
-- tells is how deep it went when it was seen last. [mm]

local instruments = require "surgeons.instruments"
local vector = require "surgeons.vector"

local implanting = {}

local free_speed = 10         -- where nothing is near [mm/s]
local careful_speed = 2.5     -- where something is
local push_speed = 0.18       -- of the plunger, strokes per second: some 5 mm/s
local near_edge = 1.3         -- the tip is held so far on this side of the middle of the opening
local over_rim = 0.75         -- and so far over its plane
local full, shallow = 0.97, 0.9
local heed = 0.3              -- how much a new look counts against those before

local function mark(me, name)
    local seen = me.see()
    return seen and seen.landmarks[name]
end

local function outwards(eye, place) return vector.sub(place, eye.rim) end

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
    return seen.landmarks.viscoelastic and seen.landmarks.viscoelastic.size < shallow
end

--- Viscoelastic until the chamber looks full, or as full as this person finds full.
function implanting.fill(me, eye)
    me.take_up(instruments.outside(eye.wound), "cannula")
    me.wait(0.5)
    me.go(eye.wound, free_speed)
    me.go(vector.add(eye.rim, { 0, -1.5, 1.5 }), free_speed)
    local enough = math.min(full, me.about(full))
    me.jaw(0.7)
    me.wait_until(function(seen)
        return seen.landmarks.viscoelastic and seen.landmarks.viscoelastic.size >= enough
    end, 30)
    me.jaw(0)
    me.wait(0.5)
    withdraw(me, eye)
end

--- The injector's tip into the opening, its plunger home; back with the optic, so that it lies in the middle, and out.
function implanting.inject(me, eye)
    me.take_up(instruments.outside(eye.wound), "injector")
    me.wait(0.5)
    me.go(eye.wound, free_speed)
    me.go(vector.add(eye.rim, { 0, -near_edge, over_rim }), careful_speed)
    me.jaw(1, push_speed * me.about(1))
    me.wait_until(function(seen)
        return seen.landmarks.optic and seen.landmarks.optic.position[2] > eye.rim[2] - 0.5
    end, 8)
    me.go(vector.add(eye.rim, { 0, -near_edge - 1.5, over_rim + 0.5 }), careful_speed)
    me.wait(1.0)
    withdraw(me, eye)
end

return implanting
