-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon takes out the quarters of a nucleus. First strokes with ultrasound, mouth first along the shaft
-- and through what lies on the far side, where the bag holds it against the tip. When they take no more, piece after
-- piece is grasped with as much vacuum as it bears without being sucked in, carried to the middle and to the far side,
-- and stroked there. What a stroke took shows by how much smaller the pieces are.
-- All groups follow this plan; what they make of it depends on their hands, eyes and attention
-- (scripts/surgeons/groups.lua). It sees the picture and the machine's panel only: no measure, no event, no score. [mm]

local sculpting = require "surgeons.sculpting"
local vector = require "surgeons.vector"

local approach_speed = 6.0
local cutting = 2.35            -- pedal: 35 % of full ultrasound; 30 to 60 % is usual [AscrsUltrasoundTime2014]
local stroke_speed = 5.0        -- with it; slower, the tip waits for tissue
local grasp_speed = 3.0         -- with vacuum, until it holds
local bury_speed = 2.0          -- with a touch of ultrasound, where vacuum alone finds no hold
local press_speed = 1.5         -- with vacuum after that
local draw_speed = 2.0          -- with a piece on the tip
local grips = { 1.75, 1.45 }    -- pedal that holds nucleus without drawing it in; the same for what is softer
local panel_vacuum = 350        -- at pedal 2 [mmHg]
local full = 0.75               -- of the vacuum that the pedal asks for: the mouth is shut
local most_strokes = 40         -- at a time, without grasping
local strokes_per_piece = 12
local worth = 0.2               -- what a good stroke takes [mm^3]
local pieces_in_turn = 5        -- the largest ones
local enough = 40               -- that is left of all pieces, as it looks, less than a fifth of a lens [mm^3]
local small = 0.3               -- radius of a piece that is left
local edge = 3.9                -- of where the tip may go, from the middle of the pupil
local plate = 0.4               -- kept from where the posterior capsule was before irrigation sank it by another 0.4
local back_radius = 6.0         -- of the posterior capsule
local sleeve_room = 0.75        -- that the middle of the shaft keeps from the edge of the pupil
local until_s = 580

local function across(eye, place)
    return math.sqrt((place[1] - eye.pupil[1]) ^ 2 + (place[2] - eye.pupil[2]) ^ 2)
end

-- A place over the middle of the pupil, or off it away from the surgeon, at a depth in the lens.
local function middle(eye, depth, off) return { eye.pupil[1], eye.pupil[2] + (off or 0), eye.front[3] - depth } end

-- Where the tip may work: clear of capsule and cornea, with the shaft clear of the iris.
local function allowed(eye, place)
    local off = across(eye, place)
    local floor = eye.front[3] - sculpting.lens_thickness + off * off / (2 * back_radius) + plate
    if off > edge or place[3] < floor or place[3] > eye.front[3] + 0.3 then return false end
    local pupil_z = eye.front[3] - 0.4
    if place[3] > pupil_z then return off < eye.pupil_radius - sleeve_room end
    local share = (pupil_z - place[3]) / (eye.wound[3] - place[3])
    return across(eye, vector.mix(place, eye.wound, share)) < eye.pupil_radius - sleeve_room
end

-- The same place, or the first one on the way from it to the middle of the lens where the tip may work.
local function within(eye, place)
    local inside = middle(eye, 1.8, 0.5)
    for i = 0, 19 do
        local nearer = vector.mix(place, inside, i / 20)
        if allowed(eye, nearer) then return nearer end
    end
    return inside
end

-- Largest first, with a size of 0 where it cannot be judged.
local function pieces(seen)
    local list = {}
    for i = 1, 8 do
        local name = "fragment_" .. i
        local mark, near = seen.landmarks[name], seen.landmarks[name .. "_near"]
        if near and not (mark and mark.size < small) then
            list[#list + 1] = { position = (mark or near).position, size = mark and mark.size or 0 }
        end
    end
    return list
end

local function best(list, cost)
    local found, least
    for _, piece in ipairs(list) do
        local value = cost(piece)
        if not least or value < least then found, least = piece, value end
    end
    return found
end

local function nearest_to(seen, place)
    return best(pieces(seen), function(piece) return vector.distance(piece.position, place) end)
end

-- Of all pieces, as it looks [mm^3].
local function volume(seen)
    local sum = 0
    for _, piece in ipairs(pieces(seen)) do sum = sum + 4 / 3 * math.pi * piece.size ^ 3 end
    return sum
end

-- Little is left, and nothing lies half under the iris, where it cannot be judged.
local function finished(seen)
    for _, piece in ipairs(pieces(seen)) do
        if piece.size == 0 then return false end
    end
    return volume(seen) < enough
end

-- What makes a surgeon let go: the capsule or the iris in the tip, or a hole.
local function alarm(seen)
    local marks = seen.landmarks
    if marks.capsule_folds then return "capsule" end
    if marks.capsule_hole then return "hole" end
    return marks.iris_caught and "iris" or nil
end

local function into(eye, place) return vector.unit(vector.sub(place, eye.wound)) end
local function beyond(place, way, distance) return vector.add(place, vector.scale(way, distance)) end

-- A movement that danger ends; what it was meant to end with is no danger.
local function go(me, place, speed, reached)
    local reason = me.go(place, speed, alarm, reached)
    return reason ~= "reached" and reason or nil
end

-- Pedal up, stay until it is free, then out of the way.
local function let_go(me, eye)
    me.pedal(1)
    me.wait_until(function(seen) return not seen.landmarks.capsule_folds and not seen.landmarks.iris_caught end, 2)
    local tip = me.tip()
    me.go({ tip[1], tip[2], sculpting.surface(eye, across(eye, tip)) + 0.5 }, approach_speed)
    me.wait(0.5)
end

-- Whether the panel says that tissue shuts the mouth at this pedal.
local function holding(grip)
    local least = full * (grip - 1) * panel_vacuum
    return function(seen) return seen.vacuum_mmhg > least end
end

-- Waits until the vacuum has stayed up for a moment: it also rises where tissue only passes the mouth.
local function firm(me, holds, longest)
    local since
    me.wait_until(function(seen)
        since = holds(seen) and (since or me.time_s()) or nil
        return alarm(seen) or (since and me.time_s() - since >= 0.3)
    end, longest)
    return holds(me.see())
end

-- Takes a piece onto the tip: along the shaft where the mouth can look at it, else outwards from the middle. Returns
-- what went wrong, and whether it is held.
local function grasp(me, eye, piece, grip)
    local holds, place = holding(grip), piece.position
    local mouth_first = place[2] > eye.pupil[2] - 0.5 or place[3] > eye.front[3] - 1.2
    local start = mouth_first and within(eye, beyond(place, into(eye, place), -piece.size - 0.3)) or middle(eye, 1.7)
    me.pedal(1.2)
    local reason = go(me, start, approach_speed)
    piece = nearest_to(me.see(), place)
    if reason or not piece then return reason, false end
    place = piece.position
    local target = { place[1], place[2], math.max(place[3], eye.front[3] - 2.3) }
    local way = vector.unit(vector.sub(target, me.tip()))
    me.pedal(grip)
    reason = go(me, within(eye, beyond(place, way, 0.3 * piece.size)), grasp_speed, holds)
    if reason then return reason, false end
    if firm(me, holds, 0.5) then return alarm(me.see()), true end
    me.pedal(cutting)
    reason = go(me, within(eye, beyond(me.tip(), way, 0.6)), bury_speed)
    if reason then return reason, false end
    me.pedal(grip)
    reason = go(me, within(eye, beyond(me.tip(), way, 0.8)), press_speed, holds)
    if reason then return reason, false end
    local held = firm(me, holds, 0.6)
    return alarm(me.see()), held
end

-- What is held comes to the middle, then to the far side, as far as it follows.
local function carry(me, eye, grip)
    local holds = holding(grip)
    local function lost(seen) return not holds(seen) end
    return go(me, middle(eye, 1.6, -0.2), draw_speed, lost)
        or (holds(me.see()) and go(me, middle(eye, 1.6, 1.2), draw_speed, lost)) or nil
end

-- One stroke through a piece, beside the last one: they spread over it as seeds do in a sunflower.
local function stroke(me, eye, piece, number)
    local off = 0.8 * piece.size * math.sqrt(number * 0.618 % 1)
    local angle = 2.4 * number
    local target = vector.add(piece.position, { off * math.cos(angle), 0, 0.7 * off * math.sin(angle) })
    local way = into(eye, target)
    local from = within(eye, beyond(target, way, -piece.size))
    me.pedal(2)
    local reason = go(me, from, approach_speed)
    if reason then return reason end
    me.pedal(cutting)
    return go(me, within(eye, beyond(target, way, piece.size)), stroke_speed)
end

-- Strokes until `patience` of them in a row took nothing worth while. choose: the piece, of what is seen.
local function strokes(me, eye, choose, most, patience, number)
    local idle = 0
    for i = 1, most do
        local piece = choose(me.see())
        if not piece or idle >= patience then return nil, number + i end
        local before = volume(me.see())
        local reason = stroke(me, eye, piece, number + i)
        if reason then return reason, number + i end
        idle = volume(me.see()) < before - worth and 0 or idle + 1
    end
    return nil, number + most
end

-- Large pieces first, rather those on the far side.
local function far_one(seen)
    return best(pieces(seen), function(piece) return -piece.size - 0.4 * piece.position[2] end)
end

return function(me)
    local eye = sculpting.look_around(me)
    sculpting.enter(me, eye, sculpting.plan_groove(eye))
    me.wait(1.5)  -- the chamber deepens
    local reason, number = strokes(me, eye, far_one, most_strokes, 4, 0)
    local last, turn, tries, grip = nil, 0, 0, 1
    while me.time_s() < until_s and not finished(me.see()) do
        if reason then
            let_go(me, eye)
            if reason == "hole" then break end
        end
        local list = pieces(me.see())
        if #list == 0 then break end
        local piece = last and tries < 2 and nearest_to(me.see(), last)
        if not piece then
            turn, tries = turn + 1, 0
            piece = list[turn % math.min(pieces_in_turn, #list) + 1]
        end
        local held
        last, tries = piece.position, tries + 1
        if turn % pieces_in_turn == 0 and tries == 1 then
            reason, number = strokes(me, eye, far_one, most_strokes, 4, number)
        end
        if not reason then reason, held = grasp(me, eye, piece, grips[grip]) end
        if held and not reason then
            reason = carry(me, eye, grips[grip])
            local here = nearest_to(me.see(), me.tip())
            last = here and here.position or last
            local function same(seen)
                local found = nearest_to(seen, last)
                last = found and found.position or last
                return found
            end
            if not reason then reason, number = strokes(me, eye, same, strokes_per_piece, 2, number) end
        else
            last, grip = nil, 3 - grip
        end
    end
    sculpting.leave(me, eye)
end
