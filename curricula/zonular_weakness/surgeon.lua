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
local most_hooks = 2

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

-- Looked at for a while: one look is not exact.
local function look_at_gap(me)
    local sum, looks = { 0, 0, 0 }, 0
    for _ = 1, 8 do
        local gap = gap_of(me.see())
        if gap then
            for axis = 1, 3 do sum[axis] = sum[axis] + gap.position[axis] end
            looks = looks + 1
        end
        me.wait(0.25)
    end
    if looks == 0 then return nil end
    return { sum[1] / looks, sum[2] / looks, sum[3] / looks }
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

local function set_hook(me, gap)
    bring(me, "capsule_hook", "side_port", gap)
    me.jaw(1)
    me.go({ gap[1], gap[2], gap[3] + over_rim }, careful)
    me.wait(0.3)
    me.jaw(0)
    me.wait(0.3)
    take_out(me, "side_port")
end

return function(me)
    local eye = sculpting.look_around(me)
    if me.notices(function(seen) return gap_of(seen) end) then
        local gap = look_at_gap(me)
        if gap then cover(me, gap) end
        for number = 1, most_hooks do
            gap = look_at_gap(me)
            if not gap or me.see().landmarks["capsule_hook_" .. number] then break end
            set_hook(me, gap)
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
