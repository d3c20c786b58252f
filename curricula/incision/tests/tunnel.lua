-- SPDX-License-Identifier: GPL-3.0-or-later
-- Tunnels that are right, too short, too long and too far back, and what is done about them.

-- A place at an angle from the planned main incision, to the surgeon's right [degrees], so far from the axis [mm].
local function at(angle, rho, z)
    local turn = math.rad(angle)
    return { rho * math.sin(turn), -rho * math.cos(turn), z }
end

-- The blade through these places { rho, z } in a plane through the axis, and back along the same way.
local function cut(t, angle, places)
    local blade = t.keratome
    local shaft = at(angle, 0.9, 0.45)
    local function go(i) blade:move_to(at(angle, places[i][1], places[i][2]), { speed = 10, shaft = shaft }) end
    if angle ~= 0 then
        blade:move_to(at(0, 7.4, 3.5), { speed = 30, shaft = shaft })
        blade:move_to(at(angle, 7.4, 3.5), { speed = 30, shaft = shaft })
    end
    for i = 1, #places do go(i) end
    for i = #places - 1, 1, -1 do go(i) end
    blade:move_to(at(angle, 7.4, 3.5), { speed = 30, shaft = shaft })
    if angle ~= 0 then blade:move_to(at(0, 7.4, 3.5), { speed = 30, shaft = shaft }) end
end

local good = { { 5.9, 2.2 }, { 4.7, 3.0 }, { 2.1, 2.9 } }
local short = { { 5.9, 2.16 }, { 3.1, 2.16 } }
local long = { { 5.9, 2.2 }, { 4.7, 3.0 }, { 3.3, 3.65 }, { 1.2, 3.4 } }
local back = { { 6.9, 1.45 }, { 3.8, 1.45 } }
-- On the right side of each limit.
local barely_long_enough = { { 5.9, 2.16 }, { 5.3, 2.5 }, { 3.0, 2.45 } }
local barely_short_enough = { { 5.9, 2.2 }, { 4.7, 3.0 }, { 3.75, 3.42 }, { 1.2, 3.25 } }
local barely_before_the_iris = { { 6.9, 0.8 }, { 6.0, 1.7 }, { 3.5, 1.75 } }

local function gone(t) t.keratome:withdraw { speed = 60 } end

-- A main incision through these places; far_back: begun behind the limbus.
local function main(t, places, far_back)
    t.keratome:enter()
    if far_back then t.keratome:move_to(at(0, 7.4, 2.0), { speed = 15 }) end
    cut(t, 0, places)
    gone(t)
    t:wait(0.5)
end

-- Saline into the stroma beside the main wound.
local function hydrate(t, seconds)
    t.hydration_cannula:enter { speed = 15 }
    t.hydration_cannula:move_to(at(0, 5.3, 2.3), { speed = 10 })
    t.hydration_cannula:jaw(1)
    t:wait(seconds)
    t.hydration_cannula:jaw(0)
    t.hydration_cannula:withdraw { speed = 20 }
end

-- One stitch over the middle of the lip at an angle.
local function stitch(t, angle)
    t.needle_holder:enter { speed = 20 }
    t.needle_holder:move_to(at(0, 7.2, 2.6), { speed = 30 })
    t.needle_holder:move_to(at(angle, 7.2, 2.2), { speed = 30 })
    t.needle_holder:move_to(at(angle, 6.6, 1.35), { speed = 10 })
    t.needle_holder:move_to(at(angle, 5.7, 1.85), { speed = 10 })
    t.needle_holder:move_to(at(angle, 4.95, 3.3), { speed = 10 })
    t.needle_holder:move_to(at(angle, 7.2, 4.2), { speed = 30 })
    t.needle_holder:withdraw { speed = 60 }
end

local cuts_main = { wounds = { uncut = 1 } }

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7 },

    scenario "a tunnel of two planes shuts itself" {
        set = cuts_main,
        function(t)
            main(t, good)
            t:expect_no_event()
            t:expect("wounds.main_cut and wounds.main_planes >= 2")
            t:expect_near("wounds.main_tunnel_mm", 2.1, 0.3)
            t:expect_near("wounds.main_width_mm", 2.4, 0.1)
            t:expect("wounds.main_leak_at_20_ul_s < 0.05 and wounds.touches == 0")
        end },

    scenario "a tunnel that is just long enough" {
        set = cuts_main,
        silent_twin_of = "Tunnel too short",
        near = "wounds.main_cut and wounds.main_tunnel_mm < 1.38",
        function(t)
            main(t, barely_long_enough)
            t:expect("wounds.main_cut and wounds.main_leak_at_20_ul_s < 0.5")
        end },

    scenario "a tunnel that is nearly too long" {
        set = cuts_main,
        silent_twin_of = "Tunnel too long",
        near = "wounds.main_cut and wounds.main_tunnel_mm > 2.6",
        function(t)
            main(t, barely_short_enough)
            t:expect("wounds.main_cut and wounds.main_leak_at_20_ul_s <= 0")
        end },

    scenario "begun behind the limbus, it comes out just in front of the root of the iris" {
        set = cuts_main,
        silent_twin_of = "Posterior entry",
        near = "wounds.main_cut and wounds.main_inner_lip_mm < 0.62",
        function(t)
            main(t, barely_before_the_iris, true)
            t:expect("wounds.main_cut and wounds.main_inner_lip_mm < 0.65")
        end },

    scenario "the point of the blade alone cuts less than its width" {
        set = cuts_main,
        function(t)
            t.keratome:enter()
            cut(t, 0, { good[1], good[2], { 3.2, 2.95 } })
            gone(t)
            t:expect("wounds.main_cut and wounds.main_width_mm < 2")
        end },

    scenario "a blade moved sideways cuts wider" {
        set = cuts_main,
        function(t)
            t.keratome:enter()
            t.keratome:path({ at(0, 5.9, 2.2), at(0, 4.7, 3.0), at(0, 2.1, 2.9) }, { speed = 10 })
            t.keratome:move_by({ 0.5, 0, 0 }, { speed = 4, shaft = at(0, 0.9, 0.45) })
            t:expect("wounds.main_width_mm > 2.8")
        end },

    scenario "the side port, 80 degrees to the left" {
        function(t)
            t.side_port_blade:enter()
            t.side_port_blade:move_to(at(-80, 3.0, 3.0), { speed = 10 })
            t.side_port_blade:withdraw()
            t:expect("wounds.side_cut and not wounds.main_cut")
            t:expect_near("wounds.side_width_mm", 1.0, 0.15)
        end },

    scenario "too short: fluid comes, hydrated until it is tight" {
        set = cuts_main,
        function(t)
            t.keratome:enter()
            cut(t, 0, short)
            gone(t)
            t:wait(0.2)
            t:expect_event("Tunnel too short")
            t:expect("wounds.main_leak_ul_s > 0.5")
            hydrate(t, 2.2)
            t:expect_event("Tunnel too short", { recovered = true, within = 1 })
        end },

    scenario "too short, and a stitch holds it" {
        set = cuts_main,
        function(t)
            t.keratome:enter()
            cut(t, 0, short)
            gone(t)
            t:expect_event("Tunnel too short", { within = 0.5 })
            stitch(t, 0)
            t:expect("wounds.main_sutures == 1")
            t:expect_event("Tunnel too short", { recovered = true, within = 1 })
        end },

    scenario "too short, and left" {
        recover_within_s = 3,
        set = cuts_main,
        function(t)
            t.keratome:enter()
            cut(t, 0, short)
            gone(t)
            t:expect_event("Tunnel too short", { recovered = false, within = 4 })
        end },

    scenario "too long: a new one two clock hours away" {
        set = cuts_main,
        function(t)
            t.keratome:enter()
            cut(t, 0, long)
            t:wait(0.2)
            t:expect_event("Tunnel too long")
            cut(t, 65, good)
            gone(t)
            t:expect_event("Tunnel too long", { recovered = true, within = 1 })
            t:expect("wounds.old_cut and wounds.main_tunnel_mm < 2.5")
        end },

    scenario "too long, and left" {
        recover_within_s = 3,
        set = cuts_main,
        function(t)
            t.keratome:enter()
            cut(t, 0, long)
            gone(t)
            t:expect_event("Tunnel too long", { recovered = false, within = 4 })
        end },

    scenario "too far back: sutured, and a new one two clock hours away" {
        set = cuts_main,
        function(t)
            t.keratome:enter()
            t.keratome:move_to(at(0, 7.4, 2.0), { speed = 15 })
            cut(t, 0, back)
            t:wait(0.1)
            t:expect_event("Posterior entry")
            t:expect("wounds.touches > 0")
            cut(t, 65, good)
            gone(t)
            -- of the wound that was left: its outer lip is at 6.4 mm
            local needle = t.needle_holder
            needle:enter { speed = 20 }
            needle:move_to(at(0, 7.8, 2.2), { speed = 30 })
            needle:move_to(at(0, 7.1, 0.2), { speed = 20 })
            needle:move_to(at(0, 6.2, 1.0), { speed = 10 })
            needle:move_to(at(0, 5.6, 2.7), { speed = 10 })
            needle:withdraw { speed = 60 }
            t:expect_event("Posterior entry", { recovered = true, within = 1 })
        end },

    scenario "too far back, and used all the same" {
        recover_within_s = 3,
        set = cuts_main,
        function(t)
            t.keratome:enter()
            t.keratome:move_to(at(0, 7.4, 2.0), { speed = 15 })
            cut(t, 0, back)
            gone(t)
            t:expect_event("Posterior entry", { recovered = false, within = 4 })
        end },
}
