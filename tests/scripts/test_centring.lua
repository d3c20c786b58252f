-- SPDX-License-Identifier: GPL-3.0-or-later
-- How a virtual surgeon brings the eye into the field and into focus, with a microscope of a few lines.
local centring = require "surgeons.centring"
local chance = require "surgeons.chance"
local operator = require "surgeons.operator"
local perception = require "surgeons.perception"
local support = require "support"

local case, equal, near = support.case, support.equal, support.near

local dt = 0.01
local names = { "cystotome", "microscope" }
local pupil_z = 1.5

local function percept(t, at)
    local field = at and { position = { at[1], at[2], at[3] }, radius = 7.3,
        out_of_focus_mm = math.max(0, math.abs(at[3] - pupil_z) - 0.7) }
    return { time_s = t, tip_brightness = 0, reflex_brightness = 0, pedal = 0, power = 0, tools = {}, field = field,
        landmarks = { pupil = { position = { 0, 0, pupil_z }, size = 3.75 },
            incision = { position = { 0, -4.3, 2.7 }, size = 1.2 } } }
end

-- As far towards a value as a motor gets in a step.
local function towards(value, target, most) return value + math.max(-most, math.min(most, target - value)) end

-- Lets a person follow a plan from where the microscope stands; gives where it stands at the end, and the time.
local function stands_after(plan, group, seed, at)
    local person = operator.start(plan, group, seed, dt, names)
    local t = 0
    while not person:done() and t < 60 do
        local foot = person:operate(percept(t, at))[2]
        if foot.present then
            for axis = 1, 3 do at[axis] = towards(at[axis], foot.position[axis], (axis < 3 and 4 or 2) * dt) end
        end
        t = t + dt
    end
    equal(person:done(), true, "the plan ends")
    return at, t
end

local function off_centre(group)
    local sum = 0
    for seed = 1, 24 do
        local at = stands_after(centring.centre, group, seed, { 1.6, 1.2, pupil_z + 2 })
        sum = sum + math.sqrt(at[1] ^ 2 + at[2] ^ 2)
        near(at[3], pupil_z, 0.7, "focus of seed " .. seed)
    end
    return sum / 24
end

case("everybody gets the pupil sharp, and a novice leaves it about twice as far from the middle", function()
    local novice, expert = off_centre("a"), off_centre("d")
    equal(novice / expert > 1.6 and novice / expert < 2.5, true, ("%.2f mm against %.2f mm"):format(novice, expert))
end)

case("one who is focused too low finds it as well", function()
    near(stands_after(centring.centre, "d", 4, { 0, 0, pupil_z - 4 })[3], pupil_z, 0.7)
end)

case("nobody moves what is well centred and sharp; in between only what is far off", function()
    local at = stands_after(centring.centre, "a", 3, { 0.1, 0.1, pupil_z })
    equal(at[1] == 0.1 and at[2] == 0.1 and at[3] == pupil_z, true)
    at = stands_after(centring.keep, "a", 3, { 1.2, 0, pupil_z })
    equal(at[1] == 1.2 and at[2] == 0, true)
    at = stands_after(centring.keep, "d", 3, { 5, 0, pupil_z })
    equal(at[1] < 3, true)
end)

case("a microscope that cannot go where it is sent holds nobody up", function()
    local person = operator.start(function(me) me.microscope.move_by({ 99, 0, 0 }) end, "d", 1, dt, names)
    for i = 0, 5 do person:operate(percept(i * dt, { 0, 0, 0 })) end
    equal(person:done(), true)
end)

case("without a microscope there is nothing to do, and what is seen is not changed by one that is focused", function()
    local person = operator.start(function(me)
        equal(me.microscope, nil)
        centring.centre(me)
    end, "d", 1, dt, { "cystotome" })
    person:operate(percept(0))
    equal(person:done(), true)
    local someone = { reaction_s = 0, lateral_error_mm = 0.1, depth_error_mm = 0.4, brightness_error = 0.3,
        size_error = 0.1 }
    local function pupil_seen(at)
        local see = perception.start(chance.stream(2, "p"), someone, dt,
            function(purpose) return chance.stream(2, purpose) end)
        return see(percept(0, at)).landmarks.pupil.position
    end
    equal(pupil_seen({ 0, 0, pupil_z })[1], pupil_seen(nil)[1])
    near(pupil_seen({ 0, 0, pupil_z + 2.7 })[1] / pupil_seen(nil)[1], 3, 1e-12, "2 mm beyond the depth of field")
end)

case("how high the microscope is focused is not seen", function()
    local someone = { reaction_s = 0, lateral_error_mm = 0, depth_error_mm = 0, brightness_error = 0, size_error = 0 }
    local see = perception.start(chance.stream(2, "p"), someone, dt,
        function(purpose) return chance.stream(2, purpose) end)
    local field = see(percept(0, { 1, 2, 5 })).field
    equal(field.position[2], 2)
    equal(field.position[3], nil)
    near(field.out_of_focus_mm, 2.8, 1e-12)
end)
