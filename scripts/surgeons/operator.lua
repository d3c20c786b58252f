-- SPDX-License-Identifier: GPL-3.0-or-later
-- A person who operates: perception, hand, foot and attention with the parameters of one group. A plan says what the
-- person intends; it runs as a coroutine and sees only `me`, below.

local chance = require "surgeons.chance"
local groups = require "surgeons.groups"
local instruments = require "surgeons.instruments"
local microscope = require "surgeons.microscope"
local motion = require "surgeons.motion"
local perception = require "surgeons.perception"
local requests = require "engine.requests"
local tremor = require "surgeons.tremor"
local vector = require "surgeons.vector"

local operator = {}

local most_askew = 15  -- spread of a chosen direction for a planning error of 1 [deg]; proposal
local pedal_rate = 8  -- travel of the foot, pedal positions per second; proposal
local jaw_rate = 4    -- of the fingers, openings per second; proposal
local turn_rate = 180  -- of an instrument between the fingers, degrees per second; proposal

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

-- One hand: `name` begins the names of its streams of chance, `instrument` is what it holds at first, or nil.
local function make_hand(stream, person, dt, name, instrument)
    return { present = false, instrument = instrument, jaw = 0, jaw_target = 0, jaw_rate = jaw_rate,
        turned = 0, turn_target = 0, hand = motion.hand(stream(name .. "aim"), person.aim_error),
        tremble = tremor.start(stream(name .. "tremor"), person.tremor_um * 1e-3, dt) }
end

-- The first instrument for each hand: the leading one works through the main incision, the other one through a side
-- port.
local function first_for(names, side_port)
    for _, name in ipairs(names) do
        if (instruments.held(name).wound == "side_port") == side_port then return name end
    end
    return nil
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
    --- instrument: by name, when it is another one than before. wound: landmark of another wound than it goes through
    --- otherwise.
    function words.take_up(place, instrument, wound)
        if instrument and not self.index[instrument] then
            error(("take_up: the scene has no instrument '%s'"):format(instrument), 2)
        end
        side.instrument = instrument or side.instrument
        side.wound = wound
        side.present, side.jaw, side.jaw_target = true, 0, 0
        side.turned, side.turn_target = 0, 0
        side.hand:put(place)
    end

    --- Moves the fingers: opening of the jaws of forceps, 0 closed to 1 open; how hard a syringe is pressed, 0 to 1;
    --- how far the plunger of an injector is pushed, 0 to 1. rate: how fast, per second; else as fast as fingers do.
    function words.jaw(opening, rate) side.jaw_target, side.jaw_rate = opening, rate or jaw_rate end

    --- Rolls the instrument between the fingers: degrees about its shaft from how hands hold it, anticlockwise as seen
    --- from the hand.
    function words.turn(degrees) side.turn_target = degrees end

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

-- What a plan may do with the foot that moves the microscope.
local function foot_words(self)
    local foot = self.foot
    local function push(shift)
        foot:push(shift)
        while foot:moving() do coroutine.yield() end
    end
    return {
        --- Begins to move it by { x, y, z } [mm], and does not wait for its end.
        begin = function(shift) foot:push(shift) end,

        --- Moves it by { x, y, z } [mm].
        move_by = push,

        --- Moves it until a place that is seen is in the middle of the field, as this person finds the middle.
        centre_on = function(place) push(foot:shift_to(place, self.seen.field)) end,
    }
end

-- What a plan may do. The words of a hand are those of the leading hand; me.left has the same for the other one. There
-- is one pair of eyes, one foot and one attention. Everything that takes time waits until it is over.
local function make_me(self)
    local me = hand_words(self, self.right)
    me.left = hand_words(self, self.left)
    me.microscope = self.foot and foot_words(self)  -- nil where the scene has none

    --- What is seen now: tools, landmarks, field, tip_brightness, reflex_brightness, pedal, power. nil before the first
    --- look.
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

    --- Asks the staff for something, or declares it, by its name in the exercise.
    function me.request(name)
        local id, complaint = requests.find(self.requests, name)
        if not id then error(complaint, 2) end
        table.insert(self.asked, requests.command(id))
    end

    --- Names of the instruments for the hands, in the scene's order.
    function me.instruments() return { table.unpack(self.names) } end

    --- Waits until both hands are still, as me.go does for one.
    function me.together(watch, reached) return carry_out(self, { self.right, self.left }, watch, reached) end
    return me
end

local Operator = {}
Operator.__index = Operator

--- plan: function(me), run as a coroutine. seed: an integer. dt: [s]. names: of the instruments, in the scene's order.
--- habits: { recovers = false } for a person who sees danger and does nothing about it. declared: what may be asked of
--- the staff, list of { id, title, name }.
function operator.start(plan, group, seed, dt, names, habits, declared)
    local person = operator.person(group, seed)
    local function stream(purpose) return chance.stream(seed, purpose) end
    local hands, has_microscope = microscope.apart_from(names)
    local self = setmetatable({ person = person, dt = dt, time_s = 0, pedal = 0, pedal_target = 0,
        recovers = not habits or habits.recovers ~= false, names = hands, index = {},
        requests = declared or {}, asked = {},
        foot = has_microscope and microscope.foot(stream("centring"), person.centring_mm) or nil,
        right = make_hand(stream, person, dt, "", first_for(hands, false)),
        left = make_hand(stream, person, dt, "left ", first_for(hands, true)), planning = stream("planning"),
        look = perception.start(stream("perception"), person, dt, stream),
        inattentive = attention(stream("attention"), person, dt) }, Operator)
    for i, name in ipairs(hands) do self.index[name] = i end
    local me = make_me(self)
    self.thread = coroutine.create(function() plan(me) end)
    return self
end

local function think(self)
    if coroutine.status(self.thread) == "dead" then return end
    local ok, message = coroutine.resume(self.thread)
    if not ok then error(message, 0) end
end

-- As far towards a target as a rate allows in a step.
local function towards(value, target, most) return value + math.max(-most, math.min(most, target - value)) end

--- The plan has run to its end.
function Operator:done() return coroutine.status(self.thread) == "dead" end

-- The wound holds the shaft, wherever one believes it to be; but an eye that can roll gives way to the hand, so that
-- the shaft goes where one believes the wound to be.
local function wound_of(self, name, landmarks)
    local believed = landmarks.limbus and self.seen and self.seen.landmarks[name]
    return believed or landmarks[name]
end

-- What one hand does in the coming step.
local function move(self, side, landmarks, pedal)
    local hold = instruments.held(side.instrument)
    local wound = wound_of(self, side.wound or hold.wound, landmarks)
    local tip = vector.add(side.hand:advance(self.dt), side.tremble())
    side.jaw = towards(side.jaw, side.jaw_target, side.jaw_rate * self.dt)
    side.turned = towards(side.turned, side.turn_target, turn_rate * self.dt)
    return { present = side.present, position = tip, jaw = side.jaw,
        orientation = instruments.orientation(hold, wound and wound.position, tip, side.turned), pedal = pedal }
end

local function put_away()
    return { present = false, position = { 0, 0, 0 }, orientation = { 1, 0, 0, 0 }, jaw = 0, pedal = 0 }
end

--- Takes the picture of now; returns what each instrument does in the coming step, in the scene's order:
--- { present, position, orientation, jaw, pedal }, and what is asked of the staff in it: commands.
function Operator:operate(percept)
    self.time_s, self.asked = percept.time_s, {}
    local seen = self.look(percept)
    if not self.inattentive() then
        self.seen = seen
        think(self)
    end
    self.pedal = towards(self.pedal, self.pedal_target, pedal_rate * self.dt)
    local samples = {}
    for i in ipairs(self.names) do samples[i] = put_away() end
    local right, left = self.index[self.right.instrument], self.index[self.left.instrument]
    if right then samples[right] = move(self, self.right, percept.landmarks, self.pedal) end
    if left then
        local sample = move(self, self.left, percept.landmarks, 0)
        -- What the leading hand has taken up is not in the other one, which would have held it.
        if left ~= right or self.left.present then samples[left] = sample end
    end
    if self.foot then samples[#samples + 1] = self.foot:sample(percept.field) end
    return samples, self.asked
end

return operator
