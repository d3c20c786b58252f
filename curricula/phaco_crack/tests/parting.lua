-- SPDX-License-Identifier: GPL-3.0-or-later
-- The split: complete or not, by tips at the floor of the groove or too high.

local crack_events = require "crack_events"

-- Both instruments into the eye, over the groove, with irrigation on; the chamber deepens.
local function enter(t)
    t.phaco:enter({ speed = 30 })
    t.phaco:pedal(1)
    t.phaco:move_to({ 0.3, 0, 2.6 }, { speed = 30 })
    t.spatula:enter({ speed = 30 })
    t.spatula:move_to({ -0.3, 0, 2.6 }, { speed = 30 })
    t:wait(0.5)
end

local function both(t, right, left, speed, stop)
    t:together(function() t.phaco:move_to(right, { speed = speed, motion = "even", stop = stop }) end,
        function() t.spatula:move_to(left, { speed = speed, motion = "even", stop = stop }) end)
end

-- Both tips down at y, to a height, and apart by a way each, or until something is so.
local function part(t, y, z, way, stop)
    both(t, { 0.3, y, 2.4 }, { -0.3, y, 2.4 }, 20)
    both(t, { 0.3, y, z }, { -0.3, y, z }, 10)
    both(t, { 0.3 + way, y, z }, { -0.3 - way, y, z }, 1.5, stop)
end

-- Back together and up.
local function close(t, y, z)
    both(t, { 0.3, y, z }, { -0.3, y, z }, 10)
    both(t, { 0.3, y, 2.4 }, { -0.3, y, 2.4 }, 20)
end

local function split(t, y, z, way, stop)
    part(t, y, z, way, stop)
    close(t, y, z)
end

return scenarios {
    patient = { age = 68, cataract = "NO4", pupil_mm = 7.5 },

    scenario "parted too little, looked, and parted again" {
        function(t)
            enter(t)
            split(t, 1.5, -1.55, 0.7)
            t:expect("crack.bridge_share > 0.1")
            t:expect_event("Incomplete split", { within = 4 })
            split(t, 1.5, -1.55, 1.5)
            split(t, -1.5, -1.55, 1.5)
            t:expect_event("Incomplete split", { recovered = true })
        end },

    scenario "parted too little, and left so" {
        recover_within_s = 3,
        function(t)
            enter(t)
            split(t, 1.5, -1.55, 0.7)
            t:expect_event("Incomplete split", { recovered = false, within = 4 })
        end },

    scenario "parted near both ends, and a little bridges the groove still" {
        silent_twin_of = "Incomplete split",
        set = { goal = { bridge_percent = 12 } },
        near = "crack.bridge_share > 0.08 and crack.bridge_share < 0.12 and " .. crack_events.both_out,
        function(t)
            enter(t)
            split(t, 1.6, -1.55, 1.5, "crack.bridge_share < 0.12")
            split(t, -1.5, -1.55, 1.5, "crack.bridge_share < 0.12")
            t:wait(4)
        end },

    scenario "parted just low enough" {
        silent_twin_of = "Tips too shallow",
        near = ("phaco.force_mN > 2 and spatula.force_mN > 2 and %s > %s - 0.3"):format(crack_events.higher_tip,
            crack_events.lower_half),
        function(t)
            enter(t)
            part(t, 1.2, -0.6, 1.4)
            close(t, 1.2, -0.6)
        end },

    scenario "parted too high, closed at once" {
        function(t)
            enter(t)
            part(t, 1.2, 0.4, 1.4)
            t:expect_event("Tips too shallow")
            both(t, { 0.3, 1.2, 0.4 }, { -0.3, 1.2, 0.4 }, 3)
            t:expect_event("Tips too shallow", { recovered = true })
        end },

    scenario "parted too high, and held so" {
        function(t)
            enter(t)
            part(t, 1.2, 0.4, 1.4)
            t:expect_event("Tips too shallow", { recovered = false, within = 3 })
        end },
}
