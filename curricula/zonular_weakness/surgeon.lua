-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon works on a lens whose zonules are weak. All groups follow this plan; what they make of it
-- depends on their hands, eyes and attention (scripts/surgeons/groups.lua). The plan sees the picture only: no measure,
-- no event, no score. Who does not notice that the bag lacks its hold begins to sculpt at once, as in any other lens.

local instruments = require "surgeons.instruments"
local sculpting = require "surgeons.sculpting"

local speed, careful = 6.0, 2.0
local press = 0.9
local covered = 0.22        -- of the chamber, viscoelastic that lies over a gap by then
local over_rim = 0.15       -- height of a hook over the edge of the opening before it goes round it [mm]
local widest_open = 45      -- arc that may stay without hold [deg]
local most_hooks = 3
local most_tries = 3        -- for each hook

local function bring(me, name, wound, place)
    local mark = me.see().landmarks[wound].position
    me.take_up(instruments.outside(mark), name, wound)
    me.wait(0.5)
    me.go(mark, speed)
    me.go({ 0.6 * place[1], 0.6 * place[2], place[3] + 1.2 }, speed)
end

local function take_out(me, wound)
    local tip = me.tip()
    local mark = me.see().landmarks[wound].position
    me.go({ 0.6 * tip[1], 0.6 * tip[2], tip[3] + 1.2 }, speed)
    me.go(mark, speed)
    me.go(instruments.outside(mark), speed)
    me.put_down()
end

local function gap_of(seen) return seen.landmarks.zonule_gap end

-- Looked at for a while, as one look is not exact: the edge of the opening before the middle of the gap, and the middle
-- of the opening.
local function look_at_gap(me)
    local place, middle, looks, half_arc = { 0, 0, 0 }, { 0, 0, 0 }, 0, 0
    for _ = 1, 8 do
        local marks = me.see().landmarks
        local gap, opening = marks.zonule_gap, marks.capsulorhexis or marks.pupil
        if gap then
            for axis = 1, 3 do
                place[axis] = place[axis] + gap.position[axis]
                middle[axis] = middle[axis] + opening.position[axis]
            end
            looks, half_arc = looks + 1, half_arc + gap.size
        end
        me.wait(0.25)
    end
    if looks == 0 then return nil end
    for axis = 1, 3 do place[axis], middle[axis] = place[axis] / looks, middle[axis] / looks end
    local away = math.sqrt((place[1] - middle[1]) ^ 2 + (place[2] - middle[2]) ^ 2)
    return { place = place, middle = middle, arc = math.deg(2 * half_arc / looks / away) }
end

-- The place of one of so many hooks that part the gap evenly.
local function hook_place(gap, number, count)
    local turn = math.rad(gap.arc * (number / (count + 1) - 0.5))
    local x, y = gap.place[1] - gap.middle[1], gap.place[2] - gap.middle[2]
    return { gap.middle[1] + x * math.cos(turn) - y * math.sin(turn),
        gap.middle[2] + x * math.sin(turn) + y * math.cos(turn), gap.place[3] }
end

local function hooks_seen(me)
    local count = 0
    while me.see().landmarks["capsule_hook_" .. (count + 1)] do count = count + 1 end
    return count
end

-- With the cannula as near to the gap as the pupil lets one see.
local function cover(me, gap)
    local place = { 1.35 * gap[1], 1.35 * gap[2], gap[3] - 0.1 }
    bring(me, "cannula", "incision", place)
    me.go(place, careful)
    me.jaw(press)
    me.wait_until(function(seen)
        local mark = seen.landmarks.viscoelastic
        return mark and mark.size >= me.about(covered)
    end, 8)
    me.jaw(0)
    take_out(me, "incision")
end

local function set_hook(me, place)
    bring(me, "capsule_hook", "side_port", place)
    me.jaw(1)
    me.go({ place[1], place[2], place[3] + over_rim }, careful)
    me.wait(0.3)
    me.jaw(0)
    me.wait(0.3)
    take_out(me, "side_port")
end

-- As many hooks as leave no wide arc without hold between them; one that did not take hold is set again.
local function hold_bag(me, gap)
    local count = math.max(1, math.min(most_hooks, math.ceil(gap.arc / widest_open) - 1))
    for number = 1, count do
        for _ = 1, most_tries do
            if hooks_seen(me) >= number then break end
            gap = look_at_gap(me) or gap
            set_hook(me, hook_place(gap, number, count))
        end
    end
end

return function(me)
    local eye = sculpting.look_around(me)
    if me.notices(gap_of) then
        local gap = look_at_gap(me)
        if gap then
            cover(me, gap.place)
            hold_bag(me, gap)
        end
        eye = sculpting.look_around(me)
    end
    local groove = sculpting.plan_groove(eye)
    sculpting.enter(me, eye, groove)
    sculpting.sculpt(me, eye, groove, {
        deep_enough = 0.6, surely_deep = 0.5, thin = 0.06, until_s = 250, recover = sculpting.draw_back,
        floor = function(seen) return seen.landmarks.groove_floor end,
    })
    sculpting.leave(me, eye)
end
