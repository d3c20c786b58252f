-- SPDX-License-Identifier: GPL-3.0-or-later
-- What holds a bag of which an arc has no zonules: hooks, a ring, and viscoelastic over the gap; and ultrasound without.

local coarse = { patient = { tetrahedra = 1000 } }  -- the load counts, not the mesh

-- Of the edge of the opening at an angle [degrees] and a height over it [mm].
local function rim(t, angle, over)
    local a = math.rad(angle)
    return { 2.6 * math.cos(a), 2.6 * math.sin(a), 1.58 + over }
end

local function set_hook(t, angle)
    t.capsule_hook:enter({ speed = 20 })
    t.capsule_hook:jaw(1)
    t.capsule_hook:move_to(rim(t, angle, 1.0), { speed = 15 })
    t.capsule_hook:move_to(rim(t, angle, 0.1), { speed = 5 })
    t.capsule_hook:jaw(0)
    t:wait(0.1)
    t.capsule_hook:withdraw({ speed = 20 })
end

local function feed_ring(t)
    t.ring:enter({ speed = 20 })
    t.ring:move_to(rim(t, 90, 1.0), { speed = 15 })
    t.ring:move_to(rim(t, 90, 0.1), { speed = 5 })
    t.ring:jaw(1)
    t:wait(2.2)
    t.ring:withdraw({ speed = 20 })
end

local function gap(degrees)
    return { patient = { tetrahedra = 1000 }, zonules = { lost_from_deg = 30, lost_deg = degrees } }
end

local function sound(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -1, 3.4 }, { speed = 15 })
    t.phaco:pedal(3)
    t:wait(0.2)
    t.phaco:pedal(1)
end

return scenarios {
    scenario "the lens lies away from the gap, and a hook over it draws it back" {
        set = gap(90),
        function(t)
            t:wait(1)
            t:expect("bag.offset_mm > 0.2 and zonules.unsupported_deg > 89")
            local aside = t:value("bag.offset_mm")
            set_hook(t, 75)
            t:wait(0.5)
            t:expect("zonules.hooks == 1 and zonules.unsupported_deg < 50")
            t:expect(function(eye) return eye.bag.offset_mm < 0.8 * aside end)
        end },

    scenario "a ring in a gap of three clock hours draws the lens back" {
        set = gap(90),
        function(t)
            t:wait(1)
            feed_ring(t)
            t:wait(0.5)
            t:expect("zonules.ring and zonules.unsupported_deg < 1 and bag.offset_mm < 0.1")
        end },

    scenario "a ring in a gap of six clock hours does not suffice" {
        set = gap(180),
        function(t)
            t:wait(1)
            feed_ring(t)
            t:wait(0.5)
            t:expect("zonules.ring and zonules.unsupported_deg > 170 and bag.offset_mm > 0.2")
        end },

    scenario "ultrasound at a bag without hold, then hooks" {
        set = coarse,
        function(t)
            sound(t)
            t:expect_event("Bag not supported")
            t.phaco:withdraw({ speed = 20 })
            set_hook(t, 60)
            t:expect_event("Bag not supported", { recovered = true, within = 1 })
        end },

    scenario "ultrasound at a bag without hold, and on" {
        set = coarse,
        function(t)
            sound(t)
            t:expect_event("Bag not supported", { recovered = false, within = 61 })
        end },

    scenario "hooks first, then ultrasound" {
        set = coarse,
        silent_twin_of = "Bag not supported",
        function(t)
            set_hook(t, 60)
            sound(t)
            t:expect("zonules.hooks == 1")
        end },
}
