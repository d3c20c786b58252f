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
local quick_speed = 6         -- with open jaws, which push nothing
local slow_speed = 3          -- of what is held
local above = 1.0             -- from where one comes down on what one takes
local lifts = 0.6             -- to see whether it is held:
local comes = 0.4             -- what is rises by so much of that or more
local tries = 4               -- of taking hold
local stands_out = 0.2        -- higher than the rim: an arm that is seen there lies before the bag
local first_reach = 1.4       -- beyond the middle of the opening an arm is drawn by its middle,
local reach = 1.3             -- and by its elbow, until all of it is within the rim
local beside = 0.5            -- the middle, on the side of its end,
local over_rim = 0.9          -- so high on the way,
local below_rim = 1.5         -- and pressed so far down there,
local let_go_at = 0.6         -- before it is led back so far on its own side of the middle
local relaxes_s = 2.0         -- acrylic that is held gives in, and springs back the slower
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

-- Forceps on a place of the arm; whether they have it. Each look is from nearer than the one before.
local function take_hold(me, mark)
    for _ = 1, tries do
        me.jaw(1)
        for _, height in ipairs { above, 0 } do
            local seen = me.see().landmarks[mark]
            if not seen then return false end
            me.go(vector.add(seen.position, { 0, 0, height }), height == above and free_speed or quick_speed)
        end
        me.jaw(0)
        me.wait(0.4)
        local before = me.see().landmarks[mark]
        me.go(vector.add(me.tip(), { 0, 0, lifts }), slow_speed)
        me.wait(0.3)
        local seen = me.see().landmarks[mark]
        if before and seen and seen.position[3] - before.position[3] > comes * lifts then return true end
    end
    return false
end

local function let_go(me)
    me.jaw(1)
    me.wait(0.2)
    me.go(vector.add(me.tip(), { 0, 0, above }), quick_speed)
end

--- Whether the arm of a haptic, "leading" or "trailing", is seen to lie before the bag.
function implanting.lies_before(seen, which)
    local arm, rim = seen.landmarks["haptic_" .. which .. "_middle"], seen.landmarks.bag_rim
    return arm ~= nil and rim ~= nil and arm.position[3] > rim.position[3] + stands_out
end

-- Across the opening, away from the elbow, which lies behind the iris: as far from the middle of the arm as its end.
-- And to the side of that where the arm lies, if its end shows.
local function way_in(seen, which, rim)
    local middle = seen.landmarks["haptic_" .. which .. "_middle"].position
    local tip = seen.landmarks["haptic_" .. which]
    local elbow = tip and vector.sub(vector.scale(middle, 2), tip.position) or middle
    local function flat(v) return vector.unit { v[1], v[2], 0 } end
    local way = flat(vector.sub(rim, elbow))
    if not tip then return way, { 0, 0, 0 } end
    local out = vector.sub(middle, rim)
    return way, vector.scale(flat(vector.sub(out, vector.scale(way, vector.dot(out, way)))), beside)
end

--- An arm that lies before the bag, hand over hand: drawn in by its middle, then by its elbow until all of it is within
--- the rim, pressed down there, and led back to its side behind the rim. Whether it was held.
function implanting.tuck_in(me, eye, which)
    me.take_up(instruments.outside(eye.wound), "lens_forceps")
    me.wait(0.5)
    me.go(eye.wound, free_speed)
    local seen = me.see()
    local rim = (seen.landmarks.bag_rim or { position = eye.rim }).position
    local name = "haptic_" .. which
    local held = false
    if seen.landmarks[name .. "_middle"] and take_hold(me, name .. "_middle") then
        local way, side = way_in(seen, which, rim)
        local function at(along, height)
            return vector.add(rim, { along * way[1] + side[1], along * way[2] + side[2], height })
        end
        me.go(at(first_reach, over_rim), slow_speed)
        me.wait(relaxes_s)
        let_go(me)
        held = take_hold(me, name .. "_elbow")
        if held then
            me.go(at(reach, over_rim), slow_speed)
            me.go(at(reach, -below_rim), slow_speed)
            me.wait(relaxes_s)
            me.go(at(-let_go_at, -below_rim), slow_speed)
        end
        let_go(me)
    end
    me.jaw(1)
    me.go(vector.add(eye.rim, { 0, 0, 2 * above }), slow_speed)
    withdraw(me, eye)
    return held
end

return implanting
