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

--- All of the implant, with the mouth at a place, and the injector out of the eye.
function implant_hand.inject(t, place, turned)
    implant_hand.bring(t, place, turned)
    implant_hand.push(t, function() return t:value("implant.released") end)
    t.injector:jaw(0)
    t.injector:withdraw({ speed = 10 })
end

return implant_hand
