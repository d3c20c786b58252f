-- SPDX-License-Identifier: GPL-3.0-or-later
-- The foot with which a person moves the microscope: sent a way, it presses the pedal until the microscope is there.

local vector = require "surgeons.vector"

local microscope = {}

microscope.name = "microscope"

--- The names of a scene's instruments without the microscope's, which is the last one; and whether it has one.
function microscope.apart_from(names)
    local hands = { table.unpack(names) }
    local has = hands[#hands] == microscope.name
    if has then table.remove(hands) end
    return hands, has
end

local Foot = {}
Foot.__index = Foot

--- stream: of this person's misjudgement of the middle; centring_mm: its spread, each direction.
function microscope.foot(stream, centring_mm)
    return setmetatable({ stream = stream, centring_mm = centring_mm }, Foot)
end

--- Begins to move it by { x, y, z } [mm].
function Foot:push(shift) self.shift = shift end

function Foot:moving() return self.shift ~= nil or self.target ~= nil end

--- A shift that brings a place into the middle, as this person finds the middle. field: as it is seen.
function Foot:shift_to(place, field)
    return { place[1] - field.position[1] + self.centring_mm * self.stream:normal(),
        place[2] - field.position[2] + self.centring_mm * self.stream:normal(), 0 }
end

--- What the foot does in the coming step. field: as it is now. The foot goes off the pedal when the microscope stands:
--- it is there, or can go no farther.
function Foot:sample(field)
    local now = field.position
    if self.shift then
        self.target, self.shift, self.before = vector.add(now, self.shift), nil, nil
    elseif self.before and vector.distance(now, self.before) == 0 then
        self.target = nil
    end
    self.before = now
    return { present = self.target ~= nil, position = self.target or now, orientation = { 1, 0, 0, 0 }, jaw = 0,
        pedal = 0 }
end

return microscope
