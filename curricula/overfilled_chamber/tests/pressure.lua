-- SPDX-License-Identifier: GPL-3.0-or-later
-- A chamber pressed too full: let out past the lip of the side port, and left so.

local full = { ["viscoelastic.fill"] = 1 }

-- Pressed until a condition holds, in a chamber that is full.
local function inject(t, condition)
    t.cannula:enter({ speed = 20 })
    t.cannula:move_to({ 0, -1.5, 3 }, { speed = 12 })
    t.cannula:jaw(0.7)
    t:wait_until(condition, 15)
    t.cannula:jaw(0)
    t.cannula:withdraw({ speed = 20 })
end

-- The lip of the side port pressed aside by the spatula until a condition holds.
local function burp(t, condition)
    t.spatula:enter({ speed = 10 })
    t.spatula:move_by({ 0.2, 0, -0.3 }, { speed = 6 })
    t.spatula:move_by({ 0, 0.9, 0 }, { speed = 6 })
    t:wait_until(condition, 8)
    t.spatula:move_by({ 0, -0.9, 0.3 }, { speed = 6 })
    t.spatula:withdraw({ speed = 20 })
end

return scenarios {
    patient = { age = 68, cataract = "NO3", pupil_mm = 7 },

    scenario "pressed too long, and burped through the side port" {
        set = full,
        function(t)
            inject(t, "viscoelastic.pressure_mmhg > 62")
            t:expect_event("Overfilled")
            burp(t, "viscoelastic.pressure_mmhg < 24")
            t:expect_event("Overfilled", { recovered = true, within = 2 })
            t:expect("viscoelastic.fill > 0.95")
        end },

    scenario "pressed too long, and the wounds left alone" {
        set = full,
        recover_within_s = 3,
        function(t)
            inject(t, "viscoelastic.pressure_mmhg > 62")
            t:expect_event("Overfilled", { recovered = false, within = 4 })
        end },

    scenario "pressed a little too long" {
        set = full,
        silent_twin_of = "Overfilled",
        near = "viscoelastic.pressure_mmhg > 55",
        function(t)
            inject(t, "viscoelastic.pressure_mmhg > 55")
            t:wait(1)
        end },
}
