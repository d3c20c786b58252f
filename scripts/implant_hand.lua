-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an exact hand does with an implant and its injector, for starts and scenarios of the exercises that share it. It
-- knows the measures, which no surgeon does.

local implant_hand = {}

--- A thin lens in a narrow cartridge, its haptics tucked: it comes out short, and costs half as much to simulate as the
--- exercise's own.
implant_hand.thin = { ["implant.centre_mm"] = 0.6, ["implant.edge_mm"] = 0.2, ["cartridge.tucked"] = 1,
    ["cartridge.bore_mm"] = 2.35, ["cartridge.nozzle_mm"] = 2.35 }

--- The same with other settings besides.
function implant_hand.thin_with(set)
    for name, value in pairs(implant_hand.thin) do set[name] = value end
    return set
end

--- The exercise's own lens, of a material whose surfaces stick to each other so strongly [kPa].
function implant_hand.sticky(kpa) return { ["implant.tackiness_kpa"] = kpa } end

local stroke = 0.18    -- of the plunger, share per second
local at_once = 0.3    -- of its stroke: before that it does not meet the implant
local look_s = 0.02

--- Brings the injector's mouth to a place. turned: about its shaft [degrees].
function implant_hand.bring(t, place, turned)
    t.injector:turn(turned or 0)
    t.injector:enter({ speed = 10 })
    t.injector:move_to(place, { speed = 6 })
end

--- Pushes the plunger until test() is true, or it is home.
function implant_hand.push(t, test)
    local pushed = at_once
    t.injector:jaw(pushed)
    t:wait(0.5)
    while pushed < 1 and not test() do
        pushed = math.min(1, pushed + stroke * look_s)
        t.injector:jaw(pushed)
        t:wait(look_s)
    end
end

-- What is left in the injector, which stays so long [s] and leaves.
local function push_out(t, stays)
    implant_hand.push(t, function() return t:value("implant.released") end)
    t:wait(stays)
    t.injector:jaw(0)
    t.injector:withdraw({ speed = 10 })
end

--- All of the implant, with the mouth at a place, and the injector out of the eye.
function implant_hand.inject(t, place, turned)
    implant_hand.bring(t, place, turned)
    push_out(t, 0)
end

--- All of it from two places: until most of it is out with the mouth at the first, the rest at the second, where the
--- mouth stays so long [s] before the injector leaves.
function implant_hand.inject_from_two(t, first, second, stays)
    implant_hand.bring(t, first)
    implant_hand.push(t, function() return t:value("implant.delivered") > 0.63 end)
    t.injector:move_to(second, { speed = 5 })
    push_out(t, stays)
end

-- Faster than a surgeon: what is tested is where they lead the haptic.
local free = { speed = 17.6, motion = "even" }
local slow = { speed = 8, motion = "even" }

-- Lens forceps on a place, from above; what they hold is lifted a little.
local function take(t, place)
    local x, y, z = table.unpack(place)
    t.lens_forceps:jaw(1)
    t.lens_forceps:move_to({ x, y, z + 0.8 }, free)
    t.lens_forceps:move_to(place, free)
    t.lens_forceps:jaw(0)
    t:wait(0.2)
    t.lens_forceps:move_by({ 0, 0, 0.6 }, slow)
end

local function let_go(t)
    t.lens_forceps:jaw(1)
    t:wait(0.1)
    t.lens_forceps:move_by({ 0, 0, 1 }, free)
end

--- The arm of a trailing haptic that lies before the rim, as in the start "trailing_out": drawn in by its middle, then
--- by its elbow until all of it is within the rim, pressed down there and led back behind the rim. middle, elbow: where
--- it is taken; the elbow after it has been drawn in.
function implant_hand.tuck_in(t, middle, elbow)
    t.lens_forceps:enter({ speed = 50 })
    take(t, middle)
    t.lens_forceps:move_to({ 0.2, 1.2, 0.7 }, slow)
    t:wait(0.3)
    let_go(t)
    take(t, elbow)
    t.lens_forceps:move_to({ 0.3, 1.5, 0.6 }, slow)
    t.lens_forceps:move_to({ 0.3, 1.5, -1.7 }, slow)
    t:wait(0.3)
    t.lens_forceps:move_to({ 0.4, -0.9, -1.7 }, slow)
    let_go(t)
    t.lens_forceps:move_to({ 0, 0, 1.6 }, free)
    t.lens_forceps:withdraw({ speed = 50 })
end

--- An implant that lies upside down in the bag, as in the start "upside_down", while it unfolds: taken by its edge on
--- the right, and turned over by drawing that edge up and across to the left and letting it down there. meanwhile: what
--- is done while the forceps hold it, before it is turned.
function implant_hand.turn_over(t, meanwhile)
    local turning = { speed = 4, motion = "even" }
    t.lens_forceps:enter({ speed = 50 })
    t.lens_forceps:jaw(1)
    t.lens_forceps:move_to({ 2.0, 0.8, 1.0 }, { speed = 17 })
    t.lens_forceps:move_to({ 2.0, 0.8, 0.0 }, { speed = 10 })
    t.lens_forceps:jaw(0)
    t:wait(0.1)
    meanwhile()
    t.lens_forceps:move_to({ 1.9, 0.9, 2.4 }, turning)
    t.lens_forceps:move_to({ 0.5, 1.1, 2.9 }, turning)
    t.lens_forceps:move_to({ -0.9, 1.1, 2.8 }, turning)
    t.lens_forceps:move_to({ -2.0, 0.9, 1.2 }, turning)
    t.lens_forceps:move_to({ -2.2, 0.8, 0.2 }, turning)
    let_go(t)
    t.lens_forceps:withdraw({ speed = 50 })
end

return implant_hand
