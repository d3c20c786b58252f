-- SPDX-License-Identifier: GPL-3.0-or-later
-- Ready, and not: lashes beside the drape, a pedal that nobody tested.

local half_width, places, shut = 14, 12, 4.5

-- Where the lashes of a place are: along = 1 to 12 from the surgeon's left.
local function lash(lid, along)
    local x = half_width * ((2 * along - 1) / places - 1)
    return { x, lid * shut * (1 - (x / half_width) ^ 2), 2.2 - 0.02 * x * x }
end

-- The drape along a lid, from one place to another.
local function cover(t, lid, first, last)
    t.drape:move_to(lash(lid, first), { speed = 80 })
    t.drape:jaw(1)
    for along = first, last do t.drape:move_to(lash(lid, along), { speed = 55 }) end
    t.drape:jaw(0)
end

local function drape(t, last)
    t.drape:enter()
    cover(t, -1, 1, 12)
    cover(t, 1, 1, last)
    t.drape:withdraw { speed = 60 }
end

local function open(t)
    t.speculum:enter()
    t.speculum:move_to({ 0, 0, 6 }, { speed = 60 })
    t.speculum:move_to({ 0, 0, 5 }, { speed = 20 })
    t.speculum:jaw(1)
    t:wait(0.1)
    t.speculum:withdraw { speed = 60 }
end

local function test_pedal(t, last, seconds)
    t.phaco:enter { through = "hand_rest" }
    for position = 1, last do
        t.phaco:pedal(position)
        t:wait(seconds or 0.4)
    end
    t.phaco:pedal(0)
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7.5, incision_deg = 90 },

    scenario "all done, then ready" {
        function(t)
            drape(t, 12)
            t:expect("lids.covered_percent > 99")
            open(t)
            t:expect("lids.opening > 0.9")
            test_pedal(t, 3)
            t:expect("lids.pedal_tested")
            t.phaco:withdraw { speed = 30 }
            t.microscope:centre()
            t:request("Settings confirmed")
            t:request("Side confirmed")
            t:request("Ready to begin")
            t:wait(0.1)
            t:expect("microscope.in_focus and microscope.pupil_offset < 0.1")
            t:expect_no_event()
        end },

    scenario "the last lash is seen and covered before one is ready" {
        silent_twin_of = "Lashes uncovered",
        near = "lids.covered_percent > 95 and lids.covered_percent < 98 and not drape.present",
        function(t)
            drape(t, 10)
            t:wait(0.2)
            t.drape:enter()
            cover(t, 1, 11, 12)
            t.drape:withdraw { speed = 60 }
            t:request("Ready to begin")
            t:wait(0.1)
        end },

    scenario "the pedal tested for no longer than it takes" {
        silent_twin_of = "Pedal not tested",
        near = "lids.pedal_tested and lids.pedal_1_s < 0.36 and lids.pedal_2_s < 0.36 and lids.pedal_3_s < 0.36",
        function(t)
            test_pedal(t, 3, 0.32)
            t:request("Ready to begin")
            t:wait(0.1)
        end },

    scenario "a corner left out, and covered when it is told" {
        function(t)
            drape(t, 9)
            t:expect("lids.covered_percent < 95")
            t:request("Ready to begin")
            t:wait(0.1)
            t:expect_event("Lashes uncovered")
            t.drape:enter()
            cover(t, 1, 10, 12)
            t:expect_event("Lashes uncovered", { recovered = true, within = 1 })
        end },

    scenario "a corner left out, and left so" {
        function(t)
            t:request("Ready to begin")
            t:expect_event("Lashes uncovered", { recovered = false, within = 9 })
        end },

    scenario "pedal tested to 2 only, then to 3" {
        function(t)
            test_pedal(t, 2)
            t:expect("not lids.pedal_tested and lids.pedal_2_s > 0.3")
            t:request("Ready to begin")
            t:wait(0.1)
            t:expect_event("Pedal not tested")
            t.phaco:pedal(3)
            t:expect_event("Pedal not tested", { recovered = true, within = 1 })
        end },

    scenario "the bottle's line is shut: the test shows nothing" {
        recover_within_s = 3,
        function(t)
            t:set { ["machine.infusion"] = 0 }
            test_pedal(t, 3)
            t:expect("not lids.pedal_tested and lids.pedal_1_s == 0")
            t:request("Ready to begin")
            t:expect_event("Pedal not tested", { recovered = false, within = 4 })
        end },

    scenario "a drape that is not pressed covers nothing" {
        function(t)
            t.drape:enter()
            t.drape:move_to(lash(-1, 6), { speed = 60 })
            t.drape:move_to(lash(-1, 7), { speed = 20 })
            t:expect("lids.covered_percent == 0")
        end },
}
