-- SPDX-License-Identifier: GPL-3.0-or-later
-- The microscope in a scenario: an exact foot. It moves as fast as its motors do.

local coordinates = require "scenario.coordinates"
local vector = require "surgeons.vector"
local words = require "engine.words"

local Microscope = {}
Microscope.__index = Microscope

--- What a scenario may ask of it.
Microscope.public = { "move_to", "move_by", "centre", "position" }

local place_of = coordinates.within(25)  -- as far as it may be sent from the middle of the eye [mm]; as in the kernel

--- index: of the instrument, from 0.
function Microscope.new(index, test) return setmetatable({ index = index, test = test }, Microscope) end

--- What is in the middle of its field and in focus: { x, y, z } [mm].
function Microscope:position()
    local eye = self.test.eye
    return { eye:value("microscope.x_mm"), eye:value("microscope.y_mm"), eye:value("microscope.z_mm") }
end

local function send(self, place, where, what)
    if self.target then words.fail(where, ("microscope:%s: it still moves"):format(what)) end
    self.target = place
    self.test:pause(where, function() return vector.distance(self:position(), place) < 1e-9 end)
    self.target = nil
end

--- Until a place is in the middle of its field and in focus.
function Microscope:move_to(place)
    local where = self.test:where()
    send(self, place_of(place, where, "microscope:move_to"), where, "move_to")
end

--- The same by a shift from where it is.
function Microscope:move_by(shift)
    local where = self.test:where()
    local by = place_of(shift, where, "microscope:move_by")
    send(self, place_of(vector.add(self:position(), by), where, "microscope:move_by"), where, "move_by")
end

--- Until the pupil, which lies on the eye's axis, is in the middle and its edge in focus.
function Microscope:centre()
    local defocus = self.test.eye:value("microscope.defocus_mm")
    send(self, { 0, 0, self:position()[3] - defocus }, self.test:where(), "centre")
end

--- What the foot does in the coming step.
function Microscope:sample()
    return { instrument = self.index, present = self.target ~= nil, position = self.target or { 0, 0, 0 },
        orientation = { 1, 0, 0, 0 }, jaw = 0, pedal = 0 }
end

return Microscope
