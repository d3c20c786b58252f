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

--- A place by its distance and angle from a middle that is so far to the surgeon's right of the axis [mm].
function rhexis_hand.beside(aside, radius, angle, height, lift)
    local a = math.rad(angle)
    local x, y = aside + radius * math.cos(a), radius * math.sin(a)
    return place(math.sqrt(x * x + y * y), math.deg(math.atan(y, x)), height, lift)
end

local beside = rhexis_hand.beside

-- A function that tells places before the end of the tear, along a circle: so far ahead [mm], at a height. And the
-- angle about the circle's middle at which the tear ends in the capsule at rest [degrees], which changes as it tears
-- and not as the needle stretches it. farther_out: than where it ends now [mm]; or nil: towards the circle.
local function before_end(t, circle, farther_out)
    local aside, lift = circle.aside or 0, t:value("lens.lift_mm")
    local angle, radius = math.rad(t:value("rhexis.tip_angle_deg")), t:value("rhexis.tip_radius_mm")
    local rest_x, rest_y = radius * math.cos(angle) - aside, radius * math.sin(angle)
    local at_rest = math.sqrt(rest_x * rest_x + rest_y * rest_y)
    local x, y = t:value("rhexis.tip_x_mm") - aside, t:value("rhexis.tip_y_mm")
    local now = math.deg(math.atan(y, x))
    local out = farther_out or math.max(-0.3, math.min(circle.outwards or 0.35, circle.radius - at_rest))
    local wanted = math.sqrt(x * x + y * y) + 0.1 + out
    return math.deg(math.atan(rest_y, rest_x)), function(ahead, height)
        return beside(aside, wanted, now + (circle.sense or 1) * math.deg(ahead / wanted), height, lift)
    end
end

-- The needle, through the capsule anew so far before the end of a tear [mm].
local function put_before(t, ahead, far)
    t.cystotome:move_to(ahead(far, 0.3), { speed = 12 })
    t.cystotome:move_to(ahead(far, -0.4), { speed = 4 })
end

-- Towards a place, no farther than a step of the way.
local function step_towards(t, goal, circle)
    local step, from = 0.15, t.cystotome:tip()
    local share = math.min(1, step / math.max(1e-6, math.sqrt((goal[1] - from[1]) ^ 2 + (goal[2] - from[2]) ^ 2)))
    local to = {}
    for i = 1, 3 do to[i] = from[i] + share * (goal[i] - from[i]) end
    return t.cystotome:move_to(to, { seconds = step / (circle.speed or 3), motion = "even", stop = circle.stop })
end

-- How much farther out the needle goes, at each try at a strip that only yields [mm]: inside, it slips over the flap.
local farther_out = { 0.1, 0.25, 0.4 }

--- With the needle, its point under the capsule: draws the end of the tear round along a circle by so many degrees,
--- or until a condition holds; where nothing tears, the needle goes in anew behind the end of the tear and farther out.
--- circle: { radius, aside = of its middle to the right of the axis [mm], sense = 1 against the clock or -1 with it,
--- by = [degrees], stop, speed = [mm/s], outwards = most that it leads outwards [mm], patience = steps in which nothing
--- tears before the needle is put in anew, longest = [s] }. Returns whether the condition holds.
function rhexis_hand.draw_round(t, circle)
    local until_s = t:time_s() + (circle.longest or 15)
    local gone, waits, tries, last = 0, 0, 0, nil
    while gone < circle.by and t:time_s() < until_s and t:value("rhexis.tip_radius_mm") do
        local angle, ahead = before_end(t, circle, farther_out[tries])
        local on = last and (circle.sense or 1) * ((angle - last + 180) % 360 - 180) or 0
        gone, last, waits = gone + on, angle, math.abs(on) > 0.5 and 0 or waits + 1
        if waits == 0 then tries = 0 end
        if waits > (circle.patience or 8) then
            waits, tries = 1, tries % #farther_out + 1
            t.cystotome:move_by({ 0, 0, 0.8 }, { speed = 12 })
            ahead = select(2, before_end(t, circle, farther_out[tries]))
            put_before(t, ahead, -0.2)
        end
        if step_towards(t, ahead(0.6 + 0.12 * math.min(8, waits), -0.4), circle) then return true end
    end
    return false
end

--- With the needle: through the capsule on a circle, at an angle about its middle, and round along it. circle: as for
--- draw_round, with from = that angle [degrees], 0 unless given. Returns as draw_round does.
function rhexis_hand.cut_circle(t, circle)
    local lift = t:value("lens.lift_mm")
    local function over(height) return beside(circle.aside or 0, circle.radius, circle.from or 0, height, lift) end
    t.cystotome:enter({ speed = 20 })
    t.cystotome:move_to(over(0.5), { speed = 12 })
    t.cystotome:move_to(over(-0.4), { speed = 2 })
    return rhexis_hand.draw_round(t, circle)
end

-- Pierces the capsule outside the rim of an opening, as far from the axis [mm], at an angle [degrees], and cuts
-- through the rim from there: a tear ends there then. Returns whether one does.
local function notch(t, angle, radius)
    local lift = t:value("lens.lift_mm")
    local function ends_here(eye)
        local now = eye.rhexis.tip_angle_deg
        return now ~= nil and math.abs((now - angle + 180) % 360 - 180) < 20
    end
    t.cystotome:turn(90)  -- so that the slit runs towards the rim
    t.cystotome:move_to(place(radius, angle, 0.3, lift), { speed = 12 })
    t.cystotome:move_to(place(radius, angle, -0.4, lift), { speed = 6 })
    local done = t.cystotome:move_to(place(radius - 2, angle, -0.4, lift), { speed = 2, motion = "even",
        stop = ends_here })
    t.cystotome:turn(0)
    t.cystotome:move_by({ 0, 0, 0.8 }, { speed = 12 })
    return done
end

--- A second cut from the rim of a closed opening, round along a circle, and another where that did not do. The needle
--- is in the eye. circle: as for draw_round, with at = angle [degrees] and from = distance from the axis [mm] where the
--- needle goes in first; where the rim only yields, it tries beside that place. Returns whether the condition holds.
function rhexis_hand.cut_anew(t, circle)
    for _, farther in ipairs { 0, 8, -8, 24, 40, -24 } do
        local angle = circle.at + farther
        t.cystotome:move_to(place(circle.from, angle, 0.8, t:value("lens.lift_mm")), { speed = 12 })
        if notch(t, angle, circle.from) then
            local _, ahead = before_end(t, circle)
            put_before(t, ahead, 0.4)
            if rhexis_hand.draw_round(t, circle) then return true end
            t.cystotome:move_by({ 0, 0, 0.8 }, { speed = 12 })
        end
    end
    return false
end

--- A new cut from the other end of a tear that the needle began: it goes in outside that end, cuts from there with the
--- clock, and draws the new end of the tear round. circle: as for draw_round, with at = angle [degrees] and from =
--- distance from the axis [mm] where the needle goes in.
function rhexis_hand.cut_from_other_end(t, circle)
    local lift, way = t:value("lens.lift_mm"), {}
    t.cystotome:enter({ speed = 20 })
    t.cystotome:move_to(place(circle.from, circle.at, 0.4, lift), { speed = 15 })
    t.cystotome:move_to(place(circle.from, circle.at, -0.4, lift), { speed = 6 })
    for i = 1, 6 do
        way[i] = place(circle.from + (circle.radius - circle.from) * i / 6, circle.at - 10 * i, -0.4, lift)
    end
    t.cystotome:path(way, { speed = 2.5, motion = "even" })
    circle.sense, circle.patience = -1, circle.patience or 20
    return rhexis_hand.draw_round(t, circle)
end

--- A cut from the other end leads outwards to where the old tear ran; the needle is put in anew where a last strip only
--- yields.
function rhexis_hand.meet_tear(t)
    local circle = { sense = -1, radius = 3.2, outwards = 0.3, by = 360, longest = 0.8, stop = "rhexis.loose_mm2 > 5" }
    for _ = 1, 8 do
        if rhexis_hand.draw_round(t, circle) then return end
    end
end

function rhexis_hand.lift_out(t)
    t.cystotome:move_by({ 0, 0, 1.2 }, { speed = 8 })
    t.cystotome:withdraw({ speed = 20 })
end

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
    local _, angle, lift = rhexis_hand.tear_end(t)
    local way = math.rad(angle + 90 - t:value("rhexis.tip_heading_deg"))
    local x = t:value("rhexis.tip_x_mm") + ahead * math.cos(way) - aside * math.sin(way)
    local y = t:value("rhexis.tip_y_mm") + ahead * math.sin(way) + aside * math.cos(way)
    return place(math.sqrt(x * x + y * y), math.deg(math.atan(y, x)), height, lift)
end

function rhexis_hand.open_jaws(t)
    t.forceps:jaw(1)
    t:wait(0.1)
    t.forceps:move_by({ 0, 0, 0.3 }, { speed = 8 })
end

--- Takes hold of the flap, so far behind the end of the tear and so far inside of it [mm]; lower and farther behind
--- each time until it is held, then the same nearer to the tear's edge. Returns whether it is.
function rhexis_hand.take_hold(t, behind, inside)
    for round = 0, 7 do
        local try = round % 4
        if round == 4 then inside = 0.4 * inside end
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
--- Returns whether it does. ahead, aside: of by_tear [mm]. In a shallow chamber 2 and 1 lead a tear outwards.
function rhexis_hand.pull(t, ahead, aside, stop)
    rhexis_hand.take_hold(t, 0.5, 0.4)
    return t.forceps:move_to(rhexis_hand.by_tear(t, ahead, aside, 0.2), { speed = 2, motion = "even", stop = stop })
end

--- Pulls on in a shallow chamber as one does in a deep one, until the end of the tear is past the zonules. The forceps
--- are in the eye.
function rhexis_hand.pull_on(t)
    for _ = 1, 8 do
        if rhexis_hand.pull(t, 2, 1, "rhexis.run_out") then break end
        rhexis_hand.open_jaws(t)
    end
    t:expect("rhexis.run_out")
end

--- Pulls the tear outwards until a condition holds, or, where none is given, it has come to the zonules: held near its
--- end, and led forwards and towards the angle of the chamber, again and again. The forceps are in the eye.
function rhexis_hand.lose_edge(t, stop)
    for pull = 1, 8 do
        local radius, angle, lift = rhexis_hand.tear_end(t)
        rhexis_hand.take_hold(t, 0.3, 0.2)
        t:expect("forceps.holding")
        t.forceps:move_to(place(radius - 0.2, angle + 3, 0.3 + lift), { speed = 2 })
        local to = place(4.6, angle + 30 + 10 * ((pull - 1) % 3), 0)
        local lost = t.forceps:move_to({ to[1], to[2], 2.4 }, { speed = 2, motion = "even",
            stop = stop or "rhexis.run_out" })
        if lost then break end
        rhexis_hand.open_jaws(t)
    end
end

--- With the cannula, until the chamber is full. given: { to = how full it is to be, press = on the syringe, 0 to 1,
--- speed = of the cannula in and out [mm/s] }.
function rhexis_hand.fill(t, given)
    local wanted = given or {}
    t.cannula:enter({ speed = wanted.speed or 20 })
    t.cannula:move_to({ 0, -1.5, 3 + t:value("lens.lift_mm") }, { speed = 12 })
    t.cannula:jaw(wanted.press or 0.7)
    t:wait_until("viscoelastic.fill > " .. (wanted.to or 0.98), 20)
    t.cannula:jaw(0)
    t.cannula:withdraw({ speed = wanted.speed or 20 })
end

return rhexis_hand
