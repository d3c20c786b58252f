-- SPDX-License-Identifier: GPL-3.0-or-later
-- Wounds that are tight, that leak, and that a burn has drawn apart.

local short = { wounds = { main_tunnel_mm = 1.1, main_width_mm = 2.6 } }
local burnt = { wounds = { main_burn = 0.6 } }

local function hydrate(t, seconds)
    t.hydration_cannula:enter { speed = 15 }
    t.hydration_cannula:move_to({ 0, -5.3, 2.3 }, { speed = 10 })
    t.hydration_cannula:jaw(1)
    t:wait(seconds)
    t.hydration_cannula:jaw(0)
    t.hydration_cannula:withdraw { speed = 20 }
end

local function stitch(t, x)
    t.needle_holder:enter { speed = 20 }
    t.needle_holder:move_to({ x, -7.2, 2.6 }, { speed = 30 })
    t.needle_holder:move_to({ x, -6.6, 1.3 }, { speed = 15 })
    t.needle_holder:move_to({ x, -5.7, 1.85 }, { speed = 10 })
    t.needle_holder:move_to({ x, -4.95, 3.3 }, { speed = 10 })
    t.needle_holder:withdraw { speed = 60 }
end

-- Presses on the outer lip.
local function test(t, deep)
    t.sponge:enter { speed = 20 }
    t.sponge:move_by({ 0, 0.77 * deep, -0.64 * deep }, { speed = 4 })
    t:wait(0.5)
    t.sponge:move_by({ 0, -0.77 * deep, 0.64 * deep }, { speed = 6 })
    t.sponge:withdraw { speed = 30 }
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 6 },

    scenario "hydrated, and dry under the sponge" {
        function(t)
            hydrate(t, 1.5)
            test(t, 0.9)
            t:expect("wounds.checked and wounds.tested_leak_ul_s <= 0.05 and wounds.peak_press_mN > 200")
            t:expect_no_event("Leak")
        end },

    scenario "hydrated for a moment: a trace comes under the sponge" {
        silent_twin_of = "Leak",
        near = "wounds.checked and wounds.tested_leak_ul_s > 0.03",
        function(t)
            hydrate(t, 0.6)
            test(t, 0.9)
            t:wait(0.5)
        end },

    scenario "a short tunnel, hydrated until next to nothing comes" {
        set = short,
        silent_twin_of = "Leak",
        near = "instruments.out_s > 0.5 and wounds.leak_at_20_ul_s > 0.03",
        function(t)
            hydrate(t, 1.15)
            t:wait(1)
        end },

    scenario "not hydrated: the test shows what comes; hydrated and tested again" {
        function(t)
            test(t, 0.9)
            t:expect("wounds.checked and wounds.tested_leak_ul_s > 0.05")
            t:expect_event("Leak")
            hydrate(t, 1.5)
            t:expect("not wounds.checked")
            test(t, 0.9)
            t:expect_event("Leak", { recovered = true, within = 1 })
        end },

    scenario "a short tunnel, hydrated too little: the test shows what comes, and it is left" {
        recover_within_s = 3,
        set = short,
        function(t)
            hydrate(t, 0.5)
            test(t, 0.9)
            t:expect("wounds.checked and wounds.tested_leak_ul_s > 1")
            t:expect_event("Leak")
            t:expect("wounds.leak_at_20_ul_s > 1")
            t:expect_event("Leak", { recovered = false, within = 4 })
            t:expect("chamber.pressure_mmhg < 12")
        end },

    scenario "a burnt wound: hydration does not close it, stitches do" {
        set = burnt,
        function(t)
            t:expect("wounds.leak_at_20_ul_s > 1")
            hydrate(t, 1)
            t:expect_event("Leak", { within = 1 })
            t:expect("wounds.leak_at_20_ul_s > 0.05")
            stitch(t, -0.3)
            stitch(t, 0.3)
            t:expect("wounds.main_sutures == 2 and wounds.distortion_d > 0.5")
            t.hydration_cannula:enter { speed = 20 }
            t.hydration_cannula:move_to({ 0, -3.4, 2.9 }, { speed = 10 })
            t.hydration_cannula:jaw(1)
            t:wait_until("chamber.pressure_mmhg > 18", 2)
            t.hydration_cannula:withdraw { speed = 30 }
            test(t, 0.9)
            t:expect_event("Leak", { recovered = true, within = 1 })
        end },

    scenario "a needle that misses the middle, or goes through into the chamber, holds nothing" {
        set = short,
        function(t)
            stitch(t, 1.4)
            t:expect("wounds.main_sutures == 0")
            t.needle_holder:enter()
            t.needle_holder:move_to({ 0, -7.2, 2.6 }, { speed = 30 })
            t.needle_holder:path({ { 0, -6.6, 1.3 }, { 0, -4.9, 1.9 }, { 0, -4.5, 3.7 } }, { speed = 10 })
            t:expect("wounds.main_sutures == 0")
        end },
}
