-- SPDX-License-Identifier: GPL-3.0-or-later
-- A person who operates: perception, hand, foot and attention with the parameters of one group. A plan says what the
-- person intends; it runs as a coroutine and sees only `me`, below.

local chance = require "surgeons.chance"
local groups = require "surgeons.groups"
local motion = require "surgeons.motion"
local perception = require "surgeons.perception"
local tremor = require "surgeons.tremor"
local vector = require "surgeons.vector"

local operator = {}

local pedal_rate = 8  -- travel of the foot, pedal positions per second; proposal

--- Parameters of one person of a group.
function operator.person(group, seed)
    local stream = chance.stream(seed, "person")
    local person = { group = group }
    for _, parameter in ipairs(groups.parameters) do
        person[parameter.name] = parameter[group] * math.exp(groups.spread * stream:normal())
    end
    return person
end

-- True during a lapse of attention.
local function attention(stream, person, dt)
    local left = 0
    return function()
        if left > 0 then
            left = left - dt
        elseif stream:uniform() < person.lapses_per_min / 60 * dt then
            left = person.lapse_s
        end
        return left > 0
    end
end

-- What a plan may do. Everything that takes time waits until it is over. Speeds are peak speeds [mm/s].
local function make_me(self)
    local me = {}

    --- What is seen now: tools, landmarks, tip_brightness, reflex_brightness, pedal, power. nil before the first look.
    function me.see() return self.seen end

    function me.time_s() return self.time_s end

    --- A quantity as this person really chooses it: about the value that the plan asks for.
    function me.about(value) return value * math.exp(self.person.planning_error * self.planning:normal()) end

    --- Where the hand believes the tip to be.
    function me.tip() return self.hand.place end

    --- Waits until a test of what is seen is true; false when `longest` seconds passed first.
    function me.wait_until(test, longest)
        local until_s = self.time_s + (longest or math.huge)
        while not test(self.seen) do
            if self.time_s >= until_s - 1e-9 then return false end
            coroutine.yield()
        end
        return true
    end

    function me.wait(seconds)
        me.wait_until(function() return false end, seconds)
    end

    --- The instrument appears with its tip at a place outside the wound; its shaft turns about the wound from then on.
    function me.take_up(place)
        self.present = true
        self.hand:put(place)
    end

    function me.put_down() self.present = false end

    --- Presses the foot: 0 up, 1 irrigation, 2 aspiration, 3 ultrasound; the fraction is travel within the position.
    function me.pedal(position) self.pedal_target = position end

    -- Waits for the end of the movement; `watch` stops it as soon as it returns something.
    local function carry_out(watch)
        while self.hand:moving() do
            coroutine.yield()
            local reason = watch and self.seen and watch(self.seen)
            if reason then
                self.hand:stop()
                return reason
            end
        end
        return nil
    end

    --- Moves the tip in a straight line. `watch`, a function of what is seen, may stop it by returning a reason, which
    --- is returned then; nil at the end of the movement.
    function me.go(place, speed, watch)
        self.hand:move(place, speed)
        return carry_out(watch)
    end

    --- The same along a path, a function of the share of the way (0 to 1).
    function me.follow(path, speed, watch)
        self.hand:follow(path, speed)
        return carry_out(watch)
    end
    return me
end

-- The shaft goes through the wound; while the tip is still outside or close to it, it points as it did on the way in.
local function shaft(self, tip)
    local entry = vector.unit({ 0, -1, 0.5 })
    if not self.wound then return entry end
    local out = vector.sub(self.wound, tip)
    local depth = vector.dot(out, entry)
    local turned = math.max(0, math.min(1, (depth - 0.5) / 1.5))
    if turned == 0 then return entry end
    return vector.unit(vector.mix(entry, vector.unit(out), turned))
end

local Operator = {}
Operator.__index = Operator

--- plan: function(me), run as a coroutine. seed: an integer. dt: [s].
function operator.start(plan, group, seed, dt)
    local person = operator.person(group, seed)
    local function stream(purpose) return chance.stream(seed, purpose) end
    local self = setmetatable({ person = person, dt = dt, time_s = 0, present = false, pedal = 0, pedal_target = 0,
        hand = motion.hand(stream("aim"), person.aim_error), planning = stream("planning"),
        tremble = tremor.start(stream("tremor"), person.tremor_um * 1e-3, dt),
        look = perception.start(stream("perception"), person, dt),
        inattentive = attention(stream("attention"), person, dt) }, Operator)
    local me = make_me(self)
    self.thread = coroutine.create(function() plan(me) end)
    return self
end

local function think(self)
    if coroutine.status(self.thread) == "dead" then return end
    local ok, message = coroutine.resume(self.thread)
    if not ok then error(message, 0) end
end

local function press(self)
    local way = self.pedal_target - self.pedal
    local most = pedal_rate * self.dt
    self.pedal = self.pedal + math.max(-most, math.min(most, way))
end

--- The plan has run to its end.
function Operator:done() return coroutine.status(self.thread) == "dead" end

--- Takes the picture of now; returns what the hand and foot do in the coming step: { present, position, orientation,
--- jaw, pedal }.
function Operator:operate(percept)
    self.time_s = percept.time_s
    local incision = percept.landmarks.incision
    self.wound = incision and incision.position  -- it holds the shaft, wherever one believes it to be
    local seen = self.look(percept)
    if not self.inattentive() then
        self.seen = seen
        think(self)
    end
    press(self)
    local aim = self.hand:advance(self.dt)
    local tip = vector.add(aim, self.tremble())
    return { present = self.present, position = tip, orientation = vector.orientation(shaft(self, tip)), jaw = 0,
        pedal = self.pedal }
end

return operator
