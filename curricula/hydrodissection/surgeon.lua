-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does in hydrodissection: saline under the rim at one quadrant after the other until the wave
-- has crossed, the nucleus pressed back in between, and then turned with the end of the cannula. It sees the picture
-- only. [mm]

local instruments = require "surgeons.instruments"

local speed, careful = 6.0, 3.0
local under_rim = 0.35      -- outside the edge of the opening
local below_rim = 0.3       -- under it
local over_lens = 0.8       -- height at which nothing touches it
local press = 0.28          -- of the syringe
local firmer = 0.45         -- once viscoelastic has gone, saline finds its way out past the nucleus
local crossed = 0.99        -- size of the wave that a surgeon is content with
local inject_longest = 7.0  -- [s]
local bulges = 0.4          -- forward: no more saline
local pressed = 0.5         -- depth to which the nucleus is pressed back
local press_s = 0.8
local sites = { 90, 20, 160 }  -- anticlockwise from the surgeon's right [deg]
local more_sites = { 0, 180, 90, 20, 160 }  -- while the nucleus is held [deg]
local arm, dent = 2.0, 0.7  -- of the turn
local stroke = { 20, 100 }  -- [deg]
local turn_speed = 3.0
local turned_enough = 70    -- [deg]
local most_strokes = 6
local held = 15             -- turned by less after some strokes, the nucleus is held [deg]
local strokes_to_tell = 2

local function at(middle, radius, angle, z)
    return { middle[1] + radius * math.cos(math.rad(angle)), middle[2] + radius * math.sin(math.rad(angle)), z }
end

local function front(me) return me.see().landmarks.lens_front.position end
local function wave(seen) return seen.landmarks.fluid_wave and seen.landmarks.fluid_wave.size or 0 end
local function burst(seen) return seen.landmarks.capsule_hole and "burst" or nil end

local function over(me)
    local tip = me.tip()
    me.go({ tip[1], tip[2], front(me)[3] + over_lens }, speed)
end

local function press_back(me)
    over(me)
    local middle = front(me)
    me.go({ middle[1], middle[2], middle[3] + over_lens }, speed)
    me.go({ middle[1], middle[2], middle[3] - pressed }, careful)
    me.wait(press_s)
    over(me)
end

local function inject(me, rim, rest, angle, how_hard)
    local edge = at(rim.position, rim.size - 0.5, angle, rim.position[3] + 0.5)
    me.go(edge, speed)
    me.go(at(rim.position, rim.size + under_rim, angle, rim.position[3] - below_rim), careful)
    me.jaw(me.about(how_hard))
    me.wait_until(function(seen)
        return wave(seen) > crossed or burst(seen)
            or (me.notices(function(now) return now.landmarks.lens_front.position[3] - rest > bulges end) and true)
    end, inject_longest)
    me.jaw(0)
    me.wait(0.2)
    me.go(edge, speed)
end

local function spoke(me)
    local mark = me.see().landmarks.cortical_spoke.position
    return math.deg(math.atan(mark[2], mark[1]))
end

-- Anticlockwise, in strokes. Whether it turned.
local function turn(me)
    local start = spoke(me)
    for done = 1, most_strokes do
        local middle = front(me)
        over(me)
        me.go(at(middle, arm, stroke[1], middle[3] + over_lens), speed)
        me.go(at(middle, arm, stroke[1], middle[3] - dent), careful)
        me.follow(function(share)
            return at(middle, arm, stroke[1] + (stroke[2] - stroke[1]) * share, middle[3] - dent)
        end, turn_speed)
        over(me)
        local turned = (spoke(me) - start + 60) % 360 - 60
        if turned > turned_enough then return true end
        if done >= strokes_to_tell and turned < held then return false end
    end
    return false
end

-- What the wave has not reached still holds the nucleus: saline from another side, and another try.
local function free(me, rest)
    for _, angle in ipairs(more_sites) do
        if turn(me) then return end
        inject(me, me.see().landmarks.capsulorhexis, rest, angle, firmer)
        if me.notices(burst) then return end
        press_back(me)
    end
    turn(me)
end

-- The capsule has burst: viscoelastic under the nucleus, and no turning.
local function lift(me, rim, wound)
    me.go(wound, speed)
    me.go(instruments.outside(wound), speed)
    me.put_down()
    me.take_up(instruments.outside(wound), "cannula")
    me.wait(0.5)
    me.go(wound, speed)
    me.go(at(rim.position, rim.size - 0.5, 90, rim.position[3] + 0.5), speed)
    me.go(at(rim.position, rim.size + under_rim, 90, rim.position[3] - below_rim), careful)
    me.jaw(0.3)
    me.wait(1.5)
    me.jaw(0)
end

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.capsulorhexis end, 10)
    local rim, rest = me.see().landmarks.capsulorhexis, front(me)[3]
    local wound = me.see().landmarks.incision.position
    me.take_up(instruments.outside(wound), "saline_cannula")
    me.wait(0.5)
    me.go(wound, speed)
    for _, angle in ipairs(sites) do
        inject(me, rim, rest, angle, press)
        if me.notices(burst) then break end
        press_back(me)
        if wave(me.see()) > crossed then break end
    end
    if not me.notices(burst) then free(me, rest) end
    if me.notices(burst) then lift(me, rim, wound) end
    over(me)
    me.go(wound, speed)
    me.go(instruments.outside(wound), speed)
    me.put_down()
end
