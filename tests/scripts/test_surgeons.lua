-- SPDX-License-Identifier: GPL-3.0-or-later
-- The model of a person who operates, against its own parameters.
local chance = require "surgeons.chance"
local groups = require "surgeons.groups"
local motion = require "surgeons.motion"
local operator = require "surgeons.operator"
local perception = require "surgeons.perception"
local support = require "support"
local tremor = require "surgeons.tremor"
local vector = require "surgeons.vector"

local case, equal, near = support.case, support.equal, support.near

local dt = 0.01

local function percept(t, x, brightness)
    return { time_s = t, tip_brightness = brightness or 0.2, reflex_brightness = 0.3, pedal = 0, power = 0,
        tools = { phaco = { present = true, position = { x, 0, 0 }, orientation = { 1, 0, 0, 0 } } },
        landmarks = { pupil = { position = { 0, 0, 1.5 }, size = 3.75 },
            incision = { position = { 0, -4.3, 2.7 }, size = 1.2 } } }
end

case("chance is the same for the same seed and purpose, and another for others", function()
    local function three(seed, purpose)
        local stream = chance.stream(seed, purpose)
        return ("%.17g %.17g %.17g"):format(stream:uniform(), stream:normal(), stream:normal())
    end
    equal(three(5, "x"), three(5, "x"))
    equal(three(5, "x") ~= three(6, "x"), true)
    equal(three(5, "x") ~= three(5, "y"), true)
    local stream, sum, square = chance.stream(1, "test"), 0, 0
    for _ = 1, 20000 do
        local value = stream:normal()
        sum, square = sum + value, square + value * value
    end
    near(sum / 20000, 0, 0.03, "mean")
    near(square / 20000, 1, 0.05, "variance")
end)

case("a minimum-jerk path starts and ends at rest and is fastest in the middle", function()
    equal(motion.minimum_jerk(0), 0)
    equal(motion.minimum_jerk(1), 1)
    near(motion.minimum_jerk(0.5), 0.5, 1e-12)
    near((motion.minimum_jerk(0.501) - motion.minimum_jerk(0.499)) / 0.002, 1.875, 1e-4)
    near(motion.minimum_jerk(1e-3), 0, 1e-7)
end)

case("a movement takes the time of its peak speed and misses by the aim error", function()
    local square, n = 0, 400
    local hand = motion.hand(chance.stream(3, "aim"), 0.05)
    for _ = 1, n do
        hand:put({ 0, 0, 0 })
        hand:move({ 10, 0, 0 }, 5)
        local steps, fastest, before = 0, 0, hand.place
        while hand:moving() do
            local place = hand:advance(dt)
            fastest = math.max(fastest, vector.distance(place, before) / dt)
            before, steps = place, steps + 1
        end
        near(steps * dt, 1.875 * 10 / 5, 2 * dt, "duration")
        near(fastest, 5, 1.2, "peak speed")
        square = square + (hand.place[1] - 10) ^ 2
    end
    near(math.sqrt(square / n), 0.5, 0.06, "spread along the way")
end)

case("a hand that is told to stop stops within 0.2 s and a short way", function()
    local hand = motion.hand(chance.stream(3, "aim"), 0)
    hand:put({ 0, 0, 0 })
    hand:move({ 10, 0, 0 }, 5)
    for _ = 1, 180 do hand:advance(dt) end
    local x = hand.place[1]
    hand:stop()
    for _ = 1, 20 do hand:advance(dt) end
    equal(hand:moving(), false)
    equal(hand.place[1] > x and hand.place[1] < x + 0.5, true, "way")
end)

-- Mean square of a signal in one frequency [Hz]: Goertzel's recurrence over all of it.
local function power_at(signal, hz)
    local w = 2 * math.pi * hz * dt
    local k, s1, s2 = 2 * math.cos(w), 0, 0
    for _, x in ipairs(signal) do s1, s2 = x + k * s1 - s2, s1 end
    return 2 * (s1 * s1 + s2 * s2 - k * s1 * s2) / (#signal * #signal)
end

case("tremor has the root mean square of its parameter, all of it between 8 and 12 Hz", function()
    local step = tremor.start(chance.stream(11, "tremor"), 0.2, dt)
    local axes, square, n = { {}, {}, {} }, 0, 6000
    for i = 1, n do
        local shift = step()
        for axis = 1, 3 do axes[axis][i] = shift[axis] end
        square = square + vector.dot(shift, shift)
    end
    near(math.sqrt(square / n), 0.2, 0.01, "root mean square [mm]")
    local inside, all = 0, 0
    for axis = 1, 3 do
        for i = 1, n // 2 - 1, 1 do
            local hz = i / (n * dt)
            local at_edge = hz > 7.8 and hz < 12.2
            if at_edge or i % 20 == 0 then
                local p = power_at(axes[axis], hz) * (at_edge and 1 or 20)
                all = all + p
                if at_edge then inside = inside + p end
            end
        end
    end
    equal(inside / all > 0.97, true, "share inside the band " .. inside / all)
end)

local function streams(seed) return function(purpose) return chance.stream(seed, purpose) end end

case("what is seen is late by the reaction time", function()
    local person = { reaction_s = 0.37, lateral_error_mm = 0, depth_error_mm = 0, brightness_error = 0, size_error = 0 }
    local see = perception.start(chance.stream(1, "p"), person, dt, streams(1))
    local noticed
    for i = 0, 200 do
        local t = i * dt
        local seen = see(percept(t, t >= 1 and 5 or 0))
        if seen and seen.tools.phaco.position[1] > 4 and not noticed then noticed = t end
    end
    near(noticed, 1.37, dt + 1e-9)
end)

case("places are misjudged by the parameters, and the misjudgement drifts slowly", function()
    local person = { reaction_s = 0, lateral_error_mm = 0.1, depth_error_mm = 0.4, brightness_error = 0.3,
        size_error = 0.1 }
    local see = perception.start(chance.stream(2, "p"), person, dt, streams(2))
    local lateral, depth, bright, jump, before, n = 0, 0, 0, 0, nil, 60000
    for i = 0, n - 1 do
        local seen = see(percept(i * dt, 0, 0.5))
        local place = seen.tools.phaco.position
        lateral, depth = lateral + place[1] ^ 2, depth + place[3] ^ 2
        bright = bright + math.log(seen.tip_brightness / 0.5) ^ 2
        jump = jump + (before and (place[3] - before) ^ 2 or 0)
        before = place[3]
    end
    near(math.sqrt(lateral / n), 0.1, 0.02, "across")
    near(math.sqrt(depth / n), 0.4, 0.08, "along")
    near(math.sqrt(bright / n), 0.3, 0.06, "brightness")
    equal(math.sqrt(jump / n) < 0.05, true, "from step to step")
end)

case("sizes are misjudged in proportion, hardness by the finger, and what is counted is exact", function()
    local person = { reaction_s = 0, lateral_error_mm = 0, depth_error_mm = 0, brightness_error = 0, size_error = 0.1,
        palpation_error = 0.3 }
    local see = perception.start(chance.stream(2, "p"), person, dt, streams(2))
    local shown = { hardness = 20, stitches = 2, viscoelastic = 0.5, capsulorhexis = 2.6, surface_at_tip = 0 }
    local square, n = { hardness = 0, viscoelastic = 0, capsulorhexis = 0 }, 60000
    for i = 0, n - 1 do
        local raw = percept(i * dt, 0)
        for name, size in pairs(shown) do raw.landmarks[name] = { position = { 0, 0, 0 }, size = size } end
        local marks = see(raw).landmarks
        for name, sum in pairs(square) do square[name] = sum + math.log(marks[name].size / shown[name]) ^ 2 end
        equal(marks.stitches.size, 2)
        equal(marks.surface_at_tip.size, 0)
    end
    near(math.sqrt(square.viscoelastic / n), 0.1, 0.02, "a share")
    near(math.sqrt(square.capsulorhexis / n), 0.1, 0.02, "a radius")
    near(math.sqrt(square.hardness / n), 0.3, 0.06, "by touch")
end)

local names = { "phaco", "spatula" }

local function samples_of(seed, group, plan, n)
    local person = operator.start(plan, group, seed, dt, names)
    local texts = {}
    for i = 0, n - 1 do
        local s = person:operate(percept(i * dt, 0))[1]
        texts[#texts + 1] = ("%.17g %.17g %.17g %.17g"):format(s.position[1], s.position[2], s.position[3], s.pedal)
    end
    return table.concat(texts, "\n")
end

local function to_and_fro(me)
    me.wait_until(function(seen) return seen end)
    me.take_up({ 0, -6, 3 })
    for _ = 1, 3 do
        me.pedal(3)
        me.go({ 0, 2, 1 }, me.about(4))
        me.pedal(1)
        me.go({ 0, -1, 1 }, 6)
    end
end

case("a surgeon does the same again with the same seed, and something else with another", function()
    equal(samples_of(7, "a", to_and_fro, 500), samples_of(7, "a", to_and_fro, 500))
    equal(samples_of(7, "a", to_and_fro, 500) ~= samples_of(8, "a", to_and_fro, 500), true)
    equal(samples_of(7, "a", to_and_fro, 500) ~= samples_of(7, "d", to_and_fro, 500), true)
end)

case("a hand puts one instrument down and takes up another, and moves its fingers at a finite speed", function()
    local function plan(me)
        me.wait_until(function(seen) return seen end)
        me.take_up({ 0, -6, 3 }, "forceps")
        me.jaw(1)
        me.wait(1)
        me.put_down()
        me.take_up({ 0, -6, 3 }, "cannula")
    end
    local person = operator.start(plan, "d", 4, dt, { "cystotome", "forceps", "cannula" })
    local jaws, together = {}, 0
    for i = 0, 200 do
        local samples = person:operate(percept(i * dt, 0))
        local present = 0
        for _, sample in ipairs(samples) do present = present + (sample.present and 1 or 0) end
        together = math.max(together, present)
        equal(samples[1].present, false, "nobody took the cystotome up")
        if samples[2].present then jaws[#jaws + 1] = samples[2].jaw end
    end
    equal(together, 1, "one hand, one instrument")
    near(jaws[2] - jaws[1], 4 * dt, 1e-9, "per step")
    near(jaws[#jaws], 1, 1e-9)
    equal(pcall(function()
        operator.start(function(me) me.take_up({ 0, 0, 0 }, "spoon") end, "d", 4, dt, names):operate(percept(0, 0))
    end), false, "an instrument that is not there")
end)

case("the leading hand may take up what the other one would hold, and has it", function()
    local person = operator.start(function(me)
        me.take_up({ 5, 0, 3 }, "capsule_hook", "side_port")
        me.wait(1)
    end, "d", 4, dt, { "phaco", "capsule_hook" })
    local samples
    for step = 1, 50 do samples = person:operate(percept(step * dt, 0)) end
    equal(samples[1].present, false)
    equal(samples[2].present, true)
end)

case("a plan that draws numbers of its own changes nothing else", function()
    local function dice(me)
        for _ = 1, 10 do math.random() end
        to_and_fro(me)
    end
    equal(samples_of(7, "b", dice, 300), samples_of(7, "b", to_and_fro, 300))
end)

case("a plan sees late pictures only and nothing else of the world", function()
    local first, found = nil, {}
    local function plan(me)
        me.wait_until(function(seen) return seen end)
        first = me.time_s() - me.see().time_s
        for _, words in ipairs({ me, me.left }) do
            for name, value in pairs(words) do
                if type(value) ~= "function" and name ~= "left" then found[#found + 1] = name end
            end
        end
    end
    local person = operator.start(plan, "d", 4, dt, names)
    for i = 0, 200 do person:operate(percept(i * dt, 0)) end
    near(first, person.person.reaction_s, dt + 1e-9, "age of the first picture")
    equal(#found, 0, "values within reach: " .. table.concat(found, ", "))
end)

case("the shaft passes the wound once the tip is inside, and an orientation is a unit quaternion", function()
    local person
    person = operator.start(function(me)
        me.take_up({ 0, -6.5, 3.7 })
        me.go({ 0.5, 2, 0 }, 20)
    end, "d", 4, dt, names)
    for i = 0, 400 do
        local s = person:operate(percept(i * dt, 0))[1]
        local q = s.orientation
        near(q[1] ^ 2 + q[2] ^ 2 + q[3] ^ 2 + q[4] ^ 2, 1, 1e-9)
        if i > 300 then
            local z = { 2 * (q[2] * q[4] + q[1] * q[3]), 2 * (q[3] * q[4] - q[1] * q[2]),
                1 - 2 * (q[2] ^ 2 + q[3] ^ 2) }
            local to_wound = vector.sub({ 0, -4.3, 2.7 }, s.position)
            near(vector.norm(vector.cross(z, to_wound)), 0, 1e-9, "wound off the shaft")
            equal(vector.dot(z, to_wound) > 0, true, "the hand is outside")
        end
    end
end)

local function two_handed(t)
    local seen = percept(t, 0)
    seen.tools.spatula = { present = true, position = { -1, 0, 2 }, orientation = { 1, 0, 0, 0 } }
    seen.landmarks.side_port = { position = { -4.2, -0.7, 2.7 }, size = 0.5 }
    return seen
end

-- What one hand did over n steps, as a text.
local function way_of(which, plan, picture, n, habits)
    local person = operator.start(plan, "a", 7, dt, names, habits)
    local texts = {}
    for i = 0, n - 1 do
        local s = person:operate(picture(i * dt))[which]
        texts[#texts + 1] = ("%s %.17g %.17g %.17g %.17g"):format(s.present, s.position[1], s.position[2],
            s.position[3], s.pedal)
    end
    return table.concat(texts, "\n")
end

local function with_both(me)
    me.wait_until(function(seen) return seen end)
    me.take_up({ 0, -6, 3 })
    me.left.take_up({ -6, -1, 3 })
    for _ = 1, 3 do
        me.pedal(3)
        me.left.begin(function(share) return { -6 + 5 * share, 0, 2 } end, 3)
        me.go({ 0, 2, 1 }, me.about(4))
        me.pedal(1)
        me.go({ 0, -1, 1 }, 6)
        me.together()
    end
end

case("the other hand has chances of its own: what the leading hand does is the same with and without it", function()
    local function leading_only(me)
        me.left = { take_up = function() end, begin = function() end }
        me.together = function() end
        with_both(me)
    end
    equal(way_of(1, with_both, two_handed, 200), way_of(1, leading_only, function(t) return percept(t, 0) end, 200))
    equal(way_of(2, with_both, two_handed, 200) ~= way_of(1, with_both, two_handed, 200), true)
end)

case("both hands move at once, the foot goes with the leading one, and the other shaft passes the side port", function()
    local person = operator.start(with_both, "d", 3, dt, names)
    local moved_at_once, before_right, before_left = 0, nil, nil
    for i = 0, 300 do
        local right, left = table.unpack((person:operate(two_handed(i * dt))))
        if before_right then
            local a, b = vector.distance(right.position, before_right), vector.distance(left.position, before_left)
            if a > 0.02 and b > 0.02 and a < 1 and b < 1 then moved_at_once = moved_at_once + 1 end
        end
        before_right, before_left = right.position, left.position
        equal(left.pedal, 0)
    end
    equal(moved_at_once > 50, true, "steps in which both moved: " .. moved_at_once)
    local left = person:operate(two_handed(301 * dt))[2]
    local q = left.orientation
    local z = { 2 * (q[2] * q[4] + q[1] * q[3]), 2 * (q[3] * q[4] - q[1] * q[2]), 1 - 2 * (q[2] ^ 2 + q[3] ^ 2) }
    local y = { 2 * (q[2] * q[3] - q[1] * q[4]), 1 - 2 * (q[2] ^ 2 + q[4] ^ 2), 2 * (q[3] * q[4] + q[1] * q[2]) }
    local to_wound = vector.sub({ -4.2, -0.7, 2.7 }, left.position)
    near(vector.norm(vector.cross(z, to_wound)), 0, 1e-9, "wound off the shaft")
    equal(y[3] > 0.5, true, "its bent end points down")
end)

case("who does not react to danger goes on, but still stops where a movement has reached its purpose", function()
    local function plan(me)
        me.wait_until(function(seen) return seen end)
        me.take_up({ 0, 0, 0 })
        local reason = me.go({ 10, 0, 0 }, 5, function(seen) return seen.time_s > 1 and "danger" end,
            function(seen) return seen.time_s > 2 end)
        me.take_up({ reason == "danger" and 1 or reason == "reached" and 2 or 3, 0, 0 })
    end
    local function last_x(habits)
        local person = operator.start(plan, "d", 5, dt, names, habits)
        local x
        for i = 0, 400 do x = person:operate(percept(i * dt, 0))[1].position[1] end
        return math.floor(x + 0.5)
    end
    equal(last_x(nil), 1)
    equal(last_x({ recovers = true }), 1)
    equal(last_x({ recovers = false }), 2)
end)

case("marks that come and go do not change how the rest is seen", function()
    local person = { reaction_s = 0, lateral_error_mm = 0.1, depth_error_mm = 0.4, brightness_error = 0.3,
        size_error = 0.1 }
    local function tip_after(with_marks)
        local see = perception.start(chance.stream(2, "p"), person, dt, streams(2))
        local seen
        for i = 0, 300 do
            local raw = percept(i * dt, 0, 0.5)
            if with_marks and i > 100 then raw.landmarks.groove_1_start = { position = { 0, -2, 1 }, size = 1 } end
            seen = see(raw)
        end
        return ("%.17g"):format(seen.tools.phaco.position[1]), seen.landmarks.groove_1_start
    end
    local plain = tip_after(false)
    local marked, mark = tip_after(true)
    equal(plain, marked)
    equal(mark.position[2] ~= -2 and mark.size ~= 1, true, "misjudged like everything else")
end)

case("people of a group vary about its parameters, and the groups keep their order", function()
    for _, parameter in ipairs(groups.parameters) do
        local means = {}
        for _, group in ipairs(groups.names) do
            local sum = 0
            for seed = 1, 60 do sum = sum + operator.person(group, seed)[parameter.name] end
            means[#means + 1] = sum / 60
            near(sum / 60 / parameter[group], 1, 0.08, parameter.name .. " of " .. group)
        end
        for i = 2, 4 do equal(means[i] < means[i - 1], true, parameter.name) end
        equal(#parameter.source > 0, true)
    end
end)
