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

--- The same of a material whose surfaces stick to each other so strongly [kPa].
function implant_hand.tacky(kpa) return implant_hand
