-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an exact hand does to open the anterior capsule, for starts and scenarios of the exercises that share it. It
-- knows the measures, which no surgeon does. The tear goes round against the clock.

local rhexis_hand = {}

--- A place by its distance from the middle [mm], angle [degrees, 0 to the surgeon's right, 90 away from the
--- surgeon] and height over the front of the lens [mm]. lift: of the lens (lens.lift_mm), 0 in a full chamber [mm].
function rhexis_hand.place(radius, angle, height, lift)
    local a = math.rad(angle)
    local front = 1.878 * math.sqrt(math.max(0, 1 - (radius / 4.82) ^ 2)) + (lift or 0)
    return { radius * math.cos(a), radius * math.sin(a), front + height }
end

local place = rhexis_hand.place

--- With the needle: through the capsule, outwards to the planned circle, and a quarter of the way round along it.
function rhexis_hand.begin_flap(t)
    t.cystotome:enter()
    local lift = t:value("lens.lift_mm")
    t.cystotome:move_to(place(0.9, -10, 0.5, lift), { speed = 12 })
    t.cystotome:move_to(place(0.9, -10, -0.4, lift), { speed = 2 })
    local way = {}
    for i = 1, 12 do way[i] = place(math.min(2.55, 0.9 + 1.65 * i / 7), -10 + 10 * i, -0.4, lift) end
    t.cystotome:path(way, { speed = 1.3, motion = "even" })
    t.cystotome:move_to(place(2.55, 110, 0.8, lift), { speed = 8 })
    t.cystotome:withdraw({ speed = 20 })
end

--- Of the end of the tear, its distance from the middle [mm] and its angle [degrees]; and the lift of the lens [mm].
function rhexis_hand.tear_end(t)
    return t:value("rhexis.tip_radius_mm"), t:value("rhexis.tip_angle_deg"), t:value("lens.lift_mm")
end

--- A place by the tear: from its end so far ahead, the way it goes, and so far aside, into the flap [mm], at a height
--- over the front of the lens [mm].
function rhexis_hand.by_tear(t, ahead, aside, height)
    local radius, angle, lift = rhexis_hand.tear_end(t)
    local a = math.rad(angle)
    local way = a + math.rad(90 - t:value("rhexis.tip_heading_deg"))
    local x = radius * math.cos(a) + ahead * math.cos(way) - aside * math.sin(way)
    local y = radius * math.sin(a) + ahead * math.sin(way) + aside * math.cos(way)
    return place(math.sqrt(x * x + y * y), math.deg(math.atan(y, x)), height, lift)
end

function rhexis_hand.open_jaws(t)
    t.forceps:jaw(1)
    t:wait(0.1)
    t.forceps:move_by({ 0, 0, 0.3 }, { speed = 8 })
end

--- Takes hold of the flap, so far behind the end of the tear and so far inside of it [mm]; lower and farther behind
--- each time until it is held. Returns whether it is.
function rhexis_hand.take_hold(t, behind, inside)
    for try = 0, 3 do
        local back = -behind - 0.15 * try
        t.forceps:jaw(1)
        t:wait(0.1)
        t.forceps:move_to(rhexis_hand.by_tear(t, back, inside, 0.7), { speed = 12 })
        t.forceps:move_to(rhexis_hand.by_tear(t, back, inside, 0.05 - 0.1 * try), { speed = 3 })
        t.forceps:jaw(0)
        t:wait(0.15)
        if t:value("forceps.holding") then return true end
    end
    return false
end

--- Holds the flap and pulls towards a place by the tear, close to the lens, until it is there or a condition holds.
--- Returns whether it does. ahead, aside: of by_tear [mm]. A pull of 2 and 1.5 leads a tear round in a deep chamber.
function rhexis_hand.pull(t, ahead, aside, stop)
    rhexis_hand.take_hold(t, 0.5, 0.4)
    return t.forceps:move_to(rhexis_hand.by_tear(t, ahead, aside, 0.2), { speed = 2, motion = "even", stop = stop })
end

--- With the cannula, until the chamber is full.
function rhexis_hand.fill(t)
    t.cannula:enter({ speed = 20 })
    t.cannula:move_to({ 0, -1.5, 3 + t:value("lens.lift_mm") }, { speed = 12 })
    t.cannula:jaw(0.7)
    t:wait_until("viscoelastic.fill > 0.98", 20)
    t.cannula:jaw(0)
    t.cannula:withdraw({ speed = 20 })
end

return rhexis_hand
