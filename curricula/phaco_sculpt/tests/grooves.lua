-- SPDX-License-Identifier: GPL-3.0-or-later
-- A groove that is too shallow when the spatula comes to it, and one that is not across the other. The exact hand needs
-- no turned lens for that: it sculpts in any direction.

local sculpt_hand = require "sculpt_hand"

-- Shallow grooves in a coarse mesh show both as well as deep ones, and sooner.
local function shallow(percent)
    return { patient = { tetrahedra = 1000 }, goal = { depth_percent = percent } }
end

local function layers(t, turn, ...)
    for _, height in ipairs { ... } do sculpt_hand.stroke(t, turn, height, 30) end
end

local function come_in(t)
    t.phaco:enter({ speed = 20 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0, -sculpt_hand.half_length, sculpt_hand.over }, { speed = 20 })
end

-- Well over the lens, to look.
local function lift(t)
    t.phaco:move_to({ 0, 0, 3.8 }, { speed = 8 })
    t:wait(0.5)
end

local function leave(t)
    t:together(function() t.phaco:withdraw({ speed = 20 }) end,
        function() if t:value("spatula.present") then t.spatula:withdraw({ speed = 20 }) end end)
end

local function touch_with_spatula(t)
    t.spatula:enter({ speed = 20 })
    t.spatula:move_to({ -1.2, 1, 2.2 }, { speed = 20 })
    t.spatula:move_to({ -1.2, 1, 0.6 }, { speed = 3, stop = "spatula.in_contact" })
    t:expect("spatula.in_contact and grooves.count == 1")
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5 },

    scenario "spatula at a shallow groove; both grooves made deep enough" {
        start = "thin_groove",
        set = shallow(24),
        function(t)
            come_in(t)
            touch_with_spatula(t)
            t:expect_event("Groove too shallow")
            t.spatula:withdraw({ speed = 20 })
            layers(t, 0, 0.4)
            layers(t, 90, 0.9, 0.4)
            t:expect_event("Groove too shallow", { recovered = true })
        end },

    scenario "spatula at a shallow groove, and nothing more" {
        set = shallow(24),
        function(t)
            come_in(t)
            layers(t, 0, 0.9)
            touch_with_spatula(t)
            leave(t)
            t:expect_event("Groove too shallow", { recovered = false })
        end },

    scenario "spatula at a groove just deep enough" {
        start = "thin_groove",
        set = shallow(30),
        silent_twin_of = "Groove too shallow",
        near = "spatula.in_contact and 100 * groove_1.depth_share < 34",
        function(t)
            come_in(t)
            layers(t, 0, 0.4)
            touch_with_spatula(t)
            t:expect("100 * groove_1.depth_share > 30")
        end },

    scenario "second groove askew; another one across" {
        start = "askew",
        hold_within_s = 1,
        set = shallow(10),
        function(t)
            come_in(t)
            t:expect_event("Groove askew", { within = 9 })
            lift(t)
            layers(t, 90, 0.9, 0.4)
            t:expect_event("Groove askew", { recovered = true })
        end },

    scenario "second groove askew, and left so" {
        start = "askew",
        set = shallow(10),
        function(t)
            come_in(t)
            layers(t, 45, 0.4)
            t:expect_event("Groove askew", { within = 9 })
            leave(t)
            t:expect_event("Groove askew", { recovered = false })
        end },

    scenario "second groove nearly across" {
        start = "groove",
        hold_within_s = 1,
        set = shallow(10),
        silent_twin_of = "Groove askew",
        near = "groove_2.length_mm >= 3 and grooves.angle_deg < 83",
        function(t)
            come_in(t)
            layers(t, 81, 0.9)
            t:wait(1.5)
            t:expect("groove_2.length_mm >= 3 and grooves.angle_deg > 80")
        end },
}
