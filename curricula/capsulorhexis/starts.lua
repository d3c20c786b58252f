-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

-- A place by its distance from the middle [mm], angle [degrees, 0 to the surgeon's right, 90 away from the surgeon] and
-- height over the front of the lens [mm], as it is in a full chamber.
local function place(radius, angle, height)
    local a = math.rad(angle)
    local front = 1.878 * math.sqrt(math.max(0, 1 - (radius / 4.82) ^ 2))
    return { radius * math.cos(a), radius * math.sin(a), front + height }
end

-- Through the capsule, outwards to the planned circle, and a quarter of the way round along it.
local function begin_flap(t)
    t.cystotome:enter()
    local z = t:value("lens.lift_mm")
    t.cystotome:move_to(place(0.9, -10, 0.5 + z), { speed = 12 })
    t.cystotome:move_to(place(0.9, -10, -0.4 + z), { speed = 2 })
    local way = {}
    for i = 1, 12 do way[i] = place(math.min(2.55, 0.9 + 1.65 * i / 7), -10 + 10 * i, -0.4 + z) end
    t.cystotome:path(way, { speed = 1.3, motion = "even" })
    t.cystotome:move_to(place(2.55, 110, 0.8 + z), { speed = 8 })
    t.cystotome:withdraw({ speed = 20 })
end

return starts {
    flap = { set = { ["viscoelastic.fill"] = 1 }, begin_flap },
    shallow = { set = { ["viscoelastic.fill"] = 0.3, ["vitreous.pressure_mmhg"] = 20,
        ["capsule.toughness"] = 0.6 }, begin_flap },
    brittle = { set = { ["viscoelastic.fill"] = 0.7, ["vitreous.pressure_mmhg"] = 20,
        ["capsule.toughness"] = 0.2 }, begin_flap },
}
