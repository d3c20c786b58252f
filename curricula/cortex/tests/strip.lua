-- SPDX-License-Identifier: GPL-3.0-or-later
-- Cortex held in the fornix, drawn to the middle and aspirated.

local function enter(t)
    t.ia_tip:enter { speed = 20 }
    t.ia_tip:pedal(1)
    t.ia_tip:move_to({ 0, -0.5, -0.3 }, { speed = 10 })
end

local function at(angle, out, z)
    return { out * math.cos(math.rad(angle)), out * math.sin(math.rad(angle)), z }
end

-- angle: of the sector's middle, anticlockwise from the surgeon's right [deg].
local function take(t, angle)
    t.ia_tip:move_to(at(angle, 3.85, -0.55), { speed = 8 })
    t.ia_tip:pedal(2)
    t:wait_until("cortex.held", 1.5)
    t.ia_tip:move_to(at(angle, 1.3, -0.6), { speed = 5 })
    t:wait_until("not cortex.held", 2)
    t.ia_tip:pedal(1)
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 8.5 },

    scenario "one sector, stripped and taken" {
        set = { cortex = { left = 0.0625 } },
        function(t)
            enter(t)
            take(t, 11)
            t:expect("cortex.left_percent <= 2 and not capsule.captured and not capsule.open")
            t:expect("zonules.peak_strain < 0.2")
            t.ia_tip:withdraw()
            t:wait(0.2)
            t:expect_no_event("Cortex left")
        end },

    scenario "the tip leaves too early, and goes in again" {
        set = { cortex = { left = 0.1875 } },
        function(t)
            enter(t)
            take(t, 11)
            t:expect("cortex.left_percent > 10")
            t.ia_tip:withdraw { speed = 20 }
            t:wait(0.1)
            t:expect_event("Cortex left")
            enter(t)
            take(t, 34)
            take(t, 56)
            t:expect_event("Cortex left", { recovered = true, within = 1 })
        end },

    scenario "the tip leaves too early" {
        recover_within_s = 3,
        set = { cortex = { left = 0.1875 } },
        function(t)
            enter(t)
            take(t, 11)
            t.ia_tip:withdraw { speed = 12 }
            t:expect_event("Cortex left", { recovered = false, within = 4 })
        end },

    scenario "too little vacuum strips nothing" {
        set = { cortex = { left = 0.0625 }, ia = { vacuum_mmhg = 80 } },
        function(t)
            enter(t)
            take(t, 11)
            t:expect("cortex.left_percent > 6 and cortex.taken_mm3 <= 0")
        end },

    scenario "a little is left" {
        set = { cortex = { left = 0.125 } },
        silent_twin_of = "Cortex left",
        near = "cortex.taken_mm3 > 0 and cortex.left_percent > 6 and not ia_tip.present",
        function(t)
            enter(t)
            take(t, 11)
            t.ia_tip:withdraw()
            t:wait(0.3)
            t:expect("cortex.left_percent > 2 and cortex.left_percent < 10")
        end },
}
