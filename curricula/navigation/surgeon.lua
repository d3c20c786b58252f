-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does: to each place in turn, still for a while; round the circle; out. It sees the picture
-- only.

local targets = require "targets"

local speed = 4       -- [mm/s]
local still_s = 2.5   -- how long a place is held, by feel
local good = 0.3      -- as near as one wants to be, looked at [mm]
local most_tries = 6

-- Where the tip is seen to be, over half a second.
local function look(me)
    local sum, n = { 0, 0, 0 }, 0
    for _ = 1, 5 do
        me.wait(0.1)
        local seen = me.see()
        local probe = seen and seen.tools.probe
        if probe then
            for axis = 1, 3 do sum[axis] = sum[axis] + probe.position[axis] end
            n = n + 1
        end
    end
    if n == 0 then return nil end
    return { sum[1] / n, sum[2] / n, sum[3] / n }
end

local function off(a, b) return math.max(math.abs(a[1] - b[1]), math.abs(a[2] - b[2]), math.abs(a[3] - b[3])) end

-- To a place, looked at, put right, and held.
local function hold(me, place)
    me.go(place, speed)
    for _ = 1, most_tries do
        local seen = look(me)
        if not seen or off(seen, place) < good then break end
        local tip = me.tip()
        me.go({ tip[1] + place[1] - seen[1], tip[2] + place[2] - seen[2], tip[3] + place[3] - seen[3] }, speed)
    end
    me.wait(still_s)
end

return function(me)
    me.wait_until(function(seen) return seen and seen.landmarks.incision and seen.landmarks.pupil end, 5)
    local marks = me.see().landmarks
    local wound, pupil = marks.incision.position, marks.pupil.position
    local function at(x, y, z) return { pupil[1] + x, pupil[2] + y, z } end
    local inside = { 0.75 * wound[1], 0.75 * wound[2], 3.0 }
    me.take_up { 1.3 * wound[1], 1.3 * wound[2], wound[3] + 0.6 }
    me.go(inside, speed)
    for _, target in ipairs(targets) do
        hold(me, at(table.unpack(target.place)))
    end
    local circle = targets.circle
    me.follow(function(share)
        local angle = math.pi * (1 + 2.03 * share)
        return at(circle.radius * math.cos(angle), circle.radius * math.sin(angle), circle.height)
    end, 2.5)
    me.wait(0.5)
    me.go(at(0, 0, circle.height), speed)
    me.go(inside, speed)
    me.go({ 1.3 * wound[1], 1.3 * wound[2], wound[3] + 0.6 }, speed)
    me.put_down()
    me.wait(1)
end
