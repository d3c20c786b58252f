-- SPDX-License-Identifier: GPL-3.0-or-later
-- What holds a bag of which an arc has no zonules: hooks, a ring, viscoelastic over the gap; and ultrasound without.

local hand = require "zonule_hand"

local coarse = { patient = { tetrahedra = 1000 } }  -- the load counts, not the mesh

local function gap(degrees)
    return { patient = { tetrahedra = 1000 },
        zonules = { lost_from_deg = 30, lost_deg = degrees, toughness = 1 } }
end

local function sound(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -1, 3.6 }, { speed = 15 })
    t.phaco:pedal(3)
    t:wait(0.2)
    t.phaco:pedal(1)
end

return scenarios {
    patient = { age = 74, cataract = "NO3", pupil_mm = 8 },

    scenario "the lens lies away from the gap, and a hook over it draws it back" {
        set = gap(90),
        function(t)
            t:wait(1)
            t:expect("bag.offset_mm > 0.15 and bag.tilt_deg > 2 and zonules.unsupported_deg > 89")
            local aside = t:value("bag.offset_mm")
            hand.set_hook(t)
            t:wait(0.5)
            t:expect("zonules.hooks == 1 and zonules.unsupported_deg < 60")
            t:expect(function(eye) return eye.bag.offset_mm < 0.8 * aside end)
        end },

    scenario "a ring in a gap of three clock hours draws the lens back" {
        set = gap(90),
        function(t)
            t:wait(1)
            hand.feed_ring(t)
            t:wait(0.5)
            t:expect("zonules.ring and zonules.unsupported_deg < 1 and bag.offset_mm < 0.1")
        end },

    scenario "a ring in a gap of five clock hours holds in part only" {
        set = gap(150),
        function(t)
            t:wait(1)
            hand.feed_ring(t)
            t:wait(0.5)
            t:expect("zonules.ring and zonules.unsupported_deg > 60 and bag.offset_mm > 0.15")
        end },

    scenario "ultrasound at a bag without hold, then a hook" {
        set = coarse,
        function(t)
            sound(t)
            t:expect_event("Bag not supported")
            t.phaco:withdraw({ speed = 20 })
            hand.set_hook(t)
            t:expect_event("Bag not supported", { recovered = true, within = 1 })
        end },

    scenario "ultrasound at a bag without hold, and on" {
        set = coarse,
        function(t)
            sound(t)
            t:expect_event("Bag not supported", { recovered = false, within = 9 })
        end },

    scenario "a hook first, then ultrasound" {
        set = coarse,
        silent_twin_of = "Bag not supported",
        near = "phaco.ultrasound and zonules.unsupported_deg > 25",
        function(t)
            hand.set_hook(t)
            sound(t)
            t:expect("zonules.hooks == 1")
        end },
}
