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

local most_askew = 15  -- spread of a chosen direction for a planning error of 1 [deg]; proposal
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

-- One hand with its instrument: `name` begins the names of its streams of chance, `wound` is the landmark that holds
-- the shaft of its instrument.
local function make_hand(stream, person, dt, name, wound)
    return { present = false, wound = wound, hand = motion.hand(stream(name .. "aim"), person.aim_error),
        tremble = tremor.start(stream(name .. "tremor"), person.tremor_um * 1e-3, dt) }
end

-- Waits until these hands are still. `watch` stops them as soon as it returns something: that is how a person reacts to
-- danger, so it is not heeded by a person who does not. `reached` stops them where their purpose is fulfilled.
local function carry_out(self, hands, watch, reached)
    local function moving()
        for _, side in ipairs(hands) do
            if side.hand:moving() then return true end
        end
        return false
    end
    while moving() do
        coroutine.yield()
        local reason = self.seen and ((self.recovers and watch and watch(self.seen))
            or (reached and reached(self.seen) and "reached"))
        if reason then
            for _, side in ipairs(hands) do side.hand:stop() end
            return reason
        end
    end
    return nil
end

-- What a plan may do with one hand. Speeds are peak speeds [mm/s].
local function hand_words(self, side)
    local words = {}

    --- Where the hand believes the tip to be.
    function words.tip() return side.hand.place end

    --- The instrument appears with its tip at a place outside the wound; its shaft turns about the wound from then on.
    function words.take_up(place)
        side.present = true
        side.hand:put(place)
    end

    function words.put_down() side.present = false end

    --- Begins a movement along a path, a function of the share of the way (0 to 1), and does not wait for its end.
    function words.begin(path, speed) side.hand:follow(path, speed) end

    --- Moves the tip in a straight line. `watch`, a function of what is seen, may stop it by returning a reason, which
    --- is returned then; `reached`, likewise, by returning true: the reason is "reached". nil at the end of the
    --- movement.
    function words.go(place, speed, watch, reached)
        side.hand:move(place, speed)
        return carry_out(self, { side }, watch, reached)
    end

    --- The same along a path, a function of the share of the way (0 to 1).
    function words.follow(path, speed, watch, reached)
        side.hand:follow(path, speed)
        return carry_out(self, { side }, watch, reached)
    end
    return words
end

-- What a plan may do. The words of a hand are those of the leading hand; me.left has the same for the other one. There
-- is one pair of eyes, one foot and one attention. Everything that takes time waits until it is over.
local function make_me(self)
    local me = hand_words(self, self.right)
    me.left = hand_words(self, self.left)

    --- What is seen now: tools, landmarks, tip_brightness, reflex_brightness, pedal, power. nil before the first look.
    function me.see() return self.seen end

    function me.time_s() return self.time_s end

    --- What condition(seen) says of the picture now; nothing for a person who sees what goes wrong and leaves it so.
    function me.notices(condition)
        local seen = me.see()
        return self.recovers and seen and condition(seen) or nil
    end

    --- A quantity as this person really chooses it: about the value that the plan asks for.
    function me.about(value) return value * math.exp(self.person.planning_error * self.planning:normal()) end

    --- A direction [deg] as this person really takes it.
    function me.towards(direction)
        return direction + most_askew * self.person.planning_error * self.planning:normal()
    end

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

    --- Presses the foot: 0 up, 1 irrigation, 2 aspiration, 3 ultrasound; the fraction is travel within the position.
    function me.pedal(position) self.pedal_target = position end

    --- Waits until both hands are still, as me.go does for one.
    function me.together(watch, reached) return carry_out(self, { self.right, self.left }, watch, reached) end
    return me
end

-- The shaft goes through the wound; while the tip is still outside or close to it, it points as it did on the way in:
-- outwards and up.
local function shaft(wound, tip)
    if not wound then return vector.unit({ 0, -1, 0.5 }) end
    local across = math.sqrt(wound[1] * wound[1] + wound[2] * wound[2])
    local entry = vector.unit({ wound[1] / across, wound[2] / across, 0.5 })
    local out = vector.sub(wound, tip)
    local depth = vector.dot(out, entry)
    local turned = math.max(0, math.min(1, (depth - 0.5) / 1.5))
    if turned == 0 then return entry end
    return vector.unit(vector.mix(entry, vector.unit(out), turned))
end

local Operator = {}
Operator.__index = Operator

--- plan: function(me), run as a coroutine. seed: an integer. dt: [s]. habits: { recovers = false } for a person who
--- sees danger and does nothing about it.
function operator.start(plan, group, seed, dt, habits)
    local person = operator.person(group, seed)
    local function stream(purpose) return chance.stream(seed, purpose) end
    local self = setmetatable({ person = person, dt = dt, time_s = 0, pedal = 0, pedal_target = 0,
        recovers = not habits or habits.recovers ~= false,
        right = make_hand(stream, person, dt, "", "incision"),
        left = make_hand(stream, person, dt, "left ", "side_port"), planning = stream("planning"),
        look = perception.start(stream("perception"), person, dt, stream),
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

-- What one hand does in the coming step. The wound holds the shaft, wherever one believes it to be.
local function move(self, side, landmarks, orientation, pedal)
    local wound = landmarks[side.wound]
    local tip = vector.add(side.hand:advance(self.dt), side.tremble())
    return { present = side.present, position = tip, orientation = orientation(shaft(wound and wound.position, tip)),
        jaw = 0, pedal = pedal }
end

--- Takes the picture of now; returns what the leading hand with the foot, and what the other hand do in the coming
--- step: { present, position, orientation, jaw, pedal }.
function Operator:operate(percept)
    self.time_s = percept.time_s
    local seen = self.look(percept)
    if not self.inattentive() then
        self.seen = seen
        think(self)
    end
    press(self)
    return move(self, self.right, percept.landmarks, vector.orientation, self.pedal),
        move(self, self.left, percept.landmarks, vector.upright, 0)
end

return operator
