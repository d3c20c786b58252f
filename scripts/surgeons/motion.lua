-- SPDX-License-Identifier: GPL-3.0-or-later
-- Voluntary movements: minimum-jerk paths between places (Flash & Hogan 1985), whose end is missed by an error that
-- grows with the length of the movement (Harris & Wolpert 1998).

local vector = require "surgeons.vector"

local motion = {}

--- Share of the way at share t of the time, both 0 to 1.
function motion.minimum_jerk(t)
    if t <= 0 then return 0 end
    if t >= 1 then return 1 end
    return t * t * t * (10 + t * (6 * t - 15))
end

local peak_over_mean = 1.875  -- peak speed of a minimum-jerk movement over its mean

local Hand = {}
Hand.__index = Hand

--- A hand at rest. stream: chance of this person's aim; aim_error: share of the length of a movement.
function motion.hand(stream, aim_error)
    return setmetatable({ stream = stream, aim_error = aim_error, place = { 0, 0, 0 } }, Hand)
end

function Hand:put(place)
    self.place, self.movement = place, nil
end

--- Begins a movement along a path, a function of the share of the way (0 to 1), with a peak speed [mm/s].
function Hand:follow(path, speed)
    local start, goal = path(0), path(1)
    local length = 0
    for i = 1, 8 do length = length + vector.distance(path((i - 1) / 8), path(i / 8)) end
    local spread = self.aim_error * length
    local missed = { spread * self.stream:normal(), spread * self.stream:normal(), spread * self.stream:normal() }
    local late = vector.sub(self.place, start)  -- where the hand is, seen from where the path begins
    local function real(share)
        return vector.add(path(share), vector.add(vector.scale(late, 1 - share), vector.scale(missed, share)))
    end
    length = math.max(length, vector.distance(self.place, goal))
    self.movement = { path = real, duration = math.max(0.1, peak_over_mean * length / speed), elapsed = 0 }
end

--- Begins a movement in a straight line to a place.
function Hand:move(target, speed)
    local from = self.place
    self:follow(function(share) return vector.mix(from, target, share) end, speed)
end

--- Ends the movement within a short way, as a hand does that is told to stop.
function Hand:stop()
    local m = self.movement
    if not m then return end
    local t = m.elapsed / m.duration
    local speed = 30 * t * t * (1 - t) * (1 - t) / m.duration  -- of the share of the way [1/s]
    local share = math.min(1, motion.minimum_jerk(t) + 0.05 * speed)
    local from, to = self.place, m.path(share)
    self.movement = { path = function(u) return vector.mix(from, to, u) end, duration = 0.15, elapsed = 0 }
end

function Hand:moving() return self.movement ~= nil end

--- Advances by dt [s] and returns the place.
function Hand:advance(dt)
    local m = self.movement
    if m then
        m.elapsed = m.elapsed + dt
        self.place = m.path(motion.minimum_jerk(m.elapsed / m.duration))
        if m.elapsed >= m.duration - 1e-9 then self.movement = nil end
    end
    return self.place
end

return motion
