-- SPDX-License-Identifier: GPL-3.0-or-later
-- One instrument in a scenario: an exact hand, without tremor. Its shaft turns about the wound that it goes through.

local condition = require "engine.condition"
local coordinates = require "scenario.coordinates"
local fields = require "engine.fields"
local instruments = require "surgeons.instruments"
local motion = require "surgeons.motion"
local vector = require "surgeons.vector"
local words = require "engine.words"

local Hand = {}
Hand.__index = Hand

--- What a scenario may ask of it.
Hand.public = { "enter", "withdraw", "move_to", "move_by", "path", "pedal", "jaw", "turn", "tip" }

local main_entry = "incision"  -- of an instrument whose own wound the eye does not have

local outside_mm = 2.2       -- from the wound to where an instrument appears
local peak_over_mean = 1.875  -- of the speed of a minimum-jerk movement
local place_of = coordinates.within(50)  -- as far as a place may be from the middle of the eye, each direction [mm]

local number = { kind = "number" }

local move_rules = {
    speed = { kind = "number", from = 0.01, to = 200 },  -- [mm/s]: peak of a smooth movement
    seconds = { kind = "number", from = 0.01, to = 600 },  -- instead of a speed: how long it takes
    motion = { kind = "text", default = "smooth", choices = { "smooth", "even" } },
    shaft = { kind = "any" },              -- direction from the tip to the hand at the end; "wound" turns it back
    stop = { kind = "condition" },         -- the movement ends as soon as this holds
}
local default_speed = 5

local function direction_of(value, where)
    if value == "wound" then return nil end
    if type(value) ~= "table" or #value ~= 3 then
        words.fail(where, "shaft must be a direction { x, y, z } from the tip to the hand, or \"wound\"")
    end
    for i = 1, 3 do fields.check_value(number, value[i], where, "shaft") end
    if vector.norm(value) < 1e-9 then words.fail(where, "shaft = { 0, 0, 0 } is no direction") end
    return vector.unit(value)
end

--- index: of the instrument, from 0; landmarks: name -> { position }.
function Hand.new(name, index, landmarks, test)
    local self = setmetatable({ name = name, index = index, test = test, landmarks = landmarks, inside = false,
        place = { 0, 0, 0 }, pedal_now = 0, jaw_now = 0, turned = 0, hold = instruments.held(name) }, Hand)
    self:go_through(landmarks[self.hold.wound] and self.hold.wound or main_entry)
    return self
end

function Hand:go_through(landmark)
    self.wound = self.landmarks[landmark].position
    self.out = instruments.way_out(self.wound)
end

local function through_wound(self, tip) return instruments.shaft(self.hold, self.wound, tip) end

local function shaft_at(self, tip)
    local move = self.move
    local function along(axis) return axis or through_wound(self, tip) end
    if not move then return along(self.axis) end
    local from, to = along(move.axis_from), along(move.axis_to)
    local mixed = vector.mix(from, to, move.share)
    return vector.norm(mixed) > 1e-6 and vector.unit(mixed) or to
end

-- The place at a share of the length of a line through the points, and that length.
local function line_through(points)
    local at = { 0 }
    for i = 2, #points do at[i] = at[i - 1] + vector.distance(points[i - 1], points[i]) end
    local length = at[#at]
    return function(share)
        local wanted = share * length
        for i = 2, #points do
            if wanted <= at[i] and at[i] > at[i - 1] then
                return vector.mix(points[i - 1], points[i], (wanted - at[i - 1]) / (at[i] - at[i - 1]))
            end
        end
        return points[#points]
    end, length
end

local function duration_of(options, length)
    if options.seconds then return options.seconds end
    local mean = (options.speed or default_speed) / (options.motion == "smooth" and peak_over_mean or 1)
    return length / mean
end

-- Moves through the points; returns true when `stop` ended it.
local function follow(self, points, given, where, what)
    local options = fields.read(given or {}, move_rules, self.name .. ":" .. what, words.line_here())
    if options.speed and options.seconds then words.fail(where, what .. ": speed and seconds are both given") end
    if self.move then words.fail(where, ("%s:%s: it still moves"):format(self.name, what)) end
    table.insert(points, 1, self.place)
    local path, length = line_through(points)
    local axis = self.axis
    if options.shaft ~= nil then axis = direction_of(options.shaft, where) end
    local stop = options.stop and condition.bind(options.stop, self.test.eye, "in " .. what)
    self.move = { path = path, duration = duration_of(options, length), elapsed = 0, share = 0, axis_from = self.axis,
        axis_to = axis, even = options.motion == "even" }
    local stopped = false
    self.test:pause(where, function()
        stopped = self.move ~= nil and stop ~= nil and stop.test()
        return stopped or not self.move
    end)
    if stopped then  -- the shaft stays as it is
        self.axis = (self.axis or axis) and shaft_at(self, self.place)
        self.move = nil
    end
    return stopped
end

local function must_be_inside(self, where, what)
    if not self.inside then
        words.fail(where, ("%s:%s: %s is not in the eye; %s:enter() brings it in"):format(self.name, what, self.name,
            self.name))
    end
end

--- Through the wound into the eye: appears outside it, and its tip stops in it. through: landmark of another wound.
function Hand:enter(given)
    local where = self.test:where()
    local options = fields.read(given or {}, { speed = move_rules.speed, through = { kind = "text" } },
        self.name .. ":enter", words.line_here())
    if self.inside then words.fail(where, ("%s:enter: it is in the eye already"):format(self.name)) end
    if options.through then
        if not self.landmarks[options.through] then
            words.fail(where, ("%s:enter: the eye has no '%s'%s"):format(self.name, options.through,
                words.hint(options.through, words.keys(self.landmarks))))
        end
        self:go_through(options.through)
    end
    self.inside, self.axis = true, nil
    self.place = vector.add(self.wound, vector.scale(self.out, outside_mm))
    follow(self, { self.wound }, { speed = options.speed }, where, "enter")
end

--- Straight back to the wound and out of it.
function Hand:withdraw(given)
    local where = self.test:where()
    local options = fields.read(given or {}, { speed = move_rules.speed }, self.name .. ":withdraw", words.line_here())
    must_be_inside(self, where, "withdraw")
    follow(self, { self.wound }, { speed = options.speed, shaft = self.axis and "wound" or nil }, where, "withdraw")
    follow(self, { vector.add(self.wound, vector.scale(self.out, outside_mm)) }, { speed = options.speed }, where,
        "withdraw")
    self.inside = false
    self.test:pause_one_step(where)
end

--- In a straight line to a place { x, y, z } of the eye's frame [mm]. True when options.stop ended it.
function Hand:move_to(place, options)
    local where = self.test:where()
    must_be_inside(self, where, "move_to")
    return follow(self, { place_of(place, where, self.name .. ":move_to") }, options, where, "move_to")
end

--- The same by a shift from where the tip is.
function Hand:move_by(shift, options)
    local where = self.test:where()
    must_be_inside(self, where, "move_by")
    local by = place_of(shift, where, self.name .. ":move_by")
    return follow(self, { vector.add(self.place, by) }, options, where, "move_by")
end

--- Through several places without a halt.
function Hand:path(places, options)
    local where = self.test:where()
    must_be_inside(self, where, "path")
    if type(places) ~= "table" or #places == 0 then
        words.fail(where, self.name .. ":path must be given a list of places { { x, y, z }, ... }")
    end
    local points = {}
    for i, place in ipairs(places) do points[i] = place_of(place, where, ("%s:path: place %d"):format(self.name, i)) end
    return follow(self, points, options, where, "path")
end

--- 0 up, 1 irrigation, 2 aspiration, 3 ultrasound; the fraction is travel within the position. At once.
function Hand:pedal(position)
    local where = self.test:where()
    fields.check_value({ kind = "number", from = 0, to = 3 }, position, where, self.name .. ":pedal")
    self.pedal_now = position
end

--- Forceps: opening of the jaws, 0 closed to 1 open. Cannula: how hard the hand presses, 0 to 1. At once.
function Hand:jaw(opening)
    local where = self.test:where()
    fields.check_value({ kind = "number", from = 0, to = 1 }, opening, where, self.name .. ":jaw")
    self.jaw_now = opening
end

--- About its own shaft, so far from how it is held otherwise, anticlockwise as seen from the hand [degrees]. At once.
function Hand:turn(angle)
    local where = self.test:where()
    fields.check_value({ kind = "number", from = -180, to = 180 }, angle, where, self.name .. ":turn")
    self.turned = angle
end

--- Where the tip is: { x, y, z } [mm].
function Hand:tip() return { table.unpack(self.place) } end

--- What the instrument does in the coming step of dt [s].
function Hand:sample(dt)
    local move = self.move
    if move then
        move.elapsed = move.elapsed + dt
        local time = move.duration > 0 and math.min(1, move.elapsed / move.duration) or 1
        if move.elapsed >= move.duration - 1e-9 then time = 1 end
        move.share = move.even and time or motion.minimum_jerk(time)
        self.place = move.path(move.share)
    end
    local sample = { instrument = self.index, present = self.inside, position = self.place,
        orientation = vector.turned(self.hold.orientation(shaft_at(self, self.place)), self.turned),
        jaw = self.jaw_now, pedal = self.pedal_now }
    if move and move.elapsed >= move.duration - 1e-9 then self.axis, self.move = move.axis_to, nil end
    return sample
end

return Hand
