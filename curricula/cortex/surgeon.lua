-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a virtual surgeon does with cortex: holds each tag in the fornix with the mouth up, draws it to the middle, and
-- aspirates it there. Where the iris hides the fornix it feels its way round under it, and the vacuum tells that
-- something shuts the mouth. Folds that run to the tip are let go. It sees the picture only. [mm]

local aspirating = require "surgeons.aspirating"

local speed, careful, strips = 7.0, 4.0, 4.0
local sectors = 16
local equator, equator_z = 4.2, -0.4  -- where the fornix must be when nothing of it is seen
local on_the_back = 3.7     -- a tag that is seen no farther out than this lies on the back of the bag
local shut = 100            -- vacuum that tells of something in a mouth that is not seen [mmHg]
local fornix = 3.85         -- how far out the tip goes
local below = 0.55          -- under the tag, so that the mouth, which looks up, meets it
local near_side = -2.0      -- from here on tags lie near the incision
local near_fornix, aside, near_below = 3.75, 0.65, 0.2
local rolled = 80           -- how far the tip is rolled there [degrees]
local middle = 1.3          -- how far out a tag is aspirated
local middle_z = -0.6
local holds_longest = 1.5   -- [s]
local takes_longest = 2.0
local most_passes = 3

local function at(place, out, z)
    local across = math.max(0.1, math.sqrt(place[1] ^ 2 + place[2] ^ 2))
    return { place[1] / across * out, place[2] / across * out, z }
end

-- Under a tag, so that the mouth meets it.
local function under(place)
    return at(place, math.min(fornix, math.max(1.0, math.sqrt(place[1] ^ 2 + place[2] ^ 2))), place[3] - below), 0
end

-- Near the incision the tip stands steeply, and its mouth looks away from the tag that lies behind it: it goes beside
-- the tag, towards the middle of the near side, and is rolled until the mouth looks across at it.
local function beside(place)
    local side = place[1] < 0 and 1 or -1
    local tip = at({ place[1] + side * aside, place[2] }, near_fornix, place[3] - near_below)
    return tip, side * rolled
end

local function reach(place)
    if place[2] < near_side then return beside(place) end
    return under(place)
end

local function holds(seen) return seen.landmarks.cortex_at_tip ~= nil end
local function mouth_shut(seen) return holds(seen) or seen.vacuum_mmhg > shut end

-- Holds what lies at a place, draws it to the middle and aspirates it. Returns whether something was held.
local function take(me, place, held)
    me.go(at(place, middle, middle_z), speed)
    local tip, roll = reach(place)
    me.turn(roll)
    me.go(tip, careful)
    me.pedal(2)
    if not aspirating.wait_until(me, held, holds_longest) then return true end
    local came = held(me.see())
    if me.go(at(place, middle, middle_z), strips, aspirating.folds) then
        aspirating.let_go(me)
        return true
    end
    me.turn(0)
    if aspirating.wait_until(me, function(seen) return not holds(seen) end, takes_longest) then me.pedal(1) end
    return came
end

-- Where the cortex of a sector must be: in the fornix, all round.
local function hidden(sector, level)
    local angle = 2 * math.pi * (sector - 0.5) / sectors
    return { equator * math.cos(angle), equator * math.sin(angle), level }
end

local function in_fornix(place) return math.sqrt(place[1] ^ 2 + place[2] ^ 2) > on_the_back end

-- A tag is followed out to the fornix, where it hangs, also where the iris hides that.
local function root_of(place, level)
    if in_fornix(place) then return place end
    return at(place, equator, level)
end

-- How high the fornix lies, by the tags that were seen there.
local function level_after(level, marks)
    for i = 1, sectors do
        local mark = marks["cortex_" .. i]
        if mark and in_fornix(mark.position) then level = level + 0.1 * (mark.position[3] - level) end
    end
    return level
end

-- Once round: each tag by its root, what of it is left then where it is seen, and under the iris what never was seen,
-- until nothing comes there. done: sector -> true. level: how high the fornix lies; returned as it is known then.
local function go_round(me, done, level)
    for i = 1, sectors do
        local marks = me.see().landmarks
        level = level_after(level, marks)
        local mark, wide = marks["cortex_" .. i], marks.pupil.size
        local held = wide < fornix and mouth_shut or holds
        if mark then
            take(me, done[i] and mark.position or root_of(mark.position, level), held)
            done[i] = true
        elseif not done[i] and wide < equator then
            done[i] = not take(me, hidden(i, level), held)
        end
    end
    return level
end

-- Whether a look round the pupil, or under the iris, finds any. The pupil's size is judged, not known: what was never
-- looked for behind a narrow one is looked for once.
local function some_left(seen, done)
    for i = 1, sectors do
        if seen.landmarks["cortex_" .. i] or not done[i] and seen.landmarks.pupil.size < equator then return true end
    end
    return false
end

return function(me)
    me.wait_until(function(seen) return seen ~= nil end, 10)
    local wound = aspirating.come_to_wound(me, speed)
    me.go({ 0, -middle, middle_z }, speed)
    local done, level = {}, equator_z
    for _ = 1, most_passes do
        level = go_round(me, done, level)
        if not some_left(me.see(), done) then break end
    end
    me.pedal(1)
    me.go({ 0, -1, 0.5 }, speed)
    aspirating.come_out(me, wound, speed)
end
