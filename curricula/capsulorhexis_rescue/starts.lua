-- SPDX-License-Identifier: GPL-3.0-or-later
-- States of this exercise to start from. They are made when they are asked for.

-- A place by its distance from the middle [mm], angle [degrees, 0 to the surgeon's right, 90 away from the surgeon] and
-- height over the front of the lens [mm], as it is in a full chamber.
local function place(radius, angle, height)
    local a = math.rad(angle)
    local front = 1.878 * math.sqrt(math.max(0, 1 - (radius / 4.82) ^ 2))
    return { radius * math.cos(a), radius * math.sin(a), front + height }
end

local cut_end = 110

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

-- Held near the end of the tear and led on along a circle close to the iris; false if nothing was held.
local function lead_on(t, cut_turned, stop)
    local radius = t:value("rhexis.tip_radius_mm")
    local angle = cut_end + t:value("rhexis.turned_deg") - cut_turned
    local z = t:value("lens.lift_mm")
    for try = 0, 3 do
        t.forceps:jaw(1)
        t:wait(0.1)
        t.forceps:move_to(place(radius - 0.4, angle - 12 - 4 * try, 0.7 + z), { speed = 12 })
        t.forceps:move_to(place(radius - 0.4, angle - 12 - 4 * try, 0.05 - 0.1 * try + z), { speed = 3 })
        t.forceps:jaw(0)
        t:wait(0.15)
        if t:value("forceps.holding") then break end
    end
    local way = {}
    for i = 1, 10 do way[i] = place(3.2, angle - 10 + 6 * i, 0.2 + z) end
    local stopped = t.forceps:path(way, { speed = 2, motion = "even", stop = stop })
    t.forceps:jaw(1)
    t:wait(0.1)
    t.forceps:move_by({ 0, 0, 0.3 }, { speed = 8 })
    return stopped
end

-- Led as in a deep chamber, in a shallow one: the capsule takes the tear outwards.
local function run_out(t)
    begin_flap(t)
    local cut_turned = t:value("rhexis.turned_deg")
    t.forceps:enter({ speed = 20 })
    for _ = 1, 8 do
        if lead_on(t, cut_turned, "rhexis.tip_radius_mm > goal.radius_mm + 0.6") then break end
    end
    t.forceps:withdraw({ speed = 20 })
end

return starts {
    begin = { run_out },
}
